// SPDX-License-Identifier: BSD-3-Clause
#include "Visibility/SeenTriangles.h"

#include "Core/IsFinite.h"
#include "Core/ParallelChunks.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

namespace ink
{

namespace
{

constexpr int longestSide = 1024; ///< of the picture, pixels
constexpr double leastMargin = 2.0;
constexpr double mostMargin = 256.0;
constexpr double widestTangent = 2.0;
/// Pixels that triangles reach beyond their edges, so that none is missed between two.
constexpr double overlap = 1e-4;
/// Of the mesh's size: what is nearer to the eye's plane has no place in the picture.
constexpr double nearest = 1e-6;

/// A point of the mesh in the picture.
struct ProjectedPoint
{
  glm::dvec2 pixel; ///< not finite: there is none, it lies behind the eye
  /// Larger for what is nearer to the eye, positive, and linear in the picture: with perspective one over
  /// depth.
  double nearness;

  bool isInFront() const { return std::isfinite(this->pixel.x); }
};

/// The mesh as the eye sees it.
struct Projection
{
  std::vector<ProjectedPoint> points;
  int width = 0; ///< pixels; 0: nothing is in front of the eye
  int height = 0;
  bool parallel = false;
  double pixel = 0.0; ///< the size of one; with perspective at a depth of 1

  Projection(const TriangleMesh& mesh, const Eye& eye, const glm::dvec3& axis);

