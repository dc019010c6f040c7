// SPDX-License-Identifier: BSD-3-Clause
// What holds for every filter's output, whatever its input is.
#ifndef StabilityChecks_h
#define StabilityChecks_h

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

/// Whether all values of all numeric point arrays, coordinates included, are finite, normals have the length
/// 1, and cells have points that exist.
inline bool CheckValidPoints(const std::string& name, vtkPolyData* output)
{
  const vtkIdType count = output->GetNumberOfPoints();
  bool valid = true;
  const auto checkArray = [&](vtkDataArray* array, const char* what)
  {
    EXPECT_EQ(array->GetNumberOfTuples(), count) << name << ": values in " << what;
    valid = valid && array->GetNumberOfTuples() == count;
    for (vtkIdType n = 0; valid && n < array->GetNumberOfTuples(); ++n)
    {
      for (int c = 0; valid && c < array->GetNumberOfComponents(); ++c)
      {
        const double value = array->GetComponent(n, c);
        valid = std::isfinite(value);
        EXPECT_TRUE(valid) << name << ": finite values in " << what << ", found " << value << " at " << n;
      }
    }
  };
  if (output->GetPoints())
  {
    checkArray(output->GetPoints()->GetData(), "the points");
  }
  for (int i = 0; i < output->GetPointData()->GetNumberOfArrays(); ++i)
  {
    if (vtkDataArray* array = output->GetPointData()->GetArray(i))
    {
      checkArray(array, array->GetName());
    }
  }
  vtkDataArray* normals = output->GetPointData()->GetNormals();
  for (vtkIdType n = 0; valid && normals && n < count; ++n)
  {
    double normal[3];
    normals->GetTuple(n, normal);
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    valid = std::abs(length - 1.0) < 1e-5;
    EXPECT_TRUE(valid) << name << ": normals of length 1, found " << length << " at " << n;
  }
  for (vtkCellArray* cells :
    { output->GetVerts(), output->GetLines(), output->GetPolys(), output->GetStrips() })
  {
    if (valid && cells && cells->GetNumberOfConnectivityIds() > 0)
    {
      double range[2];
      cells->GetConnectivityArray()->GetRange(range, 0);
      valid = range[0] >= 0 && range[1] < static_cast<double>(count);
      EXPECT_TRUE(valid) << name << ": cells of points below " << count << ", found " << range[0] << " to "
                         << range[1];
    }
  }
  return valid;
}

#endif
