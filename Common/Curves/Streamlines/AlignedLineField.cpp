// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Streamlines/AlignedLineField.h"

#include "Core/ParallelChunks.h"
#include "Curvature/PrincipalCurvature.h"
#include "Curvature/TurnedTangent.h"
#include "Curves/Streamlines/ConnectionMultigrid.h"
#include "Mesh/OnePerPoint.h"
#include "Mesh/PointGroups.h"
#include "Mesh/PointTriangles.h"

#include <glm/geometric.hpp>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ink
{

namespace
{

/// Keeps the matrix positive definite where no point prefers anything.
constexpr double leastPreference = 1e-6;
/// Of cotangents: a triangle ties its corners to each other, whatever its shape.
constexpr double leastCotangent = 0.05;
constexpr double mostCotangent = 20.0;
/// Of groups of points, in reaches: over so little, directions differ by turns alone.
constexpr double groupRadius = 1.0 / 6.0;
constexpr double tolerance = 1e-3;
constexpr int mostIterations = 200;

using Complex = ConnectionMultigrid::Scalar;
using Matrix = ConnectionMultigrid::Matrix;
using Vector = ConnectionMultigrid::Vector;

struct Stopped
{
};

/// Tells progress: it is applied once in each iteration.
class WatchedPreconditioner : public ConnectionMultigrid
{
public:
  Progress progress;

  /// @throws Stopped
  Vector solve(const Vector& residual) const
  {
    if (this->progress && !this->progress(std::min(1.0 * this->Iteration++ / mostIterations, 1.0)))
    {
      throw Stopped();
    }
    return ConnectionMultigrid::solve(residual);
  }

private:
  mutable int Iteration = 0;
};

/// Tangent vectors as complex numbers.
class TangentPlanes
{
public:
  explicit TangentPlanes(std::span<const glm::vec3> normals)
    : Normals(normals)
  {
  }

  bool has(std::size_t point) const { return this->Normals[point] != glm::vec3(0.0f); }
  /// Squared and of length 1; 0 of a vector that has no direction.
  Complex squared(const glm::dvec3& vector, std::size_t point) const
  {
    const auto [x, y] = this->axes(point);
    const Complex z(glm::dot(vector, x), glm::dot(vector, y));
    const double size = std::norm(z);
    return size > 0.0 ? z * z / size : Complex(0.0);
  }
  /// From one plane to another, of length 1.
  Complex turn(std::size_t from, std::size_t to) const
  {
    const glm::dvec3 axis = this->axes(from)[0];
    return this->squared(
      turnedTangent(axis, glm::dvec3(this->Normals[from]), glm::dvec3(this->Normals[to])), to);
  }
  glm::dvec3 root(const Complex& squared, std::size_t point) const
  {
    const auto [x, y] = this->axes(point);
    const double angle = 0.5 * std::arg(squared);
    return glm::normalize(std::cos(angle) * x + std::sin(angle) * y);
  }

private:
  std::array<glm::dvec3, 2> axes(std::size_t point) const
  {
    return tangentAxes(glm::dvec3(this->Normals[point]));
  }

  std::span<const glm::vec3> Normals;
};

/// Half of the cotangents of a triangle's angles, each that of the edge that it faces; zeros if it has no
/// area.
std::array<double, 3> halfCotangents(const TriangleMesh& mesh, const Triangle& triangle)
{
  std::array<double, 3> result{};
  const std::array<glm::dvec3, 3> p{ mesh.points[triangle[0]], mesh.points[triangle[1]],
    mesh.points[triangle[2]] };
  const double area = glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
  for (std::size_t i = 0; i < 3 && area > 0.0 && std::isfinite(area); ++i)
  {
    const double cosine = glm::dot(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]);
    result[i] = 0.5 * std::clamp(cosine / area, leastCotangent, mostCotangent);
  }
  return result;
}

/// The unknowns: one for each group of points, whose directions differ by turns alone.
class Unknowns
{
public:
  Unknowns(const TriangleMesh& mesh, std::span<const glm::vec3> normals, double radius)
    : Mesh(mesh)
    , Planes(normals)
    , Around(mesh)
    , Groups(groupPoints(mesh, this->Around, normals, radius))
    , Radius(radius)
  {
    this->Turns.resize(mesh.points.size(), Complex(1.0));
    this->Centers.resize(this->Groups.size());
    for (std::size_t group = 0; group < this->Groups.size(); ++group)
    {
      const std::span<const std::uint32_t> members = this->Groups.of(group);
      for (const std::uint32_t point : members)
      {
        this->Centers[group] += mesh.points[point] / static_cast<double>(members.size());
        this->Turns[point] = point == members[0] ? Complex(1.0) : this->Planes.turn(members[0], point);
      }
    }
  }

  /// The matrix of the sum, and its right side.
  /// @param preferenceOf(point) finite
  template <class PreferenceOf>
  std::pair<Matrix, Vector> equations(
    std::span<const glm::dvec3> directions, double reach, const PreferenceOf& preferenceOf) const
  {
    const auto size = static_cast<Eigen::Index>(this->Groups.size());
    Matrix matrix(size, size);
    Vector wanted = Vector::Zero(size);
    std::vector<Complex> row(this->Groups.size()); // of those that it names
    std::vector<std::uint32_t> names;
    for (std::size_t group = 0; group < this->Groups.size(); ++group)
    {
      const auto own = static_cast<Eigen::Index>(group);
      names.assign(1, static_cast<std::uint32_t>(group));
      double diagonal = 0.0;
      for (const std::uint32_t point : this->Groups.of(group))
      {
        const double found = this->addTies(point, row, names);
        // A point without area is alone.
        const double area = found > 0.0 ? found / reach / reach : 1.0;
        const double preference = preferenceOf(point);
        diagonal += area * (std::abs(preference) + leastPreference);
        if (preference != 0.0)
        {
          wanted[own] += area * preference * std::conj(this->Turns[point]) *
            this->Planes.squared(directions[point], point);
        }
      }
      row[group] += diagonal;
      std::sort(names.begin(), names.end());
      names.erase(std::unique(names.begin(), names.end()), names.end());
      matrix.startVec(own);
      for (const std::uint32_t name : names)
      {
        matrix.insertBack(own, name) = row[name];
        row[name] = 0.0;
      }
    }
    matrix.finalize();
    return { std::move(matrix), std::move(wanted) };
  }

  /// A point's number: between those of its group and of the ones tied to it.
  Complex at(const Matrix& matrix, const Vector& found, std::size_t point) const
  {
    const std::uint32_t group = this->Groups.ofPoints[point];
    Complex sum(0.0);
    for (Matrix::InnerIterator tie(matrix, group); tie; ++tie)
    {
      const auto other = static_cast<std::size_t>(tie.col());
      const std::uint32_t middle = this->Groups.of(other)[0];
      const double away =
        glm::distance(this->Mesh.points[point], this->Centers[other]) / (2.0 * this->Radius);
      if (away < 1.0 && this->Planes.has(middle))
      {
        sum +=
          (1.0 - away * away) * (1.0 - away * away) * this->Planes.turn(middle, point) * found[tie.col()];
      }
    }
    return this->Groups.of(group).size() > 1 && sum != Complex(0.0) ? sum : this->Turns[point] * found[group];
  }

  const TangentPlanes& planes() const { return this->Planes; }

private:
  /// Adds the ties of a point to those of other groups. @return a third of the area of its triangles
  double addTies(std::uint32_t point, std::vector<Complex>& row, std::vector<std::uint32_t>& names) const
  {
    const std::uint32_t group = this->Groups.ofPoints[point];
    double area = 0.0;
    for (const std::uint32_t t : this->Around.of(point))
    {
      const Triangle& triangle = this->Mesh.triangles[t];
      const std::array<double, 3> weights = halfCotangents(this->Mesh, triangle);
      if (weights[0] == 0.0)
      {
        continue;
      }
      area += glm::length(glm::cross(this->Mesh.points[triangle[1]] - this->Mesh.points[triangle[0]],
                this->Mesh.points[triangle[2]] - this->Mesh.points[triangle[0]])) /
        6.0;
      for (std::size_t i = 0; i < 3; ++i)
      {
        const std::uint32_t other = triangle[i];
        const std::uint32_t to = this->Groups.ofPoints[other];
        if (to == group || !this->Planes.has(point) || !this->Planes.has(other))
        {
          continue;
        }
        // Across the same border groups are farther from each other than points are.
        const double between = glm::distance(this->Centers[group], this->Centers[to]);
        const double edge = glm::distance(this->Mesh.points[point], this->Mesh.points[other]);
        const double weight = weights[point == triangle[(i + 1) % 3] ? (i + 2) % 3 : (i + 1) % 3] *
          (edge < between ? edge / between : 1.0);
        const Complex turn =
          other < point ? this->Planes.turn(other, point) : std::conj(this->Planes.turn(point, other));
        if (row[to] == Complex(0.0))
        {
          names.push_back(to);
        }
        row[to] -= weight * std::conj(this->Turns[point]) * turn * this->Turns[other];
        row[group] += weight;
      }
    }
    return area;
  }

  const TriangleMesh& Mesh;
  TangentPlanes Planes;
  PointTriangles Around;
  PointGroups Groups;
  double Radius;
  std::vector<Complex> Turns; ///< from the plane of each point's group's middle to its own
  std::vector<glm::dvec3> Centers;
};

} // namespace

