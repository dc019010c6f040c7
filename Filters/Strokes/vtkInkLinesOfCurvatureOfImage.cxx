// SPDX-License-Identifier: BSD-3-Clause
// What vtkInkLinesOfCurvature makes of images.
#include "vtkInkLinesOfCurvature.h"

#include "Curvature/FieldCurvature.h"
#include "Curves/Streamlines/EvenFieldStreamlines.h"
#include "Fields/Resampling/SmoothGrid.h"
#include "InkCellCenters.h"
#include "InkImageGrid.h"
#include "InkLineWriter.h"
#include "InkRegion.h"
#include "InkVTKCompat.h"
#include "InkWithGridField.h"
#include "IsoSurface/ResampledSamples.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

vtkInkLinesOfCurvature::vtkInkLinesOfCurvature()
{
  this->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

int vtkInkLinesOfCurvature::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkInkLinesOfCurvature::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using SDDP = vtkStreamingDemandDrivenPipeline;
  if (!this->Superclass::RequestUpdateExtent(request, inputVector, outputVector))
  {
    return 0;
  }
  vtkInformation* info = inputVector[0]->GetInformationObject(0);
  if (vtkImageData::GetData(info))
  {
    // Lines run through all of it.
    info->Set(SDDP::UPDATE_PIECE_NUMBER(), 0);
    info->Set(SDDP::UPDATE_NUMBER_OF_PIECES(), 1);
    info->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    if (int* whole = info->Get(SDDP::WHOLE_EXTENT()))
    {
      info->Set(SDDP::UPDATE_EXTENT(), whole, 6);
    }
    this->OwnsImage = outputVector->GetInformationObject(0)->Get(SDDP::UPDATE_PIECE_NUMBER()) <= 0;
  }
  return 1;
}

void vtkInkLinesOfCurvature::MakeLinesOfImage(vtkInformationVector** given, vtkPolyData* output)
{
  InkPointInput points;
  vtkInformationVector** input = points.Take(this, given);
  vtkImageData* image = vtkImageData::GetData(input[0]);
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* found = this->GetInputArrayToProcess(0, input, association);
  vtkDataArray* scalars = InkChooseScalars(this, image, found, association, 0);
  if (!scalars || !this->OwnsImage)
  {
    return;
  }
  const ink::GridGeometry grid = InkMakeGrid(image, InkExtent(image->GetExtent()));
  if (glm::any(glm::lessThan(grid.dimensions(), glm::ivec3(2))))
  {
    const glm::ivec3& n = grid.dimensions();
    throw std::invalid_argument("it has " + std::to_string(n.x) + " x " + std::to_string(n.y) + " x " +
      std::to_string(n.z) + " samples; expected at least 2 along each axis");
  }
  double begun = 0.0;
  double share = 0.1;
  const ink::Progress progress = [&](double done)
  {
    this->UpdateProgress(begun + share * done);
    return !InkCheckAbort(this);
  };
  const std::vector<ink::HalfSpace> region = InkRegion(this->Region);
  const auto within = [&](const glm::dvec3& p) { return grid.contains(p) && ink::areContaining(region, p); };
  ink::EvenStreamlineOptions options;
  options.trace.maximumStep = this->StepFactor * grid.smallestSpacing();
  options.trace.umbilicLimit = this->UmbilicLimit;
  options.stopDistance = this->StopDistance;
  options.minimumLength = this->MinimumLength;
  options.seed = static_cast<std::uint64_t>(this->Seed);
  if (this->MaximumLength > 0.0)
  {
    options.trace.maximumLength = this->MaximumLength;
  }
  InkLineWriter writer(InkNeedsDoublePrecision(grid) ? VTK_DOUBLE : VTK_FLOAT, this->ComputeCurvatures);
  const auto work = [&]<class T>(const ink::GridField<T>& field)
  {
    const glm::dvec3 deviation =
      ink::makeIsoSurfaceResampling(grid, this->FieldSmoothing, 1, ink::SmoothingTarget::Surface).deviation;
    const auto smooth = ink::smoothGrid(field, deviation, progress);
    begun = 0.1;
    const ink::SurfaceSamples samples = ink::samplesOfGrid(field, this->IsoValue, progress);
    if (smooth.empty() || !progress(0.0) || samples.positions.empty())
    {
      return;
    }
    using Work = ink::SmoothedValue<T>;
    const ink::GridField<Work> form(grid, std::span<const Work>(smooth));
    begun = 0.2;
    share = 0.8;
    this->AddLines({ field, form, this->IsoValue, within }, samples, options, writer, progress);
  };
  int component = 0;
  const vtkSmartPointer<vtkDataArray> contiguous = InkMakeContiguous(scalars, component);
  InkWithGridField(
    grid, contiguous, component, InkGetMarks(image->GetPointData(), vtkDataSetAttributes::HIDDENPOINT), work);
  if (InkCheckAbort(this))
  {
    return;
  }
  writer.Write(output);
  if (output->GetNumberOfLines() == 0 && !this->Region)
  {
    vtkWarningMacro("The iso-surface at " << this->IsoValue
                                          << " has no lines; expected a surface that is larger "
                                          << "than the least length of lines, with directions.");
  }
}

void vtkInkLinesOfCurvature::AddLines(const ink::FieldSurface& surface, ink::SurfaceSamples samples,
  ink::EvenStreamlineOptions options, InkLineWriter& writer, const std::function<bool(double)>& progress)
{
  glm::dvec3 lower(std::numeric_limits<double>::infinity());
  glm::dvec3 upper(-lower);
  for (const glm::dvec3& p : samples.positions)
  {
    lower = glm::min(lower, p);
    upper = glm::max(upper, p);
  }
  const double diagonal = glm::distance(lower, upper);
  // Within one cell there are no lines.
  if (!(diagonal > 0.0))
  {
    return;
  }
  options.spacing = this->Spacing > 0.0 ? this->Spacing : DefaultSpacing * diagonal;
  const double negligible =
    this->NegligibleCurvature > 0.0 ? this->NegligibleCurvature : DefaultNegligible / diagonal;
  const std::vector<ink::HalfSpace> region = InkRegion(this->Region);
  const auto all = static_cast<double>(samples.positions.size());
  std::erase_if(samples.positions, [&](const glm::dvec3& p) { return !ink::areContaining(region, p); });
  samples.area *= static_cast<double>(samples.positions.size()) / all;
  const int first = this->Families == MINIMUM ? 1 : 0;
  const int last = this->Families == MAXIMUM ? 0 : 1;
  for (int family = first; family <= last; ++family)
  {
    const auto ofFamily = [&](double done) { return progress((family - first + done) / (last - first + 1)); };
    const ink::FieldStreamlines lines =
      ink::evenFieldStreamlines(surface, samples, family == 0, negligible, options, ofFamily);
    if (InkCheckAbort(this))
    {
      return;
    }
    writer.Add(
      lines, family, [&](std::size_t n) { return glm::vec3(lines.points[n].normal); },
      [&](std::size_t n)
      {
        const ink::PrincipalCurvature here =
          ink::fieldCurvature(surface.form, lines.positions[n]).value_or(ink::PrincipalCurvature());
        return std::array<float, 2>{ static_cast<float>(here.k1), static_cast<float>(here.k2) };
      });
  }
}
