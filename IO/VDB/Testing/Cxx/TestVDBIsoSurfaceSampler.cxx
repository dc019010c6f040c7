// SPDX-License-Identifier: BSD-3-Clause
// vtkInkVDBIsoSurfaceSampler makes the points that vtkInkIsoSurfaceSampler makes of vtkInkVDBReader's image.

#include "InkTestMessages.h"
#include "VDBTestFiles.h"

#include "vtkImageData.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkInkVDBIsoSurfaceSampler.h"
#include "vtkInkVDBReader.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace
{

/// Settings that both samplers have.
struct Settings
{
  int NormalMethod = vtkInkIsoSurfaceSampler::INTERPOLATED_NORMAL;
  int Arithmetic = vtkAlgorithm::SINGLE_PRECISION;
  int Points = vtkAlgorithm::DEFAULT_PRECISION;
  int ProjectionSteps = 0;
  double Smoothing = 0.0;
  int SmoothingTarget = vtkInkIsoSurfaceSampler::SURFACE;
  int Subdivision = 1;
  int LargestParts = 0;
  int Padding = 3; ///< of the image

  template <class Sampler>
  void Apply(Sampler* sampler) const
  {
    sampler->SetNormalMethod(this->NormalMethod);
    sampler->SetArithmeticPrecision(this->Arithmetic);
    sampler->SetOutputPointsPrecision(this->Points);
    sampler->SetProjectionSteps(this->ProjectionSteps);
    sampler->SetSmoothing(this->Smoothing);
    sampler->SetSmoothingTarget(this->SmoothingTarget);
    sampler->SetSubdivision(this->Subdivision);
    sampler->SetLargestParts(this->LargestParts);
  }
};

std::vector<VDBSample> Dense(
  const std::string& file, const char* grid, const std::vector<double>& values, const Settings& settings = {})
{
  vtkNew<vtkInkVDBReader> reader;
  reader->SetFileName(file.c_str());
  reader->SetGridName(grid);
  reader->SetPadding(settings.Padding);
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

class VDBIsoSurfaceSampler : public testing::Test
{
protected:
  VDBIsoSurfaceSampler()
  {
    this->Sphere->transform().postRotate(0.5, openvdb::math::Z_AXIS);
    const auto fog = openvdb::DoubleGrid::create(0.0);
    fog->setName("fog");
    fog->fill({ openvdb::Coord(-20, 0, 0), openvdb::Coord(20, 11, 15) }, 1.0);
    fog->pruneGrid();
    this->File = WriteVDB(".vdb", { this->Sphere, fog });
    this->Messages->Observe(this->Sampler);
    this->Sampler->SetFileName(this->File.c_str());
  }
  void TearDown() override { EXPECT_TRUE(this->Messages->Messages.empty()) << this->Messages->Messages[0]; }

  /// Two surfaces of the level set.
  std::vector<VDBSample> SampleTwo()
  {
    this->Sampler->SetNumberOfContours(2);
    this->Sampler->SetValue(0, 0.5);
    this->Sampler->SetValue(1, -0.25);
    this->Sampler->Update();
    return SamplesOf(this->Sampler->GetOutput());
  }
  std::vector<VDBSample> SampleFog()
  {
    this->Sampler->SetGridName("fog");
    this->Sampler->SetValue(0, 0.5);
    this->Sampler->Update();
    return SamplesOf(this->Sampler->GetOutput());
  }

  openvdb::FloatGrid::Ptr Sphere = MakeSphere();
  std::string File;
  vtkNew<vtkInkVDBIsoSurfaceSampler> Sampler;
  vtkNew<InkTestMessages> Messages;
};

} // namespace

TEST_F(VDBIsoSurfaceSampler, SamplesLevelSetsAtZeroUnasked)
{
  Sampler->Update();
  const std::vector<VDBSample> samples = SamplesOf(Sampler->GetOutput());
  EXPECT_EQ(samples, Dense(File, "sphere", { 0.0 })) << "the dense sphere's points, found " << samples.size();
  const openvdb::Vec3d center = Sphere->transform().indexToWorld(openvdb::Vec3d(2.0, 4.0, 6.0));
  int inward = 0;
  for (const VDBSample& s : samples)
  {
    const openvdb::Vec3d out = openvdb::Vec3d(s[0], s[1], s[2]) - center;
    inward += out.dot(openvdb::Vec3d(s[3], s[4], s[5])) < 0.99 * out.length();
  }
  EXPECT_EQ(inward, 0) << "outward normals, " << inward << " are not";
  EXPECT_EQ(Sampler->GetOutput()->GetNumberOfCells(), 1) << "one poly-vertex";
  vtkDataArray* radius = Sampler->GetOutput()->GetPointData()->GetArray("Radius");
  EXPECT_TRUE(radius && std::abs(radius->GetComponent(0, 0) - 0.25 * std::sqrt(3.0)) < 1e-6)
    << "half a cell's diagonal";
}

TEST_F(VDBIsoSurfaceSampler, SamplesTwoSurfaces)
{
  const std::vector<VDBSample> samples = SampleTwo();
  EXPECT_EQ(samples, Dense(File, "sphere", { 0.5, -0.25 }))
    << "two surfaces, found " << samples.size() << " points";
  EXPECT_EQ(std::count_if(samples.begin(), samples.end(),
              [](const VDBSample& s) { return std::isnan(s[3]) || s[3] * s[3] > 1.001; }),
    0)
    << "unit normals";
}

TEST_F(VDBIsoSurfaceSampler, PiecesShareThePointsOut)
{
  const std::vector<VDBSample> samples = SampleTwo();
  std::vector<VDBSample> pieces;
  vtkIdType largest = 0;
  for (int piece = 0; piece < 3; ++piece)
  {
    Sampler->UpdatePiece(piece, 3, 0);
    const std::vector<VDBSample> part = SamplesOf(Sampler->GetOutput());
    largest = std::max(largest, Sampler->GetOutput()->GetNumberOfPoints());
    pieces.insert(pieces.end(), part.begin(), part.end());
  }
  std::sort(pieces.begin(), pieces.end());
  EXPECT_EQ(pieces, samples) << "three pieces make the whole";
  EXPECT_LT(largest, static_cast<vtkIdType>(samples.size() / 2)) << "pieces of about the same size";
}

TEST_F(VDBIsoSurfaceSampler, SamplesFogVolumes)
{
  const std::vector<VDBSample> samples = SampleFog();
  EXPECT_TRUE(!samples.empty() && samples == Dense(File, "fog", { 0.5 }))
    << "a fog volume's points, found " << samples.size();
}

TEST_F(VDBIsoSurfaceSampler, MakesNothingButPointsWhereAskedTo)
{
  const std::vector<VDBSample> samples = SampleFog();
  Sampler->ComputeNormalsOff();
  Sampler->ComputeRadiusOff();
  Sampler->GenerateVerticesOff();
  Sampler->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  Sampler->Update();
  vtkPolyData* output = Sampler->GetOutput();
  EXPECT_TRUE(output->GetPointData()->GetNumberOfArrays() == 0 && output->GetNumberOfCells() == 0 &&
    output->GetPoints()->GetDataType() == VTK_DOUBLE &&
    output->GetNumberOfPoints() == static_cast<vtkIdType>(samples.size()))
    << "nothing but points in double precision";
}

TEST_F(VDBIsoSurfaceSampler, SettingsMakeTheSamplesOfTheImage)
{
  Sampler->SetValue(0, 0.3);
  for (const char* grid : { "sphere", "fog" })
  {
    Sampler->SetGridName(grid);
    std::vector<VDBSample> before;
    for (int method = vtkInkIsoSurfaceSampler::CELL; method <= vtkInkIsoSurfaceSampler::REGRESSION; ++method)
    {
      for (const int arithmetic : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION })
      {
        for (const int points : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION })
        {
          const Settings settings{ method, arithmetic, points };
          settings.Apply(Sampler.Get());
          Sampler->Update();
          const std::vector<VDBSample> samples = SamplesOf(Sampler->GetOutput());
          EXPECT_TRUE(!samples.empty() && samples == Dense(File, grid, { 0.3 }, settings))
            << grid << ": method " << method << ", arithmetic " << arithmetic << ", points " << points
            << ": the dense path's to the bit";
          // Each does change something.
          const bool doubled = std::string(grid) == "fog" && arithmetic == vtkAlgorithm::DOUBLE_PRECISION;
          EXPECT_TRUE(doubled || points == vtkAlgorithm::DOUBLE_PRECISION || samples != before)
            << grid << ": method " << method << ", arithmetic " << arithmetic
            << ": other samples than before";
          before = samples;
        }
      }
    }
  }
}

