// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStippleInput_h
#define InkStippleInput_h

#include "vtkType.h"

#include <array>
#include <string>

class vtkDataArray;
class vtkPolyData;

/// The parts of a stipple generator's output: what the mapper reads.
struct InkStippleInput
{
  /// Looks for the arrays; what is missing stays null or at its default.
  explicit InkStippleInput(vtkPolyData* data);

  vtkPolyData* Data;
  vtkDataArray* Normals;            ///< cell data, 3 components
  vtkDataArray* GradientMagnitudes; ///< cell data, 1 component, 0 to 1; volumes only
  vtkDataArray* Values;             ///< cell data, 1 component, 0 to 1; volumes only
  vtkDataArray* GlobalIds;          ///< of the cells, 1 component; null if missing
  bool Surface;              ///< field data ElementKind 1; if it is not 0 or 1, when there are no gradients
  double ElementSize;        ///< field data, in the data's units; 0 if missing
  double StipplesPerElement; ///< field data; 0 if missing or no number: the longest list counts

  /// Why they cannot be drawn, for the user: what was expected and what was found; empty if they can.
  std::string FindProblem() const;

  /// What the arrays are. Each has its own modification time, which no other ever has: their latest would not
  /// tell when one is exchanged for an older one.
  struct Key
  {
    std::array<vtkMTimeType, 8> Arrays{};
    bool Surface = false;
    double ElementSize = 0.0;
    double StipplesPerElement = 0.0;
    bool operator==(const Key&) const = default;
  };
  Key GetKey() const;
};

#endif
