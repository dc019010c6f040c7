// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <concepts>

namespace ink
{

/// The concept of a scalar field over world space. Grids, sparse grids, implicit models and analytic shapes
/// satisfy it, so that algorithms on iso-surfaces are written once.
///
/// What asks a field at single positions takes any Field: projectToIsoSurface (Fields/Projection.h) and
/// projectSamples. What visits all samples in memory order takes a GridField, because it is fast by knowing
/// where they are: estimateGradients and laplacianOfGaussian read rows, findActiveCells and
/// placeIsoSurfaceSamples vectors of cells, and IsoSurface/Vdb/VdbSamples.h leaves of a tree.
///
/// For a world point p: value(p) is the field's value, gradient(p) its first derivatives in value per world
/// unit, and hessian(p) its symmetric second derivatives in value per world unit squared. A field that is
/// undefined at p returns NaN from all of them.
template <class F>
concept Field = requires(const F& field, const glm::dvec3& p)
{
  {
    field.value(p)
    } -> std::convertible_to<double>;
  {
    field.gradient(p)
    } -> std::convertible_to<glm::dvec3>;
  {
    field.hessian(p)
    } -> std::convertible_to<glm::dmat3>;
};

} // namespace ink
