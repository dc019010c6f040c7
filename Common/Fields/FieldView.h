// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Fields/Field.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <functional>

namespace ink
{

/// Any Field, for what asks it at few positions and so need not be compiled for each type of field. Satisfies
/// ink::Field; the field must outlive it.
class FieldView
{
public:
  template <Field F>
  FieldView(const F& field)
    : Value([&field](const glm::dvec3& p) { return static_cast<double>(field.value(p)); })
    , Gradient([&field](const glm::dvec3& p) { return static_cast<glm::dvec3>(field.gradient(p)); })
    , Hessian([&field](const glm::dvec3& p) { return static_cast<glm::dmat3>(field.hessian(p)); })
  {
  }

  double value(const glm::dvec3& p) const { return this->Value(p); }
  glm::dvec3 gradient(const glm::dvec3& p) const { return this->Gradient(p); }
  glm::dmat3 hessian(const glm::dvec3& p) const { return this->Hessian(p); }

private:
  std::function<double(const glm::dvec3&)> Value;
  std::function<glm::dvec3(const glm::dvec3&)> Gradient;
  std::function<glm::dmat3(const glm::dvec3&)> Hessian;
};

} // namespace ink
