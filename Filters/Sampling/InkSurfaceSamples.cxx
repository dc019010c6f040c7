// SPDX-License-Identifier: BSD-3-Clause
#include "InkSurfaceSamples.h"

#include "Core/Hash.h"
#include "Core/ParallelChunks.h"
#include "InkAllocate.h"
#include "Mesh/SurfaceStretch.h"
#include "PointSampling/CoveringRadius.h"
#include "PointSampling/PoissonDiskCount.h"
#include "PointSampling/ProgressiveBlueNoise.h"
#include "PointSampling/WhiteNoise.h"
#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtksys/SystemInformation.hxx"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

namespace
{

constexpr const char* FaceIdName = "FaceId";
constexpr const char* FacePointsName = "FacePoints";
constexpr const char* BarycentricName = "BarycentricCoordinates";
constexpr const char* SampledMeshName = "SampledMesh";
constexpr const char* SampledPointsName = "SampledMeshPoints";
// Of triangles around a sample whose stretch counts, at the most.
constexpr int MostStretchRounds = 8;

// The maximum memory per sample during generation, including its share of darts and its entry in the order.
constexpr double BytesWhite = 100.0;
constexpr double BytesBlue = 600.0;
constexpr double BytesProgressive = 200.0;

std::string Text(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

template <class Real>
void PlacePoints(const ink::TriangleMesh& mesh, const std::vector<ink::SurfaceSample>& samples, Real* points)
{
  ink::parallelForEach(samples.size(),
    [&](std::size_t i)
    {
      const glm::dvec3 point = ink::positionOf(mesh, samples[i]);
      for (int axis = 0; axis < 3; ++axis)
      {
        points[3 * i + axis] = static_cast<Real>(point[axis]);
      }
    });
}

vtkSmartPointer<vtkPoints> PlacePoints(
  const ink::TriangleMesh& mesh, const std::vector<ink::SurfaceSample>& samples, int type)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataType(type == VTK_DOUBLE ? VTK_DOUBLE : VTK_FLOAT);
  InkSetNumberOfPoints(points, static_cast<vtkIdType>(samples.size()));
  if (auto* floats = vtkFloatArray::SafeDownCast(points->GetData()))
  {
    PlacePoints(mesh, samples, floats->GetPointer(0));
  }
  else
  {
    PlacePoints(mesh, samples, vtkDoubleArray::SafeDownCast(points->GetData())->GetPointer(0));
  }
  return points;
}

vtkSmartPointer<vtkFloatArray> PlaceNormals(const ink::TriangleMesh& mesh,
  const std::vector<glm::vec3>& normals, const std::vector<ink::SurfaceSample>& samples)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName("Normals");
  array->SetNumberOfComponents(3);
  InkSetNumberOfTuples(array, static_cast<vtkIdType>(samples.size()));
  ink::placeNormals(mesh, normals, samples, std::span<float>(array->GetPointer(0), 3 * samples.size()));
  return array;
}

/// For each point of the mesh, the factor by which discs around it must grow since the samples were made.
/// Empty if nothing has moved.
std::vector<float> GetStretch(const InkMeshTriangles& triangles, vtkPolyData* samples, vtkDataArray* radius)
{
  vtkDataArray* array = samples->GetFieldData()->GetArray(SampledPointsName);
  if (!array || array->GetNumberOfComponents() != 3 ||
    array->GetNumberOfTuples() != static_cast<vtkIdType>(triangles.Points.size()))
  {
    throw std::invalid_argument(std::string("the first frame's samples lack the field array ") +
      SampledPointsName + " with the mesh's " + std::to_string(triangles.Points.size()) +
      " points; expected samples made with KeepFaces");
  }
  std::vector<glm::dvec3> before(triangles.Points.size());
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    array->GetTuple(static_cast<vtkIdType>(i), &before[i].x);
  }
  if (before == triangles.Points)
  {
    return {};
  }
  // The number of rings that the widest disc reaches on triangles of mean size.
  const double area = triangles.Triangles.empty()
    ? 0.0
    : ink::cumulateArea({ before, triangles.Triangles, {}, {} }).area.back();
  const double side =
    1.5 * std::sqrt(area / static_cast<double>(std::max<std::size_t>(triangles.Triangles.size(), 1)));
  double range[2];
  radius->GetRange(range);
  const double rounds = side > 0.0 ? range[1] / side : 0.0;
  return ink::pointStretch(before, triangles.Points, triangles.Triangles,
    static_cast<int>(std::min(std::ceil(rounds), static_cast<double>(MostStretchRounds))));
}

} // namespace

