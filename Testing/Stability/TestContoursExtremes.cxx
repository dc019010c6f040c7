// SPDX-License-Identifier: BSD-3-Clause
// vtkInkContours at the ends of what meshes, images and eyes can be: right curves, or none and one clear
// message.
#include "InkTestMesh.h"
#include "InkTestMessages.h"
#include "InkTestVolume.h"
#include "RandomImages.h"
#include "RandomMeshes.h"
#include "StabilityChecks.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInkContours.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
using Vector = std::array<double, 3>;

/// Contours with all arrays, for a parallel eye along -z unless it is changed.
class Checked
{
public:
  Checked()
  {
    this->Filter->SetEyeToDirection();
    this->Filter->ComputeNormalsOn();
    this->Filter->ComputeRadialCurvatureOn();
    this->Filter->ComputeArcLengthOn();
    this->Filter->ComputeCellIdsOn();
    this->Messages->Observe(this->Filter);
  }
  /// The lines, which are valid. @param words as in InkTestMessages
  vtkPolyData* Of(vtkDataObject* data, const std::string& name, const std::vector<std::string>& words = {})
  {
    this->Messages->Messages.clear();
    this->Filter->SetInputDataObject(data);
    this->Filter->Update();
    this->Messages->Expect(name, words);
    vtkPolyData* lines = this->Filter->GetOutput();
    EXPECT_TRUE(CheckValidPoints(name, lines)) << name;
    return lines;
  }

  vtkNew<vtkInkContours> Filter;
  vtkNew<InkTestMessages> Messages;
};

vtkSmartPointer<vtkPolyData> Ball(const Vector& center, double radius)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(center.data());
  source->SetRadius(radius);
  source->SetThetaResolution(60);
  source->SetPhiResolution(40);
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return source->GetOutput();
}

/// Of all lines, from first to last point of each.
double LengthOf(vtkPolyData* lines)
{
  double length = 0.0;
  vtkCellArray* cells = lines->GetLines();
  for (vtkIdType line = 0; line < cells->GetNumberOfCells(); ++line)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCellAtId(line, size, ids);
    for (vtkIdType i = 1; i < size; ++i)
    {
      Vector a;
      Vector b;
      lines->GetPoint(ids[i - 1], a.data());
      lines->GetPoint(ids[i], b.data());
      length += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
  }
  return length;
}

void ExpectOneCircle(vtkPolyData* lines, double radius, double error, const std::string& name)
{
  EXPECT_EQ(lines->GetNumberOfLines(), 1) << name;
  EXPECT_NEAR(LengthOf(lines) / (2.0 * std::numbers::pi * radius), 1.0, error) << name;
}

/// A ball of radius 6 samples in the middle of 17 samples each way.
vtkSmartPointer<vtkImageData> BallImage(
  int type, const Vector& spacing, const Vector& origin, const Vector& values)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(-3, 13, 5, 21, 0, 16);
  image->AllocateScalars(type, 1);
  vtkIdType n = 0;
  for (int z = -8; z <= 8; ++z)
  {
    for (int y = -8; y <= 8; ++y)
    {
      for (int x = -8; x <= 8; ++x)
      {
        const double share = std::clamp(0.5 + (6.0 - std::hypot(x, y, z)) / 16.0, 0.0, 1.0);
        image->GetPointData()->GetScalars()->SetComponent(
          n++, 0, (1.0 - share) * values[0] + share * values[1]);
      }
    }
  }
  image->SetSpacing(spacing.data());
  image->SetOrigin(origin.data());
  return image;
}

} // namespace

TEST(ContoursExtremes, MeshesOfAnySizeAnywhere)
{
  for (const double size : { 1e-9, 1.0, 1e9 })
  {
    Checked run;
    ExpectOneCircle(run.Of(Ball({ 0.0, 0.0, 0.0 }, size), "size"), size, 0.003, std::to_string(size));
  }
  Checked far;
  ExpectOneCircle(far.Of(Ball({ 1e7, -1e7, 1e7 }, 1.0), "far"), 1.0, 0.003, "far from the origin");
  Checked odd;
  odd.Filter->CreasesOn();
  odd.Filter->NonManifoldEdgesOn();
  std::vector<double> lengths;
  for (const double scale : { 1e-9, 1.0, 1e9 })
  {
    const auto mesh = InkTestOddMesh(scale);
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(mesh->GetNumberOfPoints());
    normals->Fill(0.0);
    mesh->GetPointData()->SetNormals(normals);
    lengths.push_back(LengthOf(odd.Of(mesh, "odd mesh", { InkTestOddFaces })) / scale);
    EXPECT_NEAR(lengths.back(), lengths.front(), 1e-6 * lengths.front()) << scale;
  }
  EXPECT_GT(lengths[0], 3.0);
}

/// Normals that say nothing are replaced by those of faces.
TEST(ContoursExtremes, NormalsOfNoUse)
{
  for (const double value : { 0.0, NaN, std::numeric_limits<double>::infinity() })
  {
    const auto ball = Ball({ 0.0, 0.0, 0.0 }, 1.0);
    ball->GetPointData()->GetNormals()->Fill(value);
    Checked run;
    ExpectOneCircle(run.Of(ball, "normals"), 1.0, 0.01, std::to_string(value));
  }
}

