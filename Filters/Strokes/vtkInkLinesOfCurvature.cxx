// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkLinesOfCurvature.h"

#include "Core/Hash.h"
#include "Curves/Streamlines/CombDirections.h"
#include "Curves/Streamlines/EvenStreamlines.h"
#include "Curves/Streamlines/ScatteredStreamlines.h"
#include "Curves/Streamlines/SmoothCrossField.h"
#include "InkHasPolygons.h"
#include "InkLineWriter.h"
#include "InkNotFiniteFaces.h"
#include "InkOutwardTriangles.h"
#include "InkPointCurvatures.h"
#include "InkRegion.h"
#include "InkReportException.h"
#include "InkVTKCompat.h"
#include "Mesh/FeatureSplit.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPlanes.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace
{

constexpr double DefaultScatterLength = 0.25;  ///< of the root of the area
constexpr double ScatterCloseDistance = 0.001; ///< of the root of the area
constexpr double FeatureReach = 2.0;           ///< of the spacing: what is rougher has no edges

/// Cuts a mesh open at feature edges. Normals of points are kept where all of their triangles stay together.
void SplitPoints(InkMeshTriangles& triangles, const ink::FeatureSplit& split)
{
  triangles.Normals = ink::splitNormals(split, triangles.GetMesh(), triangles.Normals);
  triangles.Points = split.spread<glm::dvec3>(triangles.Points);
  triangles.Triangles = split.triangles;
}

} // namespace

/// A mesh that is cut open at its feature edges, with what lines follow.
struct vtkInkLinesOfCurvature::Surface
{
  InkMeshTriangles triangles;
  ink::MeshNavigation navigation;
  InkPointCurvatures curvatures;
  double diagonal = 0.0; ///< of the bounds
  double spacing = 0.0;
  double negligible = 0.0; ///< a curvature that counts as none

  explicit Surface(InkMeshTriangles&& mesh)
    : triangles(std::move(mesh))
    , navigation(this->triangles.GetMesh(), 180.0)
  {
    this->Require(this->navigation.area() > 0.0);
    this->diagonal = glm::distance(this->navigation.lower(), this->navigation.upper());
  }

  /// @param angle that is a feature edge's at least, degrees
  /// @return the mesh's points that those of the triangles are
  std::vector<std::uint32_t> CutFeatures(double angle)
  {
    ink::cutFeatures(this->navigation, angle, FeatureReach * this->spacing);
    const ink::FeatureSplit split = ink::splitAtFeatures(this->navigation);
    this->Require(!split.sources.empty());
    SplitPoints(this->triangles, split);
    this->navigation.setMesh(this->triangles.GetMesh());
    return split.sources;
  }

private:
  void Require(bool hasArea) const
  {
    if (!hasArea)
    {
      throw std::invalid_argument("its " + std::to_string(this->triangles.Triangles.size()) +
        " triangles have no area; expected faces with three different points that are finite");
    }
  }
};

/// The part of a surface that has lines.
struct vtkInkLinesOfCurvature::Part
{
  std::vector<ink::Triangle> triangles;
  ink::MeshNavigation navigation;
  double share; ///< of the surface's area

  Part(const Surface& cut, std::span<const ink::HalfSpace> region)
    : Part(cut, ink::trianglesWithin(cut.triangles.GetMesh(), region))
  {
  }

private:
  Part(const Surface& cut, std::span<const std::uint32_t> ids)
    : triangles(Chosen(cut, ids))
    , navigation(cut.navigation.part({ cut.triangles.Points, this->triangles, {}, {} }, ids))
    , share(this->navigation.area() / cut.navigation.area())
  {
  }
  static std::vector<ink::Triangle> Chosen(const Surface& cut, std::span<const std::uint32_t> ids)
  {
    std::vector<ink::Triangle> chosen;
    chosen.reserve(ids.size());
    for (const std::uint32_t id : ids)
    {
      chosen.push_back(cut.triangles.Triangles[id]);
    }
    return chosen;
  }
};

/// What is traced of one family.
struct vtkInkLinesOfCurvature::Traced
{
  ink::Streamlines Lines;
};

vtkStandardNewMacro(vtkInkLinesOfCurvature);

vtkInkLinesOfCurvature::~vtkInkLinesOfCurvature() = default;

void vtkInkLinesOfCurvature::SetRegion(vtkPlanes* region)
{
  if (this->Region != region)
  {
    this->Region = region;
    this->Modified();
  }
}

vtkPlanes* vtkInkLinesOfCurvature::GetRegion()
{
  return this->Region;
}