  bool contains(const glm::dvec2& at) const
  {
    return at.x >= 0.0 && at.y >= 0.0 && at.x < this->width && at.y < this->height;
  }
  std::size_t index(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(this->width) + static_cast<std::size_t>(x);
  }
  /// How near a point is that lies as many pixels' sizes nearer.
  double nearer(double nearness, double pixels) const
  {
    return this->parallel ? nearness + pixels * this->pixel
                          : nearness / (1.0 - std::min(pixels * this->pixel, 0.5));
  }
};

Projection::Projection(const TriangleMesh& mesh, const Eye& eye, const glm::dvec3& axis)
  : points(mesh.points.size())
  , parallel(eye.parallel)
{
  const glm::dvec3 forward = glm::normalize(axis);
  const glm::dvec3 aside = std::abs(forward.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, aside));
  const glm::dvec3 up = glm::cross(right, forward);
  const glm::dvec3 origin = eye.parallel ? glm::dvec3(0.0) : eye.position;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  struct Range
  {
    glm::dvec3 lower = glm::dvec3(infinite);
    glm::dvec3 upper = glm::dvec3(-infinite);

    void add(const glm::dvec3& p)
    {
      this->lower = glm::min(this->lower, p);
      this->upper = glm::max(this->upper, p);
    }
  };
  const auto inView = [&](std::size_t i)
  {
    const glm::dvec3 from = mesh.points[i] - origin;
    return glm::dvec3(glm::dot(from, right), glm::dot(from, up), glm::dot(from, forward));
  };
  const auto joined = [](const Range& a, const Range& b) {
    return Range{ glm::min(a.lower, b.lower), glm::max(a.upper, b.upper) };
  };
  const Range all = parallelReduce(
    mesh.points.size(), Range(),
    [&](std::size_t i)
    {
      Range own;
      if (const glm::dvec3 p = inView(i); isFinite(p))
      {
        own.add(p);
      }
      return own;
    },
    joined);
  const double least = nearest * glm::distance(all.lower, all.upper);
  const auto onPlane = [&](const glm::dvec3& p)
  { return this->parallel ? glm::dvec2(p) : glm::dvec2(p) / (p.z > least ? p.z : 0.0); };
  const Range shown = parallelReduce(
    mesh.points.size(), Range(),
    [&](std::size_t i)
    {
      Range own;
      const glm::dvec3 p = inView(i);
      if (const glm::dvec2 at = onPlane(p); std::isfinite(at.x) && std::isfinite(at.y))
      {
        const double widest = this->parallel ? infinite : widestTangent;
        own.add({ glm::clamp(at, -widest, widest), 0.0 });
      }
      return own;
    },
    joined);
  const glm::dvec2 size = shown.upper - shown.lower;
  if (!(std::max(size.x, size.y) > 0.0))
  {
    std::fill(this->points.begin(), this->points.end(), ProjectedPoint{ glm::dvec2(infinite), 0.0 });
    return;
  }
  this->pixel = std::max(size.x, size.y) / longestSide;
  this->width = static_cast<int>(size.x / this->pixel) + 1;
  this->height = static_cast<int>(size.y / this->pixel) + 1;
  parallelForEach(mesh.points.size(),
    [&](std::size_t i)
    {
      const glm::dvec3 p = inView(i);
      const glm::dvec2 at = onPlane(p);
      const bool isInFront = std::isfinite(at.x) && std::isfinite(at.y);
      this->points[i] = { isInFront ? (at - glm::dvec2(shown.lower)) / this->pixel : glm::dvec2(infinite),
        this->parallel ? all.upper.z - p.z + this->pixel : 1.0 / p.z };
    });
}

/// Calls visit(index, nearness) for the pixels whose centers lie in a triangle, its edges among it, until it
/// returns true. @return whether it did
template <class Visit>
bool visitPixels(const Projection& picture, const Triangle& triangle, const Visit& visit)
{
  const ProjectedPoint& a = picture.points[triangle[0]];
  const ProjectedPoint& b = picture.points[triangle[1]];
  const ProjectedPoint& c = picture.points[triangle[2]];
  const glm::dvec2 ab = b.pixel - a.pixel;
  const glm::dvec2 ac = c.pixel - a.pixel;
  const double area = ab.x * ac.y - ab.y * ac.x;
  const glm::dvec2 lower = glm::min(a.pixel, glm::min(b.pixel, c.pixel));
  const glm::dvec2 upper = glm::max(a.pixel, glm::max(b.pixel, c.pixel));
  if (area == 0.0)
  {
    return false;
  }
  const auto firstCenter = [](double from)
  { return static_cast<int>(std::ceil(std::clamp(from, 0.0, 2.0 * longestSide) - overlap - 0.5)); };
  const auto lastCenter = [](double to, int count)
  { return static_cast<int>(std::floor(std::clamp(to + overlap, 0.0, static_cast<double>(count)) - 0.5)); };
  const auto [least, most] = std::minmax({ a.nearness, b.nearness, c.nearness });
  // Corners' weights along a row, each its value at x = 0 and its slope.
  const glm::dvec3 slopes((ab.y - ac.y) / area, ac.y / area, -ab.y / area);
  const int lastRow = lastCenter(upper.y, picture.height);
  for (int y = firstCenter(lower.y); y <= lastRow; ++y)
  {
    const glm::dvec2 from(-a.pixel.x, y + 0.5 - a.pixel.y);
    const double second = (from.x * ac.y - from.y * ac.x) / area;
    const double third = (ab.x * from.y - ab.y * from.x) / area;
    const glm::dvec3 starts(1.0 - second - third, second, third);
    double left = lower.x;
    double right = upper.x;
    for (int corner = 0; corner < 3; ++corner)
    {
      const double zero = -starts[corner] / slopes[corner];
      left = slopes[corner] > 0.0 ? std::max(left, zero) : left;
      right = slopes[corner] < 0.0 ? std::min(right, zero) : right;
    }
    const int lastX = lastCenter(right, picture.width);
    for (int x = firstCenter(left); x <= lastX; ++x)
    {
      const glm::dvec3 weights = starts + (x + 0.5) * slopes;
      const double nearness = weights.x * a.nearness + weights.y * b.nearness + weights.z * c.nearness;
      if (visit(picture.index(x, y), std::clamp(nearness, least, most)))
      {
        return true;
      }
    }
  }
  return false;
}

/// How many of a triangle's points are in front of the eye.
int countInFront(const Projection& picture, const Triangle& triangle)
{
  return static_cast<int>(std::count_if(triangle.begin(), triangle.end(),
    [&](std::uint32_t point) { return picture.points[point].isInFront(); }));
}

/// For each pixel how near the nearest surface is; 0 where there is none.
std::vector<float> nearestSurfaces(const TriangleMesh& mesh, const Projection& picture)
{
  std::vector<float> image(picture.index(0, picture.height));
  parallelForEach(mesh.triangles.size(),
    [&](std::size_t t)
    {
      if (countInFront(picture, mesh.triangles[t]) < 3)
      {
        return;
      }
      visitPixels(picture, mesh.triangles[t],
        [&](std::size_t index, double nearness)
        {
          // A maximum is the same in any order.
          const std::atomic_ref<float> kept(image[index]);
          const auto found = static_cast<float>(nearness);
          float before = kept.load(std::memory_order_relaxed);
          while (before < found && !kept.compare_exchange_weak(before, found, std::memory_order_relaxed))
          {
          }
          return false;
        });
    });
  return image;
}

/// Each pixel becomes the least within a square of 2 reach + 1 pixels; beyond the picture is nothing.
void takeLeastAround(std::vector<float>& image, const Projection& picture, int reach)
{
  const auto width = static_cast<std::size_t>(picture.width);
  std::vector<float> rows(image.size());
  const auto height = static_cast<std::size_t>(picture.height);
  const auto farther = static_cast<std::size_t>(reach);
  const auto columns = [&](std::size_t y)
  {
    std::vector<float> padded(width + 2 * farther, 0.0f);
    std::copy_n(&image[y * width], width, &padded[farther]);
    float* row = &rows[y * width];
    std::copy_n(padded.data(), width, row);
    for (std::size_t k = 1; k <= 2 * farther; ++k)
    {
      for (std::size_t x = 0; x < width; ++x)
      {
        row[x] = std::min(row[x], padded[x + k]);
      }
    }
  };
  parallelForEach(height, columns, 16);
  parallelForEach(
    height,
    [&](std::size_t y)
    {
      float* row = &image[y * width];
      if (y < farther || y + farther >= height)
      {
        std::fill_n(row, width, 0.0f);
        return;
      }
      std::copy_n(&rows[(y - farther) * width], width, row);
      for (std::size_t k = y - farther + 1; k <= y + farther; ++k)
      {
        for (std::size_t x = 0; x < width; ++x)
        {
          row[x] = std::min(row[x], rows[k * width + x]);
        }
      }
    },
    16);
}

} // namespace

