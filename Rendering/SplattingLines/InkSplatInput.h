// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSplatInput_h
#define InkSplatInput_h

#include "vtkType.h"

#include <string>

class vtkDataArray;
class vtkPointData;
class vtkPoints;

/// The parts of the mapper's input, as chosen by name.
struct InkSplatInput
{
  vtkPoints* Points;
  vtkDataArray* Normals;   ///< null if missing
  vtkDataArray* Radii;     ///< null if missing
  std::string NormalsName; ///< asked for
  std::string RadiiName;
  bool RadiiRequired;

  /// Why they cannot be drawn, for the user: the array expected and the arrays found; empty if they can.
  std::string FindProblem(vtkPointData* found) const;
};

#endif
