// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkView.h"

#include "InkCutSides.h"
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
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

vtkStandardNewMacro(vtkInkView);

namespace
{

/// What is rendered for a picture both of whose sides are shorter has as many pixels of height at least, of
/// which splats' sizes are parts, as far as MOST_SUPERSAMPLING allows.
constexpr int LeastHeight = 500;

/// How many times more than its front the left or the top of a volume shows, to be seen: skulls of mice 1.9,
/// brains of macaques 1.65, those of humans 1.4. Of what its image cuts on both sides, less than that is no
/// slab, which cuts are closed of, see vtkInkStyle.
constexpr double ShowsMore = 1.6;
constexpr double Slab = 2.0;

/// A part that sticks out at a side, as of jaws, is not cut off there for the most part.
constexpr double CutShare = 0.05;

/// Degrees to the side of what is a cut for the most part.
constexpr double SlabAngle = 45.0;

/// Of a block that its image cuts out more than this share of each side is covered.
constexpr double BlockShare = 0.5;
constexpr const char* BlockView = "iso";

InkOrientation FindOrientation(const std::string& name, const std::string& up)
{
  InkOrientation orientation = *InkOrientation::Find(name);
  orientation.Stand(up);
  return orientation;
}

/// The image's own axes, which scans tilt.
std::array<std::array<double, 3>, 3> AxesOf(vtkImageData* image)
{
  const double* d = image->GetDirectionMatrix()->GetData();
  return { { { d[0], d[3], d[6] }, { d[1], d[4], d[7] }, { d[2], d[5], d[8] } } };
}

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

void vtkInkView::ChooseForFrame(vtkPoints* frame, bool seenThrough)
{
  if (this->OfMesh || this->GivenName || !frame || frame->GetNumberOfPoints() == 0)
  {
    return;
  }
  this->Name = InkFindSideOfFlat(frame->GetBounds(), this->Up, ShowsMore);
  this->Azimuth = this->GivenAzimuth.value_or(0.0);
  this->Elevation = this->GivenElevation.value_or(0.0);
  if (this->Image && !seenThrough)
  {
    const std::array<double, 6> covered = InkFindCutSides(this->Image, frame);
    if (this->IsCutAcross(covered))
    {
      this->Name = InkFindSideOfFlat(frame->GetBounds(), this->Up, Slab);
    }
    this->TurnToSides(covered, frame);
  }
  this->Modified();
}

void vtkInkView::TurnToSides(const std::array<double, 6>& covered, vtkPoints* frame)
{
  // Straight ahead, of a block of its own no more than a rectangle is seen.
  const auto isOwnBlock = [&]
  { return this->Name == "front" && this->IsBlock(InkFindFlatSides(this->Image, frame)); };
  if (!this->GivenAzimuth && !this->GivenElevation && (this->IsBlock(covered) || isOwnBlock()))
  {
    this->Name = BlockView;
  }
  else if (this->Name == "left" && this->IsCutAcross(covered))
  {
    this->Azimuth = this->GivenAzimuth.value_or(SlabAngle);
  }
  else if (this->Name == "top" && this->IsCutAcross(covered))
  {
    this->Name = "front";
    this->Elevation = this->GivenElevation.value_or(SlabAngle);
  }
}

bool vtkInkView::IsBlock(const std::array<double, 6>& covered) const
{
  const InkOrientation orientation = FindOrientation(BlockView, this->Up);
  const auto axes = AxesOf(this->Image);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const bool isUpperSeen = vtkMath::Dot(orientation.Direction, axes[axis].data()) < 0.0;
    if (!(covered[2 * axis + (isUpperSeen ? 1 : 0)] > BlockShare))
    {
      return false;
    }
  }
  return true;
}

bool vtkInkView::IsCutAcross(const std::array<double, 6>& covered) const
{
  const InkOrientation orientation = FindOrientation(this->Name, this->Up);
  const auto axes = AxesOf(this->Image);
  std::size_t axis = 0;
  double most = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double along = std::abs(vtkMath::Dot(orientation.Direction, axes[i].data()));
    axis = along > most ? i : axis;
    most = std::max(most, along);
  }
  return covered[2 * axis] > CutShare && covered[2 * axis + 1] > CutShare;
}

void vtkInkView::Apply(vtkCamera* camera, double turned)
{
  InkOrientation orientation = FindOrientation(this->Name, this->Up);
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
  // Large pictures are not made larger still, however low they are.
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
