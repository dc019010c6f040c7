// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSplatDrawing_h
#define InkSplatDrawing_h

#include "InkRenderTarget.h"
#include "InkSplatSettings.h"
#include "InkSplatStyle.h"
#include "InkViewUniforms.h"

#include "vtkType.h"

#include <memory>
#include <optional>
#include <vector>

class InkDrawingProgress;
class InkSplatPasses;
class InkSplatQuads;
struct InkFrame;
class vtkAbstractMapper;

/// The drawing of one actor in one renderer: what of it is up to date stays, so that a changed style costs no
/// splats and an unchanged view nothing but the last pass.
class InkSplatDrawing
{
public:
  /// Draws into the caller's framebuffer, viewport and blending; else leaves the OpenGL state as it was.
  /// @return false when this OpenGL cannot draw into the images that are needed
  bool Draw(InkSplatPasses& passes, InkSplatQuads& quads, const InkViewUniforms& view,
    const InkSplatSettings& splatting, const InkSplatStyle& style, const double paperColor[3],
    vtkAbstractMapper* mapper, const InkFrame& frame);

  /// The layers that there are, up to those asked for.
  int GetNumberOfLayers() const { return this->Present; }

private:
  /// One sheet of surface behind the other, and what is drawn of it.
  struct Layer
  {
    std::unique_ptr<InkRenderTarget> Colors;
    std::unique_ptr<InkRenderTarget> Surface;
    std::unique_ptr<InkRenderTarget> Illumination;
    std::unique_ptr<InkRenderTarget> Ink;
  };

  bool Allocate(InkSplatPasses& passes, const InkViewUniforms& view, const InkSplatSettings& splatting);
  bool AllocateLayer(
    InkSplatPasses& passes, const InkViewUniforms& view, const InkSplatSettings& splatting, Layer& layer);
  bool DrawSplats(InkSplatPasses& passes, InkSplatQuads& quads, const InkViewUniforms& view,
    const InkSplatSettings& splatting, InkDrawingProgress& progress);
  bool DrawSurface(InkSplatPasses& passes, const InkViewUniforms& view, const InkSplatSettings& splatting,
    std::size_t index, InkDrawingProgress& progress);
  void DrawInk(
    InkSplatPasses& passes, InkSplatQuads& quads, const InkViewUniforms& view, const InkSplatStyle& style);

  /// How much of the picture is there with this part, 0 to 1, of a layer's splats.
  double FindProgress(std::size_t layer, double part) const;

  std::unique_ptr<InkRenderTarget> ZBuffer;
  std::vector<std::unique_ptr<InkRenderTarget>> Sums; ///< for each pixel, for 2 x 2, for 4 x 4
  std::vector<Layer> Layers;
  int Present = 0;
  int Reach = 0; ///< pixels by which ink may go beyond the surface

  std::optional<InkViewUniforms> View;
  std::optional<InkSplatSettings> Splatting;
  std::optional<InkSplatStyle> Style;
  vtkMTimeType UploadTime = 0;
};

#endif
