// SPDX-License-Identifier: BSD-3-Clause
// vtkInkHatching: spacing of the families, cut strokes, order, errors.
#include "InkTestMessages.h"
#include "InkTestProgress.h"
#include "vtkInkHatching.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace
{

/// Lines along x over the square from 0 to 10, with points .1 apart, at even y; each third is of the second
/// family.
vtkSmartPointer<vtkPolyData> SquareLines(int count, bool withArrays)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkFloatArray> priorities;
  vtkNew<vtkUnsignedCharArray> families;
  vtkNew<vtkIntArray> numbers;
  vtkNew<vtkFloatArray> heights;
  priorities->SetName("Priority");
  families->SetName("LineFamily");
  numbers->SetName("Number");
  heights->SetName("Height");
  for (int line = 0; line < count; ++line)
  {
    lines->InsertNextCell(101);
    for (int i = 0; i <= 100; ++i)
    {
      const double y = 10.0 * (line + 0.5) / count;
      lines->InsertCellPoint(points->InsertNextPoint(0.1 * i, y, 0.0));
      heights->InsertNextValue(static_cast<float>(y));
    }
    priorities->InsertNextValue(static_cast<float>(line) / static_cast<float>(count));
    families->InsertNextValue(line % 3 == 2);
    numbers->InsertNextValue(100 + line);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  data->GetPointData()->AddArray(heights);
  data->GetCellData()->AddArray(numbers);
  if (withArrays)
  {
    data->GetCellData()->AddArray(priorities);
    data->GetCellData()->AddArray(families);
  }
  return data;
}

vtkSmartPointer<vtkPolyData> Square()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(0.0, 0.0, 0.0);
  plane->SetPoint1(10.0, 0.0, 0.0);
  plane->SetPoint2(0.0, 10.0, 0.0);
  plane->SetResolution(3, 2);
  plane->Update();
  return plane->GetOutput();
}

double Value(vtkPolyData* data, const char* name, vtkIdType cell)
{
  return data->GetCellData()->GetArray(name)->GetComponent(cell, 0);
}

} // namespace

TEST(Hatching, SpacingOfFamilies)
{
  vtkNew<vtkInkHatching> hatching;
  hatching->SetInputData(SquareLines(30, true));
  hatching->SetSurfaceData(Square());
  hatching->Update();
  vtkPolyData* output = hatching->GetOutput();
  ASSERT_EQ(output->GetNumberOfLines(), 30);
  for (vtkIdType cell = 0; cell < 30; ++cell)
  {
    const bool second = cell % 3 == 2;
    EXPECT_EQ(Value(output, "LineFamily", cell), second);
    EXPECT_FLOAT_EQ(Value(output, "Spacing", cell), second ? 1.0 : 0.5) << "100 / length";
    EXPECT_FLOAT_EQ(Value(output, "Priority", cell), cell / 30.0);
    EXPECT_EQ(Value(output, "Number", cell), 100 + cell) << "other arrays go with them";
  }
  EXPECT_NE(output->GetPointData()->GetArray("Height"), nullptr);
  hatching->SetSpacing(0.25);
  hatching->SetSurfaceData(nullptr);
  hatching->Update();
  EXPECT_FLOAT_EQ(Value(hatching->GetOutput(), "Spacing", 0), 0.25) << "as given";
}

/// Of lines that are closer where y is small: how far they are from each other where, within the second
/// family, too; not with one distance for all.
TEST(Hatching, LocalSpacing)
{
  const vtkSmartPointer<vtkPolyData> lines = SquareLines(90, true);
  const auto yOf = [](double y) { return y * (0.5 + 0.05 * y); };
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    double p[3];
    lines->GetPoint(i, p);
    lines->GetPoints()->SetPoint(i, p[0], yOf(p[1]), p[2]);
  }
  vtkNew<vtkInkHatching> hatching;
  hatching->SetInputData(lines);
  hatching->SetSurfaceData(Square());
  hatching->Update();
  vtkPolyData* output = hatching->GetOutput();
  vtkDataArray* ratios = output->GetPointData()->GetArray("SpacingRatio");
  ASSERT_NE(ratios, nullptr);
  ASSERT_EQ(ratios->GetNumberOfComponents(), 8);
  ASSERT_EQ(ratios->GetNumberOfTuples(), output->GetNumberOfPoints());
  // At borders there may be half a distance or less to the side of a line.
  for (vtkIdType cell = 8; cell < 82; ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    output->GetLines()->GetCellAtId(cell, size, ids);
    const double middle = 10.0 * (cell + 0.5) / 90.0;
    // The derivative of y: of both families, as every third line is the second's.
    const bool second = cell % 3 == 2;
    const double tolerance = second ? 0.12 : 0.2;
    for (vtkIdType i = 0; i < size; ++i)
    {
      EXPECT_NEAR(ratios->GetComponent(ids[i], 0), 0.5 + 0.1 * middle, tolerance) << cell << " at " << i;
    }
  }
  hatching->LocalSpacingOff();
  hatching->Update();
  EXPECT_EQ(hatching->GetOutput()->GetPointData()->GetArray("SpacingRatio"), nullptr);
  hatching->LocalSpacingOn();
  hatching->SetSpacing(0.3);
  hatching->Update();
  EXPECT_EQ(hatching->GetOutput()->GetPointData()->GetArray("SpacingRatio"), nullptr) << "as given";
}

