// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkInkSplattingLinesMapperInternals_h
#define vtkInkSplattingLinesMapperInternals_h

#include "vtkInkSplattingLinesMapper.h"

#include "InkReportedMessages.h"
#include "InkSplatDrawing.h"
#include "InkSplatPasses.h"
#include "InkSplatPoints.h"
#include "InkSplatQuads.h"
#include "InkSplatStyle.h"
#include "InkWindowResources.h"

#include "vtkActor.h"
#include "vtkRenderer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// What the mapper keeps on the GPU for one window.
class vtkInkSplattingLinesMapper::vtkWindowResources
{
public:
  explicit vtkWindowResources(vtkOpenGLRenderWindow* window)
    : Passes(window)
    , Quads(window)
  {
  }

  /// What the points on the GPU were made from; modification times are unique, so no pointers are needed.
  struct Source
  {
    vtkMTimeType Points;
    vtkMTimeType Normals;
    vtkMTimeType Radii;
    vtkMTimeType Ghosts;
    std::string Colors;
    double Radius;
    bool operator==(const Source&) const = default;
  };

  /// The drawing of an actor in a renderer, null if there is none.
  InkSplatDrawing* Find(vtkRenderer* renderer, vtkActor* actor)
  {
    const auto found = std::find_if(this->Drawings.begin(), this->Drawings.end(),
      [&](const Drawing& d) { return d.Renderer == renderer && d.Actor == actor; });
    return found == this->Drawings.end() ? nullptr : &found->Splats;
  }

  /// The same, made if there is none; those of actors and renderers that are gone go, for which the window's
  /// context must be current.
  InkSplatDrawing& Get(vtkRenderer* renderer, vtkActor* actor)
  {
    std::erase_if(this->Drawings, [](const Drawing& d) { return !d.Renderer || !d.Actor; });
    if (InkSplatDrawing* found = this->Find(renderer, actor))
    {
      return *found;
    }
    Drawing& drawing = this->Drawings.emplace_back();
    drawing.Renderer = renderer;
    drawing.Actor = actor;
    return drawing.Splats;
  }

  InkSplatPasses Passes;
  InkSplatQuads Quads;
  std::optional<Source> PointsSource; ///< what the points on the GPU were made from
  vtkMTimeType OrderTime = 0;         ///< of the priorities that the order is by; 0: by chance

private:
  struct Drawing
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    vtkWeakPointer<vtkActor> Actor;
    InkSplatDrawing Splats;
  };
  std::vector<Drawing> Drawings;
};

/// What the mapper keeps.
class vtkInkSplattingLinesMapper::vtkInternals
{
public:
  InkSplatPoints Points;
  std::optional<vtkWindowResources::Source> PointsSource; ///< what Points was read from
  InkReportedMessages Reported;
  InkWindowResources<vtkWindowResources> Windows;
  struct LayerStyle
  {
    std::optional<std::array<double, 3>> Color;
    double Strength = 1.0;
    double LineWidth = 0.0;
    double DashLength = 0.0;
  };
  std::array<LayerStyle, InkSplatStyle::MostLayers> Layers;

  /// Null for a layer that there cannot be.
  LayerStyle* FindLayer(int layer)
  {
    return layer >= 0 && layer < InkSplatStyle::MostLayers ? &this->Layers[static_cast<std::size_t>(layer)]
                                                           : nullptr;
  }
  double Get(int layer, double LayerStyle::*property)
  {
    const LayerStyle* style = this->FindLayer(layer);
    return style ? style->*property : 0.0;
  }
};

#endif
