// SPDX-License-Identifier: BSD-3-Clause
// The Method CHAINS: what finds contours, what hides them, and those of a frame.
#include "vtkInkSilhouetteMapper.h"

#include "vtkInkSilhouetteMapperInternals.h"

#include "InkFrame.h"
#include "InkImageGrid.h"
#include "InkOutsideRange.h"
#include "InkStrokeMarks.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkContourValues.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <sstream>
#include <string>

ink::Eye vtkInkSilhouetteMapper::vtkInternals::FindEye(const InkFrame& frame)
{
  vtkCamera* camera = frame.Renderer->GetActiveCamera();
  vtkNew<vtkMatrix4x4> toView;
  frame.Actor->GetModelToWorldMatrix(toView);
  vtkMatrix4x4::Multiply4x4(camera->GetModelViewTransformMatrix(), toView, toView);
  vtkNew<vtkMatrix4x4> fromView;
  vtkMatrix4x4::Invert(toView, fromView);
  const bool parallel = camera->GetParallelProjection();
  const double inView[4] = { 0.0, 0.0, parallel ? -1.0 : 0.0, parallel ? 0.0 : 1.0 };
  double eye[4];
  fromView->MultiplyPoint(inView, eye);
  const glm::dvec3 found(eye[0], eye[1], eye[2]);
  return parallel ? ink::Eye::along(found) : ink::Eye::at(found);
}

void vtkInkSilhouetteMapper::vtkInternals::Drawn::AlignDashes(ink::Contours& contours, double period)
{
  constexpr double periodsOfReach = 2.0; // farther away are other lines
  this->Dashes.align(contours, period, periodsOfReach * period);
  vtkDataArray* arcLengths = this->Lines->GetPointData()->GetArray("ArcLength");
  for (std::size_t i = 0; i < contours.arcLength.size(); ++i)
  {
    arcLengths->SetComponent(static_cast<vtkIdType>(i), 0, contours.arcLength[i]);
  }
  arcLengths->Modified();
}

vtkImageData* vtkInkSilhouetteMapper::FindImage()
{
  return vtkImageData::SafeDownCast(this->GetInputDataSet());
}

bool vtkInkSilhouetteMapper::HidesItself()
{
  vtkPolyData* other = this->Superclass::FindSurface();
  return this->Method != VOXEL_SEGMENTS && (!other || other->GetNumberOfPoints() == 0);
}

vtkPolyData* vtkInkSilhouetteMapper::FindSurface()
{
  return !this->HidesItself() ? this->Superclass::FindSurface()
    : this->FindImage()       ? this->Internals->OfImage.GetSurface()
                              : this->GetInput();
}

double vtkInkSilhouetteMapper::FindDepthTolerance()
{
  const double own = this->Superclass::FindDepthTolerance();
  return this->HidesItself() && this->FindImage()
    ? std::max(own, this->Internals->OfImage.GetDepthTolerance())
    : own;
}

bool vtkInkSilhouetteMapper::GetExtent(double bounds[6])
{
  if (this->Method != CHAINS)
  {
    return false;
  }
  this->GetInputDataSet()->GetBounds(bounds);
  return std::all_of(bounds, bounds + 6, [](double bound) { return std::isfinite(bound); });
}

bool vtkInkSilhouetteMapper::UpdateFinder()
{
  vtkInternals& internals = *this->Internals;
  internals.Finder = nullptr;
  if (vtkImageData* image = this->FindImage())
  {
    internals.Finder = this->PrepareImage(image) ? &internals.OfImage : nullptr;
  }
  else if (this->CheckPolygons())
  {
    if (internals.OfMesh.Update(this->GetInput(),
          { this->Silhouettes, this->Faceted, this->Creases, this->FeatureAngle, this->Borders,
            this->NonManifoldEdges, this->ShortestCrease, this->ShortestBorder, true,
            this->SharpCreasesOnly }))
    {
      this->WarnOfNormals();
    }
    internals.Finder = &internals.OfMesh;
  }
  return internals.Finder != nullptr;
}

bool vtkInkSilhouetteMapper::PrepareImage(vtkImageData* image)
{
  const int* samples = image->GetDimensions();
  if (std::min({ samples[0], samples[1], samples[2] }) < 2)
  {
    std::ostringstream message;
    message << "The image has " << samples[0] << " x " << samples[1] << " x " << samples[2]
            << " samples. An iso-surface needs at least 2 along each axis.";
    this->ReportOnce(message.str());
    return false;
  }
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* found = this->GetInputArrayToProcess(1, image, association);
  std::string problem;
  vtkDataArray* scalars = InkChooseScalars(this, 1, image, found, association, this->ImageComponent, problem);
  if (!scalars)
  {
    this->ReportOnce(problem);
    return false;
  }
  const double* values = this->ContourValues->GetValues();
  const InkImageContourFinder::Options options{ { values,
                                                  values + this->ContourValues->GetNumberOfContours() },
    this->ImageComponent, this->Silhouettes, this->Borders };
  if (this->Internals->OfImage.Update(image, scalars, options))
  {
    const std::string outside =
      InkDescribeOutside(options.IsoValues, scalars, this->ImageComponent, "contours");
    if (std::any_of(
          values, values + options.IsoValues.size(), [](double value) { return std::isnan(value); }))
    {
      vtkWarningMacro("An iso-value is not a number (NaN) and has no contours.");
    }
    if (!outside.empty())
    {
      vtkWarningMacro(<< outside);
    }
  }
  return true;
}

bool vtkInkSilhouetteMapper::UpdateChains(InkMarks& own, const InkFrame& frame)
{
  vtkInternals& internals = *this->Internals;
  vtkInternals::Drawn& drawn = internals.Views.Get(frame.Renderer, frame.Actor);
  const ink::Eye eye = vtkInternals::FindEye(frame);
  double bounds[6];
  const double period =
    this->CoherentDashes && this->GetExtent(bounds) ? this->FindDashPeriod(frame, bounds) : 0.0;
  constexpr double tolerance = 1e-4; // tiles of a picture have other rounding
  const vtkMTimeType finderTime = internals.Finder->GetTime();
  if (drawn.FinderTime != finderTime || !(drawn.Eye == eye) ||
    std::abs(period - drawn.Period) > tolerance * period)
  {
    try
    {
      InkContourFinder::Found found = internals.Finder->Find(eye);
      drawn.Lines = found.Lines;
      if (drawn.FinderTime != finderTime || period == 0.0)
      {
        drawn.Dashes.reset();
      }
      if (period > 0.0)
      {
        drawn.AlignDashes(found.Contours, period);
      }
    }
    catch (const std::exception& error)
    {
      this->ReportOnce(std::string("The contours of the surface cannot be found: ") + error.what());
      return false;
    }
    drawn.FinderTime = finderTime;
    drawn.Eye = eye;
    drawn.Period = period;
  }
  return drawn.Lines->GetNumberOfLines() > 0 && this->UpdateStrokes(own, drawn.Lines);
}

vtkPolyData* vtkInkSilhouetteMapper::GetContours(vtkRenderer* renderer, vtkActor* actor)
{
  const vtkInternals::Drawn* drawn = this->Internals->Views.Find(renderer, actor);
  return drawn ? drawn->Lines.Get() : nullptr;
}
