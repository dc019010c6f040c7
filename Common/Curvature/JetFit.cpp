// SPDX-License-Identifier: BSD-3-Clause
#include "Curvature/JetFit.h"

#include "Curvature/LeastNorm.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ink
{

namespace
{

using Pair = Eigen::Array2d; // a vector register of every 64-bit processor

/// How much the weight of the farthest points is below that of the nearest, before it is squared.
constexpr double fading = 0.8;

/// The index of u^(d - b) v^b among all monomials, by degree d.
constexpr int monomial(int d, int b)
{
  return d * (d + 1) / 2 + b;
}
constexpr int monomialsUpTo(int degree)
{
  return monomial(degree + 1, 0);
}

/// The coefficients of monomials, in coordinates divided by the reach.
using Polynomial = std::array<double, monomialsUpTo(3)>;

/// Sums over the points of weight times monomials, and of these times heights.
template <int degree>
struct Moments
{
  std::array<double, monomialsUpTo(2 * degree)> powers;
  std::array<double, monomialsUpTo(degree)> heights;
  double squares; // of heights
};

double reachOf(const TangentPoints& points, std::size_t count)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    largest = std::max(largest, points.u[i] * points.u[i] + points.v[i] * points.v[i]);
  }
  return std::sqrt(largest);
}

template <int degree>
Moments<degree> sumMoments(const TangentPoints& points, std::size_t count, double reach)
{
  constexpr int powers = monomialsUpTo(2 * degree);
  constexpr int heights = monomialsUpTo(degree);
  std::array<Pair, powers> power;
  std::array<Pair, heights> withHeight;
  Pair squares = Pair::Zero();
  power.fill(Pair::Zero());
  withHeight.fill(Pair::Zero());
  const double inverse = 1.0 / reach;
  const auto addPair = [&](const Pair& u, const Pair& v, const Pair& z, const Pair& present)
  {
    std::array<Pair, powers> w;
    w[0] = present * (1.0 - fading * (u * u + v * v)).square();
    power[0] += w[0];
    withHeight[0] += w[0] * z;
    squares += w[0] * z * z;
#pragma GCC unroll 8
    for (int d = 1; d <= 2 * degree; ++d)
    {
#pragma GCC unroll 8
      for (int b = 0; b <= d; ++b)
      {
        const int to = monomial(d, b);
        w[to] = b < d ? w[monomial(d - 1, b)] * u : w[monomial(d - 1, b - 1)] * v;
        power[to] += w[to];
        if (d <= degree)
        {
          withHeight[to] += w[to] * z;
        }
      }
    }
  };
  std::size_t i = 0;
  for (; i + 2 <= count; i += 2)
  {
    addPair(inverse * Eigen::Map<const Pair>(&points.u[i]), inverse * Eigen::Map<const Pair>(&points.v[i]),
      inverse * Eigen::Map<const Pair>(&points.height[i]), Pair::Ones());
  }
  if (i < count)
  {
    addPair(inverse * Pair(points.u[i], 0.0), inverse * Pair(points.v[i], 0.0),
      inverse * Pair(points.height[i], 0.0), Pair(1.0, 0.0));
  }
  Moments<degree> result;
  for (int n = 0; n < powers; ++n)
  {
    result.powers[n] = power[n].sum();
  }
  for (int n = 0; n < heights; ++n)
  {
    result.heights[n] = withHeight[n].sum();
  }
  result.squares = squares.sum();
  return result;
}

