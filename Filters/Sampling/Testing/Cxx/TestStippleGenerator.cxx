// SPDX-License-Identifier: BSD-3-Clause
// The stipples of a ball: which voxels have them, what their arrays say, and what each property changes.

#include "SamplerTestImages.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInkGradient.h"
#include "vtkInkStippleGenerator.h"
#include "vtkMath.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <string>

namespace
{

const double Radius = 10.0;

/// 100 in a ball around the origin, 0 outside, a step of one voxel in between.
vtkSmartPointer<vtkImageData> MakeBall(int type = VTK_FLOAT)
{
  return MakeImage(type, { -15, 16, -14, 15, -16, 14 },
    [](double x, double y, double z)
    { return 100.0 * std::clamp(Radius + 0.5 - std::sqrt(x * x + y * y + z * z), 0.0, 1.0); });
}

vtkSmartPointer<vtkPolyData> Stipple(
  vtkImageData* image,
  const std::function<void(vtkInkStippleGenerator*)>& change = [](vtkInkStippleGenerator*) {})
{
  vtkNew<vtkInkStippleGenerator> generator;
  generator->SetInputData(image);
  change(generator);
  generator->Update();
  return generator->GetOutput();
}

double Field(vtkPolyData* data, const char* name, int component = 0)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() == 1 ? array->GetComponent(0, component) : -1.0;
}

double Distance(vtkPolyData* data, vtkIdType point)
{
  double p[3];
  data->GetPoint(point, p);
  return vtkMath::Norm(p);
}

std::vector<std::array<double, 3>> PointsOf(vtkPolyData* data)
{
  std::vector<std::array<double, 3>> points(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    data->GetPoint(static_cast<vtkIdType>(n), points[n].data());
  }
  return points;
}

/// One poly-vertex for each element, which hold all points in their order, and one tuple for each in each
/// array.
void CheckContract(vtkPolyData* data, int perVoxel)
{
  const vtkIdType elements = data->GetNumberOfCells();
  EXPECT_TRUE(elements > 1000 && data->GetNumberOfVerts() == elements) << "many elements, found " << elements;
  EXPECT_EQ(data->GetNumberOfPoints(), elements * perVoxel)
    << perVoxel << " stipples an element, found " << data->GetNumberOfPoints() << " of " << elements;
  vtkIdType next = 0;
  for (vtkIdType e = 0; e < elements; ++e)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    data->GetVerts()->GetCellAtId(e, size, ids);
    bool ordered = size == perVoxel && data->GetCellType(e) == VTK_POLY_VERTEX;
    for (vtkIdType i = 0; i < size; ++i)
    {
      ordered = ordered && ids[i] == next++;
    }
    ASSERT_TRUE(ordered) << "element " << e << " to hold the next " << perVoxel << " points";
  }
  vtkCellData* cells = data->GetCellData();
  EXPECT_TRUE(cells->GetNormals() && cells->GetNormals()->GetName() == std::string("Normals")) << "normals";
  for (const char* name : { "Normals", "GradientMagnitude", "Value" })
  {
    EXPECT_TRUE(cells->GetArray(name) && cells->GetArray(name)->GetNumberOfTuples() == elements)
      << "a " << name << " for each element";
  }
  EXPECT_EQ(Field(data, "ElementKind"), 0.0) << "volume elements";
  EXPECT_EQ(Field(data, "ElementSize"), 1.0) << "elements of size 1";
  EXPECT_EQ(Field(data, "StipplesPerElement"), perVoxel) << "StipplesPerElement of " << perVoxel;
  EXPECT_TRUE(Field(data, "ScalarRange", 0) == 0.0 && Field(data, "ScalarRange", 1) == 100.0)
    << "the scalar range";
  const double steepest = Field(data, "GradientMagnitudeRange", 1);
  EXPECT_TRUE(Field(data, "GradientMagnitudeRange", 0) == 0.0 && steepest > 30.0 && steepest <= 60.0)
    << "the steepest gradient to be about 50, found " << steepest;
}

