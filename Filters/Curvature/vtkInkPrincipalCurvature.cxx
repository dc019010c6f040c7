// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkPrincipalCurvature.h"

#include "Curvature/MeshCurvature.h"
#include "Curvature/SmoothedCurvature.h"
#include "Fields/Grid/GridField.h"
#include "InkAllocate.h"
#include "InkCellCenters.h"
#include "InkHasPolygons.h"
#include "InkImageGrid.h"
#include "InkMeshTriangles.h"
#include "InkNotFiniteFaces.h"
#include "InkPointNormals.h"
#include "InkPrecision.h"
#include "InkReportException.h"
#include "InkVTKCompat.h"
#include "InkWithGridField.h"
#include "IsoSurface/ResampledSamples.h"
#include "Mesh/FeatureSplit.h"
#include "Mesh/MeshNavigation.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkInkPrincipalCurvature);

namespace
{

using SDDP = vtkStreamingDemandDrivenPipeline;

/// The mesh, with ghost cells as any others, but without hidden ones.
vtkSmartPointer<vtkPolyData> WithGhosts(vtkPolyData* mesh)
{
  vtkUnsignedCharArray* ghosts = mesh->GetCellGhostArray();
  if (!ghosts)
  {
    return mesh;
  }
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(mesh);
  vtkNew<vtkUnsignedCharArray> hidden;
  hidden->DeepCopy(ghosts);
  for (vtkIdType cell = 0; cell < hidden->GetNumberOfTuples(); ++cell)
  {
    hidden->SetValue(
      cell, static_cast<unsigned char>(hidden->GetValue(cell) & ~vtkDataSetAttributes::DUPLICATECELL));
  }
  copy->GetCellData()->AddArray(hidden);
  return copy;
}

ink::CurvatureOptions OptionsOf(vtkInkPrincipalCurvature* filter)
{
  const bool isJet = filter->GetEstimator() == vtkInkPrincipalCurvature::JET;
  const bool derivatives = filter->GetComputeDerivative() && isJet && filter->GetDegree() == 3;
  return { isJet ? ink::CurvatureEstimator::Jet : ink::CurvatureEstimator::ExponentialMap,
    filter->GetNumberOfRings(), filter->GetAdaptive(), filter->GetDegree(), derivatives };
}

/// Of each point the curvature of the side that is largest around it.
ink::MeshCurvature OfSides(const InkMeshTriangles& triangles, const ink::MeshNavigation& navigation,
  ink::CurvatureOptions options, const ink::Progress& progress)
{
  const ink::FeatureSplit split = ink::splitAtFeatures(navigation);
  const std::vector<glm::dvec3> points = split.spread<glm::dvec3>(triangles.Points);
  const ink::TriangleMesh sides{ points, split.triangles, {}, {} };
  options.seams = ink::Seams::Apart;
  const ink::MeshCurvature ofSides = ink::estimateCurvature(
    sides, ink::splitNormals(split, triangles.GetMesh(), triangles.Normals), options, progress);
  if (ofSides.points.size() != points.size())
  {
    return {}; // aborted
  }
  std::vector<double> areas(points.size());
  std::vector<std::uint32_t> largest(triangles.Points.size(), ink::MeshNavigation::border);
  for (const auto& [a, b, c] : split.triangles)
  {
    const double area = glm::length(glm::cross(points[b] - points[a], points[c] - points[a]));
    for (const std::uint32_t side : { a, b, c })
    {
      areas[side] += area; // 0 of triangles that are not usable
    }
  }
  for (std::uint32_t t = 0; t < split.triangles.size(); ++t)
  {
    for (std::size_t i = 0; i < 3 && navigation.isUsable(t); ++i)
    {
      const std::uint32_t side = split.triangles[t][i];
      std::uint32_t& best = largest[triangles.Triangles[t][i]];
      best = best == ink::MeshNavigation::border || areas[side] > areas[best] ? side : best;
    }
  }
  ink::MeshCurvature result;
  result.points.resize(largest.size());
  result.sources.assign(largest.size(), ink::CurvatureSource::None);
  result.derivatives.resize(ofSides.derivatives.empty() ? 0 : largest.size());
  for (std::size_t i = 0; i < largest.size(); ++i)
  {
    if (const std::uint32_t side = largest[i]; side != ink::MeshNavigation::border)
    {
      result.points[i] = ofSides.points[side];
      result.sources[i] = ofSides.sources[side];
      if (!result.derivatives.empty())
      {
        result.derivatives[i] = ofSides.derivatives[side];
      }
    }
  }
  return result;
}

/// @param featureAngle in degrees; 180: neighborhoods go on over all edges
ink::MeshCurvature OfMesh(
  vtkPolyData* mesh, const ink::CurvatureOptions& options, double featureAngle, const ink::Progress& progress)
{
  const bool hasEdges = featureAngle < 180.0;
  const bool wantNormals = hasEdges || InkPointNormals(mesh) != nullptr;
  const InkMeshTriangles triangles(
    WithGhosts(mesh), wantNormals, InkMeshTriangles::Order::OfMesh, InkMeshTriangles::Repeats::Kept);
  if (hasEdges)
  {
    ink::MeshNavigation navigation(triangles.GetMesh(), 180.0);
    const double diagonal = glm::distance(navigation.lower(), navigation.upper());
    ink::cutFeatures(navigation, featureAngle, ink::defaultFeatureReach * diagonal);
    return OfSides(triangles, navigation, options, progress);
  }
  return ink::estimateCurvature(triangles.GetMesh(), triangles.Normals, options, progress);
}

/// Forgets the curvature of points outside the grid, where a field continues what is at its border.
void KeepWithin(const ink::GridGeometry& grid, double rounding, std::span<const glm::dvec3> positions,
  ink::MeshCurvature& found)
{
  for (std::size_t i = 0; i < found.points.size(); ++i)
  {
    const glm::dvec3 index = grid.toIndex(positions[i]);
    if (!(glm::all(glm::greaterThanEqual(index, glm::dvec3(-rounding))) &&
          glm::all(glm::lessThanEqual(index, glm::dvec3(grid.dimensions() - 1) + rounding))))
    {
      found.points[i] = {};
      found.sources[i] = ink::CurvatureSource::None;
      if (!found.derivatives.empty())
      {
        found.derivatives[i] = {};
      }
    }
  }
}

/// @param scalars contiguous
ink::MeshCurvature OfField(vtkPolyData* points, vtkImageData* image, vtkDataArray* scalars, int component,
  double smoothing, bool derivatives, const ink::Progress& progress)
{
  std::vector<glm::dvec3> positions(static_cast<std::size_t>(points->GetNumberOfPoints()));
  double largest = 0.0;
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    points->GetPoint(static_cast<vtkIdType>(i), &positions[i].x);
    for (int c = 0; c < 3; ++c)
    {
      const double size = std::abs(positions[i][c]);
      largest = std::isfinite(size) ? std::max(largest, size) : largest;
    }
  }
  const ink::GridGeometry geometry = InkMakeGrid(image, InkExtent(image->GetExtent()));
  const ink::ElementMarks hidden = InkGetMarks(image->GetPointData(), vtkDataSetAttributes::HIDDENPOINT);
  const bool isFlat = glm::any(glm::lessThan(geometry.dimensions(), glm::ivec3(2)));
  const glm::dvec3 deviation = isFlat
    ? glm::dvec3(0.0)
    : ink::makeIsoSurfaceResampling(geometry, smoothing, 1, ink::SmoothingTarget::Surface).deviation;
  ink::MeshCurvature found = InkWithGridField(geometry, scalars, component, hidden,
    [&]<class T>(const ink::GridField<T>& field)
    { return ink::smoothedCurvatures(field, deviation, positions, progress, derivatives); });
  // Points on the border are inside however their coordinates are rounded.
  const bool isDouble = points->GetPoints() && points->GetPoints()->GetDataType() == VTK_DOUBLE;
  const double epsilon =
    isDouble ? std::numeric_limits<double>::epsilon() : std::numeric_limits<float>::epsilon();
  KeepWithin(geometry, 4.0 * epsilon * (1.0 + largest / geometry.smallestSpacing()), positions, found);
  return found;
}

