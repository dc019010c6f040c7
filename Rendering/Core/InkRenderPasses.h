// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkRenderPasses_h
#define InkRenderPasses_h

#include "vtkInkRenderingCoreModule.h" // for the export macro

#include <string>
#include <vector>

class vtkAbstractMapper;
class vtkActor;
class vtkOpenGLRenderPass;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;

/// The render passes that an actor takes part in (depth peeling, blending in any order), which may change the
/// shaders that draw it.
class VTKINKRENDERINGCORE_EXPORT InkRenderPasses
{
public:
  InkRenderPasses(vtkAbstractMapper* mapper, vtkActor* actor);
  bool IsEmpty() const { return this->Passes.empty(); }
  /// Whether they are VTK's order-independent pass alone.
  bool IsOrderIndependent() const;

  void ReplaceShaderValues(
    std::string& vertexShader, std::string& geometryShader, std::string& fragmentShader) const;
  void SetShaderParameters(vtkShaderProgram* program, vtkOpenGLVertexArrayObject* vertexArray) const;

private:
  vtkAbstractMapper* Mapper;
  vtkActor* Actor;
  std::vector<vtkOpenGLRenderPass*> Passes;
};

#endif
