// SPDX-License-Identifier: BSD-3-Clause
// vtkInkStippleMapper and stipples that are not as the generator makes them: the right picture of what is
// left, or an empty one with one clear message; with positions in either precision.
#include "InkTestStipples.h"
#include "StippleInk.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{

using namespace StippleInk;

const char* const NothingLeft = "None of the";

/// Voxels around a sphere, of which copies are spoilt.
class StippleMapperSpoilt : public StippleInk::Test
{
protected:
  Data CopyVoxels() const
  {
    Data copy = vtkSmartPointer<vtkPolyData>::New();
    copy->DeepCopy(this->Voxels);
    return copy;
  }

  /// With another cell array of a name, or none.
  Data Replace(const char* name, const vtkSmartPointer<vtkAbstractArray>& array) const
  {
    const Data copy = this->CopyVoxels();
    copy->GetCellData()->RemoveArray(name);
    if (array)
    {
      array->SetName(name);
      copy->GetCellData()->AddArray(array);
    }
    return copy;
  }

  Data WithField(const char* name, double value) const
  {
    const Data copy = this->CopyVoxels();
    copy->GetFieldData()->GetArray(name)->SetComponent(0, 0, value);
    return copy;
  }

  const Data Voxels = InkTestStipples::SphereVoxels(1.0, 0.15, 6);
  const double Usual = FindInk("voxels", this->Voxels);
};

} // namespace

/// Elements and stipples with numbers that are not finite are passed over; where nothing is left, one message
/// says so.
TEST_F(StippleMapperSpoilt, NumbersThatAreNotFinite)
{
  for (const double bad : { NaN, Infinity })
  {
    for (const char* name : { "Normals", "GradientMagnitude", "Value" })
    {
      const std::string what = std::string(name) + " of " + std::to_string(bad);
      const Data some = this->CopyVoxels();
      vtkDataArray* array = some->GetCellData()->GetArray(name);
      for (vtkIdType e = 0; e < array->GetNumberOfTuples(); e += 4)
      {
        array->SetComponent(e, 0, bad);
      }
      ExpectInk("some " + what, some, 0.78 * this->Usual, 0.81 * this->Usual);
      array->Fill(bad);
      ExpectMessage("all " + what, some, NothingLeft);
    }
    const Data some = this->CopyVoxels();
    for (vtkIdType i = 0; i < some->GetNumberOfPoints(); i += 4)
    {
      double p[3];
      some->GetPoint(i, p);
      p[i % 3] = bad;
      some->GetPoints()->SetPoint(i, p);
    }
    // Among them the first of every second list.
    ExpectInk("some positions of " + std::to_string(bad), some, 0.59 * this->Usual, 0.62 * this->Usual);
    for (vtkIdType i = 0; i < some->GetNumberOfPoints(); ++i)
    {
      some->GetPoints()->SetPoint(i, bad, bad, bad);
    }
    ExpectMessage("all positions of " + std::to_string(bad), some, NothingLeft);
  }
}

/// Normals of length 0 are passed over, any other length counts as the direction.
TEST_F(StippleMapperSpoilt, NormalsOfOtherLengths)
{
  const Data flat = this->CopyVoxels();
  vtkDataArray* normals = flat->GetCellData()->GetArray("Normals");
  for (vtkIdType e = 0; e < normals->GetNumberOfTuples(); e += 2)
  {
    normals->SetTuple3(e, 0.0, 0.0, 0.0);
  }
  ExpectInk("some normals of length 0", flat, 0.51 * this->Usual, 0.535 * this->Usual);
  normals->Fill(0.0);
  ExpectMessage("all normals of length 0", flat, NothingLeft);

  for (const double length : { 1e-30, 1e30 })
  {
    const Data other = this->CopyVoxels();
    vtkDataArray* array = other->GetCellData()->GetArray("Normals");
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        array->SetComponent(i, axis, length * array->GetComponent(i, axis));
      }
    }
    ExpectInk("normals of length " + std::to_string(length), other, 0.999 * this->Usual, 1.001 * this->Usual);
  }
}

