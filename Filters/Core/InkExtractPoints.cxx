// SPDX-License-Identifier: BSD-3-Clause
#include "InkExtractPoints.h"

#include "InkAllocate.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <numeric>

void InkExtractPoints(vtkPointSet* input, std::span<const std::uint32_t> ids, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(ids.size());
  vtkNew<vtkIdList> from;
  vtkNew<vtkIdList> to;
  from->SetNumberOfIds(count);
  to->SetNumberOfIds(count);
  std::copy(ids.begin(), ids.end(), from->GetPointer(0));
  std::iota(to->GetPointer(0), to->GetPointer(0) + count, vtkIdType(0));
  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  InkSetNumberOfPoints(points, count);
  input->GetPoints()->GetData()->GetTuples(from, points->GetData());
  output->SetPoints(points);
  output->GetPointData()->CopyAllOn();
  output->GetPointData()->CopyAllocate(input->GetPointData(), count);
  output->GetPointData()->CopyData(input->GetPointData(), from, to);
  output->GetFieldData()->PassData(input->GetFieldData());
}
