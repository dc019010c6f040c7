// SPDX-License-Identifier: BSD-3-Clause
#include "InkSplatInput.h"

#include "InkArrayList.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <sstream>

namespace
{

std::string Quote(const char* name)
{
  return std::string("\"") + (name ? name : "") + '"';
}

/// What is wrong with an array of some components, one tuple for each point.
std::string CheckArray(vtkDataArray* array, const std::string& name, int components, vtkIdType points)
{
  std::ostringstream problem;
  if (!array)
  {
    problem << "No point array " << Quote(name.c_str()) << " with " << components << " component"
            << (components == 1 ? "." : "s.");
  }
  else if (array->GetNumberOfComponents() != components)
  {
    problem << "The point array " << Quote(array->GetName()) << " has " << array->GetNumberOfComponents()
            << " components instead of " << components << '.';
  }
  else if (array->GetNumberOfTuples() != points)
  {
    problem << "The point array " << Quote(array->GetName()) << " has " << array->GetNumberOfTuples()
            << " tuples for " << points << " points.";
  }
  return problem.str();
}

} // namespace

std::string InkSplatInput::FindProblem(vtkPointData* found) const
{
  const vtkIdType count = this->Points->GetNumberOfPoints();
  std::string problem = CheckArray(this->Normals, this->NormalsName, 3, count);
  if (problem.empty() && (this->Radii || this->RadiiRequired))
  {
    problem = CheckArray(this->Radii, this->RadiiName, 1, count);
  }
  if (!problem.empty())
  {
    problem += " Point arrays (components) in the input: " + InkListArrays(found) + '.';
  }
  return problem;
}