vtkMTimeType vtkInkLinesOfCurvature::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Region ? std::max(own, this->Region->GetMTime()) : own;
}

const char* vtkInkLinesOfCurvature::GetFamiliesAsString()
{
  return this->Families == MAXIMUM ? "Maximum" : this->Families == MINIMUM ? "Minimum" : "Both";
}

const char* vtkInkLinesOfCurvature::GetSeedingAsString()
{
  return this->Seeding == EVENLY_SPACED ? "EvenlySpaced" : "AreaScatter";
}

const char* vtkInkLinesOfCurvature::GetIntegratorAsString()
{
  return this->Integrator == EULER ? "Euler" : "RungeKutta4";
}

int vtkInkLinesOfCurvature::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  vtkImageData* image = vtkImageData::GetData(inputVector[0]);
  try
  {
    if (image)
    {
      this->MakeLinesOfImage(inputVector, output);
    }
    else
    {
      this->MakeLines(vtkPolyData::GetData(inputVector[0]), output);
    }
  }
  catch (...)
  {
    InkReportException(this, output,
      image ? "The lines of curvature of the image cannot be made"
            : "The lines of curvature of the mesh cannot be made");
  }
  return 1;
}

void vtkInkLinesOfCurvature::MakeLines(vtkPolyData* mesh, vtkPolyData* output)
{
  if (!InkHasPolygons(mesh))
  {
    if (mesh->GetNumberOfPoints() > 0)
    {
      vtkWarningMacro("The input has " << mesh->GetNumberOfPoints() << " points and no polygons or strips; "
                                       << "expected a surface. There are no lines.");
    }
    return;
  }
  // The work's shares: curvature and smoothing a fifth, and the families the rest.
  double begun = 0.0;
  double share = 0.1;
  const ink::Progress progress = [&](double done)
  {
    this->UpdateProgress(begun + share * done);
    return !InkCheckAbort(this);
  };
  Surface cut(InkOutwardTriangles(mesh));
  cut.spacing = this->Spacing > 0.0 ? this->Spacing : DefaultSpacing * cut.diagonal;
  cut.negligible =
    this->NegligibleCurvature > 0.0 ? this->NegligibleCurvature : DefaultNegligible / cut.diagonal;
  const std::vector<std::uint32_t> sources = cut.CutFeatures(this->FeatureAngle);
  cut.curvatures = InkFindPointCurvatures(mesh, cut.triangles, sources, cut.negligible, progress);
  begun = 0.1;
  if (cut.curvatures.Umbilics.empty() || !progress(0.0))
  {
    return;
  }
  this->FindDirections(cut, progress);
  if (InkCheckAbort(this))
  {
    return;
  }
  const Part part(cut, InkRegion(this->Region));
  InkLineWriter writer(mesh->GetPoints()->GetDataType(), this->ComputeCurvatures);
  const int first = this->Families == MINIMUM ? 1 : 0;
  const int last = this->Families == MAXIMUM ? 0 : 1;
  share = 0.8 / (last - first + 1);
  begun = 0.2;
  for (int family = first; family <= last; ++family, begun += share)
  {
    const ink::Streamlines lines = this->TraceFamily(cut, part, family, progress).Lines;
    if (InkCheckAbort(this))
    {
      return;
    }
    const std::vector<glm::vec3> normals =
      ink::normalsAt(part.navigation, cut.triangles.Normals, lines.points);
    writer.Add(
      lines, family, [&](std::size_t n) { return normals[n]; },
      [&](std::size_t n) { return cut.curvatures.At(part.navigation.mesh(), lines.points[n]); });
  }
  writer.Write(output);
  if (output->GetNumberOfLines() == 0 && !this->Region)
  {
    vtkWarningMacro(
      "The surface has no lines: its directions are undefined everywhere, or it is smaller than "
      << "the least length of lines. Its bounds' diagonal is " << cut.diagonal << "; expected more than "
      << (this->Seeding == EVENLY_SPACED ? this->MinimumLength * cut.spacing : 0.0) << ".");
    return;
  }
  InkWarnOfNotFiniteFaces(this, mesh);
}

void vtkInkLinesOfCurvature::FindDirections(Surface& cut, const std::function<bool(double)>& progress)
{
  const InkMeshTriangles& triangles = cut.triangles;
  InkPointCurvatures& curvatures = cut.curvatures;
  const ink::TriangleMesh surface = triangles.GetMesh();
  if (this->SmoothDirections)
  {
    const auto smooth = [&](const std::vector<glm::dvec3>& directions, const std::vector<float>& preferences)
    {
      return this->CombDirections
        ? ink::combDirections(
            surface, triangles.Normals, directions, curvatures.Umbilics, preferences, cut.spacing, progress)
        : ink::smoothCrossField(surface, triangles.Normals, directions, curvatures.Umbilics,
            this->SmoothingIterations, progress, ink::Seams::Apart);
    };
    curvatures.FollowForm(surface, triangles.Normals, cut.negligible, cut.spacing, smooth);
  }
}

