// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStippleInput_h
#define InkStippleInput_h

#include "vtkType.h"

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
  bool Surface;                     ///< field data ElementKind 1; without it, when there are no gradients
  double ElementSize;               ///< field data, in the data's units; 0 if missing
  double StipplesPerElement;        ///< field data; 0 if missing: the longest list counts

  /// Why they cannot be drawn, for the user: what was expected and what was found; empty if they can.
  std::string FindProblem() const;

  /// A number that changes with any of the arrays.
  vtkMTimeType GetTime() const;
};

#endif