/// Adds the point arrays of a result.
class ArrayWriter
{
public:
  ArrayWriter(vtkPolyData* output, int type)
    : Output(output)
    , Type(type)
  {
  }

  /// @param value(i, c): component c at point i
  template <class Value>
  void Add(const char* name, int components, const Value& value)
  {
    const auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(this->Type));
    this->Fill(array, name, components, value);
  }
  template <class Value>
  void AddFlags(const char* name, const Value& value)
  {
    this->Fill(vtkNew<vtkUnsignedCharArray>(), name, 1, value);
  }

private:
  template <class Value>
  void Fill(vtkDataArray* array, const char* name, int components, const Value& value)
  {
    array->SetName(name);
    array->SetNumberOfComponents(components);
    InkSetNumberOfTuples(array, this->Output->GetNumberOfPoints());
    // What is too large for the type becomes its largest value.
    const double most = array->GetDataTypeMax();
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < components; ++c)
      {
        array->SetComponent(i, c, std::clamp<double>(value(static_cast<std::size_t>(i), c), -most, most));
      }
    }
    this->Output->GetPointData()->AddArray(array);
  }

  vtkPolyData* Output;
  int Type;
};

} // namespace

vtkInkPrincipalCurvature::vtkInkPrincipalCurvature()
{
  this->SetNumberOfInputPorts(2);
  this->SetInputArrayToProcess(
    0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
}

vtkInkPrincipalCurvature::~vtkInkPrincipalCurvature() = default;

void vtkInkPrincipalCurvature::SetFieldArray(const char* name)
{
  if (name && *name)
  {
    this->SetInputArrayToProcess(0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, name);
  }
  else
  {
    this->SetInputArrayToProcess(
      0, 1, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS);
  }
}

const char* vtkInkPrincipalCurvature::GetEstimatorAsString()
{
  return this->Estimator == JET ? "Jet" : "ExponentialMap";
}

const char* vtkInkPrincipalCurvature::GetOutputArraysPrecisionAsString()
{
  return InkNameOfPrecision(this->OutputArraysPrecision);
}

int vtkInkPrincipalCurvature::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  if (port == 1)
  {
    info->Set(INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkInkPrincipalCurvature::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!this->Superclass::RequestUpdateExtent(request, inputVector, outputVector))
  {
    return 0;
  }
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkInformation* mesh = inputVector[0]->GetInformationObject(0);
  vtkInformation* image = inputVector[1]->GetInformationObject(0);
  if (image)
  {
    // A piece of points may lie anywhere in the image.
    image->Set(SDDP::UPDATE_PIECE_NUMBER(), 0);
    image->Set(SDDP::UPDATE_NUMBER_OF_PIECES(), 1);
    image->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    if (int* whole = image->Get(SDDP::WHOLE_EXTENT()))
    {
      image->Set(SDDP::UPDATE_EXTENT(), whole, 6);
    }
  }
  else if (mesh && outInfo->Get(SDDP::UPDATE_NUMBER_OF_PIECES()) > 1)
  {
    // One more, for the normals of the last ring.
    mesh->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(),
      outInfo->Get(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS()) + ink::curvatureReach(OptionsOf(this)) + 1);
  }
  return 1;
}