std::vector<glm::dvec3> alignedLineField(const TriangleMesh& mesh, std::span<const glm::vec3> normals,
  std::span<const glm::dvec3> directions, std::span<const float> preferences, double reach,
  const Progress& progress)
{
  checkOnePerPoint(mesh, normals.size(), "normals");
  checkOnePerPoint(mesh, directions.size(), "directions");
  checkOnePerPoint(mesh, preferences.size(), "preferences");
  const Unknowns unknowns(mesh, normals, groupRadius * reach);
  const TangentPlanes& planes = unknowns.planes();
  const auto preferenceOf = [&](std::size_t i)
  {
    const bool isKnown = planes.has(i) && std::isfinite(preferences[i]) && directions[i] != glm::dvec3(0.0);
    return isKnown ? static_cast<double>(preferences[i]) : 0.0;
  };
  const auto [matrix, wanted] = unknowns.equations(directions, reach, preferenceOf);
  std::vector<glm::dvec3> result(directions.begin(), directions.end());
  if (wanted.isZero(0.0))
  {
    return result;
  }
  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper, WatchedPreconditioner> solver;
  solver.preconditioner().progress = progress;
  solver.setTolerance(tolerance);
  solver.setMaxIterations(mostIterations);
  solver.compute(matrix);
  try
  {
    const Vector found = solver.solve(wanted);
    parallelForEach(result.size(),
      [&, &ties = matrix](std::size_t i)
      {
        if (const Complex u = planes.has(i) ? unknowns.at(ties, found, i) : Complex(0.0); u != Complex(0.0))
        {
          result[i] = planes.root(u, i);
        }
      });
  }
  catch (const Stopped&)
  {
    // Left as they are.
  }
  return result;
}

} // namespace ink