TEST(ContoursExtremes, Eyes)
{
  const auto ball = Ball({ 0.0, 0.0, 0.0 }, 1.0);
  const auto image = BallImage(VTK_FLOAT, { 1, 1, 1 }, { -5, -13, -8 }, { 0, 1 });
  Checked run;
  run.Filter->SetValue(0, 0.5);
  run.Filter->SetEyeToPosition();
  for (const double away : { 1e3, 1e12, 1e100 })
  {
    run.Filter->SetEyePosition(0.0, 0.0, away);
    ExpectOneCircle(run.Of(ball, "far eye"), 1.0, 0.003, "mesh from " + std::to_string(away));
    ExpectOneCircle(run.Of(image, "far eye"), 6.0, 0.02, "image from " + std::to_string(away));
  }
  // Inside of a convex surface nothing turns away.
  for (const Vector& eye : { Vector{ 0.0, 0.0, 0.0 }, Vector{ 0.1, -0.2, 0.3 } })
  {
    run.Filter->SetEyePosition(eye[0], eye[1], eye[2]);
    EXPECT_EQ(run.Of(ball, "inside")->GetNumberOfLines(), 0);
    EXPECT_EQ(run.Of(image, "inside")->GetNumberOfLines(), 0);
  }
  // In the surface itself, at a point of the mesh, and just outside.
  for (const double z : { 1.0, 1.0 + 1e-12, 1.001 })
  {
    run.Filter->SetEyePosition(0.0, 0.0, z);
    EXPECT_LT(LengthOf(run.Of(ball, "in the surface")), 1.0) << z;
  }
  run.Filter->SetEyeToDirection();
  for (const double length : { 1e-300, 1e-9, 1e9, 1e300 })
  {
    run.Filter->SetEyeDirection(0.0, length, 0.0);
    ExpectOneCircle(run.Of(ball, "direction"), 1.0, 0.01, "mesh along " + std::to_string(length));
    ExpectOneCircle(run.Of(image, "direction"), 6.0, 0.02, "image along " + std::to_string(length));
  }
}

TEST(ContoursExtremes, ImagesOfAnySizeAnywhere)
{
  const struct
  {
    const char* Name;
    Vector Spacing;
    Vector Origin;
  } grids[] = { { "plain", { 1, 1, 1 }, { 0, 0, 0 } }, { "tiny", { 1e-9, 1e-9, 1e-9 }, { 0, 0, 0 } },
    { "huge", { 1e9, 1e9, 1e9 }, { 0, 0, 0 } }, { "far", { 0.01, 0.01, 0.01 }, { 1e7, -1e7, 1e7 } },
    { "mirrored", { -1, 1, 1 }, { 0, 0, 0 } } };
  for (const auto& grid : grids)
  {
    Checked run;
    run.Filter->SetValue(0, 0.5);
    vtkPolyData* lines = run.Of(BallImage(VTK_DOUBLE, grid.Spacing, grid.Origin, { 0, 1 }), grid.Name);
    ExpectOneCircle(lines, 6.0 * std::abs(grid.Spacing[0]), 0.02, grid.Name);
  }
  // 1 : 1000: an ellipsoid, whose outline is that of its longest section.
  for (const double thickness : { 1e-3, 1e3 })
  {
    Checked run;
    run.Filter->SetValue(0, 0.5);
    ExpectOneCircle(run.Of(BallImage(VTK_FLOAT, { 1, 1, thickness }, { 0, 0, 0 }, { 0, 1 }), "slices"), 6.0,
      0.02, "along the slices' axis");
    run.Filter->SetEyeDirection(1.0, 0.0, 0.0);
    vtkPolyData* ellipse = run.Of(BallImage(VTK_FLOAT, { 1, 1, thickness }, { 0, 0, 0 }, { 0, 1 }), "slices");
    EXPECT_EQ(ellipse->GetNumberOfLines(), 1) << thickness;
    EXPECT_NEAR(LengthOf(ellipse) / (4.0 * 6.0 * std::max(thickness, 1.0)), 1.0, 0.02) << thickness;
  }
}

