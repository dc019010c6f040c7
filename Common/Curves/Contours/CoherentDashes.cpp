// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/CoherentDashes.h"

#include "Core/KdTree.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

namespace ink
{
namespace
{

/// Over how many periods dashes give way to each other. Measured on contours of scans that turn by a degree a
/// frame: with 1, dashes slide by a third of what the shift of whole chains leaves, and are two or three
/// hundredths longer or shorter, on average, however long it turns.
constexpr double Elasticity = 1.0;

/// Periods of two frames are the same up to this share.
constexpr double SamePeriod = 5e-3;

/// A chain's points, with lengths in periods.
struct Chain
{
  std::vector<double> steps;  ///< lengths of its segments, the one that closes it included
  std::vector<double> phases; ///< of its points, as its own arc length gives them
  double closingPhase = 0.0;  ///< of the first point, once around
  bool closed = false;

  Chain(const Contours& contours, std::size_t number, double period)
    : closed(contours.chains.closed[number] != 0)
  {
    const std::size_t begin = contours.chains.offsets[number];
    const std::size_t end = contours.chains.offsets[number + 1];
    for (std::size_t point = begin; point < end; ++point)
    {
      this->phases.push_back(contours.arcLength[point] / period);
      if (point > begin)
      {
        this->steps.push_back(this->phases[point - begin] - this->phases[point - begin - 1]);
      }
    }
    this->closingPhase = this->phases.back();
    if (this->closed)
    {
      this->steps.push_back(glm::distance(contours.positions[end - 1], contours.positions[begin]) / period);
      this->closingPhase += this->steps.back();
      const double whole = this->closingPhase - this->phases.front();
      this->stretch(whole > 0.0 ? this->periods() / whole : 1.0);
      this->closingPhase = this->phases.front() + this->periods();
    }
  }

  /// A whole number, of a closed chain.
  double periods() const { return std::max(std::round(this->closingPhase - this->phases.front()), 1.0); }

  void stretch(double factor)
  {
    for (double& phase : this->phases)
    {
      phase *= factor;
    }
  }

  /// The half lengths of both segments at a point.
  double weightOf(std::size_t point) const
  {
    const double after = point < this->steps.size() ? this->steps[point] : 0.0;
    const double before = point > 0 ? this->steps[point - 1] : this->closed ? this->steps.back() : 0.0;
    return 0.5 * (before + after);
  }