InkSurfaceSamples::InkSurfaceSamples(const InkMeshTriangles& triangles, const InkSampleRequest& request)
  : Triangles(triangles)
{
  if (request.ByRadius && !(request.Radius > 0.0 && std::isfinite(request.Radius)))
  {
    throw std::invalid_argument("SampleRadius is " + Text(request.Radius) + "; expected a length above 0");
  }
  const ink::TriangleMesh mesh = triangles.GetMesh();
  // A mesh of only ghost cells belongs to another piece.
  if (mesh.triangles.empty())
  {
    return;
  }
  this->Areas = ink::cumulateArea(mesh);
  const double area = this->Areas.area.back();
  if (!(area > 0.0))
  {
    throw std::invalid_argument("its " + std::to_string(mesh.triangles.size()) +
      " triangles have no area; expected faces with three different points that are finite");
  }
  if (!(this->Areas.weights().back() > 0.0))
  {
    throw std::invalid_argument("the density is nowhere above 0 on a face with an area");
  }
  // Progressive samples have one radius at a time.
  const InkNoise noise =
    request.Noise == InkNoise::Progressive && mesh.hasDensity() ? InkNoise::Blue : request.Noise;
  const bool progressive = noise == InkNoise::Progressive;
  const double fitting = progressive ? ink::progressiveCount(ink::defaultCandidates) : ink::saturatedCount;
  const double count = request.ByRadius ? std::ceil(fitting * area / (request.Radius * request.Radius))
                                        : static_cast<double>(request.Count);
  this->CheckMemory(count, noise);

  const auto seed = static_cast<std::uint64_t>(request.Seed);
  if (progressive)
  {
    this->Samples = ink::sampleProgressively(mesh, this->Areas, triangles.Normals,
      static_cast<std::size_t>(count), ink::defaultCandidates, seed, request.Progress);
    this->Cover =
      ink::progressiveCover(area, static_cast<double>(this->Samples.size()), ink::defaultCandidates);
    return;
  }
  if (noise == InkNoise::Blue && !request.ByRadius)
  {
    this->Samples = ink::samplePoissonDiskCount(
      mesh, this->Areas, triangles.Normals, request.Count, request.CoverageSlack, seed, request.Progress)
                      .samples;
    this->Cover =
      ink::poissonDiskCover(area, static_cast<double>(this->Samples.size()), request.CoverageSlack);
    return;
  }
  const auto upTo = [&](double begin, double end)
  {
    return [&, begin, end](double done)
    { return !request.Progress || request.Progress(begin + done * (end - begin)); };
  };
  const double half = request.Priority ? 0.5 : 1.0;
  if (noise == InkNoise::Blue)
  {
    this->Samples =
      ink::samplePoissonDisk(mesh, this->Areas, request.Radius, request.CoverageSlack, seed, upTo(0.0, half))
        .samples;
    this->Cover = ink::poissonDiskCover(request.Radius, request.CoverageSlack);
  }
  else if (request.ByRadius && !triangles.Names.empty() && !mesh.hasDensity())
  {
    this->Samples = ink::sampleWhiteNoise(
      mesh, triangles.Names, ink::saturatedCount / (request.Radius * request.Radius), seed, upTo(0.0, half));
    this->Cover = ink::whiteNoiseCover(area, count);
  }
  else
  {
    this->Samples =
      ink::sampleWhiteNoise(mesh, this->Areas, static_cast<std::size_t>(count), seed, upTo(0.0, half));
    this->Cover = ink::whiteNoiseCover(area, count);
  }
  if (request.Priority &&
    !ink::sortByPriority(mesh, this->Areas, triangles.Normals, this->Samples, seed, upTo(half, 1.0)))
  {
    this->Samples.clear();
  }
}