/// Values beyond 0 to 1 count as its ends.
TEST_F(StippleMapperSpoilt, ValuesBeyondTheirRange)
{
  const Data beyond = this->CopyVoxels();
  beyond->GetCellData()->GetArray("Value")->Fill(-3.0);
  ExpectInk("values below 0", beyond, 0.0, 0.0);
  beyond->GetCellData()->GetArray("Value")->Fill(1e30);
  beyond->GetCellData()->GetArray("GradientMagnitude")->Fill(1e30);
  ExpectAbout("values above 1", beyond, 3.0 * this->Usual);
}

/// Arrays that do not fit, of which one message tells.
TEST_F(StippleMapperSpoilt, ArraysThatDoNotFit)
{
  for (const char* name : { "Normals", "GradientMagnitude", "Value" })
  {
    const std::string expected = std::string("\"") + name + "\" with";
    auto text = vtkSmartPointer<vtkStringArray>::New();
    text->SetNumberOfValues(this->Voxels->GetNumberOfCells());
    auto wide = vtkSmartPointer<vtkFloatArray>::New();
    wide->SetNumberOfComponents(2);
    wide->SetNumberOfTuples(this->Voxels->GetNumberOfCells());
    wide->Fill(0.5);
    auto few = vtkSmartPointer<vtkFloatArray>::New();
    few->SetNumberOfComponents(std::string(name) == "Normals" ? 3 : 1);
    few->SetNumberOfTuples(3);
    few->Fill(0.5);
    // A volume is known by its gradients; without them and without ElementKind it would be a surface.
    ExpectMessage(std::string("no ") + name, this->Replace(name, nullptr), expected);
    ExpectMessage(std::string("text as ") + name, this->Replace(name, text), expected);
    ExpectMessage(std::string("pairs as ") + name, this->Replace(name, wide), expected);
    ExpectMessage(std::string("too few ") + name, this->Replace(name, few), expected);
  }
  auto integers = vtkSmartPointer<vtkIntArray>::New();
  integers->SetNumberOfComponents(3);
  for (vtkIdType e = 0; e < this->Voxels->GetNumberOfCells(); ++e)
  {
    double n[3];
    this->Voxels->GetCellData()->GetArray("Normals")->GetTuple(e, n);
    integers->InsertNextTuple3(
      std::round(1000.0 * n[0]), std::round(1000.0 * n[1]), std::round(1000.0 * n[2]));
  }
  ExpectInk(
    "normals in integers", this->Replace("Normals", integers), 0.99 * this->Usual, 1.01 * this->Usual);
}

TEST_F(StippleMapperSpoilt, FieldData)
{
  for (const double bad : { 0.0, -1.0, NaN, Infinity })
  {
    ExpectMessage(
      "ElementSize " + std::to_string(bad), this->WithField("ElementSize", bad), "\"ElementSize\"");
    // The longest list counts then.
    ExpectInk("StipplesPerElement " + std::to_string(bad), this->WithField("StipplesPerElement", bad),
      0.99 * this->Usual, 1.01 * this->Usual);
    if (bad != 0.0)
    {
      // Their gradients make them a volume's.
      ExpectInk("ElementKind " + std::to_string(bad), this->WithField("ElementKind", bad), 0.99 * this->Usual,
        1.01 * this->Usual);
    }
  }
  // As if there were room for many more stipples, or for none.
  for (const double size : { 1e-30, 1e30 })
  {
    const double all = 120.0 * 120.0;
    ExpectAbout(
      "ElementSize " + std::to_string(size), this->WithField("ElementSize", size), size > 1.0 ? all : 0.0);
    ExpectAbout("StipplesPerElement " + std::to_string(size), this->WithField("StipplesPerElement", size),
      size > 1.0 ? 0.0 : all);
  }
}
