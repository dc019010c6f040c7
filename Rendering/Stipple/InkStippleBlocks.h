// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStippleBlocks_h
#define InkStippleBlocks_h

#include "InkStippleView.h"

#include <array>
#include <cmath>
#include <vector>

struct InkView;

/// A group of elements that lie close together. Its stipples stand one after the other on the GPU: the first
/// of each element, then the second of each, and so on, so that a beginning of them is enough where few of
/// each element are to be drawn.
struct InkStippleBlock
{
  std::array<float, 3> Low{}; ///< of its stipples' box, in the local frame
  std::array<float, 3> High{};
  float LargestValue = 0.0f;
  float LargestGradient = 0.0f;
  std::array<float, 3> Axis{}; ///< of a cone around its elements' normals, unit length
  float Spread = INFINITY;     ///< half that cone's angle in radians; from pi on there is none
  int First = 0;               ///< of its stipples
  std::vector<int> Ends;       ///< by rank: the number of its stipples up to that rank
};

/// Which stipples are worth looking at: a list of runs for one draw call.
struct InkStippleRuns
{
  std::vector<int> Firsts;
  std::vector<int> Counts;

  /// Leaves out blocks beyond the edges of the view and, of the others, the stipples that no element of the
  /// block will draw (see StippleTone::mostTone): those that face away, are in full light, ...
  /// @param margin how far in pixels stipples reach beyond their centres
  void Find(const std::vector<InkStippleBlock>& blocks, const InkView& view, const ink::StippleTone& tone,
    const InkStippleView& toneView, float margin);

  /// All stipples.
  void Fill(const std::vector<InkStippleBlock>& blocks);

  long long GetNumberOfStipples() const;

private:
  void Add(int first, int count);
};

#endif
