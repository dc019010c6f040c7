// SPDX-License-Identifier: BSD-3-Clause
// What the filter makes of a ball, and what each of its properties changes.

#include "SamplerTestImages.h"

#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkFloatArray.h"
#include "vtkInkIsoSurfaceSampler.h"
#include "vtkIntArray.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <sstream>

namespace
{

const double Radius = 8.0;

vtkSmartPointer<vtkImageData> MakeBall()
{
  return MakeImage(VTK_FLOAT, { -12, 12, -11, 11, -10, 10 },
    [](double x, double y, double z) { return BallDensity(x, y, z, Radius); });
}

class Counter : public vtkCommand
{
public:
  static Counter* New() { return new Counter; }
  void Execute(vtkObject*, unsigned long, void*) override { ++this->Runs; }

  int Runs = 0;
};

} // namespace

TEST(IsoSurfaceSampler, SamplesABall)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputData(MakeBall());
  sampler->SetValue(0, 100.0);
  sampler->Update();
  vtkPolyData* output = sampler->GetOutput();
  const vtkIdType count = output->GetNumberOfPoints();
  EXPECT_TRUE(count > 1000 && count < 2000)
    << "about one and a half points for each unit of area, found " << count;
  EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_FLOAT) << "single precision";
  EXPECT_EQ(output->GetPointData()->GetNumberOfArrays(), 2) << "two point arrays";
  auto* normals = vtkFloatArray::SafeDownCast(output->GetPointData()->GetArray("Normals"));
  vtkDataArray* radii = output->GetPointData()->GetArray("Radius");
  ASSERT_TRUE(normals && radii) << "the point arrays Normals and Radius";
  EXPECT_EQ(output->GetPointData()->GetNormals(), normals) << "Normals to be the active normals";
  EXPECT_TRUE(output->GetNumberOfCells() == 1 && output->GetCellType(0) == VTK_POLY_VERTEX &&
    output->GetVerts()->GetNumberOfConnectivityIds() == count)
    << "one poly-vertex cell with all points";
  double worstDistance = 0.0;
  double worstAngle = 0.0;
  for (vtkIdType n = 0; n < count; ++n)
  {
    double p[3];
    double normal[3];
    output->GetPoint(n, p);
    normals->GetTuple(n, normal);
    const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    // The density falls outwards, and so do the normals.
    const double cosine = (normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2]) / length;
    worstDistance = std::max(worstDistance, std::abs(length - Radius));
    worstAngle = std::max(worstAngle, std::acos(std::min(cosine, 1.0)));
    EXPECT_LT(std::abs(radii->GetTuple1(n) - 0.5 * std::sqrt(3.0)), 1e-6)
      << "half a cell's diagonal as radius";
  }
  EXPECT_LT(worstDistance, 0.5 / Radius) << "points on the sphere";
  EXPECT_LT(worstAngle, 0.5 / (Radius * Radius)) << "normals across the sphere";
}

TEST(IsoSurfaceSampler, MakesNothingWithoutAnIsoValue)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputData(MakeBall());
  sampler->Update();
  vtkPolyData* output = sampler->GetOutput();
  EXPECT_TRUE(output->GetNumberOfPoints() == 0 && output->GetNumberOfCells() == 0)
    << "nothing without an iso-value";
  EXPECT_NE(output->GetPointData()->GetNormals(), nullptr) << "the arrays all the same";
}

TEST(IsoSurfaceSampler, SeveralIsoValuesComeOneAfterTheOther)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputData(MakeBall());
  vtkPolyData* output = sampler->GetOutput();
  sampler->SetValue(0, 100.0);
  sampler->Update();
  const auto outer = SamplesOf(output);
  sampler->SetValue(0, 140.0);
  sampler->Update();
  const auto inner = SamplesOf(output);
  EXPECT_TRUE(!inner.empty() && inner.size() < outer.size()) << "fewer points on the smaller ball";
  sampler->SetValue(0, 100.0);
  sampler->SetValue(1, 140.0);
  sampler->Update();
  auto expected = outer;
  expected.insert(expected.end(), inner.begin(), inner.end());
  EXPECT_EQ(SamplesOf(output), expected) << "the points of two iso-values one after the other";
  EXPECT_TRUE(sampler->GetNumberOfContours() == 2 && sampler->GetValue(1) == 140.0) << "two iso-values";
  sampler->GenerateValues(3, 90.0, 110.0);
  EXPECT_TRUE(sampler->GetNumberOfContours() == 3 && sampler->GetValue(1) == 100.0) << "three iso-values";
}

