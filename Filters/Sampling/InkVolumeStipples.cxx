// SPDX-License-Identifier: BSD-3-Clause
#include "InkVolumeStipples.h"

#include "Core/ParallelChunks.h"
#include "Fields/Grid/GridField.h"
#include "Fields/Grid/PieceOwnership.h"
#include "Fields/Resampling/AxisResampling.h"
#include "InkAllocate.h"
#include "InkImageGrid.h"
#include "InkPointOutput.h"
#include "InkStippleFields.h"
#include "InkStippleOutput.h"
#include "InkWithGridField.h"
#include "Stippling/SmoothedVoxels.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

/// The percentile of the stippled voxels' magnitudes at which GradientMagnitude is 1, so that a few metal
/// parts or outlier voxels do not make all others nearly 0.
constexpr double ReferenceShare = 0.99;

/// The stippled voxels, their positions and normalization.
struct Elements
{
  double Lowest = 0.0; ///< the range that Value is relative to
  double Highest = 0.0;
  ink::stipple::StippledVoxels Voxels;
  /// The indices of the voxels in the output: the others are only neighbors.
  std::vector<std::size_t> Own;
  std::vector<glm::ivec3> Samples; ///< of those, in the grid
  double SteepestGradient = 0.0;   ///< the magnitude that GradientMagnitude is relative to
};

/// @return false when stopped
template <class T>
bool FindElements(const ink::GridField<T>& field, const InkVolumeStippleRequest& request, Elements& elements)
{
  const glm::dvec3 deviation = ink::smoothingDeviation(field.geometry(), request.Smoothing);
  ink::stipple::VolumeStatistics statistics;
  if (request.Statistics)
  {
    statistics = *request.Statistics;
  }
  else if (request.ByPercentile || !request.GivenRanges)
  {
    const ink::SampleBox whole{ glm::ivec3(0), field.geometry().dimensions() };
    if (!ink::stipple::measureVolume(field, deviation, { whole.end, whole }, request.Gradient, statistics,
          InkPartOfProgress(request.Progress, 0.0, 0.15)))
    {
      return false;
    }
  }
  ink::stipple::VoxelCriteria criteria;
  criteria.threshold = request.ByPercentile
    ? statistics.magnitudes.quantile(0.01 * request.Percentile)
    : static_cast<float>(std::min<double>(request.Threshold, std::numeric_limits<float>::max()));
  criteria.lowest = request.Window[0];
  criteria.highest = request.Window[1];
  if (request.GivenRanges)
  {
    elements.Lowest = request.ScalarRange[0];
    elements.Highest = request.ScalarRange[1];
    elements.SteepestGradient = request.SteepestGradient;
  }
  else
  {
    if (statistics.lowest <= statistics.highest)
    {
      elements.Lowest = statistics.lowest;
      elements.Highest = statistics.highest;
    }
    // Voxels without a gradient are never stippled.
    elements.SteepestGradient = statistics.magnitudes.quantile(
      ReferenceShare, std::max(criteria.threshold, std::numeric_limits<float>::min()));
  }

  ink::SampleBox box;
  box.begin = glm::max(request.Own.begin - ink::stipple::stippleReach, glm::ivec3(0));
  box.end = glm::min(request.Own.end + ink::stipple::stippleReach, field.geometry().dimensions());
  return ink::stipple::findStippledVoxels(field, deviation, box, request.Gradient, criteria, elements.Voxels,
    InkPartOfProgress(request.Progress, 0.15, 0.35));
}

/// Calls `use` with the image's scalars as a field.
/// @throws std::invalid_argument that says what is wrong with the image
template <class Use>
bool WithField(vtkImageData* image, const InkVolumeStippleRequest& request, const Use& use)
{
  const ink::GridGeometry geometry = InkMakeGrid(image, InkExtent(image->GetExtent()));
  int component = request.Component;
  const vtkSmartPointer<vtkDataArray> array = InkMakeContiguous(request.Scalars, component);
  const ink::ElementMarks hidden = InkGetMarks(image->GetPointData(), vtkDataSetAttributes::HIDDENPOINT);
  return InkWithGridField(geometry, array, component, hidden, use);
}

