// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkGatherImages.h"

#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

namespace
{

constexpr int GeometryTag = 8371;
constexpr int ValuesTag = 8372;

/// An image, with the number of its cells that are no other part's.
struct Part
{
  vtkSmartPointer<vtkImageData> Image;
  double OwnCells;
};

/// Along a direction of one sample, one cell.
double CountCells(const int extent[6])
{
  double cells = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    cells *= std::max(extent[2 * axis + 1] - extent[2 * axis], 1);
  }
  return cells;
}

double CountOwnCells(vtkImageData* image)
{
  vtkUnsignedCharArray* ghosts = image->GetCellGhostArray();
  double cells = CountCells(image->GetExtent());
  for (vtkIdType i = 0; ghosts && i < ghosts->GetNumberOfTuples(); ++i)
  {
    cells -= (ghosts->GetValue(i) & vtkDataSetAttributes::DUPLICATECELL) != 0 ? 1.0 : 0.0;
  }
  return cells;
}

void Send(const InkWholeImages& images, vtkMultiProcessController* controller)
{
  vtkMultiProcessStream stream;
  stream << static_cast<int>(images.size());
  for (vtkImageData* image : images)
  {
    stream << CountOwnCells(image) << image->GetPointData()->GetScalars()->GetDataType();
    for (int i = 0; i < 6; ++i)
    {
      stream << image->GetExtent()[i];
    }
    for (int i = 0; i < 3; ++i)
    {
      stream << image->GetOrigin()[i] << image->GetSpacing()[i];
    }
    for (int i = 0; i < 9; ++i)
    {
      stream << image->GetDirectionMatrix()->GetData()[i];
    }
  }
  controller->Send(stream, 0, GeometryTag);
  for (vtkImageData* image : images)
  {
    controller->Send(image->GetPointData()->GetScalars(), 0, ValuesTag);
  }
}

Part ReceiveGeometry(vtkMultiProcessStream& stream)
{
  Part part{ vtkSmartPointer<vtkImageData>::New(), 0.0 };
  int type = 0;
  stream >> part.OwnCells >> type;
  std::array<int, 6> extent;
  for (int& end : extent)
  {
    stream >> end;
  }
  std::array<double, 3> origin;
  std::array<double, 3> spacing;
  for (std::size_t i = 0; i < 3; ++i)
  {
    stream >> origin[i] >> spacing[i];
  }
  std::array<double, 9> direction;
  for (double& element : direction)
  {
    stream >> element;
  }
  part.Image->SetExtent(extent.data());
  part.Image->SetOrigin(origin.data());
  part.Image->SetSpacing(spacing.data());
  part.Image->SetDirectionMatrix(direction.data());
  part.Image->GetPointData()->SetScalars(vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type)));
  return part;
}

void Receive(int process, vtkMultiProcessController* controller, std::vector<Part>& parts)
{
  vtkMultiProcessStream stream;
  controller->Receive(stream, process, GeometryTag);
  int count = 0;
  stream >> count;
  const std::size_t first = parts.size();
  for (int n = 0; n < count; ++n)
  {
    parts.push_back(ReceiveGeometry(stream));
  }
  for (std::size_t n = first; n < parts.size(); ++n)
  {
    controller->Receive(parts[n].Image->GetPointData()->GetScalars(), process, ValuesTag);
  }
}

bool HasGeometryOf(vtkImageData* image, vtkImageData* other)
{
  return std::equal(image->GetOrigin(), image->GetOrigin() + 3, other->GetOrigin()) &&
    std::equal(image->GetSpacing(), image->GetSpacing() + 3, other->GetSpacing()) &&
    std::equal(image->GetDirectionMatrix()->GetData(), image->GetDirectionMatrix()->GetData() + 9,
      other->GetDirectionMatrix()->GetData()) &&
    image->GetScalarType() == other->GetScalarType() &&
    image->GetNumberOfScalarComponents() == other->GetNumberOfScalarComponents();
}

/// Writes a part's values where they belong in the whole, row by row.
void Paste(vtkImageData* part, vtkImageData* whole)
{
  const int* extent = part->GetExtent();
  vtkDataArray* from = part->GetPointData()->GetScalars();
  vtkDataArray* to = whole->GetPointData()->GetScalars();
  const vtkIdType samples = extent[1] - extent[0] + 1;
  vtkIdType row = 0;
  for (int z = extent[4]; z <= extent[5]; ++z)
  {
    for (int y = extent[2]; y <= extent[3]; ++y, row += samples)
    {
      int first[3] = { extent[0], y, z };
      to->InsertTuples(whole->ComputePointId(first), samples, row, from);
    }
  }
}

/// The image that parts are of; null if they are not of one.
vtkSmartPointer<vtkImageData> PutTogether(const std::vector<Part>& parts)
{
  vtkImageData* first = parts.front().Image;
  std::array<int, 6> extent;
  std::copy_n(first->GetExtent(), 6, extent.begin());
  double cells = 0.0;
  for (const Part& part : parts)
  {
    if (!HasGeometryOf(part.Image, first))
    {
      return nullptr;
    }
    for (std::size_t i = 0; i < 6; i += 2)
    {
      extent[i] = std::min(extent[i], part.Image->GetExtent()[i]);
      extent[i + 1] = std::max(extent[i + 1], part.Image->GetExtent()[i + 1]);
    }
    cells += part.OwnCells;
  }
  if (cells != CountCells(extent.data()))
  {
    return nullptr;
  }
  auto whole = vtkSmartPointer<vtkImageData>::New();
  whole->CopyStructure(first);
  whole->SetExtent(extent.data());
  whole->AllocateScalars(first->GetScalarType(), first->GetNumberOfScalarComponents());
  whole->GetPointData()->GetScalars()->SetName(first->GetPointData()->GetScalars()->GetName());
  for (const Part& part : parts)
  {
    Paste(part.Image, whole);
  }
  return whole;
}

} // namespace

InkWholeImages vtkInkGatherImages(const InkWholeImages& images, vtkMultiProcessController* controller)
{
  const auto own = static_cast<int>(images.size());
  int most = own;
  controller->AllReduce(&own, &most, 1, vtkCommunicator::MAX_OP);
  if (controller->GetLocalProcessId() != 0)
  {
    Send(images, controller);
    return {};
  }
  std::vector<Part> parts;
  for (vtkImageData* image : images)
  {
    parts.push_back({ vtkSmartPointer<vtkImageData>::New(), CountOwnCells(image) });
    parts.back().Image->CopyStructure(image);
    parts.back().Image->GetPointData()->SetScalars(image->GetPointData()->GetScalars());
  }
  for (int process = 1; process < controller->GetNumberOfProcesses(); ++process)
  {
    Receive(process, controller, parts);
  }
  if (const auto whole = parts.size() > 1 && most == 1 ? PutTogether(parts) : nullptr)
  {
    return { whole };
  }
  InkWholeImages result;
  std::transform(
    parts.begin(), parts.end(), std::back_inserter(result), [](const Part& part) { return part.Image; });
  return result;
}