TEST(IsoSurfaceSampler, MakesNothingThatIsSwitchedOff)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputData(MakeBall());
  sampler->SetValue(0, 100.0);
  sampler->Update();
  vtkPolyData* output = sampler->GetOutput();
  const vtkIdType count = output->GetNumberOfPoints();
  sampler->ComputeNormalsOff();
  sampler->ComputeRadiusOff();
  sampler->GenerateVerticesOff();
  sampler->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sampler->Update();
  EXPECT_TRUE(output->GetPointData()->GetNumberOfArrays() == 0 && output->GetNumberOfCells() == 0)
    << "nothing that is switched off";
  EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_DOUBLE) << "double precision";
  EXPECT_EQ(output->GetNumberOfPoints(), count) << "the same number of points";
}

TEST(IsoSurfaceSampler, PropertiesStayWithinRange)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetCrossingRuleToStrict();
  EXPECT_EQ(sampler->GetCrossingRule(), vtkInkIsoSurfaceSampler::STRICT) << "the strict rule";
  sampler->SetCrossingRule(7);
  EXPECT_EQ(sampler->GetCrossingRule(), vtkInkIsoSurfaceSampler::STRICT) << "a crossing rule within range";
  sampler->SetArrayComponent(-3);
  EXPECT_EQ(sampler->GetArrayComponent(), 0) << "a component within range";
  std::ostringstream text;
  sampler->Print(text);
  EXPECT_NE(text.str().find("CrossingRule: Strict"), std::string::npos) << "the properties in print";
}

TEST(IsoSurfaceSampler, FollowsOriginSpacingAndDirection)
{
  // The plane x = 4.5 of the image, which is turned, mirrored and stretched into the world.
  auto image = MakeImage(VTK_UNSIGNED_CHAR, { 2, 9, 0, 7, 0, 7 }, [](double x, double, double) { return x; });
  image->SetSpacing(2.0, 1.0, 0.5);
  image->SetOrigin(10.0, 20.0, 30.0);
  // Columns: i runs along -y, j along x, k along z.
  const double direction[9] = { 0, 1, 0, -1, 0, 0, 0, 0, 1 };
  image->SetDirectionMatrix(direction);
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputData(image);
  sampler->SetValue(0, 4.5);
  sampler->Update();
  const auto samples = SamplesOf(sampler->GetOutput());
  ASSERT_EQ(samples.size(), 49u) << "one point for each of 7 x 7 cells";
  // Index (4.5, j + .5, k + .5); the values grow along i, that is along -y.
  EXPECT_EQ(samples[0], (Sample{ 10.5, 11.0, 30.25, 0.0, 1.0, 0.0 }))
    << "the first point and its normal in the world";
  double bounds[6];
  sampler->GetOutput()->GetBounds(bounds);
  EXPECT_TRUE(bounds[0] == 10.5 && bounds[1] == 16.5 && bounds[2] == 11.0 && bounds[3] == 11.0 &&
    bounds[4] == 30.25 && bounds[5] == 33.25)
    << "the plane in the world";
  const double radius = sampler->GetOutput()->GetPointData()->GetArray("Radius")->GetTuple1(0);
  EXPECT_LT(std::abs(radius - 0.5 * std::sqrt(4.0 + 1.0 + 0.25)), 1e-6) << "half a cell's diagonal as radius";
}

/// Single precision where it is enough, double where it is not.
TEST(IsoSurfaceSampler, IsSinglePrecisionWhereThatIsEnough)
{
  struct Case
  {
    double Origin;
    double Spacing;
    int Type;
  };
  for (const Case& c : { Case{ 0.0, 1.0, VTK_FLOAT }, Case{ 1e7, 1.0, VTK_DOUBLE },
         Case{ 1e7, 1e5, VTK_FLOAT }, Case{ 0.0, 1e-9, VTK_FLOAT }, Case{ 0.0, 1e9, VTK_FLOAT },
         Case{ 0.0, 1e-60, VTK_DOUBLE }, Case{ 0.0, 1e60, VTK_DOUBLE } })
  {
    auto image = MakeImage(VTK_SHORT, { 0, 7, 0, 7, 0, 7 }, [](double x, double, double) { return x; });
    image->SetOrigin(c.Origin, 0.0, 0.0);
    image->SetSpacing(c.Spacing, c.Spacing, c.Spacing);
    vtkNew<vtkInkIsoSurfaceSampler> sampler;
    sampler->SetInputData(image);
    sampler->SetValue(0, 3.25);
    sampler->Update();
    vtkPolyData* output = sampler->GetOutput();
    ASSERT_EQ(output->GetNumberOfPoints(), 49) << "49 points at spacing " << c.Spacing;
    EXPECT_EQ(output->GetPoints()->GetDataType(), c.Type)
      << "the other precision at origin " << c.Origin << ", spacing " << c.Spacing;
    double p[3];
    output->GetPoint(48, p);
    EXPECT_TRUE(
      std::abs((p[0] - c.Origin) / c.Spacing - 3.25) < 1e-2 && std::abs(p[1] / c.Spacing - 6.5) < 1e-5)
      << "points on the plane at origin " << c.Origin << ", spacing " << c.Spacing;
    const double radius = output->GetPointData()->GetArray("Radius")->GetTuple1(0);
    EXPECT_LT(std::abs(radius / c.Spacing - 0.5 * std::sqrt(3.0)), 1e-6)
      << "the radius at spacing " << c.Spacing;
    double normal[3];
    output->GetPointData()->GetNormals()->GetTuple(0, normal);
    EXPECT_TRUE(normal[0] == -1.0 && normal[1] == 0.0 && normal[2] == 0.0)
      << "the normal at spacing " << c.Spacing;
  }
}