/// The samples whose voxels belong to the piece: those of its cells that are not marked as another piece's.
ink::PieceOwnership FindOwnership(vtkImageData* image, const InkVolumeStippleRequest& request)
{
  return { InkExtent(image->GetExtent()).GetDimensions(), request.Own,
    InkGetMarks(image->GetCellData(), vtkDataSetAttributes::DUPLICATECELL) };
}

/// The indices of the found voxels that belong to the piece.
void SelectOwn(const ink::PieceOwnership& own, Elements& elements)
{
  const ink::stipple::StippledVoxels& voxels = elements.Voxels;
  const ink::SampleBox& box = voxels.box;
  const auto& [begin, end] = own.box();
  for (int z = begin.z; z < end.z; ++z)
  {
    for (int y = begin.y; y < end.y; ++y)
    {
      const std::size_t row = static_cast<std::size_t>(y - box.begin.y) +
        static_cast<std::size_t>(box.size().y) * static_cast<std::size_t>(z - box.begin.z);
      for (std::size_t n = voxels.rows[row]; n < voxels.rows[row + 1]; ++n)
      {
        const glm::ivec3 sample(voxels.x[n], y, z);
        if (sample.x >= begin.x && sample.x < end.x && own.has(sample))
        {
          elements.Own.push_back(n);
          elements.Samples.push_back(sample);
        }
      }
    }
  }
}

template <class Real>
void WritePoints(const ink::GridGeometry& geometry, const Elements& elements,
  const std::vector<glm::vec3>& stipples, std::size_t perVoxel, Real* points)
{
  ink::parallelForEach(elements.Own.size(),
    [&](std::size_t e)
    {
      for (std::size_t rank = 0; rank < perVoxel; ++rank)
      {
        const glm::dvec3 world = geometry.toWorld(
          glm::dvec3(elements.Samples[e]) + glm::dvec3(stipples[elements.Own[e] * perVoxel + rank]));
        for (int axis = 0; axis < 3; ++axis)
        {
          points[3 * (e * perVoxel + rank) + static_cast<std::size_t>(axis)] = static_cast<Real>(world[axis]);
        }
      }
    });
}

vtkSmartPointer<vtkFloatArray> MakeArray(const char* name, int components, std::size_t count)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  InkSetNumberOfTuples(array, static_cast<vtkIdType>(count));
  return array;
}

/// The relative position of a value between two others, without overflow.
float ShareOf(double value, double lowest, double highest)
{
  const double range = 0.5 * highest - 0.5 * lowest;
  return range > 0.0 ? static_cast<float>(std::clamp((0.5 * value - 0.5 * lowest) / range, 0.0, 1.0)) : 0.0f;
}

void AddCellArrays(const Elements& elements, vtkPolyData* output)
{
  const std::size_t count = elements.Own.size();
  const auto normals = MakeArray("Normals", 3, count);
  const auto magnitudes = MakeArray("GradientMagnitude", 1, count);
  const auto values = MakeArray("Value", 1, count);
  float* normal = normals->GetPointer(0);
  float* magnitude = magnitudes->GetPointer(0);
  float* value = values->GetPointer(0);
  ink::parallelForEach(count,
    [&](std::size_t e)
    {
      const std::size_t voxel = elements.Own[e];
      const glm::dvec3 gradient(elements.Voxels.gradients[voxel]);
      const double length = glm::length(gradient);
      for (int axis = 0; axis < 3; ++axis)
      {
        normal[3 * e + static_cast<std::size_t>(axis)] = static_cast<float>(-gradient[axis] / length);
      }
      magnitude[e] = ShareOf(length, 0.0, elements.SteepestGradient);
      value[e] = ShareOf(elements.Voxels.values[voxel], elements.Lowest, elements.Highest);
    });
  output->GetCellData()->SetNormals(normals);
  output->GetCellData()->AddArray(magnitudes);
  output->GetCellData()->AddArray(values);
}

