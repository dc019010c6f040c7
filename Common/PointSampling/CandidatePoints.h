// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// A sample on a surface, with the normal that decides which samples keep a distance from each other.
struct SpacedSample
{
  glm::vec3 position;
  glm::vec3 normal;    ///< unit; 0: unknown
  std::uint32_t piece; ///< of the surface that contains it
  float b1;            ///< barycentric coordinates in the piece
  float b2;
  std::uint32_t rank; ///< lower ranks are chosen earlier
};

/// Candidates for samples of a small part of a surface, of which a subset with a minimum distance is chosen.
/// Each candidate stores its distance to the nearest chosen one, and choosing one updates its neighborhood: a
/// vectorizable loop over cells whose candidates are contiguous in memory, where searching the neighborhood
/// of each candidate would traverse lists.
///
/// Samples on different sides or sheets of a surface need no distance, see areApart in SurfaceSides.h.
class CandidatePoints
{
public:
  void clear();
  void add(const SpacedSample& candidate) { this->Unsorted.push_back(candidate); }
  /// To be called after the last add().
  /// @param cell the side of the cells that candidates are sorted into
  void sort(float cell);

  /// The box of all candidates.
  const glm::vec3& low() const { return this->Low; }
  const glm::vec3& high() const { return this->High; }

  /// Excludes candidates closer than `radius` to a sample at all radii larger than their distance.
  void keepAway(const SpacedSample& sample, float radius);

  /// For one radius after the other, chooses in order of rank the candidates that are at least that far from
  /// all chosen ones.
  /// @param radii decreasing
  /// @param choose(sample, index): the sample, and which of the radii it was chosen at
  template <class Choose>
  void choose(std::span<const float> radii, const Choose& choose);

private:
  std::vector<SpacedSample> Unsorted;
  std::vector<std::uint32_t> Cells;  // of the unsorted
  std::vector<std::uint32_t> Sorted; // indices of the unsorted, cell by cell
  std::vector<std::uint32_t> Begin;  // of each cell
  glm::vec3 Low{ 0.0f };
  glm::vec3 High{ 0.0f };
  glm::ivec3 Size{ 0 };
  float Cell = 1.0f;
  // In the order of cells, with a vector more at the end.
  std::vector<float> X, Y, Z;
  std::vector<float> NormalX, NormalY, NormalZ;
  std::vector<float> Square; // of the distance to the nearest chosen one
  std::vector<std::uint32_t> Open;
  std::vector<std::uint64_t> Due;
};

template <class Choose>
void CandidatePoints::choose(std::span<const float> radii, const Choose& choose)
{
  const float last = radii.back() * radii.back();
  this->Open.clear();
  for (std::uint32_t i = 0; i < this->Unsorted.size(); ++i)
  {
    if (this->Square[i] >= last)
    {
      this->Open.push_back(i);
    }
  }
  for (std::size_t level = 0; level < radii.size(); ++level)
  {
    const float square = radii[level] * radii[level];
    this->Due.clear();
    std::size_t open = 0;
    for (const std::uint32_t i : this->Open)
    {
      if (this->Square[i] >= square)
      {
        this->Due.push_back(std::uint64_t(this->Unsorted[this->Sorted[i]].rank) << 32 | i);
      }
      else if (this->Square[i] >= last)
      {
        this->Open[open++] = i;
      }
    }
    this->Open.resize(open);
    std::sort(this->Due.begin(), this->Due.end());
    for (const std::uint64_t due : this->Due)
    {
      const auto i = static_cast<std::uint32_t>(due);
      if (this->Square[i] >= square)
      {
        const SpacedSample& sample = this->Unsorted[this->Sorted[i]];
        this->keepAway(sample, radii[level]);
        choose(sample, level);
      }
      else if (this->Square[i] >= last)
      {
        this->Open.push_back(i);
      }
    }
  }
}

} // namespace ink
