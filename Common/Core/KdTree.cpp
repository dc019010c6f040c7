// SPDX-License-Identifier: BSD-3-Clause
#include "Core/KdTree.h"

#include <nanoflann.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <utility>

namespace ink
{

namespace
{

constexpr std::size_t leafSize = 10;

/// The points as nanoflann asks for them.
struct Points
{
  std::span<const glm::vec3> all;

  std::size_t kdtree_get_point_count() const { return this->all.size(); }
  float kdtree_get_pt(std::uint32_t i, std::size_t axis) const
  {
    return this->all[i][static_cast<int>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const
  {
    return false;
  }
};

/// What nanoflann hands the points that it finds to. Its own takes equally near ones as they come.
class Nearest
{
public:
  explicit Nearest(std::size_t wanted)
    : Wanted(wanted)
  {
  }

  std::size_t size() const { return this->Found; }
  bool full() const { return this->Found == this->Wanted; }
  void sort() {} // asked for from nanoflann 1.5 on; they are sorted

  /// From which squared distance on nothing is of use: a little above that of the last, as nanoflann asks
  /// only for less than this, and adds up the distance of a branch with rounding.
  float worstDist() const { return this->Worst; }

  /// @return whether to go on
  bool addPoint(float squared, std::uint32_t index)
  {
    const std::pair<float, std::uint32_t> entry(squared, index);
    if (this->full())
    {
      if (!(entry < this->Entries[this->Found - 1]))
      {
        return true;
      }
      --this->Found;
    }
    std::size_t i = this->Found++;
    for (; i > 0 && entry < this->Entries[i - 1]; --i)
    {
      this->Entries[i] = this->Entries[i - 1];
    }
    this->Entries[i] = entry;
    if (this->full())
    {
      constexpr float rounding = 1.0f + 1.0f / 1024.0f;
      this->Worst = this->Entries[this->Found - 1].first * rounding + std::numeric_limits<float>::min();
    }
    return true;
  }

  std::uint32_t operator[](std::size_t i) const { return this->Entries[i].second; }

private:
  std::size_t Wanted;
  std::size_t Found = 0;
  float Worst = std::numeric_limits<float>::infinity();
  std::array<std::pair<float, std::uint32_t>, KdTree::most> Entries; // squared distance and index, sorted
};

} // namespace

struct KdTree::Tree
{
  using Metric = nanoflann::L2_Simple_Adaptor<float, Points, float, std::uint32_t>;

  Points points;
  nanoflann::KDTreeSingleIndexAdaptor<Metric, Points, 3, std::uint32_t> index;

  explicit Tree(std::span<const glm::vec3> all)
    : points{ all }
    , index(3, this->points, nanoflann::KDTreeSingleIndexAdaptorParams(leafSize))
  {
  }
};

KdTree::KdTree(std::span<const glm::vec3> points)
  : Index(std::make_unique<const Tree>(points))
{
}

KdTree::~KdTree() = default;

void KdTree::find(const glm::vec3& position, std::span<std::uint32_t> result) const
{
  Nearest nearest(result.size());
  this->Index->index.findNeighbors(nearest, &position.x, {});
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    result[i] = nearest[i];
  }
}

} // namespace ink