std::vector<std::uint32_t> seenTriangles(
  const TriangleMesh& mesh, const Eye& eye, const glm::dvec3& axis, double margin)
{
  eye.check();
  const glm::dvec3& along = eye.parallel ? eye.direction : axis;
  if (!(isFinite(along) && glm::length(along) > 0.0))
  {
    throw std::invalid_argument("the axis of a view must be finite and not zero");
  }
  const Projection picture(mesh, eye, along);
  if (picture.width == 0)
  {
    return {};
  }
  const double reach = std::ceil(std::clamp(margin * longestSide, leastMargin, mostMargin));
  std::vector<float> image = nearestSurfaces(mesh, picture);
  takeLeastAround(image, picture, static_cast<int>(reach));
  const auto isSeen = [&](std::size_t index, double nearness)
  { return picture.nearer(nearness, reach) >= image[index]; };
  std::vector<unsigned char> seenPoints(mesh.points.size());
  parallelForEach(mesh.points.size(),
    [&](std::size_t i)
    {
      const ProjectedPoint& point = picture.points[i];
      seenPoints[i] = picture.contains(point.pixel) &&
        isSeen(
          picture.index(static_cast<int>(point.pixel.x), static_cast<int>(point.pixel.y)), point.nearness);
    });
  return parallelSelect(mesh.triangles.size(),
    [&](std::size_t t)
    {
      const Triangle& triangle = mesh.triangles[t];
      const int inFront = countInFront(picture, triangle);
      if (inFront < 3)
      {
        return inFront > 0;
      }
      return std::any_of(triangle.begin(), triangle.end(),
               [&](std::uint32_t point) { return seenPoints[point] != 0; }) ||
        visitPixels(picture, triangle, isSeen);
    });
}

} // namespace ink