  /// Who closes a chain adds the last segment's own length: what the fit to whole periods changes, the others
  /// take.
  void keepClosingSegment()
  {
    const double others = this->phases.back() - this->phases.front();
    if (this->closed && others > 0.0)
    {
      this->stretch((this->periods() - this->steps.back()) / others);
    }
  }
};

/// What a chain's points are to have of the frame before; of weight 0 where nothing is in reach.
struct Targets
{
  std::vector<double> phases;
  std::vector<double> weights;
};

/// To the nearest whole number.
double withoutPeriods(double phase)
{
  return phase - std::round(phase);
}

/// The displacements of the least energy: of springs from the points to their targets, and of an elastic line
/// along the chain; the segment that closes a chain is rigid.
/// @param residuals of the targets, in periods, at most a half
std::vector<double> relax(
  const Chain& chain, std::span<const double> residuals, std::span<const double> weights)
{
  constexpr double shortest = 1e-6; // periods
  constexpr double held = 1e-9;     // so that a line without targets has a solution
  const auto count = static_cast<int>(residuals.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right(count);
  double stiffest = 0.0;
  const auto join = [&](int a, int b, double stiffness)
  {
    stiffest = std::max(stiffest, stiffness);
    entries.emplace_back(a, a, stiffness);
    entries.emplace_back(b, b, stiffness);
    entries.emplace_back(a, b, -stiffness);
    entries.emplace_back(b, a, -stiffness);
  };
  for (int i = 0; i < count; ++i)
  {
    // A target half a period away does not say to which side.
    const double near = std::cos(std::numbers::pi * residuals[i]);
    const double spring = weights[i] * near * near;
    entries.emplace_back(i, i, spring + held);
    right[i] = spring * residuals[i];
    if (i + 1 < count)
    {
      join(i, i + 1, Elasticity * Elasticity / std::max(chain.steps[i], shortest));
    }
  }
  if (chain.closed)
  {
    join(count - 1, 0, 1e3 * stiffest);
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  const Eigen::VectorXd solution = solver.solve(right);
  return { solution.begin(), solution.end() };
}

/// Moves a chain's phases to where their targets are.
/// @param elastic or only as a whole
void approach(Chain& chain, const Targets& targets, bool elastic)
{
  std::complex<double> sum = 0.0;
  for (std::size_t i = 0; i < chain.phases.size(); ++i)
  {
    sum += std::polar(targets.weights[i], 2.0 * std::numbers::pi * (targets.phases[i] - chain.phases[i]));
  }
  const double shift = std::arg(sum) / (2.0 * std::numbers::pi);
  std::vector<double> residuals;
  for (std::size_t i = 0; i < chain.phases.size(); ++i)
  {
    chain.phases[i] += shift;
    residuals.push_back(withoutPeriods(targets.phases[i] - chain.phases[i]));
  }
  chain.closingPhase += shift;
  if (elastic)
  {
    const std::vector<double> moved = relax(chain, residuals, targets.weights);
    for (std::size_t i = 0; i < moved.size(); ++i)
    {
      chain.phases[i] += moved[i];
    }
    chain.closingPhase += moved.front();
  }
}

} // namespace

void CoherentDashes::align(Contours& contours, double period, double reach)
{
  std::optional<KdTree> before;
  if (!this->Middles.empty())
  {
    before.emplace(this->Middles);
  }
  const glm::dvec3 origin = before || contours.positions.empty() ? this->Origin : contours.positions.front();
  const bool elastic = std::abs(period - this->Period) <= SamePeriod * period;
  const auto local = [&](std::size_t point) { return glm::vec3(contours.positions[point] - origin); };
  /// The phase of the frame before at a point, and whether there is one.
  const auto phaseBefore = [&](const glm::vec3& position)
  {
    std::uint32_t nearest;
    before->find(position, { &nearest, 1 });
    const Segment& segment = this->Segments[nearest];
    const glm::vec3 way = segment.end - segment.begin;
    const float square = glm::dot(way, way);
    const float share =
      square > 0.0f ? glm::clamp(glm::dot(position - segment.begin, way) / square, 0.0f, 1.0f) : 0.0f;
    return std::pair<double, bool>(glm::mix(segment.phaseAtBegin, segment.phaseAtEnd, share),
      glm::distance(segment.begin + share * way, position) <= reach);
  };
  std::vector<Segment> segments;
  for (std::size_t number = 0; number < contours.chains.size(); ++number)
  {
    if (contours.kinds[number] != ContourKind::Silhouette)
    {
      continue; // it does not move
    }
    const std::size_t begin = contours.chains.offsets[number];
    const std::size_t count = contours.chains.offsets[number + 1] - begin;
    Chain chain(contours, number, period);
    Targets targets;
    for (std::size_t point = 0; before && point < count; ++point)
    {
      const auto [phase, near] = phaseBefore(local(begin + point));
      targets.phases.push_back(phase);
      targets.weights.push_back(near ? chain.weightOf(point) : 0.0);
    }
    if (std::ranges::any_of(targets.weights, [](double weight) { return weight > 0.0; }))
    {
      chain.keepClosingSegment();
      approach(chain, targets, elastic);
      for (std::size_t point = 0; point < count; ++point)
      {
        contours.arcLength[begin + point] = chain.phases[point] * period;
      }
    }
    for (std::size_t i = 0; i < chain.steps.size(); ++i)
    {
      const bool closes = i + 1 == count;
      const double phase = chain.phases[i];
      const double next = closes ? chain.closingPhase : chain.phases[i + 1];
      const double whole = std::floor(phase);
      segments.push_back({ local(begin + i), local(closes ? begin : begin + i + 1),
        static_cast<float>(phase - whole), static_cast<float>(next - whole) });
    }
  }
  this->Origin = origin;
  this->Middles.clear();
  for (const Segment& segment : segments)
  {
    this->Middles.push_back(0.5f * (segment.begin + segment.end));
  }
  this->Segments = std::move(segments);
  this->Period = period;
}

} // namespace ink
