// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkLinesOfCurvature.h"

#include "Core/Hash.h"
#include "Curvature/MeshCurvature.h"
#include "Curves/Streamlines/CombCrossField.h"
#include "Curves/Streamlines/EvenStreamlines.h"
#include "Curves/Streamlines/FlatDirections.h"
#include "Curves/Streamlines/ScatteredStreamlines.h"
#include "Curves/Streamlines/SmoothCrossField.h"
#include "InkHasPolygons.h"
#include "InkLineWriter.h"
#include "InkOutwardTriangles.h"
#include "InkReportException.h"
#include "InkVTKCompat.h"
#include "Mesh/FeatureSplit.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace
{

constexpr double DefaultScatterLength = 0.25;  ///< of the root of the area
constexpr double CombReach = 0.05;             ///< of the diagonal
constexpr double ScatterCloseDistance = 0.001; ///< of the root of the area
constexpr double FeatureReach = 2.0;           ///< of the spacing: what is rougher has no edges
constexpr auto& CurvatureNames = InkLineWriter::CurvatureNames;

/// The principal curvatures and directions of a mesh's points.
struct Curvatures
{
  std::array<std::vector<glm::dvec3>, 2> Directions; ///< of maximum and minimum curvature
  std::array<std::vector<float>, 2> Values;
  std::vector<float> Umbilics;

  /// @param negligible a curvature that counts as none
  void Add(const ink::PrincipalCurvature& point, double negligible)
  {
    const bool isFinite = std::isfinite(point.k1) && std::isfinite(point.k2);
    this->Values[0].push_back(isFinite ? static_cast<float>(point.k1) : 0.0f);
    this->Values[1].push_back(isFinite ? static_cast<float>(point.k2) : 0.0f);
    this->Umbilics.push_back(isFinite ? static_cast<float>(point.umbilicMeasure(negligible)) : 1.0f);
    this->Directions[0].push_back(Unit(point.direction1));
    this->Directions[1].push_back(Unit(point.direction2));
  }

  /// Zero where it has no length.
  static glm::dvec3 Unit(const glm::dvec3& v)
  {
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? v / length : glm::dvec3(0.0);
  }

  /// k1 and k2 between the corners of a triangle.
  std::array<float, 2> At(const ink::TriangleMesh& mesh, const ink::MeshPoint& point) const
  {
    const auto& [a, b, c] = mesh.triangles[point.triangle];
    const auto mean = [&, i = a, j = b, k = c](const std::vector<float>& values)
    {
      const glm::dvec3 corners(values[i], values[j], values[k]);
      return static_cast<float>(glm::dot(corners, point.weights));
    };
    return { mean(this->Values[0]), mean(this->Values[1]) };
  }

  /// How much the direction of the first one, 1, or that of the second one, -1, bends more.
  std::vector<float> FindPreferences(double negligible) const
  {
    std::vector<float> preferences;
    for (std::size_t i = 0; i < this->Umbilics.size(); ++i)
    {
      const float first = std::abs(this->Values[0][i]);
      const float second = std::abs(this->Values[1][i]);
      const float preference = (first - second) / (first + second + static_cast<float>(negligible));
      preferences.push_back(preference * std::abs(preference));
    }
    return preferences;
  }
};

/// Those of arrays of the mesh.
/// @param sources the points whose values are wanted
void ReadCurvatures(
  vtkPolyData* mesh, std::span<const std::uint32_t> sources, double negligible, Curvatures& result)
{
  vtkDataArray* arrays[4];
  for (int i = 0; i < 4; ++i)
  {
    arrays[i] = mesh->GetPointData()->GetArray(CurvatureNames[i]);
    const int components = i < 2 ? 1 : 3;
    if (arrays[i]->GetNumberOfComponents() != components ||
      arrays[i]->GetNumberOfTuples() != mesh->GetNumberOfPoints())
    {
      throw std::invalid_argument(std::string("the point array \"") + CurvatureNames[i] + "\" has " +
        std::to_string(arrays[i]->GetNumberOfTuples()) + " tuples of " +
        std::to_string(arrays[i]->GetNumberOfComponents()) + " components; expected " +
        std::to_string(mesh->GetNumberOfPoints()) + " of " + std::to_string(components));
    }
  }
  for (const std::uint32_t source : sources)
  {
    ink::PrincipalCurvature point;
    point.k1 = arrays[0]->GetComponent(source, 0);
    point.k2 = arrays[1]->GetComponent(source, 0);
    arrays[2]->GetTuple(source, &point.direction1.x);
    arrays[3]->GetTuple(source, &point.direction2.x);
    result.Add(point, negligible);
  }
}

/// @param triangles those of the mesh, cut open at feature edges
/// @param sources the mesh's points that theirs are
Curvatures CurvaturesOf(vtkPolyData* mesh, const InkMeshTriangles& triangles,
  std::span<const std::uint32_t> sources, double negligible, const ink::Progress& progress)
{
  Curvatures result;
  if (std::all_of(std::begin(CurvatureNames), std::end(CurvatureNames),
        [&](const char* name) { return mesh->GetPointData()->GetArray(name) != nullptr; }))
  {
    ReadCurvatures(mesh, sources, negligible, result);
    return result;
  }
  ink::CurvatureOptions options;
  options.seams = ink::Seams::Apart;
  for (const ink::PrincipalCurvature& point :
    ink::estimateCurvature(triangles.GetMesh(), triangles.Normals, options, progress).points)
  {
    result.Add(point, negligible);
  }
  return result;
}

/// Cuts a mesh open at feature edges. Normals of points are kept where all of their triangles stay together.
void SplitPoints(InkMeshTriangles& triangles, const ink::FeatureSplit& split)
{
  triangles.Normals = ink::splitNormals(split, triangles.GetMesh(), triangles.Normals);
  triangles.Points = split.spread<glm::dvec3>(triangles.Points);
  triangles.Triangles = split.triangles;
}

} // namespace