void AddColors(
  const ink::GridGeometry& geometry, const Elements& elements, vtkDataArray* colors, vtkPolyData* output)
{
  std::vector<vtkIdType> ids(elements.Samples.size());
  for (std::size_t e = 0; e < elements.Samples.size(); ++e)
  {
    ids[e] = static_cast<vtkIdType>(geometry.offset(elements.Samples[e]));
  }
  InkAddColors(output, InkPickTuples(colors, ids));
}

} // namespace

bool InkMeasureVolume(
  vtkImageData* image, const InkVolumeStippleRequest& request, ink::stipple::VolumeStatistics& statistics)
{
  const auto measure = [&](const auto& field)
  {
    return ink::stipple::measureVolume(field, ink::smoothingDeviation(field.geometry(), request.Smoothing),
      FindOwnership(image, request), request.Gradient, statistics, request.Progress);
  };
  return WithField(image, request, measure);
}

void InkMakeVolumeStipples(vtkImageData* image, const InkVolumeStippleRequest& request, vtkPolyData* output)
{
  const ink::GridGeometry geometry = InkMakeGrid(image, InkExtent(image->GetExtent()));
  Elements elements;
  if (!WithField(image, request, [&](const auto& field) { return FindElements(field, request, elements); }))
  {
    return;
  }
  SelectOwn(FindOwnership(image, request), elements);

  const auto perVoxel = static_cast<std::size_t>(request.Stipples.perVoxel);
  const std::size_t count = elements.Own.size() * perVoxel;
  const double placed = static_cast<double>(elements.Voxels.size() * perVoxel);
  InkCheckStippleMemory(placed, sizeof(glm::vec3) + (request.Doubles ? 24.0 : 12.0) + 8.0);
  const std::vector<glm::vec3> stipples = ink::stipple::placeVolumeStipples(
    geometry, elements.Voxels, request.Stipples, InkPartOfProgress(request.Progress, 0.35, 0.95));
  if (stipples.empty() && elements.Voxels.size() > 0)
  {
    return;
  }

  vtkNew<vtkPoints> points;
  points->SetDataType(request.Doubles ? VTK_DOUBLE : VTK_FLOAT);
  InkSetNumberOfPoints(points, static_cast<vtkIdType>(count));
  if (auto* floats = vtkFloatArray::SafeDownCast(points->GetData()))
  {
    WritePoints(geometry, elements, stipples, perVoxel, floats->GetPointer(0));
  }
  else
  {
    WritePoints(
      geometry, elements, stipples, perVoxel, vtkDoubleArray::SafeDownCast(points->GetData())->GetPointer(0));
  }
  output->SetPoints(points);
  std::vector<vtkIdType> begins(elements.Own.size() + 1);
  for (std::size_t e = 0; e < begins.size(); ++e)
  {
    begins[e] = static_cast<vtkIdType>(e) * static_cast<vtkIdType>(perVoxel);
  }
  output->SetVerts(InkMakePolyVertices(begins));
  AddCellArrays(elements, output);
  if (request.Colors)
  {
    AddColors(geometry, elements, request.Colors, output);
  }
  const double range[2] = { elements.Lowest, elements.Highest };
  const double magnitudes[2] = { 0.0, elements.SteepestGradient };
  const double perElement = request.Stipples.perVoxel;
  const double size = std::cbrt(std::abs(glm::determinant(geometry.stepToWorld())));
  InkAddStippleFields(output, InkElementKind::Volume, size, perElement);
  InkAddField(output, "ScalarRange", range);
  InkAddField(output, "GradientMagnitudeRange", magnitudes);
}
