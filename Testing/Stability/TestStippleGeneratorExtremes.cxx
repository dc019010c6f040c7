// SPDX-License-Identifier: BSD-3-Clause
// Volumes and meshes at the ends of what there is: stipples where there should be some, all of them finite
// and within their bounds, and not a word.

#include "InkTestMesh.h"
#include "InkTestMessages.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInkStippleGenerator.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace
{

using Change = std::function<void(vtkInkStippleGenerator*)>;

/// Stipples the data with all that passes; all that comes out must be in bounds. There may be no message but
/// one of faces that are not finite.
vtkSmartPointer<vtkPolyData> Stipple(
  const std::string& name, vtkDataSet* data, const Change& change = [](vtkInkStippleGenerator*) {})
{
  vtkNew<vtkInkStippleGenerator> generator;
  vtkNew<InkTestMessages> messages;
  messages->Observe(generator);
  generator->SetInputDataObject(data);
  generator->SetThresholdModeToMagnitude();
  change(generator);
  generator->Update();
  std::erase_if(messages->Messages,
    [](const std::string& text) { return text.find(InkTestOddFaces) != std::string::npos; });
  EXPECT_TRUE(messages->Messages.empty() || generator->GetOutput()->GetNumberOfPoints() == 0)
    << name << ": no message, found " << (messages->Messages.empty() ? "" : messages->Messages[0]);
  vtkSmartPointer<vtkPolyData> output = generator->GetOutput();

  double bounds[6];
  data->GetBounds(bounds);
  double slack = 0.0;
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    double spacing[3];
    image->GetSpacing(spacing);
    slack = vtkMath::Norm(spacing);
  }
  slack += 1e-6 * std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  bool inside = true;
  for (vtkIdType n = 0; n < output->GetNumberOfPoints(); ++n)
  {
    double p[3];
    output->GetPoint(n, p);
    for (int axis = 0; axis < 3; ++axis)
    {
      inside = inside && p[axis] >= bounds[2 * axis] - slack && p[axis] <= bounds[2 * axis + 1] + slack;
    }
  }
  EXPECT_TRUE(inside) << name << ": stipples within the data's bounds";
  vtkIdType notUnit = 0;
  for (vtkIdType e = 0; e < output->GetNumberOfCells(); ++e)
  {
    const double length = vtkMath::Norm(output->GetCellData()->GetNormals()->GetTuple3(e));
    notUnit += !(std::abs(length - 1.0) < 1e-5);
  }
  EXPECT_EQ(notUnit, 0) << name << ": normals of length 1";
  for (const char* array : { "GradientMagnitude", "Value" })
  {
    if (vtkDataArray* shares = output->GetCellData()->GetArray(array))
    {
      vtkIdType outside = 0;
      for (vtkIdType e = 0; e < shares->GetNumberOfTuples(); ++e)
      {
        const double share = shares->GetComponent(e, 0);
        outside += !(share >= 0.0 && share <= 1.0);
      }
      EXPECT_EQ(outside, 0) << name << ": " << array << " within 0 to 1";
    }
  }
  return output;
}

/// n voxels a side of the squared distance from the middle, between two values.
vtkSmartPointer<vtkImageData> MakeImage(
  int type, const std::array<int, 3>& n, double low = 0.0, double high = 100.0)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n.data());
  image->AllocateScalars(type, 1);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  vtkIdType id = 0;
  for (int k = 0; k < n[2]; ++k)
  {
    for (int j = 0; j < n[1]; ++j)
    {
      for (int i = 0; i < n[0]; ++i)
      {
        const double x = 2.0 * i / n[0] - 1.0;
        const double y = 2.0 * j / n[1] - 1.0;
        const double z = 2.0 * k / n[2] - 1.0;
        const double share = (x * x + y * y + z * z) / 3.0;
        scalars->SetComponent(id++, 0, (1.0 - share) * high + share * low);
      }
    }
  }
  return image;
}

} // namespace

TEST(StippleGeneratorExtremes, Geometry)
{
  for (const std::array<double, 3>& spacing : { std::array{ 1e-9, 1e-9, 1e-9 }, std::array{ 1e9, 1e9, 1e9 },
         std::array{ 1.0, 1.0, 1000.0 }, std::array{ 1000.0, 1.0, 1.0 }, std::array{ -1.0, 2.0, -3.0 } })
  {
    const std::string name = "spacing " + std::to_string(spacing[0]) + " " + std::to_string(spacing[2]);
    const auto image = MakeImage(VTK_FLOAT, { 9, 10, 11 });
    image->SetSpacing(spacing.data());
    EXPECT_GT(Stipple(name, image)->GetNumberOfCells(), 900) << name << ": stipples";
    image->SetDirectionMatrix(0.6, -0.8, 0.0, 0.8, 0.6, 0.0, 0.0, 0.0, 1.0);
    EXPECT_GT(Stipple(name + " turned", image)->GetNumberOfCells(), 900) << name << ": stipples, turned";
  }
  const auto far = MakeImage(VTK_FLOAT, { 9, 9, 9 });
  far->SetOrigin(1e7, -1e7, 1e7);
  far->SetSpacing(0.01, 0.01, 0.01);
  const auto stipples = Stipple("far away", far);
  EXPECT_EQ(stipples->GetPoints()->GetDataType(), VTK_DOUBLE) << "far away: double precision";
}

