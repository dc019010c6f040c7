// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkShaderPass_h
#define InkShaderPass_h

#include "vtkInkRenderingCoreModule.h" // for the export macro

#include "vtkNew.h"
#include "vtkType.h"

#include <functional>
#include <map>
#include <memory>
#include <string>

class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;

/// Shaders and what binds buffers to their attributes.
class VTKINKRENDERINGCORE_EXPORT InkShaderPass
{
public:
  InkShaderPass(std::string vertexShader, std::string geometryShader, std::string fragmentShader);
  ~InkShaderPass();
  InkShaderPass(const InkShaderPass&) = delete;
  void operator=(const InkShaderPass&) = delete;

  using BindAttributes = std::function<void(vtkShaderProgram*, vtkOpenGLVertexArrayObject*)>;

  /// Makes the program ready for uniforms and draw calls, up to End; null if its shaders cannot be compiled.
  /// @param uploadTime of the buffers: when it is another, or the program is, they are bound anew
  vtkShaderProgram* Begin(
    vtkOpenGLRenderWindow* window, vtkMTimeType uploadTime, const BindAttributes& bindAttributes);
  void End();

  vtkOpenGLVertexArrayObject* GetVertexArray() const { return this->VertexArray; }

private:
  std::string VertexShader;
  std::string GeometryShader;
  std::string FragmentShader;
  vtkNew<vtkOpenGLVertexArrayObject> VertexArray;
  int ProgramHandle = 0;
  vtkMTimeType UploadTime = 0;
};

/// The passes of one window: one for each form that features and render passes give the shaders.
class VTKINKRENDERINGCORE_EXPORT InkShaderPasses
{
public:
  InkShaderPass& Find(
    const std::string& vertexShader, const std::string& geometryShader, const std::string& fragmentShader);

private:
  std::map<std::string, std::unique_ptr<InkShaderPass>> Passes; ///< by their shaders
};

#endif
