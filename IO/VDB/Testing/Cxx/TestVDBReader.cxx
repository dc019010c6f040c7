// SPDX-License-Identifier: BSD-3-Clause
// vtkInkVDBReader: values, transform, choice of grid, level sets' sign and update extents.

#include "InkTestChecks.h"
#include "VDBTestFiles.h"

#include "vtkImageData.h"
#include "vtkInkVDBReader.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <cmath>

namespace
{

using openvdb::Coord;

/// The image against OpenVDB's own values and places, voxel by voxel.
template <class Grid>
void ExpectSame(InkTestChecks& check, vtkImageData* image, const Grid& grid, double factor)
{
  int extent[6];
  image->GetExtent(extent);
  int wrongValues = 0;
  int wrongPlaces = 0;
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        const double value = factor * grid.tree().getValue(Coord(i, j, k));
        wrongValues += image->GetScalarComponentAsDouble(i, j, k, 0) != value;
        const int ijk[3] = { i, j, k };
        double p[3];
        image->TransformIndexToPhysicalPoint(ijk, p);
        const openvdb::Vec3d q = grid.transform().indexToWorld(Coord(i, j, k));
        wrongPlaces += (q - openvdb::Vec3d(p)).length() > 1e-9;
      }
    }
  }
  check(wrongValues == 0, "the grid's values, ", wrongValues, " are wrong");
  check(wrongPlaces == 0, "the grid's places, ", wrongPlaces, " are wrong");
}

} // namespace

int TestVDBReader(int, char*[])
{
  InkTestChecks check;
  const auto sphere = MakeSphere();
  sphere->transform().postRotate(0.5, openvdb::math::Z_AXIS);
  sphere->transform().postTranslate({ 100.0, -20.0, 3.0 });
  const auto density = openvdb::DoubleGrid::create(0.25);
  density->setName("density");
  density->tree().setValue(Coord(-5, 2, 900), 1.5);
  density->tree().setValue(Coord(3, 9, 905), 2.5);
  density->transform().postScale({ 1.0, -2.0, 3.0 });
  const auto other = openvdb::Vec3SGrid::create();
  other->setName("velocity");
  const std::string file = WriteVDB("TestVDBReader.vdb", { other, sphere, density });

  vtkNew<vtkInkVDBReader> reader;
  vtkNew<InkTestMessages> messages;
  messages->Observe(reader);
  check(reader->CanReadFile(file.c_str()) == 1 && reader->CanReadFile("none.vdb") == 0, "CanReadFile");
  reader->SetFileName(file.c_str());
  reader->UpdateInformation();
  check(reader->GetNumberOfGrids() == 3, "three grids, found ", reader->GetNumberOfGrids());
  check(reader->GetNameOfGrid(1) == std::string("sphere"), "a sphere, found ", reader->GetNameOfGrid(1));
  check(reader->GetTypeOfGrid(0) == std::string("vec3s"), "vec3s, found ", reader->GetTypeOfGrid(0));
  check(reader->GetTypeOfGrid(2) == std::string("double"), "double, found ", reader->GetTypeOfGrid(2));
  check(
    reader->GetClassOfGrid(1) == std::string("level set"), "level set, found ", reader->GetClassOfGrid(1));
  check(reader->GetNameOfGrid(3) == std::string(), "no fourth grid");
  int dimensions[3];
  reader->GetDimensionsOfGrid(2, dimensions);
  check(dimensions[0] == 9 && dimensions[1] == 8 && dimensions[2] == 6, "9 x 8 x 6, found ", dimensions[0],
    " x ", dimensions[1], " x ", dimensions[2]);
  check(reader->GetNumberOfActiveVoxelsOfGrid(2) == 2, "two active voxels");
  check(reader->GetGridNames()->GetNumberOfValues() == 2, "two grids that can be read");

  // The first that can be read, its inside positive.
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  check(image->GetScalarType() == VTK_FLOAT &&
      image->GetPointData()->GetScalars()->GetName() == std::string("sphere"),
    "the array sphere of floats");
  ExpectSame(check, image, *sphere, -1.0);
  reader->InvertLevelSetsOff();
  reader->Update();
  ExpectSame(check, image, *sphere, 1.0);

  reader->SetGridName("density");
  reader->InvertLevelSetsOn();
  reader->SetPadding(3);
  reader->Update();
  int extent[6];
  image->GetExtent(extent);
  check(extent[0] == -8 && extent[1] == 6 && extent[4] == 897 && extent[5] == 908, "3 voxels around, found ",
    extent[0], " to ", extent[1], " and ", extent[4], " to ", extent[5]);
  check(image->GetScalarType() == VTK_DOUBLE, "doubles");
  ExpectSame(check, image, *density, 1.0);

  const int part[6] = { -5, 0, 2, 3, 900, 900 };
  reader->Modified();
  reader->UpdateExtent(part);
  image->GetExtent(extent);
  check(std::equal(part, part + 6, extent), "the part that was asked for");
  ExpectSame(check, image, *density, 1.0);
  check(messages->Messages.empty(), "no message, found ",
    messages->Messages.empty() ? "" : messages->Messages[0]);
  return check.Result();
}
