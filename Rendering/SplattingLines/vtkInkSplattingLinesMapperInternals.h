// SPDX-License-Identifier: BSD-3-Clause
#ifndef vtkInkSplattingLinesMapperInternals_h
#define vtkInkSplattingLinesMapperInternals_h

#include "vtkInkSplattingLinesMapper.h"

#include "InkActorResources.h"
#include "InkMarks.h"
#include "InkSplatDrawing.h"
#include "InkSplatPasses.h"
#include "InkSplatPoints.h"
#include "InkSplatQuads.h"
#include "InkSplatStyle.h"

#include <array>
#include <optional>
#include <string>

/// The points on the GPU, for one window, and the drawings of them.
class vtkInkSplattingLinesMapper::vtkMarks : public InkMarks
{
public:
  explicit vtkMarks(vtkOpenGLRenderWindow* window)
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
    vtkMTimeType Edges;
    vtkMTimeType Ghosts;
    vtkMTimeType Ids;
    std::string Colors;
    double Radius;
    bool operator==(const Source&) const = default;
  };

  vtkMTimeType GetUploadTime() const override { return this->Passes.GetUploadTime(); }

  InkSplatPasses Passes;
  InkSplatQuads Quads;
  std::optional<Source> PointsSource; ///< what the points on the GPU were made from
  vtkMTimeType OrderTime = 0;         ///< of the priorities that the order is by; 0: by chance
  InkActorResources<InkSplatDrawing> Drawings;
};

/// What the mapper keeps.
class vtkInkSplattingLinesMapper::vtkInternals
{
public:
  InkSplatPoints Points;
  std::optional<vtkMarks::Source> PointsSource; ///< what Points was read from
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
