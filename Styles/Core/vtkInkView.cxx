// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkView.h"

#include "InkOrientation.h"
#include "InkPose.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

vtkStandardNewMacro(vtkInkView);

namespace
{

/// What is rendered has as many pixels on its longer side at least, as far as it is no more than
/// MOST_SUPERSAMPLING.
constexpr int LeastHeight = 500;

/// Degrees to the side of what is a cut for the most part.
constexpr double SlabAngle = 45.0;

const char* At(std::span<const char* const> words, int index)
{
  return index >= 0 && index < static_cast<int>(words.size()) ? words[static_cast<std::size_t>(index)]
                                                              : nullptr;
}

std::string ListOf(std::span<const char* const> words)
{
  std::string list;
  for (const char* word : words)
  {
    list += (list.empty() ? "" : ", ") + std::string(word);
  }
  return list;
}

bool Contains(std::span<const char* const> words, const std::string& word)
{
  return std::find(words.begin(), words.end(), word) != words.end();
}

} // namespace

void vtkInkView::SetName(const std::string& name)
{
  const std::span<const char* const> names = InkOrientation::GetViewNames();
  if (!Contains(names, name))
  {
    vtkErrorMacro("Name: expected one of " << ListOf(names) << ", found '" << name << "'; it stays "
                                           << this->Name << '.');
    return;
  }
  this->Name = name;
  this->GivenName = name;
  this->Modified();
}

int vtkInkView::GetNumberOfNames()
{
  return static_cast<int>(InkOrientation::GetViewNames().size());
}

const char* vtkInkView::GetNameOfView(int view)
{
  return At(InkOrientation::GetViewNames(), view);
}

void vtkInkView::SetUp(const std::string& axis)
{
  const std::span<const char* const> axes = InkOrientation::GetAxes();
  if (!Contains(axes, axis))
  {
    vtkErrorMacro(
      "Up: expected one of " << ListOf(axes) << ", found '" << axis << "'; it stays " << this->Up << '.');
    return;
  }
  this->Up = axis;
  this->GivenUp = axis;
  this->Modified();
}

int vtkInkView::GetNumberOfAxes()
{
  return static_cast<int>(InkOrientation::GetAxes().size());
}

const char* vtkInkView::GetAxis(int axis)
{
  return At(InkOrientation::GetAxes(), axis);
}

void vtkInkView::SetAzimuth(double degrees)
{
  InkSetClamped(this, "Azimuth", this->Azimuth, degrees, -360.0, 360.0);
  this->GivenAzimuth = this->Azimuth;
  this->Modified();
}

void vtkInkView::SetElevation(double degrees)
{
  InkSetClamped(this, "Elevation", this->Elevation, degrees, -360.0, 360.0);
  this->GivenElevation = this->Elevation;
  this->Modified();
}

void vtkInkView::Choose(vtkDataObject* data, const char* fileName)
{
  auto* mesh = vtkPolyData::SafeDownCast(data);
  this->OfMesh = mesh != nullptr;
  this->Image = nullptr;
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    this->Image = vtkSmartPointer<vtkImageData>::New();
    this->Image->CopyStructure(image);
  }
  const InkPose found =
    mesh ? InkFindPose(mesh, fileName ? fileName : "", this->GivenUp.value_or("")) : InkPose();
  this->Up = this->GivenUp.value_or(found.Up);
  this->Name = this->GivenName.value_or(found.View);
  this->Azimuth = this->GivenAzimuth.value_or(this->GivenName ? 0.0 : found.Azimuth);
  this->Elevation = this->GivenElevation.value_or(this->GivenName ? 0.0 : found.Elevation);
  this->Modified();
}

void vtkInkView::ChooseForFrame(vtkPoints* frame)
{
  if (this->OfMesh || this->GivenName || !frame || frame->GetNumberOfPoints() == 0)
  {
    return;
  }
  this->Name = InkFindSideOfFlat(frame->GetBounds(), this->Up);
  this->Azimuth = this->GivenAzimuth.value_or(0.0);
  this->Elevation = this->GivenElevation.value_or(0.0);
  if (this->Name == "left" && this->IsCutAcross(frame))
  {
    this->Azimuth = this->GivenAzimuth.value_or(SlabAngle);
  }
  else if (this->Name == "top" && this->IsCutAcross(frame))
  {
    this->Name = "front";
    this->Elevation = this->GivenElevation.value_or(SlabAngle);
  }
  this->Modified();
}

bool vtkInkView::IsCutAcross(vtkPoints* frame) const
{
  if (!this->Image)
  {
    return false;
  }
  InkOrientation orientation = *InkOrientation::Find(this->Name);
  orientation.Stand(this->Up);
  // The image's own axis, which scans tilt.
  const double* directions = this->Image->GetDirectionMatrix()->GetData();
  int axis = 0;
  double most = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double column[3] = { directions[i], directions[3 + i], directions[6 + i] };
    const double along = std::abs(vtkMath::Dot(orientation.Direction, column));
    axis = along > most ? i : axis;
    most = std::max(most, along);
  }
  const int* extent = this->Image->GetExtent();
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  for (vtkIdType i = 0; i < frame->GetNumberOfPoints(); ++i)
  {
    double point[3];
    double index[3];
    frame->GetPoint(i, point);
    this->Image->TransformPhysicalPointToContinuousIndex(point, index);
    least = std::min(least, index[axis]);
    greatest = std::max(greatest, index[axis]);
  }
  constexpr double slack = 0.5; // voxels
  return least <= extent[2 * axis] + slack && greatest >= extent[2 * axis + 1] - slack;
}

void vtkInkView::Apply(vtkCamera* camera, double turned)
{
  InkOrientation orientation = *InkOrientation::Find(this->Name);
  orientation.Stand(this->Up);
  const InkOrientation named = orientation;
  orientation.Rotate(this->Azimuth, this->Elevation);
  orientation.TurnAround(named.Up, turned);
  const double* direction = orientation.Direction;
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(-direction[0], -direction[1], -direction[2]);
  camera->SetViewUp(orientation.Up);
}

int vtkInkView::GetSupersampling(int width, int height)
{
  // Only small pictures, whatever their shape.
  const bool isSmall = std::max(width, height) < LeastHeight;
  const int wanted = isSmall ? (LeastHeight - 1) / std::max(height, 1) + 1 : 0;
  return std::clamp<int>(wanted, LEAST_SUPERSAMPLING, MOST_SUPERSAMPLING);
}

void vtkInkView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Name: " << this->Name << "\n"
     << indent << "Up: " << this->Up << "\n"
     << indent << "Azimuth: " << this->Azimuth << "\n"
     << indent << "Elevation: " << this->Elevation << "\n";
}
