// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStippleWindow_h
#define InkStippleWindow_h

#include "InkStippleInput.h"
#include "InkStippleOccluder.h"
#include "InkStipplePasses.h"

#include "vtkActor.h"
#include "vtkRenderer.h"
#include "vtkWeakPointer.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

/// What the stipple mapper has on the GPU for one window, and what that was made from.
class InkStippleWindow
{
public:
  explicit InkStippleWindow(vtkOpenGLRenderWindow* window)
    : Passes(window)
    , Occluder(window)
  {
  }

  /// The depth image for one actor in one renderer; null before it is first drawn.
  std::unique_ptr<InkStippleDepth>& FindDepth(vtkRenderer* renderer, vtkActor* actor)
  {
    std::erase_if(this->Depths, [](const Depth& d) { return !d.Renderer || !d.Actor; });
    for (Depth& depth : this->Depths)
    {
      if (depth.Renderer == renderer && depth.Actor == actor)
      {
        return depth.Image;
      }
    }
    Depth& depth = this->Depths.emplace_back();
    depth.Renderer = renderer;
    depth.Actor = actor;
    return depth.Image;
  }

  struct Source
  {
    InkStippleInput::Key Input;
    int PositionPrecision;
    bool operator==(const Source&) const = default;
  };

  InkStipplePasses Passes;
  std::optional<Source> Stipples;    ///< what those of Passes were made from
  std::optional<std::string> Colors; ///< as InkScalarColors describes those of Passes
  InkStippleOccluder Occluder;

private:
  struct Depth
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    vtkWeakPointer<vtkActor> Actor;
    std::unique_ptr<InkStippleDepth> Image;
  };
  std::vector<Depth> Depths;
};

#endif