void InkSurfaceSamples::CheckMemory(double count, InkNoise noise) const
{
  const double bytes = noise == InkNoise::White ? BytesWhite
    : noise == InkNoise::Blue                   ? BytesBlue
                                                : BytesProgressive;
  vtksys::SystemInformation system;
  const double available = 1024.0 * static_cast<double>(system.GetHostMemoryTotal());
  const double needed = count * bytes;
  constexpr std::uint32_t limit = std::numeric_limits<std::uint32_t>::max() / 8;
  constexpr double most = limit;
  if (needed > available || count > most)
  {
    throw std::invalid_argument(Text(count) + " samples would take " + Text(needed / 0x1p30) +
      " GiB of memory; expected no more than " + Text(std::floor(std::min(available / bytes, most))) +
      " samples on this machine");
  }
}

vtkSmartPointer<vtkPoints> InkSurfaceSamples::MakePoints(int type) const
{
  return PlacePoints(this->Triangles.GetMesh(), this->Samples, type);
}

vtkSmartPointer<vtkDataArray> InkSurfaceSamples::MakeNormals() const
{
  return PlaceNormals(this->Triangles.GetMesh(), this->Triangles.Normals, this->Samples);
}

vtkSmartPointer<vtkDataArray> InkSurfaceSamples::MakeRadius(int type) const
{
  const ink::TriangleMesh mesh = this->Triangles.GetMesh();
  const auto fill = [&](auto* radii)
  {
    using Real = typename std::remove_pointer_t<decltype(radii)>::ValueType;
    radii->SetName("Radius");
    InkSetNumberOfTuples(radii, static_cast<vtkIdType>(this->Samples.size()));
    const ink::LocalRadius local(mesh, this->Areas, this->Cover);
    Real* values = radii->GetPointer(0);
    ink::parallelForEach(this->Samples.size(),
      [&](std::size_t i)
      {
        values[i] = static_cast<Real>(
          mesh.hasDensity() ? local.at(ink::densityOf(mesh, this->Samples[i])) : this->Cover);
      });
    return vtkSmartPointer<vtkDataArray>(radii);
  };
  if (this->Samples.empty() || type != VTK_DOUBLE)
  {
    vtkNew<vtkFloatArray> radii;
    return this->Samples.empty() ? (radii->SetName("Radius"), vtkSmartPointer<vtkDataArray>(radii))
                                 : fill(radii.Get());
  }
  vtkNew<vtkDoubleArray> radii;
  return fill(radii.Get());
}

void InkSurfaceSamples::AddFaces(vtkPolyData* mesh, vtkPolyData* output) const
{
  const auto count = static_cast<vtkIdType>(this->Samples.size());
  vtkNew<vtkIdTypeArray> faces;
  faces->SetName(FaceIdName);
  InkSetNumberOfTuples(faces, count);
  vtkNew<vtkIdTypeArray> points;
  points->SetName(FacePointsName);
  points->SetNumberOfComponents(3);
  InkSetNumberOfTuples(points, count);
  vtkNew<vtkFloatArray> weights;
  weights->SetName(BarycentricName);
  weights->SetNumberOfComponents(3);
  InkSetNumberOfTuples(weights, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const ink::SurfaceSample& sample = this->Samples[static_cast<std::size_t>(i)];
    faces->SetValue(i, this->Triangles.FaceIds[sample.triangle]);
    const ink::Triangle& corners = this->Triangles.Triangles[sample.triangle];
    for (int corner = 0; corner < 3; ++corner)
    {
      points->SetTypedComponent(i, corner, corners[static_cast<std::size_t>(corner)]);
    }
    // Rounding may make the sum of the others exceed 1.
    weights->SetTypedComponent(i, 0, std::max(1.0f - sample.b1 - sample.b2, 0.0f));
    weights->SetTypedComponent(i, 1, sample.b1);
    weights->SetTypedComponent(i, 2, sample.b2);
  }
  output->GetPointData()->AddArray(faces);
  output->GetPointData()->AddArray(points);
  output->GetPointData()->AddArray(weights);
  vtkNew<vtkDoubleArray> sampled;
  sampled->SetName(SampledMeshName);
  sampled->SetNumberOfComponents(3);
  sampled->InsertNextTuple3(static_cast<double>(mesh->GetNumberOfCells()),
    static_cast<double>(mesh->GetNumberOfPoints()), InkFacesHash(mesh));
  vtkSmartPointer<vtkDataArray> before = vtk::TakeSmartPointer(mesh->GetPoints()->GetData()->NewInstance());
  before->DeepCopy(mesh->GetPoints()->GetData());
  before->SetName(SampledPointsName);
  output->GetFieldData()->AddArray(before);
  output->GetFieldData()->AddArray(sampled);
}