/// Blocks go through one by one.
TEST(IsoSurfaceSampler, TakesBlocksOneByOne)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeBall());
  blocks->SetBlock(1, MakeBall());
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputDataObject(blocks);
  sampler->SetValue(0, 100.0);
  for (const int pieces : { 1, 2 })
  {
    sampler->UpdatePiece(pieces - 1, pieces, 0);
    auto* output = vtkMultiBlockDataSet::SafeDownCast(sampler->GetOutputDataObject(0));
    ASSERT_TRUE(output && output->GetNumberOfBlocks() == 2) << "two blocks";
    auto* first = vtkPolyData::SafeDownCast(output->GetBlock(0));
    auto* second = vtkPolyData::SafeDownCast(output->GetBlock(1));
    EXPECT_TRUE(first && second && first->GetNumberOfPoints() > 1000 && SamplesOf(first) == SamplesOf(second))
      << "the whole ball in both blocks of " << pieces << " pieces";
  }
}

TEST(IsoSurfaceSampler, RunsOnlyAfterChanges)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  vtkNew<Counter> counter;
  const int& runs = counter->Runs;
  sampler->AddObserver(vtkCommand::StartEvent, counter);
  sampler->SetInputData(MakeBall());
  sampler->SetValue(0, 100.0);
  sampler->Update();
  sampler->Update();
  EXPECT_EQ(runs, 1) << "one run for two updates";
  sampler->SetValue(0, 100.0);
  sampler->SetCrossingRule(sampler->GetCrossingRule());
  sampler->Update();
  EXPECT_EQ(runs, 1) << "no run for values that stay the same";
  const vtkMTimeType before = sampler->GetMTime();
  sampler->SetValue(0, 90.0);
  EXPECT_GT(sampler->GetMTime(), before) << "a later time for another iso-value";
  sampler->Update();
  EXPECT_EQ(runs, 2) << "a run for another iso-value";
}

/// Several surfaces are told apart, and come as they do one by one.
TEST(IsoSurfaceSampler, SurfaceIndexTellsSurfacesApart)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputData(MakeBall());
  sampler->SetValue(0, 100.0);
  sampler->Update();
  const vtkIdType first = sampler->GetOutput()->GetNumberOfPoints();
  EXPECT_FALSE(sampler->GetOutput()->GetPointData()->GetArray("SurfaceIndex"))
    << "no SurfaceIndex for one iso-value";
  sampler->SetValue(1, 500.0);
  sampler->SetValue(2, 140.0);
  sampler->Update();
  auto* index = vtkIntArray::SafeDownCast(sampler->GetOutput()->GetPointData()->GetArray("SurfaceIndex"));
  const vtkIdType count = sampler->GetOutput()->GetNumberOfPoints();
  ASSERT_TRUE(index && index->GetNumberOfTuples() == count && count > first)
    << "a SurfaceIndex for each point";
  EXPECT_TRUE(index->GetValue(0) == 0 && index->GetValue(first - 1) == 0 && index->GetValue(first) == 2 &&
    index->GetValue(count - 1) == 2)
    << "the numbers of the iso-values that have points";

  sampler->ComputeSurfaceIndexOff();
  sampler->Update();
  EXPECT_FALSE(sampler->GetOutput()->GetPointData()->GetArray("SurfaceIndex"))
    << "no SurfaceIndex where it is off";
}

