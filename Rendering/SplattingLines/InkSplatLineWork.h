// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSplatLineWork_h
#define InkSplatLineWork_h

#include "InkSplatStyle.h"

#include "Lines/InkImage.h"
#include "Lines/RemoveSpeckles.h"

struct InkView;

/// What is done to a layer's lines as an image: speckles removed, lines made thin, wider and broken.
class InkSplatLineWork
{
public:
  InkSplatLineWork(const InkSplatStyle& style, int layer, const InkView& view);

  /// Whether anything is to be done.
  bool IsNeeded() const;

  /// By how many pixels ink may go beyond the surface.
  int GetReach() const;

  /// How many pixels beyond a tile count for what is in it.
  int GetMargin() const;

  void Apply(const ink::InkImage& image) const;

private:
  // All in pixels.
  float SpeckleLength;
  bool Thinning;
  float Growth;
  float DashLength;
  float GapLength;
  ink::CutBorders Cut;
};

#endif