void CheckBall(vtkPolyData* data)
{
  double outmost = 0.0;
  double inmost = 1e9;
  for (vtkIdType n = 0; n < data->GetNumberOfPoints(); ++n)
  {
    outmost = std::max(outmost, Distance(data, n));
    inmost = std::min(inmost, Distance(data, n));
  }
  EXPECT_TRUE(inmost > Radius - 3.5 && outmost < Radius + 3.5)
    << "stipples at the ball's surface, found distances " << inmost << " to " << outmost;
  double leastCosine = 1.0;
  double magnitudes[2];
  double values[2];
  data->GetCellData()->GetArray("GradientMagnitude")->GetRange(magnitudes);
  data->GetCellData()->GetArray("Value")->GetRange(values);
  for (vtkIdType e = 0; e < data->GetNumberOfCells(); ++e)
  {
    double normal[3];
    double point[3];
    data->GetCellData()->GetNormals()->GetTuple(e, normal);
    data->GetPoint(e * 8, point);
    leastCosine = std::min(leastCosine, vtkMath::Dot(normal, point) / vtkMath::Norm(point));
    EXPECT_LT(std::abs(vtkMath::Norm(normal) - 1.0), 1e-5) << "a unit normal";
  }
  EXPECT_GT(leastCosine, 0.95) << "normals out of the ball";
  EXPECT_TRUE(magnitudes[0] > 0.0 && magnitudes[1] == 1.0) << "magnitudes up to 1";
  EXPECT_TRUE(values[0] >= 0.0 && values[0] < 0.3 && values[1] <= 1.0 && values[1] > 0.7)
    << "values from 0 to 1, found " << values[0] << " to " << values[1];
}

} // namespace

/// Section 4.3: as many stipples as a voxel's largest projection has pixels.
TEST(StippleGenerator, ProjectedVoxelsHaveAStippleAPixel)
{
  // 64 voxels of 5 x 2.5 x 2.5 along the longest side.
  const auto image = MakeImage(VTK_FLOAT, { 0, 63, 0, 9, 0, 9 },
    [](double x, double y, double) { return x > 32.0 && y > 4.0 ? 1.0 : 0.0; });
  image->SetSpacing(5.0, 2.5, 2.5);
  const double edge = std::cbrt(5.0 * 2.5 * 2.5);
  for (const double pixels : { 100.0, 240.0, 600.0, 700.0, 3000.0 })
  {
    const auto stipples = Stipple(image,
      [&](auto* g)
      {
        g->SetMaximumStipples(3);
        g->SetMaximumStipplesModeToProjected();
        g->SetPictureSize(pixels);
      });
    const double across = edge / (64.0 * 5.0) * pixels;
    const double expected = std::clamp(std::round(across * across), 1.0, 64.0);
    EXPECT_TRUE(Field(stipples, "StipplesPerElement") == expected &&
      stipples->GetNumberOfPoints() == expected * stipples->GetNumberOfCells() &&
      stipples->GetNumberOfCells() > 0)
      << expected << " stipples a voxel of " << across << " pixels, found "
      << Field(stipples, "StipplesPerElement");
  }
}

/// Each element's gradient is what vtkInkGradient makes of its voxel.
TEST(StippleGenerator, WeightsTheRegressionAsAskedTo)
{
  const auto ball = MakeBall();
  const auto all = [](auto* g)
  {
    g->SetThresholdModeToMagnitude();
    g->SetGradientThreshold(1.0);
  };
  vtkSmartPointer<vtkPolyData> made[2];
  for (const int weighting : { 0, 1 })
  {
    made[weighting] = Stipple(ball,
      [&](auto* g)
      {
        all(g);
        g->SetGradientWeighting(weighting);
      });
    vtkNew<vtkInkGradient> gradient;
    gradient->SetInputData(ball);
    gradient->SetWeighting(weighting);
    gradient->Update();
    vtkDataArray* expected = gradient->GetOutput()->GetPointData()->GetArray("GradientMagnitude");
    vtkDataArray* found = made[weighting]->GetCellData()->GetArray("GradientMagnitude");
    const double steepest = Field(made[weighting], "GradientMagnitudeRange", 1);
    vtkIdType element = 0;
    double worst = 0.0;
    for (vtkIdType n = 0; n < expected->GetNumberOfTuples(); ++n)
    {
      const double magnitude = expected->GetTuple1(n);
      if (magnitude >= 1.0 && element < found->GetNumberOfTuples())
      {
        worst =
          std::max(worst, std::abs(found->GetTuple1(element++) * steepest - std::min(magnitude, steepest)));
      }
    }
    EXPECT_TRUE(element > 1000 && element == found->GetNumberOfTuples() && worst < 1e-4)
      << "weighting " << weighting << ": the gradients of " << element << " voxels, off by " << worst;
  }
  EXPECT_NE(PointsOf(made[1]), PointsOf(made[0])) << "others by another weighting";
  EXPECT_EQ(PointsOf(Stipple(ball, all)), PointsOf(made[0])) << "uniform weights by default";
}

