// SPDX-License-Identifier: BSD-3-Clause
#include "InkStrokePoints.h"

#include "Core/Hash.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <sstream>

InkStrokeArrays::InkStrokeArrays(vtkPolyData* data, vtkDataArray* widths, bool hatching)
  : Data(data)
  , Normals(data->GetPointData()->GetNormals() ? data->GetPointData()->GetNormals()
                                               : data->GetPointData()->GetArray("Normals"))
  , Widths(widths)
  , ArcLengths(data->GetPointData()->GetArray("ArcLength"))
  , RadialCurvature(data->GetPointData()->GetArray("RadialCurvature"))
  , OriginalIds(vtkIdTypeArray::SafeDownCast(data->GetPointData()->GetArray("vtkOriginalPointIds")))
  , Priorities(data->GetCellData()->GetArray("Priority"))
  , CellPriorities(this->Priorities != nullptr)
  , Hatching(hatching)
  , Spacings(hatching ? data->GetCellData()->GetArray("Spacing") : nullptr)
  , Families(hatching ? data->GetCellData()->GetArray("LineFamily") : nullptr)
  , Ratios(hatching ? data->GetPointData()->GetArray("SpacingRatio") : nullptr)
{
  if (!this->Priorities)
  {
    this->Priorities = data->GetPointData()->GetArray("Priority");
  }
}

std::string InkStrokeArrays::FindProblem() const
{
  std::ostringstream message;
  if (this->Data->GetNumberOfLines() == 0)
  {
    message << "Strokes need lines; found none among " << this->Data->GetNumberOfPoints() << " points and "
            << this->Data->GetNumberOfCells() << " cells.";
    return message.str();
  }
  const auto check = [&](vtkDataArray* array, int components, vtkIdType tuples, const char* of)
  {
    if (array && (array->GetNumberOfComponents() != components || array->GetNumberOfTuples() != tuples) &&
      message.str().empty())
    {
      message << "Expected " << tuples << " values with " << components << " components in the " << of
              << " array \"" << (array->GetName() ? array->GetName() : "") << "\"; found "
              << array->GetNumberOfTuples() << " with " << array->GetNumberOfComponents() << " components.";
    }
  };
  if (this->Hatching && !(this->Normals && this->Priorities && this->CellPriorities && this->Spacings))
  {
    message << "Hatching needs strokes with the point array \"Normals\" and the cell arrays \"Priority\" and "
               "\"Spacing\", as of vtkInkHatching; found none of the name \""
            << (!this->Normals       ? "Normals"
                   : !this->Spacings ? "Spacing"
                                     : "Priority")
            << "\".";
    return message.str();
  }
  const vtkIdType points = this->Data->GetNumberOfPoints();
  const vtkIdType cells = this->Data->GetNumberOfCells();
  check(this->Normals, 3, points, "point");
  check(this->Widths, 1, points, "point");
  check(this->ArcLengths, 1, points, "point");
  check(this->RadialCurvature, 1, points, "point");
  check(this->OriginalIds, 1, points, "point");
  check(this->Priorities, 1, this->CellPriorities ? cells : points, this->CellPriorities ? "cell" : "point");
  check(this->Spacings, 1, cells, "cell");
  check(this->Families, 1, cells, "cell");
  check(this->Ratios, static_cast<int>(ink::hatching::evenSpacing.size()), points, "point");
  // Positions on the GPU are ints, and each point is there once for each stroke that it belongs to.
  const vtkIdType ends = this->Data->GetLines()->GetNumberOfConnectivityIds();
  if (ends > std::numeric_limits<int>::max() / 6 && message.str().empty())
  {
    message << "Strokes of up to " << std::numeric_limits<int>::max() / 6 << " points can be drawn; found "
            << ends << '.';
  }
  return message.str();
}

float InkStrokeArrays::FindPriority(vtkIdType cell, vtkIdType line, vtkIdType point) const
{
  // Without an order, strokes are dropped by chance.
  const double priority = !this->Priorities
    ? ink::unitDouble(ink::hash(static_cast<std::uint64_t>(line)))
    : this->Priorities->GetComponent(this->CellPriorities ? cell : point, 0);
  return static_cast<float>(std::isfinite(priority) ? std::clamp(priority, 0.0, 1.0) : 1.0);
}

