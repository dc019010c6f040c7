// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Streamlines/FlatDirections.h"

#include "Mesh/BorderEdges.h"
#include "Mesh/ConnectedParts.h"

#include <Eigen/Eigenvalues>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace ink
{

namespace
{

constexpr double mostThickness = 0.03; ///< of the width
constexpr double leastFacing = 0.9;    ///< of all area to one side
constexpr double leastAlignment = 0.5; ///< of the border's edges
constexpr double nearlyEqual = 1.1;    ///< of extents

/// How a part lies in space.
struct Shape
{
  double area = 0.0;
  glm::dvec3 areaVector{ 0.0 };
  glm::dvec3 first{ 0.0 };  ///< moment: integral of the position
  glm::dmat3 second{ 0.0 }; ///< integral of its outer product with itself
  // Once it is known to be flat:
  bool isFlat = false;
  glm::dvec3 axisX{ 0.0 };
  glm::dvec3 axisY{ 0.0 };
  std::complex<double> borders;
  double borderLength = 0.0;

  void add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
  {
    const glm::dvec3 vector = 0.5 * glm::cross(b - a, c - a);
    const double size = glm::length(vector);
    if (!std::isfinite(size))
    {
      return;
    }
    const glm::dvec3 sum = a + b + c;
    this->area += size;
    this->areaVector += vector;
    this->first += size / 3.0 * sum;
    this->second += size / 12.0 *
      (glm::outerProduct(a, a) + glm::outerProduct(b, b) + glm::outerProduct(c, c) +
        glm::outerProduct(sum, sum));
  }

  glm::dmat3 covariance() const
  {
    const glm::dvec3 middle = this->first / this->area;
    return this->second / this->area - glm::outerProduct(middle, middle);
  }

  void findPlane()
  {
    if (!(this->area > 0.0))
    {
      return;
    }
    const glm::dmat3 c = this->covariance();
    Eigen::Matrix3d matrix;
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        matrix(row, column) = c[column][row];
      }
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
    const Eigen::Vector3d& values = solver.eigenvalues();
    const Eigen::Matrix3d& vectors = solver.eigenvectors();
    const glm::dvec3 normal(vectors(0, 0), vectors(1, 0), vectors(2, 0));
    this->isFlat = values[0] <= mostThickness * mostThickness * values[1] &&
      std::abs(glm::dot(this->areaVector, normal)) > leastFacing * this->area;
    this->axisX = { vectors(0, 2), vectors(1, 2), vectors(2, 2) };
    this->axisY = glm::cross(normal, this->axisX);
  }

  void addBorder(const glm::dvec3& edge)
  {
    const std::complex<double> along(glm::dot(edge, this->axisX), glm::dot(edge, this->axisY));
    if (const double length = std::abs(along); length > 0.0)
    {
      const std::complex<double> squared = along / length * along / length;
      this->borders += length * squared * squared;
      this->borderLength += length;
    }
  }

  glm::dvec3 direction() const
  {
    const bool isAligned = std::abs(this->borders) > leastAlignment * this->borderLength;
    const glm::dmat3 c = this->covariance();
    const auto extent = [&c](const glm::dvec3& axis)
    { return std::sqrt(std::max(glm::dot(axis, c * axis), 0.0)); };
    const double angle = isAligned ? 0.25 * std::arg(this->borders) : 0.0;
    glm::dvec3 along = std::cos(angle) * this->axisX + std::sin(angle) * this->axisY;
    glm::dvec3 across = std::cos(angle) * this->axisY - std::sin(angle) * this->axisX;
    if (extent(along) < extent(across))
    {
      std::swap(along, across);
    }
    if (extent(along) > nearlyEqual * extent(across))
    {
      return along;
    }
    const glm::dvec3 normal = glm::cross(along, across);
    constexpr double steep = 0.9;
    const glm::dvec3 wanted =
      std::abs(normal.x) < steep ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    if (isAligned)
    {
      return std::abs(glm::dot(along, wanted)) >= std::abs(glm::dot(across, wanted)) ? along : across;
    }
    return glm::normalize(wanted - glm::dot(wanted, normal) * normal);
  }
};

} // namespace

std::vector<glm::dvec3> flatDirections(const TriangleMesh& mesh)
{
  const std::vector<std::uint32_t> parts = connectedParts(mesh);
  std::vector<Shape> shapes(parts.empty() ? 0 : *std::max_element(parts.begin(), parts.end()) + 1);
  // Relative to a point of the part, so that moments do not cancel out far away from the origin.
  std::vector<glm::dvec3> origins(shapes.size());
  for (std::size_t i = mesh.points.size(); i-- > 0;)
  {
    origins[parts[i]] = mesh.points[i];
  }
  for (const auto& [a, b, c] : mesh.triangles)
  {
    const std::uint32_t part = parts[a];
    const glm::dvec3& origin = origins[part];
    shapes[part].add(mesh.points[a] - origin, mesh.points[b] - origin, mesh.points[c] - origin);
  }
  for (Shape& shape : shapes)
  {
    shape.findPlane();
  }
  const auto isFlat = [&](const Triangle& triangle) { return shapes[parts[triangle[0]]].isFlat; };
  for (const auto& [from, to] : borderEdges(mesh, isFlat))
  {
    shapes[parts[from]].addBorder(mesh.points[to] - mesh.points[from]);
  }
  std::vector<glm::dvec3> ofPart(shapes.size(), glm::dvec3(0.0));
  std::transform(shapes.begin(), shapes.end(), ofPart.begin(),
    [](const Shape& shape) { return shape.isFlat ? shape.direction() : glm::dvec3(0.0); });
  std::vector<glm::dvec3> result;
  result.reserve(mesh.points.size());
  for (const std::uint32_t part : parts)
  {
    result.push_back(ofPart[part]);
  }
  return result;
}

} // namespace ink
