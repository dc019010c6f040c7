// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSplatDrawing_h
#define InkSplatDrawing_h

#include "InkSplatImage.h"
#include "InkSplatStyle.h"
#include "InkSplatting.h"
#include "InkView.h"

#include "vtkType.h"

#include <memory>
#include <optional>
#include <vector>

class InkSplatPasses;
class InkSplatQuads;
class vtkAbstractMapper;
class vtkActor;

/// The drawing of one actor in one renderer: what of it is up to date stays, so that a changed style costs no
/// splats and an unchanged view nothing but the last pass.
class InkSplatDrawing
{
public:
  /// Draws into the caller's framebuffer, viewport and blending; else leaves the OpenGL state as it was.
  /// @param opacity of the whole
  /// @return false when this OpenGL cannot draw into the images that are needed
  bool Draw(InkSplatPasses& passes, InkSplatQuads& quads, const InkView& view, const InkSplatting& splatting,
    const InkSplatStyle& style, const double paperColor[3], double opacity, vtkAbstractMapper* mapper,
    vtkActor* actor);

  /// The layers that there are, up to those asked for.
  int GetNumberOfLayers() const { return this->Present; }

private:
  /// One sheet of surface behind the other, and what is drawn of it.
  struct Layer
  {
    std::unique_ptr<InkSplatImage> Colors;
    std::unique_ptr<InkSplatImage> Surface;
    std::unique_ptr<InkSplatImage> Illumination;
    std::unique_ptr<InkSplatImage> Ink;
  };

  bool Allocate(InkSplatPasses& passes, const InkView& view, const InkSplatting& splatting);
  bool AllocateLayer(
    InkSplatPasses& passes, const InkView& view, const InkSplatting& splatting, Layer& layer);
  bool DrawSplats(
    InkSplatPasses& passes, InkSplatQuads& quads, const InkView& view, const InkSplatting& splatting);
  bool DrawSurface(
    InkSplatPasses& passes, const InkView& view, const InkSplatting& splatting, std::size_t index);
  void DrawInk(InkSplatPasses& passes, InkSplatQuads& quads, const InkView& view, const InkSplatStyle& style);

  std::unique_ptr<InkSplatImage> ZBuffer;
  std::vector<std::unique_ptr<InkSplatImage>> Sums; ///< for each pixel, for 2 x 2, for 4 x 4
  std::vector<Layer> Layers;
  int Present = 0;
  int Reach = 0; ///< pixels by which ink may go beyond the surface

  std::optional<InkView> View;
  std::optional<InkSplatting> Splatting;
  std::optional<InkSplatStyle> Style;
  vtkMTimeType UploadTime = 0;
};

#endif
