// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Streamlines/CombCrossField.h"

#include "Curvature/SurfaceRings.h"
#include "Curves/Streamlines/SignedMultigrid.h"
#include "Curves/Streamlines/TurnedTangent.h"
#include "Mesh/OnePerPoint.h"

#include <glm/geometric.hpp>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace ink
{

namespace
{

/// Keeps the matrix positive definite where no point prefers anything.
constexpr double leastPreference = 1e-6;
/// Only signs matter.
constexpr double tolerance = 1e-2;
constexpr int mostIterations = 100;

using Matrix = SignedMultigrid::Matrix;

struct Stopped
{
};

/// Tells progress: it is applied once in each iteration.
class WatchedPreconditioner : public SignedMultigrid
{
public:
  Progress progress;

  /// @throws Stopped
  Eigen::VectorXd solve(const Eigen::VectorXd& residual) const
  {
    if (this->progress && !this->progress(std::min(1.0 * this->Iteration++ / mostIterations, 1.0)))
    {
      throw Stopped();
    }
    return SignedMultigrid::solve(residual);
  }

private:
  mutable int Iteration = 0;
};

} // namespace

std::vector<unsigned char> combCrossField(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  std::span<const glm::dvec3> directions, std::span<const float> preferences, double reach,
  const Progress& progress, Seams seams)
{
  const std::size_t count = mesh.points.size();
  checkOnePerPoint(mesh, normals.size(), "normals");
  checkOnePerPoint(mesh, directions.size(), "directions");
  checkOnePerPoint(mesh, preferences.size(), "preferences");
  const SurfaceRings rings(mesh, seams);
  const auto isDefined = [&](std::size_t i)
  { return normals[i] != glm::vec3(0.0f) && directions[i] != glm::dvec3(0.0); };

  // From each point to its neighbors: of points that coincide only one is others' neighbor.
  struct Edge
  {
    std::size_t from;
    std::size_t to;
    double cosine; ///< of twice the angle
  };
  std::vector<Edge> edges;
  double lengths = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    for (const std::uint32_t j : rings.ring(rings.site(i)))
    {
      const double length = glm::distance(mesh.points[i], mesh.points[j]);
      if (!isDefined(i) || !isDefined(j) || !std::isfinite(length))
      {
        continue;
      }
      const double cosine =
        glm::dot(directions[i], turnedTangent(directions[j], glm::dvec3(normals[j]), glm::dvec3(normals[i])));
      edges.push_back({ i, j, 2.0 * cosine * cosine - 1.0 });
      lengths += length;
    }
  }
  if (edges.empty() || !(lengths > 0.0))
  {
    return std::vector<unsigned char>(count);
  }

  const double edgesInReach = reach * static_cast<double>(edges.size()) / lengths;
  const double weight = edgesInReach * edgesInReach;
  const auto size = static_cast<Eigen::Index>(count);
  Eigen::VectorXd diagonal = Eigen::VectorXd::Constant(size, leastPreference);
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(size);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double preference = std::isfinite(preferences[i]) ? static_cast<double>(preferences[i]) : 0.0;
    diagonal[static_cast<Eigen::Index>(i)] += std::abs(preference);
    wanted[static_cast<Eigen::Index>(i)] = preference;
  }
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  entries.reserve(count + 2 * edges.size());
  for (const Edge& edge : edges)
  {
    const auto from = static_cast<Eigen::Index>(edge.from);
    const auto to = static_cast<Eigen::Index>(edge.to);
    diagonal[from] += weight * std::abs(edge.cosine);
    diagonal[to] += weight * std::abs(edge.cosine);
    entries.emplace_back(from, to, -weight * edge.cosine);
    entries.emplace_back(to, from, -weight * edge.cosine);
  }
  for (Eigen::Index i = 0; i < size; ++i)
  {
    entries.emplace_back(i, i, diagonal[i]);
  }
  Matrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper, WatchedPreconditioner> solver;
  solver.preconditioner().progress = progress;
  solver.setTolerance(tolerance);
  solver.setMaxIterations(mostIterations);
  solver.compute(matrix);

  std::vector<unsigned char> exchanged(count);
  try
  {
    const Eigen::VectorXd signs = solver.solve(wanted);
    for (std::size_t i = 0; i < count; ++i)
    {
      exchanged[i] = signs[static_cast<Eigen::Index>(i)] < 0.0 ? 1 : 0;
    }
  }
  catch (const Stopped&)
  {
    return std::vector<unsigned char>(count);
  }
  return exchanged;
}

} // namespace ink
