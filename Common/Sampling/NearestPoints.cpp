#include "Sampling/NearestPoints.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace ink
{

namespace
{

constexpr std::size_t leafSize = 12;

} // namespace

struct NearestPoints::Search
{
  glm::vec3 place;
  std::size_t wanted;
  std::size_t found = 0;
  std::array<std::pair<float, std::uint32_t>, most> nearest{}; // squared distance and index, sorted

  void offer(float squared, std::uint32_t index)
  {
    const std::pair<float, std::uint32_t> entry(squared, index);
    if (this->found == this->wanted)
    {
      if (!(entry < this->nearest[this->found - 1]))
      {
        return;
      }
      --this->found;
    }
    std::size_t i = this->found++;
    for (; i > 0 && entry < this->nearest[i - 1]; --i)
    {
      this->nearest[i] = this->nearest[i - 1];
    }
    this->nearest[i] = entry;
  }
};

NearestPoints::NearestPoints(std::span<const glm::vec3> points)
  : Points(points)
  , Order(points.size())
  , Axes(points.size())
{
  std::iota(this->Order.begin(), this->Order.end(), 0u);
  this->split(0, points.size());
}

int NearestPoints::widestAxis(const glm::vec3& low, const glm::vec3& high)
{
  const glm::vec3 size = high - low;
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

void NearestPoints::split(std::size_t begin, std::size_t end)
{
  if (end - begin <= leafSize)
  {
    return;
  }
  glm::vec3 low = this->Points[this->Order[begin]];
  glm::vec3 high = low;
  for (std::size_t i = begin; i < end; ++i)
  {
    low = glm::min(low, this->Points[this->Order[i]]);
    high = glm::max(high, this->Points[this->Order[i]]);
  }
  const int axis = widestAxis(low, high);
  const std::size_t middle = begin + (end - begin) / 2;
  std::nth_element(this->Order.begin() + begin, this->Order.begin() + middle, this->Order.begin() + end,
    [&](std::uint32_t a, std::uint32_t b)
    { return std::pair(this->Points[a][axis], a) < std::pair(this->Points[b][axis], b); });
  this->Axes[middle] = static_cast<std::uint8_t>(axis);
  this->split(begin, middle);
  this->split(middle + 1, end);
}

void NearestPoints::visit(std::size_t begin, std::size_t end, Search& search) const
{
  const auto offer = [&](std::uint32_t index)
  {
    const glm::vec3 offset = this->Points[index] - search.place;
    search.offer(glm::dot(offset, offset), index);
  };
  if (end - begin <= leafSize)
  {
    std::for_each(this->Order.begin() + begin, this->Order.begin() + end, offer);
    return;
  }
  const std::size_t middle = begin + (end - begin) / 2;
  const int axis = this->Axes[middle];
  const float side = search.place[axis] - this->Points[this->Order[middle]][axis];
  const bool lowerFirst = side < 0.0f;
  this->visit(lowerFirst ? begin : middle + 1, lowerFirst ? middle : end, search);
  offer(this->Order[middle]);
  if (search.found < search.wanted || side * side <= search.nearest[search.found - 1].first)
  {
    this->visit(lowerFirst ? middle + 1 : begin, lowerFirst ? end : middle, search);
  }
}

void NearestPoints::find(const glm::vec3& place, std::span<std::uint32_t> result) const
{
  Search search{ place, result.size() };
  this->visit(0, this->Points.size(), search);
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    result[i] = search.nearest[i].second;
  }
}

} // namespace ink
