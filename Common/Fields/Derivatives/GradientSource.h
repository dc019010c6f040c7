// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Derivatives/Gradients.h"
#include "Fields/Derivatives/RegressionStencils.h"
#include "Fields/Grid/GridField.h"
#include "Fields/Grid/RowReader.h"
#include "Fields/ScalarDifference.h"

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <array>
#include <cmath>
#include <optional>
#include <type_traits>
#include <vector>

/// Internal to Common/Fields/Derivatives.
namespace ink
{

/// The derivatives at a sample, per sample step, and its value.
struct SampleGradient
{
  glm::dvec3 gradient{ 0.0 };
  double value = 0.0;
};

/// What gradients are estimated from, whatever the type of a field's samples: rows converted to Work, and
/// single samples in double precision.
template <class Work>
class GradientSource
{
public:
  GradientSource(const GridGeometry& geometry, const GradientOptions& options)
    : Geometry(geometry)
  {
    if (options.method == GradientMethod::Regression)
    {
      this->Stencils.emplace(geometry, options.radius, options.weighting);
    }
  }
  virtual ~GradientSource() = default;
  GradientSource(const GradientSource&) = delete;
  GradientSource& operator=(const GradientSource&) = delete;

  const GridGeometry& geometry() const { return this->Geometry; }
  /// A regression's; none for central differences.
  const std::optional<RegressionStencils<Work>>& stencils() const { return this->Stencils; }

  /// See ink::readRow.
  virtual bool readRow(
    int j, int k, int begin, Work limit, std::span<Work> row, std::span<std::uint8_t> marks) const = 0;

  /// @param mayMiss whether some neighbors on the grid may be missing
  virtual SampleGradient at(const glm::ivec3& sample, bool mayMiss) const = 0;

private:
  const GridGeometry& Geometry;
  std::optional<RegressionStencils<Work>> Stencils;
};

template <class T, class Work>
class FieldGradientSource final : public GradientSource<Work>
{
public:
  FieldGradientSource(const GridField<T>& field, const GradientOptions& options)
    : GradientSource<Work>(field.geometry(), options)
    , Field(field)
  {
  }

  bool readRow(
    int j, int k, int begin, Work limit, std::span<Work> row, std::span<std::uint8_t> marks) const override
  {
    return ink::readRow<T, Work>(this->Field, j, k, begin, limit, row, marks);
  }

  SampleGradient at(const glm::ivec3& sample, bool mayMiss) const override
  {
    if (mayMiss && !this->Field.has(sample))
    {
      return {};
    }
    return this->stencils()
      ? this->fit(sample, mayMiss)
      : SampleGradient{ this->Field.gradientAt(sample), static_cast<double>(this->Field.at(sample)) };
  }

private:
  SampleGradient fit(const glm::ivec3& sample, bool mayMiss) const
  {
    const std::vector<glm::ivec3>& offsets = this->stencils()->offsets();
    const glm::ivec3 dimensions = this->geometry().dimensions();
    std::array<std::uint8_t, 125> used{};
    bool all = true;
    bool large = false;
    for (std::size_t n = 0; n < offsets.size(); ++n)
    {
      const glm::ivec3 neighbor = sample + offsets[n];
      const bool onGrid = glm::all(glm::greaterThanEqual(neighbor, glm::ivec3(0))) &&
        glm::all(glm::lessThan(neighbor, dimensions));
      used[n] = onGrid && (!mayMiss || this->Field.has(neighbor));
      all = all && used[n] == onGrid;
      if constexpr (std::is_same_v<T, double>)
      {
        large = large || (used[n] && std::abs(this->Field.at(neighbor)) > 1e300);
      }
    }
    // Differences from the sample itself are exact even where large integers are not exact in double.
    // Differences of doubles that would overflow are scaled down.
    const double scale = large ? 0x1p-10 : 1.0;
    const T middle = this->Field.at(sample);
    const auto relative = [&](std::size_t n)
    {
      const T other = this->Field.at(sample + offsets[n]);
      return large ? static_cast<double>(other) * scale - static_cast<double>(middle) * scale
                   : difference(other, middle);
    };
    glm::dvec3 gradient(0.0);
    double rise = 0.0;
    if (all)
    {
      const RegressionKernel& kernel = (*this->stencils())[sample];
      for (std::size_t n = 0; n < offsets.size(); ++n)
      {
        if (used[n])
        {
          const double d = relative(n);
          gradient += kernel.gradient[n] * d;
          rise += kernel.value[n] * d;
        }
      }
    }
    else
    {
      const std::vector<double>& weights = this->stencils()->weights();
      const PlaneFit fit(offsets, weights, { used.data(), offsets.size() });
      glm::dvec3 moment(0.0);
      for (std::size_t n = 0; n < offsets.size(); ++n)
      {
        if (used[n])
        {
          const double d = weights[n] * relative(n);
          moment += d * (glm::dvec3(offsets[n]) - fit.mean);
          rise += d / fit.total;
        }
      }
      gradient = fit.inverse * moment;
      rise -= glm::dot(gradient, fit.mean);
    }
    return { gradient / scale, (static_cast<double>(middle) * scale + rise) / scale };
  }

  const GridField<T>& Field;
};

} // namespace ink
