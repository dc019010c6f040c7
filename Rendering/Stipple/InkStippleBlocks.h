// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStippleBlocks_h
#define InkStippleBlocks_h

#include "InkStippleView.h"

#include <array>
#include <vector>

struct InkViewUniforms;

/// Elements that lie close together and are alike. On the GPU the stipples of a sequence of blocks, a group,
/// stand one after the other: the first of each element, then the second of each, and so on, so that one run
/// holds what is drawn of many blocks, many of each element or few.
struct InkStippleBlock
{
  struct Run
  {
    int First;
    int Count;
  };

  std::array<float, 3> Low{}; ///< of its stipples' box, in the local frame
  std::array<float, 3> High{};
  float LargestValue = 0.0f;
  float LargestGradient = 0.0f;
  std::array<float, 3> Axis{}; ///< of a cone around its elements' normals, unit length
  float LeastCosine = -1.0f;   ///< of half that cone's angle; -1: there is none
  int Group = 0;               ///< blocks of a group follow each other
  std::vector<Run> Runs;       ///< its stipples, by rank
};

/// Which stipples are worth looking at: a list of runs for one draw call.
struct InkStippleRuns
{
  std::vector<int> Firsts;
  std::vector<int> Counts;

  /// Leaves out blocks beyond the edges of the view and, of the others, the stipples that no element of the
  /// block will draw (see Tone::mostTone): those that face away, are in full light, ...
  /// @param margin how far in pixels stipples reach beyond their centers
  void Find(const std::vector<InkStippleBlock>& blocks, const InkViewUniforms& view,
    const ink::stipple::Tone& tone, const InkStippleView& toneView, float margin);

  /// All stipples.
  void Fill(int numberOfStipples);

  long long GetNumberOfStipples() const;

private:
  void Add(const InkStippleBlock::Run& run);
};

#endif
