// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Derivatives/Gradients.h"

#include "Fields/Grid/GridField.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace ink::testing
{

/// All that ink::estimateGradients gives for a box.
template <class Real>
struct Gradients
{
  SampleBox box;
  std::vector<Real> components;
  std::vector<Real> magnitudes;
  std::vector<Real> values;

  std::size_t index(const glm::ivec3& sample) const
  {
    const glm::ivec3 p = sample - this->box.begin;
    const glm::ivec3 n = this->box.size();
    return p.x + static_cast<std::size_t>(n.x) * (p.y + static_cast<std::size_t>(n.y) * p.z);
  }
  glm::dvec3 gradient(const glm::ivec3& sample) const
  {
    const Real* const g = this->components.data() + 3 * this->index(sample);
    return { g[0], g[1], g[2] };
  }
  double magnitude(const glm::ivec3& sample) const { return this->magnitudes[this->index(sample)]; }
  double value(const glm::ivec3& sample) const { return this->values[this->index(sample)]; }

  bool allFinite() const
  {
    for (const auto* array : { &this->components, &this->magnitudes, &this->values })
    {
      for (const Real x : *array)
      {
        if (!std::isfinite(x))
        {
          return false;
        }
      }
    }
    return true;
  }
  bool operator==(const Gradients& other) const
  {
    return this->components == other.components && this->magnitudes == other.magnitudes &&
      this->values == other.values;
  }
};

template <class Real = double, class T>
Gradients<Real> gradientsOf(const GridField<T>& field, const GradientOptions& options, const SampleBox& box)
{
  Gradients<Real> result{ box, {}, {}, {} };
  result.components.resize(3 * box.count());
  result.magnitudes.resize(box.count());
  result.values.resize(box.count());
  estimateGradients<T, Real>(field, box, options, { result.components, result.magnitudes, result.values });
  return result;
}

template <class Real = double, class T>
Gradients<Real> gradientsOf(const GridField<T>& field, const GradientOptions& options)
{
  return gradientsOf<Real>(field, options, SampleBox{ glm::ivec3(0), field.geometry().dimensions() });
}

/// Every way to estimate gradients.
inline std::vector<GradientOptions> allGradientOptions()
{
  using enum GradientMethod;
  using enum RegressionWeighting;
  return { { CentralDifference, 1, Uniform }, { Regression, 1, Uniform }, { Regression, 2, Uniform },
    { Regression, 1, InverseDistance }, { Regression, 2, InverseDistance } };
}

inline std::string nameOf(const GradientOptions& options)
{
  if (options.method == GradientMethod::CentralDifference)
  {
    return "central difference";
  }
  const std::string size = options.radius == 1 ? "3x3x3" : "5x5x5";
  return size + (options.weighting == RegressionWeighting::Uniform ? ", uniform" : ", inverse distance");
}

/// Calls body(sample) for each sample of a box.
template <class Body>
void forEachSample(const SampleBox& box, const Body& body)
{
  for (int k = box.begin.z; k < box.end.z; ++k)
  {
    for (int j = box.begin.y; j < box.end.y; ++j)
    {
      for (int i = box.begin.x; i < box.end.x; ++i)
      {
        body(glm::ivec3(i, j, k));
      }
    }
  }
}

/// The samples at least `margin` away from the border.
inline SampleBox inside(const GridGeometry& geometry, int margin)
{
  return { glm::ivec3(margin), geometry.dimensions() - margin };
}

/// In degrees.
inline double angleBetween(const glm::dvec3& a, const glm::dvec3& b)
{
  const double sine = glm::length(glm::cross(a, b));
  return std::atan2(sine, glm::dot(a, b)) * 57.29577951308232;
}

} // namespace ink::testing