TEST(StippleGenerator, StipplesABall)
{
  const auto ball = MakeBall();
  const auto plain = Stipple(ball);
  CheckContract(plain, 8);
  CheckBall(plain);
  const double share =
    static_cast<double>(plain->GetNumberOfCells()) / static_cast<double>(ball->GetNumberOfPoints());
  EXPECT_TRUE(share > 0.045 && share < 0.055) << "a twentieth of the voxels, found " << share;
  CheckContract(Stipple(ball, [](auto* g) { g->SetMaximumStipples(3); }), 3);
}

TEST(StippleGenerator, DependsOnTheSeedAlone)
{
  const auto ball = MakeBall();
  const auto plain = Stipple(ball);
  EXPECT_EQ(PointsOf(Stipple(ball)), PointsOf(plain)) << "the same stipples once more";
  EXPECT_NE(PointsOf(Stipple(ball, [](auto* g) { g->SetSeed(1); })), PointsOf(plain))
    << "others by another seed";
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  EXPECT_EQ(PointsOf(Stipple(ball)), PointsOf(plain)) << "the same stipples on one thread";
  unsetenv("VTK_SMP_MAX_THREADS");
  EXPECT_EQ(PointsOf(Stipple(MakeBall(VTK_UNSIGNED_CHAR))), PointsOf(Stipple(MakeBall(VTK_SHORT))))
    << "the same stipples from the same values of another type";
}

TEST(StippleGenerator, HigherThresholdsLeaveFewerElements)
{
  const auto ball = MakeBall();
  const auto atLeast = [&](double threshold)
  {
    return Stipple(ball,
      [=](auto* g)
      {
        g->SetThresholdModeToMagnitude();
        g->SetGradientThreshold(threshold);
      });
  };
  EXPECT_TRUE(atLeast(0.0)->GetNumberOfCells() > atLeast(20.0)->GetNumberOfCells() &&
    atLeast(20.0)->GetNumberOfCells() > 500 && atLeast(101.0)->GetNumberOfCells() == 0)
    << "fewer elements above higher thresholds";
  const auto all = Stipple(ball, [](auto* g) { g->SetGradientPercentile(0.0); });
  EXPECT_EQ(all->GetNumberOfCells(), atLeast(0.0)->GetNumberOfCells()) << "no element without a gradient";
}

TEST(StippleGenerator, ScalarWindowsKeepTheirValues)
{
  const auto ball = MakeBall();
  const auto all = Stipple(ball, [](auto* g) { g->SetGradientPercentile(0.0); });
  const auto window = Stipple(ball,
    [](auto* g)
    {
      g->UseScalarWindowOn();
      g->SetScalarWindow(60.0, 80.0);
      g->PassScalarsOn();
    });
  double range[2];
  window->GetCellData()->GetArray("Value")->GetRange(range);
  // Its voxels reach it, but their middles may lie outside.
  EXPECT_TRUE(window->GetNumberOfCells() > 100 && range[0] > 0.25 && range[0] < 0.6 &&
    window->GetNumberOfCells() < all->GetNumberOfCells() / 2)
    << "values around the window, found " << range[0] << " to " << range[1];
  vtkDataArray* colors = window->GetCellData()->GetScalars();
  EXPECT_TRUE(colors && colors->GetName() == std::string("Density") &&
    colors->GetNumberOfTuples() == window->GetNumberOfCells())
    << "the scalars passed on";
  EXPECT_FALSE(all->GetCellData()->GetScalars()) << "no scalars passed on unasked";
}