vtkDataArray* InkGetDensity(vtkPolyData* mesh, const char* name, int association)
{
  const bool ofCells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  vtkDataSetAttributes* data = ofCells ? static_cast<vtkDataSetAttributes*>(mesh->GetCellData())
                                       : static_cast<vtkDataSetAttributes*>(mesh->GetPointData());
  const vtkIdType expected = ofCells ? mesh->GetNumberOfCells() : mesh->GetNumberOfPoints();
  const std::string kind = ofCells ? "cell" : "point";
  vtkDataArray* density = data->GetArray(name);
  if (!density)
  {
    std::string found;
    for (int i = 0; i < data->GetNumberOfArrays(); ++i)
    {
      const char* other = data->GetArrayName(i);
      found += (i ? ", \"" : "\"") + std::string(other ? other : "") + "\"";
    }
    throw std::invalid_argument("there is no numeric " + kind + " array \"" + name +
      "\" for the density; found " + (found.empty() ? "none" : found));
  }
  if (density->GetNumberOfComponents() != 1 || density->GetNumberOfTuples() != expected)
  {
    throw std::invalid_argument("the density array " + std::string(name) + " has " +
      std::to_string(density->GetNumberOfTuples()) + " values of " +
      std::to_string(density->GetNumberOfComponents()) + " components; expected " + std::to_string(expected) +
      " of 1");
  }
  return density;
}

std::string InkDescribeUnusableDensity(vtkDataArray* density)
{
  vtkIdType negative = 0;
  vtkIdType notNumbers = 0;
  for (vtkIdType i = 0; i < density->GetNumberOfTuples(); ++i)
  {
    const double value = density->GetComponent(i, 0);
    negative += value < 0.0 ? 1 : 0;
    notNumbers += std::isnan(value) ? 1 : 0;
  }
  std::string text = negative > 0 ? std::to_string(negative) + " negative values" : "";
  if (notNumbers > 0)
  {
    text += (text.empty() ? "" : " and ") + std::to_string(notNumbers) + " that are NaN";
  }
  return text;
}

double InkFacesHash(vtkPolyData* mesh)
{
  std::uint64_t all = 0;
  for (vtkCellArray* faces : { mesh->GetPolys(), mesh->GetStrips() })
  {
    const auto face = vtk::TakeSmartPointer(faces->NewIterator());
    for (face->GoToFirstCell(); !face->IsDoneWithTraversal(); face->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* points = nullptr;
      face->GetCurrentCell(size, points);
      all = ink::hash(all, static_cast<std::uint64_t>(size));
      for (vtkIdType i = 0; i < size; ++i)
      {
        all = ink::hash(all, static_cast<std::uint64_t>(points[i]));
      }
    }
  }
  return static_cast<double>(all >> 11);
}

bool InkAreSamplesOf(vtkPolyData* samples, vtkPolyData* mesh)
{
  vtkDataArray* sampled = samples->GetFieldData()->GetArray(SampledMeshName);
  return sampled && sampled->GetNumberOfComponents() == 3 && sampled->GetNumberOfTuples() == 1 &&
    sampled->GetComponent(0, 0) == static_cast<double>(mesh->GetNumberOfCells()) &&
    sampled->GetComponent(0, 1) == static_cast<double>(mesh->GetNumberOfPoints()) &&
    sampled->GetComponent(0, 2) == InkFacesHash(mesh);
}

void InkRemoveFaces(vtkPolyData* samples)
{
  for (const char* name : { FaceIdName, FacePointsName, BarycentricName })
  {
    samples->GetPointData()->RemoveArray(name);
  }
  for (const char* name : { SampledMeshName, SampledPointsName })
  {
    samples->GetFieldData()->RemoveArray(name);
  }
}

