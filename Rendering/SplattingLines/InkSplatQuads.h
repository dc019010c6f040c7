// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSplatQuads_h
#define InkSplatQuads_h

#include "InkFullScreenPasses.h"
#include "InkSplatStyle.h"

#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class InkRenderTarget;
struct InkViewUniforms;
class vtkAbstractMapper;
class vtkActor;
class vtkOpenGLRenderWindow;
class vtkTextureObject;

/// The passes over whole images, for one window. What is bound is drawn into.
class InkSplatQuads
{
public:
  explicit InkSplatQuads(vtkOpenGLRenderWindow* window);

  /// The images that the ink of a layer is made from.
  struct Sheet
  {
    const InkRenderTarget& Surface;
    const InkRenderTarget& Illumination;
    const InkRenderTarget* Colors;    ///< of the nearest points, or null
    std::array<double, 2> Tolerances; ///< of the depth test: view units, and by slope, pixels
    bool Averaged; ///< whether ink is that of the pixel's area or, as published, of its middle
  };

  /// I1 and I2 of a layer.
  /// @param sums of splats for each pixel, and those for 2 x 2 and 4 x 4 pixels as far as there are any
  /// @param tolerances of the depth test: view units, and by slope, texels of the sums
  /// @param outline whether a line is along the surface's border also where it does not turn away
  void DrawIllumination(const InkViewUniforms& view, const InkRenderTarget& surface,
    const std::vector<const InkRenderTarget*>& sums, const std::array<double, 2>& tolerances, bool outline);

  /// The ink of a layer as an image that speckles were taken from, lines made thin, wide or broken, in one
  /// component; null where the style asks for nothing of the kind.
  /// @param scratch of the size of the illumination, is bound and drawn into
  vtkSmartPointer<vtkTextureObject> WorkOn(const InkSplatStyle& style, int layer, const InkViewUniforms& view,
    const Sheet& sheet, InkRenderTarget& scratch);

  /// The ink of a layer.
  /// @param coverage from WorkOn, or null
  /// @param reach pixels by which ink may go beyond the surface
  void DrawInk(const InkSplatStyle& style, int layer, const InkViewUniforms& view, const Sheet& sheet,
    vtkTextureObject* coverage, int reach);

  /// The drawing into the caller's framebuffer, viewport and blending. The render passes that the actor takes
  /// part in (depth peeling) may change the shader.
  /// @param paperColor null: ink alone
  /// @param reach pixels by which ink may go beyond the surface
  /// @param depthBias view units that the ink lies in front of the surface
  void DrawComposite(const InkViewUniforms& view, const InkRenderTarget& surface, const InkRenderTarget& ink,
    const double paperColor[3], double opacity, int reach, double depthBias, vtkAbstractMapper* mapper,
    vtkActor* actor);

private:
  InkFullScreenPasses Passes;
};

#endif