int vtkInkPrincipalCurvature::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  InkPointInput points;
  inputVector = points.Take(this, inputVector, 1);
  vtkPolyData* mesh = vtkPolyData::GetData(inputVector[0]);
  vtkImageData* image = vtkImageData::GetData(inputVector[1]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const ink::Progress progress = [this](double share)
  {
    this->UpdateProgress(share);
    return !InkCheckAbort(this);
  };
  try
  {
    ink::MeshCurvature found;
    if (image)
    {
      int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
      vtkDataArray* scalars = this->GetInputArrayToProcess(0, inputVector, association);
      scalars = InkChooseScalars(this, image, scalars, association, 0);
      if (!scalars)
      {
        return 1;
      }
      int component = 0;
      const vtkSmartPointer<vtkDataArray> contiguous = InkMakeContiguous(scalars, component);
      found =
        OfField(mesh, image, contiguous, component, this->FieldSmoothing, this->ComputeDerivative, progress);
      if (!found.sources.empty() &&
        std::all_of(found.sources.begin(), found.sources.end(),
          [](ink::CurvatureSource source) { return source == ink::CurvatureSource::None; }))
      {
        vtkWarningMacro("None of the input's "
          << mesh->GetNumberOfPoints()
          << " points lies in the image, where it has a gradient; expected points on its iso-surfaces. All "
             "curvatures are 0.");
      }
    }
    else if (!InkHasPolygons(mesh))
    {
      if (mesh->GetNumberOfPoints() > 0)
      {
        vtkWarningMacro("The input has " << mesh->GetNumberOfPoints() << " points and no polygons or strips; "
                                         << "expected a surface, or an image at the second input.");
      }
      return 1;
    }
    else
    {
      const ink::CurvatureOptions options = OptionsOf(this);
      if (this->ComputeDerivative && !options.derivatives)
      {
        vtkWarningMacro("The estimator is " << this->GetEstimatorAsString() << " of degree " << this->Degree
                                            << "; expected Jet of degree 3 for ComputeDerivative. There is "
                                            << "no array CurvatureDerivative.");
      }
      found = OfMesh(mesh, options, this->FeatureAngle, progress);
      InkWarnOfNotFiniteFaces(this, mesh);
    }
    if (found.points.size() != static_cast<std::size_t>(mesh->GetNumberOfPoints()))
    {
      return 1; // aborted
    }
    output->ShallowCopy(mesh);
    ArrayWriter arrays(output, this->OutputArraysPrecision == SINGLE_PRECISION ? VTK_FLOAT : VTK_DOUBLE);
    const std::vector<ink::PrincipalCurvature>& at = found.points;
    arrays.Add("k1", 1, [&](std::size_t i, int) { return at[i].k1; });
    arrays.Add("k2", 1, [&](std::size_t i, int) { return at[i].k2; });
    arrays.Add("PrincipalDirection1", 3, [&](std::size_t i, int c) { return at[i].direction1[c]; });
    arrays.Add("PrincipalDirection2", 3, [&](std::size_t i, int c) { return at[i].direction2[c]; });
    if (this->ComputeMeanCurvature)
    {
      arrays.Add("MeanCurvature", 1, [&](std::size_t i, int) { return at[i].mean(); });
    }
    if (this->ComputeGaussCurvature)
    {
      arrays.Add("GaussCurvature", 1, [&](std::size_t i, int) { return at[i].gauss(); });
    }
    if (this->ComputeUmbilicMeasure)
    {
      constexpr double flat = 1e-6;
      const double size = mesh->GetLength();
      const double negligible = size > 0.0 && std::isfinite(size) ? flat / size : 0.0;
      arrays.Add("UmbilicMeasure", 1, [&](std::size_t i, int) { return at[i].umbilicMeasure(negligible); });
    }
    if (!found.derivatives.empty())
    {
      arrays.Add("CurvatureDerivative", 4,
        [&](std::size_t i, int c)
        {
          const ink::CurvatureDerivative& d = found.derivatives[i];
          return c == 0 ? d.c111 : c == 1 ? d.c112 : c == 2 ? d.c122 : d.c222;
        });
    }
    if (this->ComputeSource)
    {
      arrays.AddFlags("CurvatureSource", [&](std::size_t i, int) { return double(found.sources[i]); });
    }
  }
  catch (...)
  {
    InkReportException(this, output, "The curvature cannot be computed");
  }
  return 1;
}

void vtkInkPrincipalCurvature::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FieldSmoothing: " << this->FieldSmoothing << "\n";
  os << indent << "Estimator: " << this->GetEstimatorAsString() << "\n";
  os << indent << "NumberOfRings: " << this->NumberOfRings << "\n";
  os << indent << "Adaptive: " << this->Adaptive << "\n";
  os << indent << "Degree: " << this->Degree << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "ComputeMeanCurvature: " << this->ComputeMeanCurvature << "\n";
  os << indent << "ComputeGaussCurvature: " << this->ComputeGaussCurvature << "\n";
  os << indent << "ComputeUmbilicMeasure: " << this->ComputeUmbilicMeasure << "\n";
  os << indent << "ComputeDerivative: " << this->ComputeDerivative << "\n";
  os << indent << "ComputeSource: " << this->ComputeSource << "\n";
  os << indent << "OutputArraysPrecision: " << this->GetOutputArraysPrecisionAsString() << "\n";
}