TEST(StippleGenerator, ScalarsOfATakenNameGetAnother)
{
  const auto ball = MakeBall();
  double range[2];
  const vtkSmartPointer<vtkImageData> named = vtkSmartPointer<vtkImageData>::New();
  named->DeepCopy(ball);
  named->GetPointData()->GetScalars()->SetName("Value");
  const auto kept = Stipple(named, [](auto* g) { g->PassScalarsOn(); });
  kept->GetCellData()->GetArray("Value")->GetRange(range);
  EXPECT_LE(range[1], 1.0) << "values from 0 to 1 beside scalars of that name";
  vtkDataArray* colors = kept->GetCellData()->GetScalars();
  EXPECT_TRUE(colors && colors->GetName() == std::string("InputValue") && colors->GetRange()[1] > 1.0)
    << "scalars passed on under another name";
}

TEST(StippleGenerator, SmoothingLeavesNoisesStipplesOut)
{
  const auto noisy = MakeImage(VTK_SHORT, { -15, 16, -14, 15, -16, 14 },
    [](double x, double y, double z)
    {
      const double inside = std::clamp(Radius + 0.5 - std::sqrt(x * x + y * y + z * z), 0.0, 1.0);
      const double noise = std::sin(1e4 * (std::sin(x) + 2.0 * std::sin(1.3 * y) + 3.0 * std::sin(1.7 * z)));
      return 100.0 * inside + 60.0 * noise;
    });
  const auto shareAstray = [&](double smoothing)
  {
    const auto data = Stipple(noisy, [&](vtkInkStippleGenerator* one) { one->SetSmoothing(smoothing); });
    double astray = 0.0;
    for (vtkIdType n = 0; n < data->GetNumberOfPoints(); ++n)
    {
      astray += std::abs(Distance(data, n) - Radius) > 3.0;
    }
    EXPECT_GT(data->GetNumberOfPoints(), 5000);
    return astray / static_cast<double>(data->GetNumberOfPoints());
  };
  EXPECT_GT(shareAstray(0.0), 0.1);
  EXPECT_LT(shareAstray(1.0), 0.01);
}

TEST(StippleGenerator, LayersAreAsThickAsAskedFor)
{
  const auto ball = MakeBall();
  const auto inVoxel = [](vtkPolyData* data, vtkIdType n)
  {
    double p[3];
    data->GetPoint(n, p);
    return std::max({ std::abs(p[0] - std::round(p[0])), std::abs(p[1] - std::round(p[1])),
      std::abs(p[2] - std::round(p[2])) });
  };
  for (const double thickness : { 0.0, 2.0 })
  {
    const auto layer = Stipple(ball, [=](auto* g) { g->SetLayerThickness(thickness); });
    double most = 0.0;
    for (vtkIdType n = 0; n < layer->GetNumberOfPoints(); ++n)
    {
      const vtkIdType first = n - n % 8;
      double normal[3];
      double a[3];
      double b[3];
      layer->GetCellData()->GetNormals()->GetTuple(n / 8, normal);
      layer->GetPoint(n, a);
      layer->GetPoint(first, b);
      vtkMath::Subtract(a, b, a);
      most = std::max(most, std::abs(vtkMath::Dot(a, normal)));
      EXPECT_LE(inVoxel(layer, n), 0.5) << "stipples in voxels";
    }
    EXPECT_TRUE(thickness == 0.0 ? most < 1e-4 : most > 1.0)
      << "a layer of thickness " << thickness << ", found " << most;
  }
}

TEST(StippleGenerator, PropertiesStayWithinRange)
{
  vtkNew<vtkInkStippleGenerator> clamped;
  clamped->SetMaximumStipples(1000);
  clamped->SetGradientPercentile(-5.0);
  clamped->SetLayerThickness(9.0);
  clamped->SetPictureSize(3.0);
  EXPECT_TRUE(clamped->GetMaximumStipples() == 64 && clamped->GetGradientPercentile() == 0.0 &&
    clamped->GetLayerThickness() == 2.0 && clamped->GetPictureSize() == 100.0)
    << "clamped properties";
}