void InkMoveSamples(vtkPolyData* mesh, vtkPolyData* samples, bool normals, int type, vtkPolyData* output)
{
  const vtkIdType count = samples->GetNumberOfPoints();
  if (count == 0)
  {
    return;
  }
  vtkDataArray* corners = samples->GetPointData()->GetArray(FacePointsName);
  vtkDataArray* weights = samples->GetPointData()->GetArray(BarycentricName);
  vtkDataArray* sampled = samples->GetFieldData()->GetArray(SampledMeshName);
  if (!corners || !weights || !sampled || corners->GetNumberOfComponents() != 3 ||
    weights->GetNumberOfComponents() != 3 || sampled->GetNumberOfComponents() != 3 ||
    sampled->GetNumberOfTuples() != 1)
  {
    throw std::invalid_argument(std::string("the first frame's samples lack one of the arrays ") +
      FacePointsName + ", " + BarycentricName + " and " + SampledMeshName +
      "; expected samples made with KeepFaces");
  }
  const auto cells = static_cast<vtkIdType>(sampled->GetComponent(0, 0));
  const auto points = static_cast<vtkIdType>(sampled->GetComponent(0, 1));
  if (cells != mesh->GetNumberOfCells() || points != mesh->GetNumberOfPoints())
  {
    throw std::invalid_argument("it has " + std::to_string(mesh->GetNumberOfCells()) + " cells and " +
      std::to_string(mesh->GetNumberOfPoints()) + " points; expected " + std::to_string(cells) + " and " +
      std::to_string(points) + " as in the mesh that the first frame's samples were made of");
  }
  if (sampled->GetComponent(0, 2) != InkFacesHash(mesh))
  {
    throw std::invalid_argument("its faces join other points than those of the mesh that the first frame's "
                                "samples were made of; expected the same " +
      std::to_string(cells) + " cells, deformed");
  }
  InkMeshTriangles triangles(mesh, normals, InkMeshTriangles::Order::OfMesh);
  vtkDataArray* radius = samples->GetPointData()->GetArray("Radius");
  const std::vector<float> stretch = radius ? GetStretch(triangles, samples, radius) : std::vector<float>();
  // Each sample has its own triangle.
  triangles.Triangles.resize(static_cast<std::size_t>(count));
  std::vector<ink::SurfaceSample> positions(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto sample = static_cast<std::size_t>(i);
    for (int corner = 0; corner < 3; ++corner)
    {
      const double point = corners->GetComponent(i, corner);
      if (!(point >= 0.0 && point < static_cast<double>(points)))
      {
        throw std::invalid_argument("the first frame's sample " + std::to_string(i) + " is on the point " +
          Text(point) + "; expected 0 to " + std::to_string(points - 1));
      }
      triangles.Triangles[sample][static_cast<std::size_t>(corner)] = static_cast<std::uint32_t>(point);
    }
    positions[sample] = { static_cast<std::uint32_t>(i), static_cast<float>(weights->GetComponent(i, 1)),
      static_cast<float>(weights->GetComponent(i, 2)) };
  }
  output->ShallowCopy(samples);
  output->SetPoints(PlacePoints(triangles.GetMesh(), positions, type));
  if (normals)
  {
    output->GetPointData()->SetNormals(PlaceNormals(triangles.GetMesh(), triangles.Normals, positions));
  }
  if (!stretch.empty())
  {
    vtkSmartPointer<vtkDataArray> grown = vtk::TakeSmartPointer(radius->NewInstance());
    grown->DeepCopy(radius);
    for (vtkIdType i = 0; i < count; ++i)
    {
      const auto sample = static_cast<std::size_t>(i);
      const auto& [a, b, c] = triangles.Triangles[sample];
      const double b1 = static_cast<double>(positions[sample].b1);
      const double b2 = static_cast<double>(positions[sample].b2);
      const double here = (1.0 - b1 - b2) * stretch[a] + b1 * stretch[b] + b2 * stretch[c];
      grown->SetComponent(i, 0, here * radius->GetComponent(i, 0));
    }
    output->GetPointData()->AddArray(grown);
  }
}
