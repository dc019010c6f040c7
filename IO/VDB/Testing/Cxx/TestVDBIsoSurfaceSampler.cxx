// SPDX-License-Identifier: BSD-3-Clause
// vtkInkVDBIsoSurfaceSampler makes the points that vtkInkIsoSurfaceSampler makes of vtkInkVDBReader's image.

#include "InkTestChecks.h"
#include "VDBTestFiles.h"

#include "vtkImageData.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkInkVDBIsoSurfaceSampler.h"
#include "vtkInkVDBReader.h"
#include "vtkNew.h"

#include <cmath>
#include <cstdlib>

namespace
{

/// Settings that both samplers have.
struct Settings
{
  int NormalMethod = vtkInkIsoSurfaceSampler::CENTRAL_DIFFERENCE;
  int Arithmetic = vtkAlgorithm::SINGLE_PRECISION;
  int Points = vtkAlgorithm::DEFAULT_PRECISION;

  template <class Sampler>
  void Apply(Sampler* sampler) const
  {
    sampler->SetNormalMethod(this->NormalMethod);
    sampler->SetArithmeticPrecision(this->Arithmetic);
    sampler->SetOutputPointsPrecision(this->Points);
  }
};

std::vector<VDBSample> Dense(
  const std::string& file, const char* grid, const std::vector<double>& values, const Settings& settings = {})
{
  vtkNew<vtkInkVDBReader> reader;
  reader->SetFileName(file.c_str());
  reader->SetGridName(grid);
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputConnection(reader->GetOutputPort());
  for (std::size_t n = 0; n < values.size(); ++n)
  {
    sampler->SetValue(static_cast<int>(n), values[n]);
  }
  settings.Apply(sampler.Get());
  sampler->Update();
  return SamplesOf(sampler->GetOutput());
}

void TestSettings(InkTestChecks& check, const std::string& file)
{
  vtkNew<vtkInkVDBIsoSurfaceSampler> sampler;
  sampler->SetFileName(file.c_str());
  sampler->SetValue(0, 0.3);
  for (const char* grid : { "sphere", "fog" })
  {
    sampler->SetGridName(grid);
    std::vector<VDBSample> before;
    for (int method = vtkInkIsoSurfaceSampler::CELL; method <= vtkInkIsoSurfaceSampler::REGRESSION; ++method)
    {
      for (const int arithmetic : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION })
      {
        for (const int points : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION })
        {
          const Settings settings{ method, arithmetic, points };
          settings.Apply(sampler.Get());
          sampler->Update();
          const std::vector<VDBSample> samples = SamplesOf(sampler->GetOutput());
          check(!samples.empty() && samples == Dense(file, grid, { 0.3 }, settings), grid, ": method ",
            method, ", arithmetic ", arithmetic, ", points ", points, ": the dense path's to the bit");
          // Each does change something.
          const bool doubled = std::string(grid) == "fog" && arithmetic == vtkAlgorithm::DOUBLE_PRECISION;
          check(doubled || points == vtkAlgorithm::DOUBLE_PRECISION || samples != before, grid, ": method ",
            method, ", arithmetic ", arithmetic, ": other samples than before");
          before = samples;
        }
      }
    }
  }
}

void TestSurfaceIndex(InkTestChecks& check, const std::string& file)
{
  vtkNew<vtkInkVDBIsoSurfaceSampler> sampler;
  sampler->SetFileName(file.c_str());
  sampler->SetGridName("sphere");
  sampler->SetValue(0, 0.5);
  sampler->Update();
  vtkPointData* data = sampler->GetOutput()->GetPointData();
  const vtkIdType first = sampler->GetOutput()->GetNumberOfPoints();
  check(first > 0 && !data->HasArray("SurfaceIndex"), "no index of one surface");
  sampler->SetValue(1, -0.25);
  sampler->Update();
  data = sampler->GetOutput()->GetPointData();
  vtkDataArray* index = data->GetArray("SurfaceIndex");
  bool right = index && index->GetNumberOfTuples() == sampler->GetOutput()->GetNumberOfPoints();
  for (vtkIdType n = 0; right && n < index->GetNumberOfTuples(); ++n)
  {
    right = index->GetTuple1(n) == (n < first ? 0.0 : 1.0);
  }
  check(right, "an index from 0 for each of two surfaces");
  sampler->ComputeSurfaceIndexOff();
  sampler->Update();
  check(!data->HasArray("SurfaceIndex"), "no index unasked");
}

} // namespace