TEST(Hatching, CutStrokes)
{
  vtkNew<vtkInkHatching> hatching;
  hatching->SetInputData(SquareLines(30, true));
  hatching->SetSurfaceData(Square());
  hatching->SetStrokeLength(2.0);
  hatching->Update();
  vtkPolyData* output = hatching->GetOutput();
  EXPECT_EQ(output->GetNumberOfLines(), 5 * 30);
  EXPECT_EQ(output->GetNumberOfPoints(), 101 * 30) << "no points but the lines'";
  std::vector<double> lengths(30, 0.0);
  std::set<double> ends;
  for (vtkIdType cell = 0; cell < output->GetNumberOfLines(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* ids;
    output->GetLines()->GetCellAtId(cell, size, ids);
    double a[3];
    double b[3];
    output->GetPoint(ids[0], a);
    output->GetPoint(ids[size - 1], b);
    const auto line = static_cast<std::size_t>(Value(output, "Number", cell) - 100);
    lengths[line] += b[0] - a[0];
    ends.insert(b[0]);
    EXPECT_TRUE(b[0] - a[0] > 0.3 && b[0] - a[0] < 3.7 && a[1] == b[1]) << "stroke " << cell;
    EXPECT_FLOAT_EQ(Value(output, "Priority", cell), static_cast<double>(line) / 30.0);
    EXPECT_FLOAT_EQ(Value(output, "Spacing", cell), line % 3 == 2 ? 1.0 : 0.5);
  }
  for (const double length : lengths)
  {
    EXPECT_NEAR(length, 10.0, 1e-5) << "all of a line";
  }
  EXPECT_GT(ends.size(), 30u) << "cut anywhere";
}

/// Without an order, lines are dropped by chance; any part of them is a part of their length.
TEST(Hatching, PriorityByChance)
{
  vtkNew<vtkInkHatching> hatching;
  hatching->SetInputData(SquareLines(40, false));
  hatching->SetSurfaceData(Square());
  hatching->Update();
  std::set<double> found;
  bool ascending = true;
  for (vtkIdType cell = 0; cell < 40; ++cell)
  {
    const double priority = Value(hatching->GetOutput(), "Priority", cell);
    ascending = ascending && (found.empty() || priority > *found.rbegin());
    found.insert(priority);
    EXPECT_EQ(Value(hatching->GetOutput(), "LineFamily", cell), 0.0);
  }
  EXPECT_TRUE(found.size() == 40 && *found.begin() == 0.0 && std::abs(*found.rbegin() - 39.0 / 40.0) < 1e-6);
  EXPECT_FALSE(ascending);
  hatching->SetSeed(1);
  vtkNew<vtkPolyData> before;
  before->DeepCopy(hatching->GetOutput());
  hatching->Update();
  EXPECT_NE(Value(before, "Priority", 0), Value(hatching->GetOutput(), "Priority", 0)) << "another seed";
}

TEST(Hatching, ProgressAndAbort)
{
  vtkNew<vtkInkHatching> hatching;
  hatching->SetInputData(SquareLines(1000, true));
  hatching->SetSurfaceData(Square());
  hatching->SetStrokeLength(2.0);
  InkTestProgressAndAbort(hatching.Get());
}

TEST(Hatching, Errors)
{
  const auto expect = [](vtkPolyData* lines, vtkPolyData* surface, const std::vector<std::string>& words)
  {
    vtkNew<vtkInkHatching> hatching;
    vtkNew<InkTestMessages> messages;
    messages->Observe(hatching);
    hatching->SetInputData(lines);
    hatching->SetSurfaceData(surface);
    hatching->Update();
    messages->Expect("hatching", words);
    EXPECT_EQ(hatching->GetOutput()->GetNumberOfLines(), 0);
  };
  expect(SquareLines(3, true), nullptr, { "expected a surface with an area", "found neither" });
  vtkNew<vtkPolyData> nothing;
  expect(SquareLines(3, true), nothing, { "found a surface without area" });
  vtkSmartPointer<vtkPolyData> lines = SquareLines(3, true);
  vtkNew<vtkFloatArray> pairs;
  pairs->SetName("Priority");
  pairs->SetNumberOfComponents(2);
  pairs->SetNumberOfTuples(3);
  lines->GetCellData()->AddArray(pairs);
  expect(lines, Square(), { "\"Priority\"", "3 with 2" });
  expect(nothing, Square(), {});
}