TEST(StippleGeneratorExtremes, Values)
{
  for (const int type : { VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT,
         VTK_UNSIGNED_INT, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG, VTK_FLOAT, VTK_DOUBLE })
  {
    vtkSmartPointer<vtkDataArray> array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
    // Doubles just within a 64-bit integer's range.
    const double low = array->GetDataTypeMin() * (1.0 - 1e-15);
    const double high = array->GetDataTypeMax() * (1.0 - 1e-15);
    const std::string name = std::string("whole range of ") + array->GetDataTypeAsString();
    EXPECT_GT(Stipple(name, MakeImage(type, { 8, 8, 8 }, low, high))->GetNumberOfCells(), 400)
      << name << ": stipples";
  }
  for (const double size : { 1e-30, 1e30 })
  {
    const std::string name = "values of " + std::to_string(size);
    EXPECT_GT(Stipple(name, MakeImage(VTK_FLOAT, { 8, 8, 8 }, 0.0, size))->GetNumberOfCells(), 400)
      << name << ": stipples";
  }
  const auto holes = MakeImage(VTK_FLOAT, { 12, 12, 12 });
  for (vtkIdType n = 0; n < holes->GetNumberOfPoints(); n += 7)
  {
    holes->GetPointData()->GetScalars()->SetComponent(
      n, 0, n % 3 ? std::numeric_limits<double>::quiet_NaN() : std::numeric_limits<double>::infinity());
  }
  EXPECT_GT(Stipple("holes", holes)->GetNumberOfCells(), 1000) << "holes: stipples";
}

TEST(StippleGeneratorExtremes, Shapes)
{
  for (const std::array<int, 3>& n : { std::array{ 1, 1, 1 }, std::array{ 1, 1, 2 }, std::array{ 30, 1, 1 },
         std::array{ 1, 30, 30 }, std::array{ 30, 30, 1 }, std::array{ 2, 2, 2 }, std::array{ 300, 2, 1 } })
  {
    const std::string name =
      std::to_string(n[0]) + " x " + std::to_string(n[1]) + " x " + std::to_string(n[2]);
    const auto image = MakeImage(VTK_FLOAT, n);
    const vtkIdType voxels = image->GetNumberOfPoints();
    const auto stipples = Stipple(name, image, [](auto* g) { g->SetMaximumStipples(64); });
    EXPECT_TRUE(stipples->GetNumberOfCells() > (voxels - 2) / 2 || voxels == 1)
      << name << ": stipples, found " << stipples->GetNumberOfCells() << " elements";
    EXPECT_EQ(stipples->GetNumberOfPoints(), 64 * stipples->GetNumberOfCells()) << name << ": 64 an element";
    // As many as the picture has pixels for a voxel, whatever its size in the world.
    for (const double spacing : { 1e-9, 1.0, 1e9 })
    {
      image->SetSpacing(spacing, spacing, spacing);
      const auto projected = Stipple(name, image,
        [](auto* g)
        {
          g->SetMaximumStipplesModeToProjected();
          g->SetPictureSize(450.0);
        });
      const double pixels = 450.0 / *std::max_element(n.begin(), n.end());
      const double expected = std::min(std::round(pixels * pixels), 64.0);
      EXPECT_EQ(static_cast<double>(projected->GetNumberOfPoints()),
        expected * static_cast<double>(projected->GetNumberOfCells()))
        << name << ", spacing " << spacing << ": " << expected << " an element";
    }
  }
}

TEST(StippleGeneratorExtremes, Meshes)
{
  // Normals of length 0 as well.
  for (const double scale : { 1e-9, 1.0, 1e9 })
  {
    const std::string name = "mesh of size " + std::to_string(scale);
    const vtkSmartPointer<vtkPolyData> mesh = InkTestOddMesh(scale);
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(mesh->GetNumberOfPoints());
    normals->Fill(0.0);
    mesh->GetPointData()->SetNormals(normals);
    const auto stipples = Stipple(name, mesh, [](auto* g) { g->SetNumberOfSurfaceStipples(300); });
    EXPECT_TRUE(stipples->GetNumberOfPoints() == 300 && stipples->GetNumberOfCells() == 3)
      << name
      << ": stipples in the three polygons with an area, the one that is there twice counted once, found "
      << stipples->GetNumberOfCells();
    const auto projected = Stipple(name, mesh, [](auto* g) { g->SetMaximumStipplesModeToProjected(); });
    EXPECT_EQ(projected->GetNumberOfPoints(), vtkInkStippleGenerator::CountForPicture(mesh, 600.0, 1.0))
      << name << ": a stipple a pixel, found " << projected->GetNumberOfPoints();
    const auto one = Stipple(name, mesh, [](auto* g) { g->SetNumberOfSurfaceStipples(1); });
    EXPECT_TRUE(one->GetNumberOfPoints() == 1 && one->GetNumberOfCells() == 1)
      << name << ": a single stipple";
  }
}