InkStrokeArrays::Key InkStrokeArrays::GetKey() const
{
  const auto time = [](vtkObject* object) { return object ? object->GetMTime() : 0; };
  return { time(this->Data->GetPoints()), time(this->Data->GetLines()), time(this->Normals),
    time(this->Widths), time(this->ArcLengths), time(this->RadialCurvature), time(this->OriginalIds),
    time(this->Priorities), time(this->Spacings), time(this->Families), time(this->Ratios), this->Hatching };
}

void InkStrokePoints::AddPoint(
  const InkStrokeArrays& arrays, vtkIdType id, const float local[3], double arcLength)
{
  this->Points.push_back({ { local[0], local[1], local[2] }, static_cast<float>(arcLength) });
  Shape shape{ { 0.0f, 0.0f, 0.0f }, 1.0f };
  if (arrays.Normals)
  {
    double normal[3];
    arrays.Normals->GetTuple(id, normal);
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    for (int axis = 0; axis < 3 && std::isfinite(length) && length > 0.0; ++axis)
    {
      shape.Normal[axis] = static_cast<float>(normal[axis] / length);
    }
  }
  if (arrays.Widths)
  {
    const double width = arrays.Widths->GetComponent(id, 0);
    shape.Width = width > 0.0 && std::isfinite(width) ? static_cast<float>(width) : 0.0f;
  }
  this->Shapes.push_back(shape);
  this->Sources.push_back(id);
  this->Ids.push_back(static_cast<std::uint32_t>(arrays.OriginalIds ? arrays.OriginalIds->GetValue(id) : id));
  if (arrays.RadialCurvature)
  {
    const double curvature = arrays.RadialCurvature->GetComponent(id, 0);
    this->RadialCurvature.push_back(std::isfinite(curvature) ? static_cast<float>(curvature) : 0.0f);
  }
  if (arrays.Hatching)
  {
    ink::hatching::SpacingRatios& ratios = this->Ratios.emplace_back(ink::hatching::evenSpacing);
    for (std::size_t i = 0; arrays.Ratios && i < ratios.size(); ++i)
    {
      const double ratio = arrays.Ratios->GetComponent(id, static_cast<int>(i));
      ratios[i] = ratio >= 0.0 && std::isfinite(ratio) ? static_cast<float>(ratio) : 1.0f;
    }
  }
  this->AddToBounds(local);
}

void InkStrokePoints::AddToBounds(const float position[3], double margin)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    double* bounds = this->LocalBounds.data() + 2 * axis;
    bounds[0] = std::min(bounds[0], position[axis] - margin);
    bounds[1] = std::max(bounds[1], position[axis] + margin);
  }
}

void InkStrokePoints::EndStroke(
  const InkStrokeArrays& arrays, int first, vtkIdType cell, vtkIdType line, bool closed)
{
  const int count = static_cast<int>(this->Points.size()) - first;
  if (count < 2)
  {
    const auto kept = static_cast<std::size_t>(first);
    this->Points.resize(kept);
    this->Shapes.resize(kept);
    this->Sources.resize(kept);
    this->Ids.resize(kept);
    this->RadialCurvature.resize(arrays.RadialCurvature ? kept : 0);
    this->Ratios.resize(arrays.Hatching ? kept : 0);
    return;
  }
  Stroke stroke{ first, first + count - 1, cell, 0.0f, 0.0f, 0.0f, closed && count > 3 };
  stroke.ArcBegin = this->Points[static_cast<std::size_t>(first)].ArcLength;
  stroke.ArcLength = this->Points.back().ArcLength - stroke.ArcBegin;
  stroke.Priority = arrays.FindPriority(cell, line, this->Sources[static_cast<std::size_t>(first)]);
  if (arrays.Hatching)
  {
    const double spacing = arrays.Spacings->GetComponent(cell, 0) / this->Frame.Unit;
    stroke.Spacing = spacing > 0.0 && std::isfinite(spacing) ? static_cast<float>(spacing) : 0.0f;
    stroke.Family = arrays.Families && arrays.Families->GetComponent(cell, 0) > 0.0 ? 1 : 0;
  }
  this->Strokes.push_back(stroke);
}