TEST_F(VDBIsoSurfaceSampler, SmoothingMakesTheSamplesOfTheImage)
{
  for (const char* grid : { "sphere", "fog" })
  {
    Sampler->SetGridName(grid);
    Sampler->SetValue(0, 0.3);
    Sampler->SetValue(1, 0.1);
    std::vector<VDBSample> before;
    for (const int target : { vtkInkIsoSurfaceSampler::SURFACE, vtkInkIsoSurfaceSampler::NORMALS })
    {
      for (const int subdivision : { 1, 2 })
      {
        Settings settings;
        settings.Smoothing = 1.2;
        settings.SmoothingTarget = target;
        settings.Subdivision = subdivision;
        settings.LargestParts = subdivision - 1;
        settings.Padding = 14;
        settings.Apply(Sampler.Get());
        Sampler->Update();
        const std::vector<VDBSample> samples = SamplesOf(Sampler->GetOutput());
        EXPECT_TRUE(!samples.empty() && samples == Dense(File, grid, { 0.3, 0.1 }, settings))
          << grid << ": target " << target << ", subdivision " << subdivision << ", found " << samples.size();
        EXPECT_NE(samples, before);
        before = samples;
        vtkPointData* arrays = Sampler->GetOutput()->GetPointData();
        EXPECT_EQ(arrays->GetArray("SurfaceIndex")->GetRange()[1], 1.0);
        EXPECT_EQ(arrays->GetArray("Radius")->GetNumberOfTuples(), Sampler->GetOutput()->GetNumberOfPoints());
      }
    }
  }
}

