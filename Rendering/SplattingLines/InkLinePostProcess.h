// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkLinePostProcess_h
#define InkLinePostProcess_h

#include "InkSplatStyle.h"

#include "Raster/CoverageImage.h"
#include "Raster/Despeckle.h"

struct InkViewUniforms;

/// What is done to a layer's lines as an image: speckles removed, lines made thin, wider and broken.
class InkLinePostProcess
{
public:
  InkLinePostProcess(const InkSplatStyle& style, int layer, const InkViewUniforms& view);

  /// Whether anything is to be done.
  bool IsNeeded() const;

  /// By how many pixels ink may go beyond the surface.
  int GetReach() const;

  /// How many pixels beyond a tile count for what is in it.
  int GetMargin() const;

  void Apply(const ink::raster::CoverageImage& image) const;

private:
  // All in pixels.
  float SpeckleLength;
  bool Thinning;
  float Growth;
  float DashLength;
  float GapLength;
  ink::raster::CutBorders Cut;
};

#endif