TEST(ContoursExtremes, ScalarsAtTheEndsOfTheirTypes)
{
  const struct
  {
    int Type;
    Vector Values;
  } types[] = { { VTK_UNSIGNED_CHAR, { 0, 255 } }, { VTK_SIGNED_CHAR, { -128, 127 } },
    { VTK_SHORT, { -32768, 32767 } }, { VTK_UNSIGNED_SHORT, { 0, 65535 } },
    { VTK_INT, { -2147483648.0, 2147483647.0 } }, { VTK_UNSIGNED_INT, { 0, 4294967295.0 } },
    { VTK_LONG_LONG, { -std::ldexp(1.0, 63), std::ldexp(1.0, 63) - 1024 } },
    { VTK_UNSIGNED_LONG_LONG, { 0, std::ldexp(1.0, 64) - 2048 } }, { VTK_FLOAT, { -3e38, 3e38 } },
    { VTK_FLOAT, { 1e-38, 2e-38 } }, { VTK_DOUBLE, { -1.7e308, 1.7e308 } },
    { VTK_DOUBLE, { 1e-300, 3e-300 } } };
  for (const auto& [type, values] : types)
  {
    Checked run;
    run.Filter->SetValue(0, 0.5 * values[0] + 0.5 * values[1]);
    const std::string name = std::to_string(type) + " from " + std::to_string(values[0]);
    ExpectOneCircle(run.Of(BallImage(type, { 1, 1, 1 }, { 0, 0, 0 }, values), name), 6.0, 0.03, name);
  }
}

TEST(ContoursExtremes, ImagesWithoutASurface)
{
  const auto ball = BallImage(VTK_FLOAT, { 1, 1, 1 }, { 0, 0, 0 }, { 0, 1 });
  Checked run;
  run.Filter->SetValue(0, 0.5);
  const auto filled = [&](double value)
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->DeepCopy(ball);
    image->GetPointData()->GetScalars()->Fill(value);
    return image;
  };
  const auto expectNone =
    [&](vtkImageData* image, const std::string& name, const std::vector<std::string>& words)
  { EXPECT_EQ(run.Of(image, name, words)->GetNumberOfLines(), 0) << name; };
  expectNone(filled(0.5), "constant", { "All of the image's values are 0.5" });
  expectNone(filled(NaN), "NaN", { "None of the image's values is finite" });
  expectNone(filled(std::numeric_limits<double>::infinity()), "infinite", { "None of the image's" });
  expectNone(vtkSmartPointer<vtkImageData>::New(), "empty", {});
  vtkNew<vtkImageData> slice;
  slice->SetDimensions(9, 9, 1);
  slice->AllocateScalars(VTK_FLOAT, 1);
  expectNone(slice, "one slice", { "9 x 9 x 1", "at least 2" });
  const auto missing = vtkSmartPointer<vtkImageData>::New();
  missing->DeepCopy(ball);
  vtkDataArray* scalars = missing->GetPointData()->GetScalars();
  for (vtkIdType n = 0; n < scalars->GetNumberOfTuples(); n += 2)
  {
    scalars->SetComponent(n, 0, NaN);
  }
  EXPECT_EQ(run.Of(missing, "every other sample")->GetNumberOfLines(), 0);
}

/// Whatever a mesh or an image is: valid lines, and one message at most, but for normals that are computed.
TEST(ContoursExtremes, AnythingAtRandom)
{
  int withLines = 0;
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    InkTestRandom random(seed);
    Checked run;
    run.Filter->SetEye(vtkInkContours::POSITION + random.UpTo(2));
    run.Filter->SetEyePosition(random.Share(), random.Share(), random.Share());
    run.Filter->SetEyeDirection(random.Share() - 0.5, random.Share() - 0.5, random.Share() + 0.1);
    run.Filter->SetFaceted(random.Once(3));
    run.Filter->SetCreases(random.Once(2));
    run.Filter->SetNonManifoldEdges(random.Once(2));
    run.Filter->SetShortestCrease(random.Once(2) ? 0.0 : random.Share());
    run.Filter->SetShortestBorder(random.Once(2) ? 0.0 : random.Share());
    run.Filter->SetProjectionSteps(random.Once(2) ? 0 : 5);
    vtkSmartPointer<vtkDataObject> data;
    if (random.Once(2))
    {
      data = RandomMesh(random).Make(random);
    }
    else
    {
      const glm::ivec3 size(1 + random.UpTo(7), 1 + random.UpTo(7), 1 + random.UpTo(7));
      const auto image = MakeImage(RandomGeometry(random, size, true));
      WithScalarType(seed,
        [&](auto zero, int type)
        {
          using T = decltype(zero);
          image->AllocateScalars(type, 1);
          const std::span<T> values(
            static_cast<T*>(image->GetScalarPointer()), static_cast<std::size_t>(image->GetNumberOfPoints()));
          const int kind = random.UpTo(4);
          FillRandomly(values, random, kind, 3, random.Once(3) ? 10 : 0);
          run.Filter->SetValue(
            0, static_cast<double>(RandomValue<T>(random, kind, 3)) + 0.5 * random.UpTo(2));
        });
      data = image;
    }
    run.Filter->SetInputDataObject(data);
    run.Filter->Update();
    std::erase_if(run.Messages->Messages,
      [](const std::string& text) { return text.find("no point normals") != std::string::npos; });
    ASSERT_LE(run.Messages->Messages.size(), 1u) << seed << ": " << run.Messages->Messages.back();
    ASSERT_TRUE(CheckValidPoints("seed " + std::to_string(seed), run.Filter->GetOutput()));
    withLines += run.Filter->GetOutput()->GetNumberOfLines() > 0;
  }
  EXPECT_GT(withLines, 100);
}
