// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSplatPasses_h
#define InkSplatPasses_h

#include "vtkNew.h"
#include "vtkType.h"

#include <map>
#include <memory>
#include <string>

class InkSplatPoints;
class InkSplatTargets;
struct InkView;
class vtkAbstractMapper;
class vtkActor;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkOpenGLVertexBufferObjectGroup;
class vtkShaderProgram;

/// The points on the GPU and the draw calls over them, for one window.
class InkSplatPasses
{
public:
  explicit InkSplatPasses(vtkOpenGLRenderWindow* window);
  ~InkSplatPasses();
  InkSplatPasses(const InkSplatPasses&) = delete;
  void operator=(const InkSplatPasses&) = delete;

  vtkOpenGLRenderWindow* GetWindow() const { return this->Window; }

  void Upload(InkSplatPoints& points);
  /// When Upload was last called, on VTK's clock; 0: never.
  vtkMTimeType GetUploadTime() const;

  /// What the splats depend on besides the points and the view.
  struct Splatting
  {
    double Lambda;
    double Sigma;
    bool AsPublished;
    bool operator==(const Splatting&) const = default;
  };

  /// The depth and the illumination splats of a view, into the targets. The OpenGL state is left as it was.
  void DrawSplats(const InkView& view, InkSplatTargets& targets, const Splatting& splatting);

  /// What the composite adds to the splats.
  struct Style
  {
    double Tau;
    double Phi;
    const double* InkColor;
    const double* PaperColor;
    bool Paper;
    double Opacity;
  };

  /// The drawing, from the targets into the caller's framebuffer, viewport and blending. The render passes
  /// that the actor takes part in (depth peeling) may change the shader.
  void DrawComposite(const InkView& view, InkSplatTargets& targets, const Style& style,
    vtkAbstractMapper* mapper, vtkActor* actor);

  /// The points' discs in the colours that encode 24 bits of their ids, from bit idShift on, or, if idShift
  /// is negative, in propColor; into the caller's framebuffer and viewport, at the given origin.
  void DrawIds(const InkView& view, const int viewportOrigin[2], int idShift, const float propColor[3]);

private:
  struct Pass;

  vtkShaderProgram* Begin(Pass& pass, const InkView& view, double radiusScale, double minimumRadius);
  void DrawPoints();

  vtkOpenGLRenderWindow* Window;
  vtkNew<vtkOpenGLVertexBufferObjectGroup> Buffers;
  int NumberOfPoints = 0;
  double LargestRadius = 0.0;
  double LargestSprite = 0.0;
  std::unique_ptr<Pass> DepthPass;
  std::unique_ptr<Pass> LightPass;
  std::unique_ptr<Pass> IdPass;
  /// One for each form that render passes give the fragment shader.
  std::map<std::string, std::unique_ptr<vtkOpenGLQuadHelper>> Composites;
};

#endif
