// SPDX-License-Identifier: BSD-3-Clause
#include "InkOutsideRange.h"

#include "vtkDataArray.h"

#include <cmath>
#include <sstream>

std::string InkDescribeOutside(
  std::span<const double> isoValues, vtkDataArray* scalars, int component, const std::string& made)
{
  double range[2];
  scalars->GetFiniteRange(range, component);
  return InkDescribeOutside(isoValues, range[0], range[1], made);
}

std::string InkDescribeOutside(
  std::span<const double> isoValues, double least, double greatest, const std::string& made)
{
  if (isoValues.empty())
  {
    return "No iso-value is set, so there are no " + made + ". Expected one or more (SetValue).";
  }
  std::ostringstream found;
  for (const double& value : isoValues)
  {
    // NaN has a warning of its own.
    if ((value > least && value <= greatest) || std::isnan(value))
    {
      return {};
    }
    found << (&value != isoValues.data() ? ", " : "") << value;
  }
  std::ostringstream expected;
  if (least == greatest)
  {
    expected << "All of the image's values are " << least << '.';
  }
  else if (least < greatest)
  {
    expected << "Expected a value above " << least << " and up to " << greatest << ", which the image has.";
  }
  else
  {
    expected << "None of the image's values is finite.";
  }
  return "No voxel lies on the iso-surface of " + found.str() + ". " + expected.str();
}