/// The index changes nothing but time, follows its input and can be given back.
TEST(IsoSurfaceSampler, IndexChangesNothingButTime)
{
  auto image = MakeBall();
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  vtkNew<vtkInkIsoSurfaceSampler> without;
  without->UseIndexOff();
  const auto same = [&](double isoValue, const char* when)
  {
    for (vtkInkIsoSurfaceSampler* one : { sampler.Get(), without.Get() })
    {
      one->SetInputData(image);
      one->SetValue(0, isoValue);
      one->Update();
    }
    const auto samples = SamplesOf(sampler->GetOutput());
    EXPECT_TRUE(!samples.empty() && samples == SamplesOf(without->GetOutput())) << "the same points " << when;
  };
  EXPECT_EQ(sampler->GetIndexMemory(), 0) << "no index before the first run";
  same(100.0, "in the first run");
  const vtkIdType memory = sampler->GetIndexMemory();
  EXPECT_TRUE(memory > 0 && memory < 0.02 * 1024 * image->GetActualMemorySize())
    << "a small index, found " << memory;
  same(120.0, "with the index");
  EXPECT_EQ(without->GetIndexMemory(), 0) << "no index where it is off";
  sampler->ReleaseIndex();
  EXPECT_EQ(sampler->GetIndexMemory(), 0) << "no index after its release";
  same(110.0, "after the release");

  auto* scalars = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  for (vtkIdType n = 0; n < scalars->GetNumberOfValues(); ++n)
  {
    scalars->SetValue(n, 200.0f - scalars->GetValue(n));
  }
  scalars->Modified();
  image->Modified();
  same(100.0, "after the array was modified");
  image = MakeBall();
  same(130.0, "with another image");
}

/// Arrays are filled again only when nobody else has them.
TEST(IsoSurfaceSampler, ReusesOnlyArraysThatNobodyHolds)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputData(MakeBall());
  sampler->SetValue(0, 100.0);
  sampler->Update();
  vtkDataArray* before = sampler->GetOutput()->GetPointData()->GetNormals();
  const vtkMTimeType time = before->GetMTime();
  sampler->SetValue(0, 110.0);
  sampler->Update();
  EXPECT_TRUE(sampler->GetOutput()->GetPointData()->GetNormals() == before && before->GetMTime() > time)
    << "the same array, modified";
  vtkNew<vtkPolyData> held;
  held->ShallowCopy(sampler->GetOutput());
  const auto samples = SamplesOf(held);
  sampler->SetValue(0, 90.0);
  sampler->Update();
  EXPECT_EQ(SamplesOf(held), samples) << "a held output that stays as it is";
  EXPECT_GT(sampler->GetOutput()->GetNumberOfPoints(), held->GetNumberOfPoints()) << "the next one beside it";
  sampler->ReuseArraysOff();
  sampler->Update();
  vtkSmartPointer<vtkDataArray> normals = sampler->GetOutput()->GetPointData()->GetNormals();
  EXPECT_EQ(normals->GetReferenceCount(), 2)
    << "no hold on the arrays of the output, but for the output's and ours";
}

/// Cheaper normals are close to the default's.
TEST(IsoSurfaceSampler, CheaperNormalsAreClose)
{
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputData(MakeBall());
  sampler->SetValue(0, 100.0);
  sampler->Update();
  const auto expected = SamplesOf(sampler->GetOutput());
  const auto farthest = [&](double scale)
  {
    sampler->Update();
    const auto samples = SamplesOf(sampler->GetOutput());
    double largest = samples.size() == expected.size() ? 0.0 : 1e30;
    for (std::size_t n = 0; n < std::min(samples.size(), expected.size()); ++n)
    {
      for (int axis = 3; axis < 6; ++axis)
      {
        largest = std::max(largest, std::abs(samples[n][axis] / scale - expected[n][axis]));
      }
    }
    return largest;
  };
  sampler->SetOutputNormalsPrecisionToShort();
  EXPECT_LE(farthest(32767.0), 0.51 / 32767.0) << "normals of 16 bits";
  EXPECT_EQ(sampler->GetOutput()->GetPointData()->GetNormals()->GetDataType(), VTK_SHORT)
    << "an array of short";
  sampler->SetOutputNormalsPrecisionToChar();
  EXPECT_LE(farthest(127.0), 0.51 / 127.0) << "normals of 8 bits";
  sampler->SetOutputNormalsPrecisionToSingle();
  sampler->SetArithmeticPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  const double single = farthest(1.0);
  EXPECT_TRUE(single > 0.0 && single < 1e-4) << "single precision close to double, off by " << single;
  sampler->SetArithmeticPrecision(vtkAlgorithm::SINGLE_PRECISION);
  for (const int method : { vtkInkIsoSurfaceSampler::CELL, vtkInkIsoSurfaceSampler::INTERPOLATED_GRADIENT,
         vtkInkIsoSurfaceSampler::REGRESSION })
  {
    sampler->SetNormalMethod(method);
    const double change = farthest(1.0);
    EXPECT_TRUE(change > 1e-6 && change < 0.1)
      << "other normals by method " << method << ", off by " << change;
  }
}
