// SPDX-License-Identifier: BSD-3-Clause
// vtkInkStippleMapper and stipples that are not as the generator makes them: the right picture of what is
// left, or an empty one with one clear message; with places in either precision.
#include "InkTestStipples.h"
#include "StippleInk.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <cmath>
#include <string>

namespace
{

using namespace StippleInk;

/// Values, positions and normals that are not finite or zero are passed over; where nothing is left, or
/// arrays do not fit, one message says so.
void TestSpoilt(InkTestChecks& check)
{
  const auto copy = [](vtkPolyData* data)
  {
    Data spoilt = vtkSmartPointer<vtkPolyData>::New();
    spoilt->DeepCopy(data);
    return spoilt;
  };
  const Data voxels = InkTestStipples::SphereVoxels(1.0, 0.15, 6);
  const double usual = FindInk(check, "voxels", voxels);
  const char* const nothingLeft = "None of the";
  for (const double bad : { NaN, Infinity })
  {
    for (const char* name : { "Normals", "GradientMagnitude", "Value" })
    {
      const std::string what = std::string(name) + " of " + std::to_string(bad);
      const Data some = copy(voxels);
      vtkDataArray* array = some->GetCellData()->GetArray(name);
      for (vtkIdType e = 0; e < array->GetNumberOfTuples(); e += 4)
      {
        array->SetComponent(e, 0, bad);
      }
      ExpectInk(check, "some " + what, some, 0.75 * usual, 0.84 * usual);
      array->Fill(bad);
      ExpectMessage(check, "all " + what, some, nothingLeft);
    }
    const Data some = copy(voxels);
    for (vtkIdType i = 0; i < some->GetNumberOfPoints(); i += 4)
    {
      double p[3];
      some->GetPoint(i, p);
      p[i % 3] = bad;
      some->GetPoints()->SetPoint(i, p);
    }
    // Among them the first of every second list.
    ExpectInk(check, "some positions of " + std::to_string(bad), some, 0.55 * usual, 0.66 * usual);
    for (vtkIdType i = 0; i < some->GetNumberOfPoints(); ++i)
    {
      some->GetPoints()->SetPoint(i, bad, bad, bad);
    }
    ExpectMessage(check, "all positions of " + std::to_string(bad), some, nothingLeft);
  }
  const Data flat = copy(voxels);
  vtkDataArray* normals = flat->GetCellData()->GetArray("Normals");
  for (vtkIdType e = 0; e < normals->GetNumberOfTuples(); e += 2)
  {
    normals->SetTuple3(e, 0.0, 0.0, 0.0);
  }
  ExpectInk(check, "some normals of length 0", flat, 0.47 * usual, 0.57 * usual);
  normals->Fill(0.0);
  ExpectMessage(check, "all normals of length 0", flat, nothingLeft);

  // Normals of any other length count as their direction, values beyond 0 to 1 as its ends.
  for (const double length : { 1e-30, 1e30 })
  {
    const Data other = copy(voxels);
    vtkDataArray* array = other->GetCellData()->GetArray("Normals");
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        array->SetComponent(i, axis, length * array->GetComponent(i, axis));
      }
    }
    ExpectInk(check, "normals of length " + std::to_string(length), other, 0.999 * usual, 1.001 * usual);
  }
  const Data beyond = copy(voxels);
  beyond->GetCellData()->GetArray("Value")->Fill(-3.0);
  ExpectInk(check, "values below 0", beyond, 0.0, 0.0);
  beyond->GetCellData()->GetArray("Value")->Fill(1e30);
  beyond->GetCellData()->GetArray("GradientMagnitude")->Fill(1e30);
  ExpectAbout(check, "values above 1", beyond, 3.0 * usual);

  const auto replace = [&](const char* name, const vtkSmartPointer<vtkAbstractArray>& array)
  {
    const Data spoilt = copy(voxels);
    spoilt->GetCellData()->RemoveArray(name);
    if (array)
    {
      array->SetName(name);
      spoilt->GetCellData()->AddArray(array);
    }
    return spoilt;
  };
  for (const char* name : { "Normals", "GradientMagnitude", "Value" })
  {
    const std::string expected = std::string("\"") + name + "\" with";
    auto text = vtkSmartPointer<vtkStringArray>::New();
    text->SetNumberOfValues(voxels->GetNumberOfCells());
    auto wide = vtkSmartPointer<vtkFloatArray>::New();
    wide->SetNumberOfComponents(2);
    wide->SetNumberOfTuples(voxels->GetNumberOfCells());
    wide->Fill(0.5);
    auto few = vtkSmartPointer<vtkFloatArray>::New();
    few->SetNumberOfComponents(std::string(name) == "Normals" ? 3 : 1);
    few->SetNumberOfTuples(3);
    few->Fill(0.5);
    // A volume is known by its gradients; without them and without ElementKind it would be a surface.
    ExpectMessage(check, std::string("no ") + name, replace(name, nullptr), expected);
    ExpectMessage(check, std::string("text as ") + name, replace(name, text), expected);
    ExpectMessage(check, std::string("pairs as ") + name, replace(name, wide), expected);
    ExpectMessage(check, std::string("too few ") + name, replace(name, few), expected);
  }
  auto integers = vtkSmartPointer<vtkIntArray>::New();
  integers->SetNumberOfComponents(3);
  for (vtkIdType e = 0; e < voxels->GetNumberOfCells(); ++e)
  {
    double n[3];
    voxels->GetCellData()->GetArray("Normals")->GetTuple(e, n);
    integers->InsertNextTuple3(
      std::round(1000.0 * n[0]), std::round(1000.0 * n[1]), std::round(1000.0 * n[2]));
  }
  ExpectInk(check, "normals in integers", replace("Normals", integers), 0.99 * usual, 1.01 * usual);

  const auto field = [&](const char* name, double value)
  {
    const Data spoilt = copy(voxels);
    spoilt->GetFieldData()->GetArray(name)->SetComponent(0, 0, value);
    return spoilt;
  };
  for (const double bad : { 0.0, -1.0, NaN, Infinity })
  {
    ExpectMessage(check, "ElementSize " + std::to_string(bad), field("ElementSize", bad), "\"ElementSize\"");
    // The longest list counts then.
    ExpectInk(check, "StipplesPerElement " + std::to_string(bad), field("StipplesPerElement", bad),
      0.99 * usual, 1.01 * usual);
    if (bad != 0.0)
    {
      FindInk(check, "ElementKind " + std::to_string(bad), field("ElementKind", bad));
    }
  }
  // As if there were room for many more stipples, or for none.
  for (const double size : { 1e-30, 1e30 })
  {
    const double all = 120.0 * 120.0;
    ExpectAbout(
      check, "ElementSize " + std::to_string(size), field("ElementSize", size), size > 1.0 ? all : 0.0);
    ExpectAbout(check, "StipplesPerElement " + std::to_string(size), field("StipplesPerElement", size),
      size > 1.0 ? 0.0 : all);
  }
}

} // namespace

int TestStippleMapperSpoilt(int, char*[])
{
  return StippleInk::Run({ TestSpoilt });
}