vtkInkLinesOfCurvature::Traced vtkInkLinesOfCurvature::TraceFamily(
  const Surface& cut, const Part& part, int family, const std::function<bool(double)>& progress)
{
  const auto& [triangles, navigation, curvatures, diagonal, spacing, negligible] = cut;
  ink::TraceOptions trace;
  trace.integrator =
    this->Integrator == EULER ? ink::StreamlineIntegrator::Euler : ink::StreamlineIntegrator::RungeKutta4;
  trace.stepFactor = this->StepFactor;
  trace.umbilicLimit = this->UmbilicLimit;
  trace.stopAtSingularities = this->SmoothDirections;
  const auto seed = static_cast<std::uint64_t>(this->Seed);
  const auto own = static_cast<std::size_t>(family);
  ink::LineField field{ curvatures.Directions[own], {}, curvatures.Umbilics };
  if (this->SmoothDirections && !this->CombDirections)
  {
    field.others = curvatures.Directions[1 - own];
  }
  if (this->Seeding == EVENLY_SPACED)
  {
    ink::EvenStreamlineOptions options{ trace, spacing, this->StopDistance, this->MinimumLength, seed };
    if (this->MaximumLength > 0.0)
    {
      options.trace.maximumLength = this->MaximumLength;
    }
    return { ink::evenStreamlines(part.navigation, triangles.Normals, field, options, progress) };
  }
  const double size = std::sqrt(navigation.area());
  trace.maximumLength = this->MaximumLength > 0.0 ? this->MaximumLength : DefaultScatterLength * size;
  trace.closeDistance = ScatterCloseDistance * size;
  std::vector<float> largest(curvatures.Points.size());
  std::transform(curvatures.Points.begin(), curvatures.Points.end(), largest.begin(),
    [](const ink::PrincipalCurvature& at)
    { return static_cast<float>(std::max(std::abs(at.k1), std::abs(at.k2))); });
  const ink::AreaSeedOptions seeds{ part.share * this->NumberOfSeeds, this->SeedsPerTriangle,
    ink::hash(seed, static_cast<std::uint64_t>(family)), largest, this->CurvatureThreshold,
    this->CurvatureFactor };
  // Of the family's work a tenth.
  const ink::Progress seeding = [&](double done) { return progress(0.1 * done); };
  const std::vector<ink::MeshPoint> starts = ink::areaSeeds(part.navigation, seeds, seeding);
  return { ink::scatteredStreamlines(part.navigation, field, starts, trace, seeds.seed,
    [&](double done) { return progress(0.1 + 0.9 * done); }) };
}

void vtkInkLinesOfCurvature::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Families: " << this->GetFamiliesAsString() << "\n";
  os << indent << "Seeding: " << this->GetSeedingAsString() << "\n";
  os << indent << "IsoValue: " << this->IsoValue << "\n";
  os << indent << "FieldSmoothing: " << this->FieldSmoothing << "\n";
  os << indent << "Spacing: " << this->Spacing << "\n";
  os << indent << "StopDistance: " << this->StopDistance << "\n";
  os << indent << "NumberOfSeeds: " << this->NumberOfSeeds << "\n";
  os << indent << "SeedsPerTriangle: " << this->SeedsPerTriangle << "\n";
  os << indent << "CurvatureThreshold: " << this->CurvatureThreshold << "\n";
  os << indent << "CurvatureFactor: " << this->CurvatureFactor << "\n";
  os << indent << "MaximumLength: " << this->MaximumLength << "\n";
  os << indent << "MinimumLength: " << this->MinimumLength << "\n";
  os << indent << "Integrator: " << this->GetIntegratorAsString() << "\n";
  os << indent << "StepFactor: " << this->StepFactor << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "UmbilicLimit: " << this->UmbilicLimit << "\n";
  os << indent << "SmoothDirections: " << this->SmoothDirections << "\n";
  os << indent << "CombDirections: " << this->CombDirections << "\n";
  os << indent << "NegligibleCurvature: " << this->NegligibleCurvature << "\n";
  os << indent << "SmoothingIterations: " << this->SmoothingIterations << "\n";
  os << indent << "ComputeCurvatures: " << this->ComputeCurvatures << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  os << indent << "Region: " << this->Region << "\n";
}
