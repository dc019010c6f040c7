// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSplatQuads_h
#define InkSplatQuads_h

#include "InkSplatStyle.h"

#include "vtkSmartPointer.h"

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

class InkSplatImage;
struct InkView;
class vtkAbstractMapper;
class vtkActor;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;

/// The passes over whole images, for one window. What is bound is drawn into.
class InkSplatQuads
{
public:
  explicit InkSplatQuads(vtkOpenGLRenderWindow* window);
  ~InkSplatQuads();
  InkSplatQuads(const InkSplatQuads&) = delete;
  void operator=(const InkSplatQuads&) = delete;

  /// I1 and I2 of a layer.
  /// @param sums of splats for each pixel, and those for 2 x 2 and 4 x 4 pixels as far as there are any
  /// @param tolerances of the depth test: view units, and by slope, texels of the sums
  void DrawIllumination(const InkView& view, const InkSplatImage& surface,
    const std::vector<const InkSplatImage*>& sums, const std::array<double, 2>& tolerances);

  /// The ink of a layer as an image that speckles were taken from, lines made thin, wide or broken, in one
  /// component; null where the style asks for nothing of the kind.
  /// @param scratch of the size of the illumination, is bound and drawn into
  vtkSmartPointer<vtkTextureObject> WorkOn(const InkSplatStyle& style, int layer, const InkView& view,
    const InkSplatImage& illumination, InkSplatImage& scratch);

  /// The ink of a layer.
  /// @param colors of the nearest points, or null
  /// @param coverage from WorkOn, or null
  /// @param reach pixels by which ink may go beyond the surface
  void DrawInk(const InkSplatStyle& style, int layer, const InkSplatImage& illumination,
    const InkSplatImage* colors, vtkTextureObject* coverage, int reach);

  /// The drawing into the caller's framebuffer, viewport and blending. The render passes that the actor takes
  /// part in (depth peeling) may change the shader.
  /// @param paperColor null: ink alone
  /// @param reach pixels by which ink may go beyond the surface
  /// @param depthBias view units that the ink lies in front of the surface
  void DrawComposite(const InkView& view, const InkSplatImage& surface, const InkSplatImage& ink,
    const double paperColor[3], double opacity, int reach, double depthBias, vtkAbstractMapper* mapper,
    vtkActor* actor);

private:
  vtkOpenGLQuadHelper& Find(
    const std::string& vertexShader, const std::string& fragmentShader, const std::string& geometryShader);
  vtkShaderProgram* Begin(vtkOpenGLQuadHelper& quad);

  vtkOpenGLRenderWindow* Window;
  std::map<std::string, std::unique_ptr<vtkOpenGLQuadHelper>> Quads; ///< by their shaders
};

#endif