/// Of a level set, which is negated, and of one that is not; two surfaces each.
TEST_F(VDBIsoSurfaceSampler, ProjectionMakesTheSamplesOfTheImage)
{
  EXPECT_EQ(Sampler->GetProjectionSteps(), 0) << "no projection unasked";
  for (const char* grid : { "sphere", "fog" })
  {
    Sampler->SetGridName(grid);
    Sampler->SetValue(0, 0.3);
    Sampler->SetValue(1, 0.1);
    for (const int points : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION })
    {
      std::vector<VDBSample> before;
      for (const int steps : { 0, 2 })
      {
        Settings settings;
        settings.Points = points;
        settings.ProjectionSteps = steps;
        settings.Apply(Sampler.Get());
        Sampler->Update();
        const std::vector<VDBSample> samples = SamplesOf(Sampler->GetOutput());
        EXPECT_TRUE(!samples.empty() && samples == Dense(File, grid, { 0.3, 0.1 }, settings))
          << grid << ": " << steps << " steps, points " << points << ": the dense path's to the bit";
        EXPECT_NE(samples, before) << grid << ": " << steps << " steps, points " << points
                                   << ": other points than before";
        before = samples;
      }
    }
  }
}

TEST_F(VDBIsoSurfaceSampler, KnowsItsSurfaceBeforeItIsSampled)
{
  this->SampleFog();
  EXPECT_EQ(this->Sampler->CountActiveCells(0.5), this->Sampler->GetOutput()->GetNumberOfPoints());
  // Values of one step between neighbors show terraces: as smooth as may be.
  EXPECT_EQ(this->Sampler->SuggestSmoothing(0.5), 2.0);
  EXPECT_EQ(this->Sampler->SuggestSmoothing(7.0), 0.0) << "no surface";
  this->Sampler->SetGridName(this->Sphere->getName().c_str());
  EXPECT_EQ(this->Sampler->SuggestSmoothing(0.0), 0.0) << "distances";
  // Of negated values, as iso-values are.
  EXPECT_GT(this->Sampler->CountActiveCells(-0.25), this->Sampler->CountActiveCells(0.5));
  this->Sampler->InvertLevelSetsOff();
  EXPECT_LT(this->Sampler->CountActiveCells(-0.25), this->Sampler->CountActiveCells(0.5));
}

TEST_F(VDBIsoSurfaceSampler, SurfaceIndexCountsFromZero)
{
  Sampler->SetGridName("sphere");
  Sampler->SetValue(0, 0.5);
  Sampler->Update();
  vtkPointData* data = Sampler->GetOutput()->GetPointData();
  const vtkIdType first = Sampler->GetOutput()->GetNumberOfPoints();
  EXPECT_TRUE(first > 0 && !data->HasArray("SurfaceIndex")) << "no index of one surface";
  Sampler->SetValue(1, -0.25);
  Sampler->Update();
  data = Sampler->GetOutput()->GetPointData();
  vtkDataArray* index = data->GetArray("SurfaceIndex");
  bool right = index && index->GetNumberOfTuples() == Sampler->GetOutput()->GetNumberOfPoints();
  for (vtkIdType n = 0; right && n < index->GetNumberOfTuples(); ++n)
  {
    right = index->GetTuple1(n) == (n < first ? 0.0 : 1.0);
  }
  EXPECT_TRUE(right) << "an index from 0 for each of two surfaces";
  Sampler->ComputeSurfaceIndexOff();
  Sampler->Update();
  EXPECT_FALSE(data->HasArray("SurfaceIndex")) << "no index unasked";
}
