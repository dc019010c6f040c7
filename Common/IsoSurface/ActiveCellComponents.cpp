// SPDX-License-Identifier: BSD-3-Clause
#include "IsoSurface/ActiveCellComponents.h"

#include "Core/ParallelChunks.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

namespace ink
{
namespace
{

/// Disjoint sets that threads unite at once: a root is linked to a lesser one only, so that each set's root
/// ends up as its least element, whatever the order.
class ConcurrentSets
{
public:
  explicit ConcurrentSets(std::size_t count)
    : Parents(count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Parents[i].store(static_cast<std::uint32_t>(i), std::memory_order_relaxed);
    }
  }

  std::uint32_t root(std::uint32_t i)
  {
    std::uint32_t parent = this->Parents[i].load(std::memory_order_relaxed);
    while (parent != i)
    {
      // Halves the path; a parent that another thread has set meanwhile is as good.
      const std::uint32_t above = this->Parents[parent].load(std::memory_order_relaxed);
      this->Parents[i].compare_exchange_weak(parent, above, std::memory_order_relaxed);
      i = above;
      parent = this->Parents[i].load(std::memory_order_relaxed);
    }
    return i;
  }

  void unite(std::uint32_t a, std::uint32_t b)
  {
    for (;;)
    {
      a = this->root(a);
      b = this->root(b);
      if (a == b)
      {
        return;
      }
      std::uint32_t greater = std::max(a, b);
      // Fails if the greater is no root any more.
      if (this->Parents[greater].compare_exchange_strong(greater, std::min(a, b), std::memory_order_relaxed))
      {
        return;
      }
    }
  }

private:
  std::vector<std::atomic<std::uint32_t>> Parents;
};

} // namespace

ActiveCellComponents findActiveCellComponents(std::span<const ActiveCellId> cells)
{
  if (cells.size() >= std::numeric_limits<std::uint32_t>::max())
  {
    throw std::invalid_argument(
      "findActiveCellComponents: expected fewer than 2^32 cells, found " + std::to_string(cells.size()));
  }
  if (std::adjacent_find(cells.begin(), cells.end(), std::greater_equal<>()) != cells.end())
  {
    throw std::invalid_argument("findActiveCellComponents: expected ascending cells");
  }
  ConcurrentSets sets(cells.size());
  parallelForChunks(cells.size(),
    [&](std::size_t, std::size_t begin, std::size_t end)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        // Walks along with the cells.
        const ActiveCellId step = activeCellStep(axis);
        auto before = std::lower_bound(cells.begin(), cells.end(), cells[begin] - step);
        for (std::size_t i = begin; i < end; ++i)
        {
          const ActiveCellId wanted = cells[i] - step;
          while (*before < wanted)
          {
            ++before;
          }
          if (*before == wanted)
          {
            sets.unite(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(before - cells.begin()));
          }
        }
      }
    });

  ActiveCellComponents components;
  components.labels.resize(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    // A root comes before all others of its set.
    const std::uint32_t root = sets.root(static_cast<std::uint32_t>(i));
    if (root == i)
    {
      components.labels[i] = static_cast<std::uint32_t>(components.counts.size());
      components.counts.push_back(0);
    }
    else
    {
      components.labels[i] = components.labels[root];
    }
    ++components.counts[components.labels[i]];
  }
  return components;
}

std::vector<char> selectComponents(std::span<const std::size_t> counts, const ComponentSelection& selection)
{
  if (counts.empty())
  {
    return {};
  }
  const auto greatest = static_cast<double>(*std::max_element(counts.begin(), counts.end()));
  const double least = selection.smallestShare < 0.0
    ? std::max(0.001 * greatest, std::min(static_cast<double>(selection.speck), 0.1 * greatest))
    : selection.smallestShare * greatest;
  std::vector<std::size_t> order(counts.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(
    order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return counts[a] > counts[b]; });
  const std::size_t most = selection.largest == 0 ? counts.size() : selection.largest;
  std::vector<char> kept(counts.size(), 0);
  for (std::size_t n = 0; n < std::min(most, order.size()); ++n)
  {
    kept[order[n]] = static_cast<double>(counts[order[n]]) >= least;
  }
  return kept;
}

} // namespace ink
