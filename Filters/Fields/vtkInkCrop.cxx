// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkCrop.h"

#include "Core/FormatNumber.h"
#include "InkExtractPoints.h"
#include "InkHasPolygons.h"
#include "InkImageGrid.h"
#include "InkReportException.h"
#include "InkSetters.h"

#include "vtkBox.h"
#include "vtkClipPolyData.h"
#include "vtkExtractVOI.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

vtkStandardNewMacro(vtkInkCrop);

namespace
{

using SDDP = vtkStreamingDemandDrivenPipeline;

bool MakesImage(vtkInformation* info)
{
  return vtkImageData::SafeDownCast(info->Get(vtkDataObject::DATA_OBJECT())) != nullptr;
}

} // namespace

void vtkInkCrop::SetBox(double x0, double x1, double y0, double y1, double z0, double z1)
{
  const bool x = InkSetRange(this, "Box along x", this->Box, x0, x1);
  const bool y = InkSetRange(this, "Box along y", this->Box + 2, y0, y1);
  const bool z = InkSetRange(this, "Box along z", this->Box + 4, z0, z1);
  if (x || y || z)
  {
    this->Modified();
  }
}

void vtkInkCrop::SetBox(const double box[6])
{
  this->SetBox(box[0], box[1], box[2], box[3], box[4], box[5]);
}

int vtkInkCrop::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

bool vtkInkCrop::FindExtent(vtkImageData* frame, int extent[6])
{
  double low[3] = { HUGE_VAL, HUGE_VAL, HUGE_VAL };
  double high[3] = { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const double point[3] = { this->Box[corner & 1], this->Box[2 + (corner >> 1 & 1)],
      this->Box[4 + (corner >> 2)] };
    double index[3];
    frame->TransformPhysicalPointToContinuousIndex(point, index);
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], index[axis]);
      high[axis] = std::max(high[axis], index[axis]);
    }
  }
  const int* whole = frame->GetExtent();
  for (int axis = 0; axis < 3; ++axis)
  {
    // A side that was meant to be a voxel's center is one.
    constexpr double rounding = 1e-6;
    const double first = std::max<double>(std::ceil(low[axis] - rounding), whole[2 * axis]);
    const double last = std::min<double>(std::floor(high[axis] + rounding), whole[2 * axis + 1]);
    // Also for NaN.
    if (!(first <= last))
    {
      return false;
    }
    extent[2 * axis] = static_cast<int>(first);
    extent[2 * axis + 1] = static_cast<int>(last);
  }
  return true;
}

void vtkInkCrop::ReportNothing(const double b[6])
{
  vtkErrorMacro("Nothing lies in the box; the data is from "
    << ink::formatNumber(b[0]) << " to " << ink::formatNumber(b[1]) << " in x, " << ink::formatNumber(b[2])
    << " to " << ink::formatNumber(b[3]) << " in y and " << ink::formatNumber(b[4]) << " to "
    << ink::formatNumber(b[5]) << " in z.");
}

int vtkInkCrop::RequestInformation(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* outputVector)
{
  vtkInformation* info = input[0]->GetInformationObject(0);
  vtkInformation* output = outputVector->GetInformationObject(0);
  if (!MakesImage(info))
  {
    return 1;
  }
  const vtkSmartPointer<vtkImageData> frame = InkMakeFrame(info);
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  std::copy_n(extent, 6, this->Kept);
  if (frame->GetNumberOfPoints() > 0 && !this->FindExtent(frame, this->Kept))
  {
    this->ReportNothing(frame->GetBounds());
  }
  double origin[3];
  frame->TransformIndexToPhysicalPoint(this->Kept[0], this->Kept[2], this->Kept[4], origin);
  for (int axis = 0; axis < 3; ++axis)
  {
    extent[2 * axis + 1] = this->Kept[2 * axis + 1] - this->Kept[2 * axis];
  }
  output->Set(SDDP::WHOLE_EXTENT(), extent, 6);
  output->Set(vtkDataObject::ORIGIN(), origin, 3);
  return 1;
}

int vtkInkCrop::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* outputVector)
{
  vtkInformation* info = input[0]->GetInformationObject(0);
  if (MakesImage(info))
  {
    int extent[6];
    outputVector->GetInformationObject(0)->Get(SDDP::UPDATE_EXTENT(), extent);
    for (int i = 0; i < 6; ++i)
    {
      extent[i] += this->Kept[i / 2 * 2];
    }
    info->Set(SDDP::UPDATE_EXTENT(), extent, 6);
  }
  return 1;
}

int vtkInkCrop::RequestData(vtkInformation*, vtkInformationVector** input, vtkInformationVector* outputVector)
{
  vtkInformation* info = input[0]->GetInformationObject(0);
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkDataObject* output = outInfo->Get(vtkDataObject::DATA_OBJECT());
  try
  {
    if (auto* image = vtkImageData::GetData(info))
    {
      int extent[6];
      info->Get(SDDP::UPDATE_EXTENT(), extent);
      this->CropImage(image, extent, vtkImageData::SafeDownCast(output));
    }
    else if (auto* mesh = vtkPolyData::GetData(info); mesh && mesh->GetNumberOfPoints() > 0)
    {
      this->CropMesh(mesh, vtkPolyData::SafeDownCast(output));
    }
  }
  catch (...)
  {
    InkReportException(this, output, "The data cannot be cropped");
  }
  return 1;
}

void vtkInkCrop::CropImage(vtkImageData* image, const int extent[6], vtkImageData* output)
{
  if (image->GetNumberOfPoints() == 0 || extent[0] > extent[1] || extent[2] > extent[3] ||
    extent[4] > extent[5])
  {
    return;
  }
  int part[6];
  std::copy_n(extent, 6, part);
  output->ShallowCopy(image);
  if (!std::equal(part, part + 6, image->GetExtent()))
  {
    // More than that was made.
    vtkNew<vtkExtractVOI> extract;
    extract->SetInputData(image);
    extract->SetVOI(part);
    extract->Update();
    output->ShallowCopy(extract->GetOutput());
  }
  double origin[3];
  image->TransformIndexToPhysicalPoint(this->Kept[0], this->Kept[2], this->Kept[4], origin);
  for (int i = 0; i < 6; ++i)
  {
    part[i] -= this->Kept[i / 2 * 2];
  }
  output->SetExtent(part);
  output->SetOrigin(origin);
}

void vtkInkCrop::CropMesh(vtkPolyData* mesh, vtkPolyData* output)
{
  if (InkHasPolygons(mesh))
  {
    vtkNew<vtkBox> inside;
    inside->SetBounds(this->Box);
    vtkNew<vtkClipPolyData> clip;
    clip->SetInputData(mesh);
    clip->SetClipFunction(inside);
    clip->InsideOutOn();
    clip->Update();
    output->ShallowCopy(clip->GetOutput());
  }
  else
  {
    std::vector<std::uint32_t> kept;
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      double p[3];
      mesh->GetPoint(i, p);
      if (p[0] >= this->Box[0] && p[0] <= this->Box[1] && p[1] >= this->Box[2] && p[1] <= this->Box[3] &&
        p[2] >= this->Box[4] && p[2] <= this->Box[5])
      {
        kept.push_back(static_cast<std::uint32_t>(i));
      }
    }
    InkExtractPoints(mesh, kept, output);
  }
  if (output->GetNumberOfPoints() == 0)
  {
    this->ReportNothing(mesh->GetBounds());
  }
}

void vtkInkCrop::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Box:";
  for (const double side : this->Box)
  {
    os << ' ' << side;
  }
  os << "\n";
}