/// Solves the normal equations by L D L^T.
template <int degree>
bool solve(const Moments<degree>& moments, Polynomial& result)
{
  constexpr int size = monomialsUpTo(degree);
  double lower[size][size];
  double diagonal[size];
  double inverse[size];
  double x[size];
  // The squared sine of the angle between a monomial and those before it. Of whole neighborhoods it is .015
  // or more, of meshes stretched fourfold 1e-4; of three rows of points, as ribbons are, up to 1e-5 by their
  // bend, which does not tell anything of the third power across.
  constexpr double rankTolerance = 3e-5;
  int i = 0;
#pragma GCC unroll 4
  for (int di = 0; di <= degree; ++di)
  {
#pragma GCC unroll 4
    for (int bi = 0; bi <= di; ++bi, ++i)
    {
      int j = 0;
#pragma GCC unroll 4
      for (int dj = 0; dj <= di; ++dj)
      {
#pragma GCC unroll 4
        for (int bj = 0; bj <= dj && j <= i; ++bj, ++j)
        {
          double sum = moments.powers[monomial(di + dj, bi + bj)];
          const double whole = sum;
          for (int k = 0; k < j; ++k)
          {
            sum -= lower[i][k] * lower[j][k] * diagonal[k];
          }
          if (j < i)
          {
            lower[i][j] = sum * inverse[j];
          }
          else if (sum > rankTolerance * whole)
          {
            diagonal[i] = sum;
            inverse[i] = 1.0 / sum;
          }
          else
          {
            return false;
          }
        }
      }
      x[i] = moments.heights[i];
      for (int k = 0; k < i; ++k)
      {
        x[i] -= lower[i][k] * x[k];
      }
    }
  }
  for (int row = size - 1; row >= 0; --row)
  {
    x[row] *= inverse[row];
    for (int k = row + 1; k < size; ++k)
    {
      x[row] -= lower[k][row] * x[k];
    }
  }
  std::copy(x, x + size, result.begin());
  return true;
}

/// Of the surface over the tangent plane at the origin, in its own metric.
/// @param hasDerivative whether the polynomial has degree 3
void findCurvature(const Polynomial& c, const TangentFrame& frame, bool hasDerivative, JetFit& result)
{
  const double fu = c[monomial(1, 0)];
  const double fv = c[monomial(1, 1)];
  const double fuu = 2.0 * c[monomial(2, 0)];
  const double fuv = c[monomial(2, 1)];
  const double fvv = 2.0 * c[monomial(2, 2)];
  const double e = 1.0 + fu * fu;
  const double w = std::sqrt(e + fv * fv);
  const double rootE = std::sqrt(e);
  // Orthonormal tangents as combinations of the derivatives of position: (u1, 0) and (u2, v2).
  const double u1 = 1.0 / rootE;
  const double u2 = -fu * fv / (rootE * w);
  const double v2 = rootE / w;
  const double unit = -1.0 / (w * result.reach); // heights grow outward
  const TangentForm form{ unit * fuu * u1 * u1, unit * u1 * (fuu * u2 + fuv * v2),
    unit * (fuu * u2 * u2 + 2.0 * fuv * u2 * v2 + fvv * v2 * v2) };
  const glm::dvec3 tangentU = frame.axisU + fu * frame.normal;
  const glm::dvec3 tangentV = frame.axisV + fv * frame.normal;
  result.curvature = principalCurvature(form, u1 * tangentU, u2 * tangentU + v2 * tangentV);
  if (hasDerivative)
  {
    const double fuuu = 6.0 * c[monomial(3, 0)];
    const double fuuv = 2.0 * c[monomial(3, 1)];
    const double fuvv = 2.0 * c[monomial(3, 2)];
    const double fvvv = 6.0 * c[monomial(3, 3)];
    // The covariant derivative of f_ij / w: f_ijk / w - (f_ij g_k + f_ik g_j + f_jk g_i) / w^3, where g is
    // half the gradient of |grad f|^2.
    const double gu = fu * fuu + fv * fuv;
    const double gv = fu * fuv + fv * fvv;
    const double unit3 = unit / result.reach;
    const double slope = 1.0 / (w * w);
    const double d[4] = { unit3 * (fuuu - slope * 3.0 * fuu * gu),
      unit3 * (fuuv - slope * (fuu * gv + 2.0 * fuv * gu)),
      unit3 * (fuvv - slope * (fvv * gu + 2.0 * fuv * gv)), unit3 * (fvvv - slope * 3.0 * fvv * gv) };
    // In coordinates of the two derivatives of position, a tangent vector is its part in the frame's plane.
    const double a[2] = { glm::dot(result.curvature.direction1, frame.axisU),
      glm::dot(result.curvature.direction1, frame.axisV) };
    const double b[2] = { glm::dot(result.curvature.direction2, frame.axisU),
      glm::dot(result.curvature.direction2, frame.axisV) };
    const auto along = [&d](const double(&p)[2], const double(&q)[2], const double(&r)[2])
    {
      return d[0] * p[0] * q[0] * r[0] +
        d[1] * (p[0] * q[0] * r[1] + p[0] * q[1] * r[0] + p[1] * q[0] * r[0]) +
        d[2] * (p[0] * q[1] * r[1] + p[1] * q[0] * r[1] + p[1] * q[1] * r[0]) + d[3] * p[1] * q[1] * r[1];
    };
    result.derivative = { along(a, a, a), along(a, a, b), along(a, b, b), along(b, b, b) };
  }
}

