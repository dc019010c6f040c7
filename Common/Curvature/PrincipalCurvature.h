// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <array>

namespace ink
{

/// The principal curvatures of a surface at a point, the same for meshes and fields.
///
/// Sign: a curvature is positive where the surface bends away from its outward normal, so that a sphere of
/// radius R with normals out of it has k1 = k2 = 1 / R, and a saddle one of each sign. The outward normal of
/// a field's surface is against the gradient, out of the denser side. The normal curvature toward the eye
/// then is what Contours::radialCurvature holds.
///
/// Order: k1 >= k2, by value and not by size. Unit: 1 / world unit.
///
/// Directions have length 1, are tangent to the surface and orthogonal to each other; direction1 x direction2
/// is the outward normal. Each stands for a line: its sign means nothing. Where k1 = k2 (umbilics), any two
/// such directions are given.
struct PrincipalCurvature
{
  double k1 = 0.0;
  double k2 = 0.0;
  glm::dvec3 direction1 = glm::dvec3(1.0, 0.0, 0.0);
  glm::dvec3 direction2 = glm::dvec3(0.0, 1.0, 0.0);

  double mean() const { return 0.5 * (this->k1 + this->k2); }
  double gauss() const { return this->k1 * this->k2; }
  /// The outward unit normal.
  glm::dvec3 normal() const;
  /// The normal curvature in a tangent direction of any length other than 0 (Euler's formula).
  double along(const glm::dvec3& direction) const;
  /// See ink::umbilicMeasure.
  double umbilicMeasure(double negligible = 0.0) const;
};

/// How little the principal directions are determined, in [0, 1]: 1 - (k1 - k2) / (|k1| + |k2|). 1 at
/// umbilics, where all directions are principal, and on planes; 0 on cylinders and saddles.
/// @param negligible a curvature that counts as none, in 1 / world unit, added to the denominator and taken
///   from the difference: the size of noise or rounding
double umbilicMeasure(double k1, double k2, double negligible = 0.0);

/// A symmetric bilinear form on a tangent plane, by its coefficients in two orthonormal axes.
struct TangentForm
{
  double l = 0.0; ///< axis 1 with axis 1
  double m = 0.0; ///< axis 1 with axis 2
  double n = 0.0; ///< axis 2 with axis 2
};

/// The curvatures of a second fundamental form: its eigenvalues and eigenvectors, in closed form.
///
/// Rössl et al. (2000, equation 9) print the directions as roots of m x^2 + (l - n) x - m = 0 with 4 m where
/// 4 m^2 is meant, and no case for m = 0; the eigenproblem has neither problem.
/// @param form with the sign above: l is the normal curvature along axis1
/// @param axis1, axis2 orthonormal, axis1 x axis2 the outward normal
PrincipalCurvature principalCurvature(
  const TangentForm& form, const glm::dvec3& axis1, const glm::dvec3& axis2);

/// Two unit vectors that complete a unit normal to a right-handed frame: axis1 x axis2 = normal.
std::array<glm::dvec3, 2> tangentAxes(const glm::dvec3& normal);

/// The derivative of the second fundamental form, a symmetric trilinear form, by its coefficients along
/// direction1 and direction2, in 1 / world unit^2: `c111` is the derivative of the normal curvature along
/// direction 1 in this direction, and so on. Directions that change sign change the sign of those
/// coefficients that name them an odd number of times.
struct CurvatureDerivative
{
  double c111 = 0.0;
  double c112 = 0.0;
  double c122 = 0.0;
  double c222 = 0.0;
};

} // namespace ink
