#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <concepts>

namespace ink
{

/// A scalar field over world space. Grids, sparse grids, implicit models and analytic shapes all satisfy it,
/// so that everything which follows a surface is written once.
///
/// For a world point p: value(p) is the field's value, gradient(p) its first derivatives in value per world
/// unit, and hessian(p) its symmetric second derivatives in value per world unit squared. A field that is
/// not defined at p returns NaN in all of them.
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
