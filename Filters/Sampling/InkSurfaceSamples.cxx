// SPDX-License-Identifier: BSD-3-Clause
#include "InkSurfaceSamples.h"

#include "Core/FormatNumber.h"
#include "Core/ParallelChunks.h"
#include "Curves/Contours/EdgeOffsets.h"
#include "InkAllocate.h"
#include "InkMemoryBudget.h"
#include "InkPlaceSamples.h"
#include "InkSampleFaces.h"
#include "PointSampling/CoveringRadius.h"
#include "PointSampling/PoissonDiskCount.h"
#include "PointSampling/ProgressiveBlueNoise.h"
#include "PointSampling/WhiteNoise.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace
{

// The maximum memory per sample during generation, including its share of darts and its entry in the order.
constexpr double BytesWhite = 100.0;
constexpr double BytesBlue = 600.0;
constexpr double BytesProgressive = 200.0;

} // namespace

InkSurfaceSamples::InkSurfaceSamples(const InkMeshTriangles& triangles, const InkSampleRequest& request)
  : Triangles(triangles)
{
  if (request.ByRadius && !(request.Radius > 0.0 && std::isfinite(request.Radius)))
  {
    throw std::invalid_argument(
      "SampleRadius is " + ink::formatNumber(request.Radius) + "; expected a length above 0");
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
  constexpr std::uint32_t most = std::numeric_limits<std::uint32_t>::max() / 8;
  InkCheckMemory(count, bytes, "samples", most);
}

vtkSmartPointer<vtkPoints> InkSurfaceSamples::MakePoints(int type) const
{
  return InkPlacePoints(this->Triangles.GetMesh(), this->Samples, type);
}

vtkSmartPointer<vtkDataArray> InkSurfaceSamples::MakeNormals() const
{
  return InkPlaceNormals(this->Triangles.GetMesh(), this->Triangles.Normals, this->Samples);
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

vtkSmartPointer<vtkDataArray> InkSurfaceSamples::MakeEdgeOffsets(double radii) const
{
  const std::vector<ink::EdgeOffsets> offsets =
    ink::edgeOffsets(this->Triangles.GetMesh(), this->Triangles.Normals, this->Samples, radii * this->Cover);
  if (offsets.empty())
  {
    return nullptr;
  }
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName("EdgeOffsets");
  array->SetNumberOfComponents(6);
  InkSetNumberOfTuples(array, static_cast<vtkIdType>(offsets.size()));
  float* values = array->GetPointer(0);
  for (const auto& [first, second] : offsets)
  {
    values = std::copy_n(&first.x, 3, values);
    values = std::copy_n(&second.x, 3, values);
  }
  return array;
}

void InkSurfaceSamples::AddFaces(vtkPolyData* mesh, vtkPolyData* output) const
{
  InkAddFaces(this->Triangles, this->Samples, mesh, output);
}
