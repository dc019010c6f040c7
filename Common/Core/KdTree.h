// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <memory>
#include <span>

namespace ink
{

/// A k-d tree for k-nearest-neighbor queries, using nanoflann.
class KdTree
{
public:
  static constexpr int most = 64;

  /// @param points finite ones only. Kept as a reference.
  explicit KdTree(std::span<const glm::vec3> points);
  ~KdTree();
  KdTree(const KdTree&) = delete;
  KdTree& operator=(const KdTree&) = delete;

  /// The indices of the points nearest to a position, the nearest first; ties are broken by index.
  /// @param result its size is the number of neighbors: at most `most`, and no more than there are points
  void find(const glm::vec3& position, std::span<std::uint32_t> result) const;

private:
  struct Tree;
  std::unique_ptr<const Tree> Index;
};

} // namespace ink