void InkStrokePoints::Read(const InkStrokeArrays& arrays)
{
  *this = {};
  double bounds[6];
  InkShiftScale::FindFiniteBounds(arrays.Data->GetPoints(), bounds);
  this->Frame = InkShiftScale::FromBounds(bounds);
  this->LocalBounds = { INFINITY, -INFINITY, INFINITY, -INFINITY, INFINITY, -INFINITY };
  vtkCellArray* lines = arrays.Data->GetLines();
  std::vector<vtkIdType> order(static_cast<std::size_t>(lines->GetNumberOfCells()));
  std::iota(order.begin(), order.end(), 0);
  if (arrays.Hatching)
  {
    std::vector<float> priorities(order.size());
    for (const vtkIdType line : order)
    {
      vtkIdType size;
      const vtkIdType* ids;
      lines->GetCellAtId(line, size, ids);
      priorities[static_cast<std::size_t>(line)] =
        arrays.FindPriority(arrays.Data->GetNumberOfVerts() + line, line, size > 0 ? ids[0] : 0);
    }
    std::stable_sort(order.begin(), order.end(),
      [&](vtkIdType a, vtkIdType b)
      { return priorities[static_cast<std::size_t>(a)] < priorities[static_cast<std::size_t>(b)]; });
  }
  for (const vtkIdType line : order)
  {
    this->ReadLine(arrays, line);
  }
}

void InkStrokePoints::ReadLine(const InkStrokeArrays& arrays, vtkIdType line)
{
  vtkIdType size;
  const vtkIdType* ids;
  arrays.Data->GetLines()->GetCellAtId(line, size, ids);
  const vtkIdType cell = arrays.Data->GetNumberOfVerts() + line;
  int first = static_cast<int>(this->Points.size());
  bool closed = size > 3 && ids[0] == ids[size - 1];
  double arcLength = 0.0; // found here
  double own = 0.0;       // from the array
  double before[3] = { 0.0, 0.0, 0.0 };
  for (vtkIdType i = 0; i < size; ++i)
  {
    double p[3];
    float local[3];
    arrays.Data->GetPoint(ids[i], p);
    this->Frame.ToLocal(p, local);
    if (!std::isfinite(local[0]) || !std::isfinite(local[1]) || !std::isfinite(local[2]))
    {
      closed = false;
      this->EndStroke(arrays, first, cell, line, false);
      first = static_cast<int>(this->Points.size());
      continue;
    }
    const bool starts = first == static_cast<int>(this->Points.size());
    if (!starts && std::equal(local, local + 3, this->Points.back().Position))
    {
      continue;
    }
    const double step =
      starts ? 0.0 : std::hypot(p[0] - before[0], p[1] - before[1], p[2] - before[2]) / this->Frame.Unit;
    arcLength += step;
    // The last point of a closed stroke is its first, with the arc length there.
    const double given = arrays.ArcLengths ? arrays.ArcLengths->GetComponent(ids[i], 0) / this->Frame.Unit
                                           : std::numeric_limits<double>::quiet_NaN();
    own = (closed && i == size - 1) || !std::isfinite(given) ? own + step : given;
    this->AddPoint(arrays, ids[i], local, arrays.ArcLengths ? own : arcLength);
    std::copy_n(p, 3, before);
  }
  this->EndStroke(arrays, first, cell, line, closed);
}

int InkStrokePoints::CountPoints(float priority) const
{
  const auto end = std::upper_bound(this->Strokes.begin(), this->Strokes.end(), priority,
    [](float value, const Stroke& stroke) { return value < stroke.Priority; });
  return end == this->Strokes.begin() ? 0 : std::prev(end)->Last + 1;
}

std::vector<std::uint32_t> InkStrokePoints::OrderColors(vtkUnsignedCharArray* colors, bool ofCells) const
{
  std::vector<std::uint32_t> ordered(this->Points.size());
  for (const Stroke& stroke : this->Strokes)
  {
    for (int point = stroke.First; point <= stroke.Last; ++point)
    {
      const auto index = static_cast<std::size_t>(point);
      const vtkIdType from = ofCells ? stroke.Cell : this->Sources[index];
      std::memcpy(&ordered[index], colors->GetPointer(4 * from), 4);
    }
  }
  return ordered;
}
