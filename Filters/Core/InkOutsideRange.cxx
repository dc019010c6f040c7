// SPDX-License-Identifier: BSD-3-Clause
#include "InkOutsideRange.h"

#include "vtkDataArray.h"

#include <cmath>
#include <sstream>

std::string InkDescribeOutside(
  std::span<const double> isoValues, vtkDataArray* scalars, int component, const std::string& made)
{
  if (isoValues.empty())
  {
    return "No iso-value is set, so there are no " + made + ". Expected one or more (SetValue).";
  }
  double range[2];
  scalars->GetFiniteRange(range, component);
  std::ostringstream found;
  for (const double& value : isoValues)
  {
    // NaN has a warning of its own.
    if ((value > range[0] && value <= range[1]) || std::isnan(value))
    {
      return {};
    }
    found << (&value != isoValues.data() ? ", " : "") << value;
  }
  std::ostringstream expected;
  if (range[0] == range[1])
  {
    expected << "All of the image's values are " << range[0] << '.';
  }
  else if (range[0] < range[1])
  {
    expected << "Expected a value above " << range[0] << " and up to " << range[1]
             << ", which the image has.";
  }
  else
  {
    expected << "None of the image's values is finite.";
  }
  return "No voxel lies on the iso-surface of " + found.str() + ". " + expected.str();
}
