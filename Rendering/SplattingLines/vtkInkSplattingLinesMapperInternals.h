// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkInkSplattingLinesMapperInternals_h
#define vtkInkSplattingLinesMapperInternals_h

#include "vtkInkSplattingLinesMapper.h"

#include "InkSplatDrawing.h"
#include "InkSplatPasses.h"
#include "InkSplatPoints.h"
#include "InkSplatQuads.h"
#include "InkSplatStyle.h"

#include "vtkActor.h"
#include "vtkRenderer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

/// What the mapper keeps.
class vtkInkSplattingLinesMapper::vtkInternals
{
public:
  /// What the points on the GPU were made from; modification times are unique, so no pointers are needed.
  struct Source
  {
    vtkMTimeType Points;
    vtkMTimeType Normals;
    vtkMTimeType Radii;
    std::string Colors;
    double Radius;
    bool operator==(const Source&) const = default;
  };

  struct Drawing
  {
    vtkWeakPointer<vtkRenderer> Renderer;
    vtkWeakPointer<vtkActor> Actor;
    InkSplatDrawing Splats;
  };

  Drawing& Find(vtkRenderer* renderer, vtkActor* actor)
  {
    std::erase_if(this->Drawings, [](const Drawing& d) { return !d.Renderer || !d.Actor; });
    for (Drawing& drawing : this->Drawings)
    {
      if (drawing.Renderer == renderer && drawing.Actor == actor)
      {
        return drawing;
      }
    }
    Drawing& drawing = this->Drawings.emplace_back();
    drawing.Renderer = renderer;
    drawing.Actor = actor;
    return drawing;
  }

  InkSplatPoints Points;
  vtkMTimeType OrderTime = 0;         ///< of the priorities that the order is by; 0: by chance
  std::optional<Source> PointsSource; ///< what Points was read from
  vtkMTimeType ReportedTime = 0;      ///< of the input whose errors were reported
  std::set<std::string> ReportedErrors;
  std::unique_ptr<InkSplatPasses> Passes;
  std::unique_ptr<InkSplatQuads> Quads;
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
  /// Whether anything changed.
  bool Set(int layer, double LayerStyle::*property, double value, double least, double most)
  {
    LayerStyle* style = this->FindLayer(layer);
    if (!style || std::isnan(value))
    {
      return false;
    }
    const double before = std::exchange(style->*property, std::clamp(value, least, most));
    return style->*property != before;
  }
  double Get(int layer, double LayerStyle::*property)
  {
    const LayerStyle* style = this->FindLayer(layer);
    return style ? style->*property : 0.0;
  }

  unsigned long WindowObserver = 0;
  std::vector<Drawing> Drawings;
};

#endif