vtkStandardNewMacro(vtkInkLinesOfCurvature);

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
  InkMeshTriangles triangles = InkOutwardTriangles(mesh);
  ink::MeshNavigation navigation(triangles.GetMesh(), 180.0);
  const auto check = [&triangles](bool hasArea)
  {
    if (!hasArea)
    {
      throw std::invalid_argument("its " + std::to_string(triangles.Triangles.size()) +
        " triangles have no area; expected faces with three different points that are finite");
    }
  };
  check(navigation.area() > 0.0);
  const double diagonal = glm::distance(navigation.lower(), navigation.upper());
  const double spacing = this->Spacing > 0.0 ? this->Spacing : DefaultSpacing * diagonal;
  ink::cutFeatures(navigation, this->FeatureAngle, FeatureReach * spacing);
  const ink::FeatureSplit split = ink::splitAtFeatures(navigation);
  check(!split.sources.empty());
  SplitPoints(triangles, split);
  const ink::TriangleMesh surface = triangles.GetMesh();
  navigation.setMesh(surface);
  const double negligible =
    this->NegligibleCurvature > 0.0 ? this->NegligibleCurvature : DefaultNegligible / diagonal;
  Curvatures curvatures = CurvaturesOf(mesh, triangles, split.sources, negligible, progress);
  begun = 0.1;
  if (curvatures.Umbilics.empty() || !progress(0.0))
  {
    return;
  }
  if (this->SmoothDirections)
  {
    std::array<std::vector<glm::dvec3>, 2>& directions = curvatures.Directions;
    const std::vector<glm::dvec3> flat = ink::flatDirections(surface);
    for (std::size_t i = 0; i < flat.size(); ++i)
    {
      if (flat[i] != glm::dvec3(0.0))
      {
        directions[0][i] = flat[i];
        curvatures.Umbilics[i] = 1.0f;
      }
    }
    directions[0] = ink::smoothCrossField(surface, triangles.Normals, directions[0], curvatures.Umbilics,
      this->SmoothingIterations, progress, ink::Seams::Apart);
    for (std::size_t i = 0; i < directions[0].size(); ++i)
    {
      directions[1][i] = Curvatures::Unit(glm::cross(glm::dvec3(triangles.Normals[i]), directions[0][i]));
    }
    if (this->CombDirections)
    {
      std::vector<float> preferences = curvatures.FindPreferences(negligible);
      for (std::size_t i = 0; i < flat.size(); ++i)
      {
        preferences[i] = flat[i] != glm::dvec3(0.0) ? 1.0f : preferences[i];
      }
      const std::vector<unsigned char> exchanged = ink::combCrossField(surface, triangles.Normals,
        directions[0], preferences, CombReach * diagonal, progress, ink::Seams::Apart);
      if (InkCheckAbort(this))
      {
        return;
      }
      for (std::size_t i = 0; i < exchanged.size(); ++i)
      {
        if (exchanged[i])
        {
          std::swap(directions[0][i], directions[1][i]);
        }
      }
    }
  }

  ink::TraceOptions trace;
  trace.integrator =
    this->Integrator == EULER ? ink::StreamlineIntegrator::Euler : ink::StreamlineIntegrator::RungeKutta4;
  trace.stepFactor = this->StepFactor;
  trace.umbilicLimit = this->UmbilicLimit;
  trace.stopAtSingularities = this->SmoothDirections;
  const auto seed = static_cast<std::uint64_t>(this->Seed);
  const auto make = [&](int family)
  {
    const auto own = static_cast<std::size_t>(family);
    ink::LineField field{ curvatures.Directions[own], {}, curvatures.Umbilics };
    if (this->SmoothDirections)
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
      return ink::evenStreamlines(navigation, triangles.Normals, field, options, progress);
    }
    const double size = std::sqrt(navigation.area());
    trace.maximumLength = this->MaximumLength > 0.0 ? this->MaximumLength : DefaultScatterLength * size;
    trace.closeDistance = ScatterCloseDistance * size;
    std::vector<float> largest(curvatures.Umbilics.size());
    std::transform(curvatures.Values[0].begin(), curvatures.Values[0].end(), curvatures.Values[1].begin(),
      largest.begin(), [](float k1, float k2) { return std::max(std::abs(k1), std::abs(k2)); });
    const ink::AreaSeedOptions seeds{ static_cast<double>(this->NumberOfSeeds), this->SeedsPerTriangle,
      ink::hash(seed, static_cast<std::uint64_t>(family)), largest, this->CurvatureThreshold,
      this->CurvatureFactor };
    // Of the family's work a tenth.
    const ink::Progress seeding = [&](double done) { return progress(0.1 * done); };
    const std::vector<ink::MeshPoint> starts = ink::areaSeeds(navigation, seeds, seeding);
    return ink::scatteredStreamlines(
      navigation, field, starts, trace, seeds.seed, [&](double done) { return progress(0.1 + 0.9 * done); });
  };
  InkLineWriter writer(mesh->GetPoints()->GetDataType(), this->ComputeCurvatures);
  const int first = this->Families == MINIMUM ? 1 : 0;
  const int last = this->Families == MAXIMUM ? 0 : 1;
  share = 0.8 / (last - first + 1);
  begun = 0.2;
  for (int family = first; family <= last; ++family, begun += share)
  {
    const ink::Streamlines lines = make(family);
    if (InkCheckAbort(this))
    {
      return;
    }
    const std::vector<glm::vec3> normals = ink::normalsAt(navigation, triangles.Normals, lines.points);
    writer.Add(
      lines, family, [&](std::size_t n) { return normals[n]; },
      [&](std::size_t n) { return curvatures.At(surface, lines.points[n]); });
  }
  writer.Write(output);
  if (output->GetNumberOfLines() == 0)
  {
    vtkWarningMacro(
      "The surface has no lines: its directions are undefined everywhere, or it is smaller than "
      << "the least length of lines. Its bounds' diagonal is " << diagonal << "; expected more than "
      << (this->Seeding == EVENLY_SPACED ? this->MinimumLength * spacing : 0.0) << ".");
  }
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
}