bool isFinite(const JetFit& fit)
{
  // A sum is finite only if all of its terms are.
  const CurvatureDerivative& d = fit.derivative;
  return std::isfinite(std::abs(fit.curvature.k1) + std::abs(fit.curvature.k2) + std::abs(d.c111) +
    std::abs(d.c112) + std::abs(d.c122) + std::abs(d.c222));
}

template <int degree>
std::optional<JetFit> fit(const TangentPoints& points, std::size_t count)
{
  constexpr std::size_t size = monomialsUpTo(degree);
  JetFit result{};
  result.count = count;
  result.reach = reachOf(points, count);
  if (count < size || !(result.reach > 0.0) || !std::isfinite(result.reach))
  {
    return std::nullopt;
  }
  const Moments<degree> moments = sumMoments<degree>(points, count, result.reach);
  Polynomial polynomial{};
  if (!solve(moments, polynomial))
  {
    return std::nullopt;
  }
  // The weighted squares that are left, by the normal equations.
  double left = moments.squares;
  for (std::size_t i = 0; i < size; ++i)
  {
    left -= polynomial[i] * moments.heights[i];
  }
  const double freedom = static_cast<double>(count - size) / static_cast<double>(count);
  result.residual = count == size
    ? std::numeric_limits<double>::infinity()
    : result.reach * std::sqrt(std::max(left, 0.0) / (moments.powers[0] * freedom));
  // Steeper ones are no surface over the tangent plane, and have directions of few digits.
  constexpr double steepest = 100.0;
  const double slopeU = polynomial[monomial(1, 0)];
  const double slopeV = polynomial[monomial(1, 1)];
  if (!(slopeU * slopeU + slopeV * slopeV < steepest * steepest))
  {
    return std::nullopt;
  }
  findCurvature(polynomial, points.frame, degree == 3, result);
  return isFinite(result) ? std::optional(result) : std::nullopt;
}

} // namespace

double JetFit::noise() const
{
  constexpr double measured = 10.0;
  return measured * this->residual /
    (this->reach * this->reach * std::sqrt(static_cast<double>(this->count)));
}

double JetFit::noiseExcess() const
{
  constexpr double share = 0.02;
  constexpr double flat = 0.01; // an angle, within the reach
  const double size = std::max(std::abs(this->curvature.k1), std::abs(this->curvature.k2));
  return this->noise() / (share * std::max(size, flat / this->reach));
}

std::optional<JetFit> fitJet(const TangentPoints& points, std::size_t count, int degree)
{
  return degree == 3 ? fit<3>(points, count) : fit<2>(points, count);
}

std::optional<PrincipalCurvature> fitPinnedQuadric(const TangentPoints& points)
{
  const double scale = reachOf(points, points.count);
  if (!(scale > 0.0) || !std::isfinite(scale))
  {
    return std::nullopt;
  }
  // Normal equations; the unknown m is scaled so that the norm of all three does not depend on the axes.
  const double root = std::sqrt(0.5);
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < points.count; ++i)
  {
    const double u = points.u[i] / scale;
    const double v = points.v[i] / scale;
    const double height = points.height[i] / scale;
    const double square = u * u + v * v;
    if (square > 0.0)
    {
      const double stretch = 1.0 + height * height / square;
      // Deviations of curvature, and not of heights: far points of slivers would decide along near ones, too.
      // But points that coincide up to noise have none.
      constexpr double noise = 1e-10; // a squared distance
      const double weight = 1.0 / (square + noise);
      const Eigen::Vector3d row =
        (weight * stretch) * Eigen::Vector3d(0.5 * u * u, root * u * v, 0.5 * v * v);
      matrix += row * row.transpose();
      right += (weight * height) * row;
    }
  }
  const Eigen::Vector3d x = leastNormSolution<3>(matrix, right);
  const TangentForm form{ -x[0] / scale, -root * x[1] / scale, -x[2] / scale };
  if (matrix.isZero(0.0) || !std::isfinite(form.l) || !std::isfinite(form.m) || !std::isfinite(form.n))
  {
    return std::nullopt;
  }
  return principalCurvature(form, points.frame.axisU, points.frame.axisV);
}

} // namespace ink