int TestVDBIsoSurfaceSampler(int, char*[])
{
  InkTestChecks check;
  const auto sphere = MakeSphere();
  sphere->transform().postRotate(0.5, openvdb::math::Z_AXIS);
  const auto fog = openvdb::DoubleGrid::create(0.0);
  fog->setName("fog");
  fog->fill({ openvdb::Coord(-20, 0, 0), openvdb::Coord(20, 11, 15) }, 1.0);
  fog->pruneGrid();
  const std::string file = WriteVDB("TestVDBIsoSurfaceSampler.vdb", { sphere, fog });

  vtkNew<vtkInkVDBIsoSurfaceSampler> sampler;
  vtkNew<InkTestMessages> messages;
  messages->Observe(sampler);
  sampler->SetFileName(file.c_str());
  sampler->Update();
  // Level sets are sampled at 0 unasked.
  std::vector<VDBSample> samples = SamplesOf(sampler->GetOutput());
  check(samples == Dense(file, "sphere", { 0.0 }), "the dense sphere's points, found ", samples.size());
  const openvdb::Vec3d center = sphere->transform().indexToWorld(openvdb::Vec3d(2.0, 4.0, 6.0));
  int inward = 0;
  for (const VDBSample& s : samples)
  {
    const openvdb::Vec3d out = openvdb::Vec3d(s[0], s[1], s[2]) - center;
    inward += out.dot(openvdb::Vec3d(s[3], s[4], s[5])) < 0.99 * out.length();
  }
  check(inward == 0, "outward normals, ", inward, " are not");
  check(sampler->GetOutput()->GetNumberOfCells() == 1, "one poly-vertex");
  vtkDataArray* radius = sampler->GetOutput()->GetPointData()->GetArray("Radius");
  check(
    radius && std::abs(radius->GetComponent(0, 0) - 0.25 * std::sqrt(3.0)) < 1e-6, "half a cell's diagonal");

  sampler->SetNumberOfContours(2);
  sampler->SetValue(0, 0.5);
  sampler->SetValue(1, -0.25);
  sampler->Update();
  samples = SamplesOf(sampler->GetOutput());
  check(samples == Dense(file, "sphere", { 0.5, -0.25 }), "two surfaces, found ", samples.size(), " points");
  check(std::count_if(samples.begin(), samples.end(),
          [](const VDBSample& s) { return std::isnan(s[3]) || s[3] * s[3] > 1.001; }) == 0,
    "unit normals");

  // Pieces share the points out.
  std::vector<VDBSample> pieces;
  vtkIdType largest = 0;
  for (int piece = 0; piece < 3; ++piece)
  {
    sampler->UpdatePiece(piece, 3, 0);
    const std::vector<VDBSample> part = SamplesOf(sampler->GetOutput());
    largest = std::max(largest, sampler->GetOutput()->GetNumberOfPoints());
    pieces.insert(pieces.end(), part.begin(), part.end());
  }
  std::sort(pieces.begin(), pieces.end());
  check(pieces == samples, "three pieces make the whole");
  check(largest < static_cast<vtkIdType>(samples.size() / 2), "pieces of about the same size");

  sampler->SetGridName("fog");
  sampler->SetNumberOfContours(1);
  sampler->SetValue(0, 0.5);
  sampler->UpdatePiece(0, 1, 0);
  samples = SamplesOf(sampler->GetOutput());
  check(!samples.empty() && samples == Dense(file, "fog", { 0.5 }), "a fog volume's points, found ",
    samples.size());

  sampler->ComputeNormalsOff();
  sampler->ComputeRadiusOff();
  sampler->GenerateVerticesOff();
  sampler->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sampler->Update();
  vtkPolyData* output = sampler->GetOutput();
  check(output->GetPointData()->GetNumberOfArrays() == 0 && output->GetNumberOfCells() == 0 &&
      output->GetPoints()->GetDataType() == VTK_DOUBLE &&
      output->GetNumberOfPoints() == static_cast<vtkIdType>(samples.size()),
    "nothing but points in double precision");
  TestSettings(check, file);
  TestSurfaceIndex(check, file);
  check(messages->Messages.empty(), "no message, found ",
    messages->Messages.empty() ? "" : messages->Messages[0]);
  return check.Result();
}
