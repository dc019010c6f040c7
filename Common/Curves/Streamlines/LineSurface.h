// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Curves/Streamlines/TracedLine.h"

#include <glm/vec3.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace ink
{

/// The direction of the lines at a point of a surface.
struct SurfaceDirection
{
  glm::dvec3 direction; ///< unit, with any sign; zero where it is not defined
  float umbilic;        ///< how little it is defined, in [0, 1] (ink::umbilicMeasure)
};

/// Where one gets going straight on along a surface, as on a geodesic.
template <class Point>
struct SurfaceArrival
{
  Point at;
  glm::dvec3 heading; ///< in the tangent plane there
};

/// A surface with a field of directions as evenly spaced lines need it, so that they are placed by the same
/// code on meshes and on iso-surfaces of fields.
///
/// A `Point` is a position as the surface knows it. `normal` is what tells sheets apart, `planeNormal` that
/// of the plane that directions lie in; `scatter` gives about so many positions by chance, uniform by area,
/// from each of which `pointOf` makes a point or nothing. `direction`, `trace` and `walk` are those of
/// StreamlineTracer and MeshNavigation. All may be called by several threads at once.
template <class S>
concept LineSurface = requires(const S& surface, const typename S::Point& at, const glm::dvec3& vector,
  const AcceptPoint<typename S::Point>& accept)
{
  {
    surface.area()
    } -> std::convertible_to<double>;
  {
    surface.center()
    } -> std::convertible_to<glm::dvec3>;
  {
    surface.position(at)
    } -> std::convertible_to<glm::dvec3>;
  {
    surface.normal(at)
    } -> std::convertible_to<glm::vec3>;
  {
    surface.planeNormal(at)
    } -> std::convertible_to<glm::dvec3>;
  {
    surface.ownDirection(at)
    } -> std::same_as<SurfaceDirection>;
  {
    surface.direction(at, vector)
    } -> std::convertible_to<glm::dvec3>;
  {
    surface.walk(at, vector, 1.0)
    } -> std::same_as<std::optional<SurfaceArrival<typename S::Point>>>;
  {
    surface.trace(at, vector, accept)
    } -> std::same_as<TracedLineOn<typename S::Point>>;
  {
    surface.pointOf(surface.scatter(std::size_t(), std::uint64_t())[0])
    } -> std::same_as<std::optional<typename S::Point>>;
  {
    S::isBefore(at, at)
    } -> std::same_as<bool>;
};

} // namespace ink
