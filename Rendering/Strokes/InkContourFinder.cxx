// SPDX-License-Identifier: BSD-3-Clause
#include "InkContourFinder.h"

#include "InkContourLines.h"

#include "Curves/Contours/LengthPriority.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <vector>

void InkContourFinder::SetReady(bool ready)
{
  this->Ready = ready;
  this->Time.Modified();
}

vtkSmartPointer<vtkPolyData> InkContourFinder::MakeLines(
  const ink::Contours& contours, std::span<const vtkIdType> cellIds, std::span<const vtkIdType> sources)
{
  auto lines = vtkSmartPointer<vtkPolyData>::New();
  InkMakeContourLines(contours, VTK_DOUBLE, cellIds, lines);
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("vtkOriginalPointIds");
  ids->SetNumberOfTuples(static_cast<vtkIdType>(sources.size()));
  std::copy(sources.begin(), sources.end(), ids->GetPointer(0));
  lines->GetPointData()->AddArray(ids);
  const std::vector<float> shares = ink::lengthPriorities(contours);
  vtkNew<vtkFloatArray> priorities;
  priorities->SetName("Priority");
  priorities->SetNumberOfTuples(static_cast<vtkIdType>(shares.size()));
  std::copy(shares.begin(), shares.end(), priorities->GetPointer(0));
  lines->GetCellData()->AddArray(priorities);
  return lines;
}
