#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace ink
{

/// Finds the nearest of a set of points: a k-d tree.
class NearestPoints
{
public:
  static constexpr int most = 64;

  /// @param points all finite. Kept as a reference.
  explicit NearestPoints(std::span<const glm::vec3> points);

  /// The indices of the nearest points to a place, the nearest first; equally near ones in the order of their
  /// indices.
  /// @param result as many as are wanted: at most `most`, and no more than there are points
  void find(const glm::vec3& place, std::span<std::uint32_t> result) const;

private:
  struct Search;
  void split(std::size_t begin, std::size_t end);
  void visit(std::size_t begin, std::size_t end, Search& search) const;
  static int widestAxis(const glm::vec3& low, const glm::vec3& high);

  std::span<const glm::vec3> Points;
  std::vector<std::uint32_t> Order; // each middle one splits the rest of its range
  std::vector<std::uint8_t> Axes;   // along which
};

} // namespace ink
