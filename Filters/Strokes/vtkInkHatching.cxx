// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkHatching.h"

#include "Core/Hash.h"
#include "Curves/Strokes/CutStroke.h"
#include "InkOutwardTriangles.h"
#include "InkRegion.h"
#include "InkReportException.h"
#include "InkSpacingRatios.h"
#include "InkVTKCompat.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPlanes.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <numeric>
#include <optional>
#include <span>
#include <sstream>
#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkInkHatching);

namespace
{

using FamilyValues = std::array<double, 2>;

/// The parts of the work that finding the lines' lengths and cutting them are, and after how many lines
/// progress is told.
constexpr double LengthsShare = 0.1;
constexpr double CuttingShare = 0.3;
constexpr vtkIdType ProgressInterval = 64;

/// The lines as the filter needs them.
struct Lines
{
  explicit Lines(vtkPolyData* data)
    : Data(data)
  {
  }

  vtkIdType GetNumber() const { return this->Data->GetNumberOfLines(); }
  vtkIdType GetCell(vtkIdType line) const { return this->Data->GetNumberOfVerts() + line; }

  std::span<const vtkIdType> GetPoints(vtkIdType line) const
  {
    vtkIdType size;
    const vtkIdType* ids;
    this->Data->GetLines()->GetCellAtId(line, size, ids);
    return { ids, static_cast<std::size_t>(size) };
  }

  /// From the line's begin, world units; what is not finite adds nothing.
  std::vector<double> FindArcLengths(vtkIdType line) const
  {
    std::vector<double> lengths;
    double before[3] = { 0.0, 0.0, 0.0 };
    for (const vtkIdType id : this->GetPoints(line))
    {
      double p[3];
      this->Data->GetPoint(id, p);
      const double step =
        lengths.empty() ? 0.0 : std::hypot(p[0] - before[0], p[1] - before[1], p[2] - before[2]);
      lengths.push_back((lengths.empty() ? 0.0 : lengths.back()) + (std::isfinite(step) ? step : 0.0));
      std::copy_n(p, 3, before);
    }
    return lengths;
  }

  vtkPolyData* Data;
};

/// The points of a part of a line that are enough for tones and bends: its ends, and others that are two
/// spacings apart, or half a spacing where it turns.
std::vector<vtkIdType> ThinOut(
  vtkPolyData* data, std::span<const vtkIdType> points, std::span<const double> arcLengths, double spacing)
{
  constexpr double straight = 0.995; // cosine of the turn
  const auto position = [&](std::size_t i)
  {
    double p[3];
    data->GetPoint(points[i], p);
    return glm::dvec3(p[0], p[1], p[2]);
  };
  std::vector<vtkIdType> kept{ points.front() };
  std::size_t last = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
  {
    const double way = arcLengths[i] - arcLengths[last];
    const glm::dvec3 before = position(i) - position(last);
    const glm::dvec3 after = position(i + 1) - position(i);
    const bool turns = !(glm::dot(before, after) >= straight * glm::length(before) * glm::length(after));
    if (way >= 2.0 * spacing || (way >= 0.5 * spacing && turns))
    {
      kept.push_back(points[i]);
      last = i;
    }
  }
  kept.push_back(points.back());
  return kept;
}

vtkDataArray* FindCellArray(vtkPolyData* data, const char* name)
{
  vtkDataArray* array = data->GetCellData()->GetArray(name);
  if (array &&
    (array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != data->GetNumberOfCells()))
  {
    std::ostringstream message;
    message << "expected " << data->GetNumberOfCells() << " values with 1 component in the cell array \""
            << name << "\", found " << array->GetNumberOfTuples() << " with "
            << array->GetNumberOfComponents();
    throw std::invalid_argument(message.str());
  }
  return array;
}

/// Priorities of lines in a random order: the share of their family's length that comes before each.
std::vector<double> ShufflePriorities(
  const std::vector<double>& lengths, const std::vector<int>& families, const FamilyValues& wholes, int seed)
{
  const auto key = [seed](std::size_t line)
  { return ink::hash(static_cast<std::uint64_t>(seed), static_cast<std::uint64_t>(line)); };
  std::vector<std::size_t> order(lengths.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return std::pair(key(a), a) < std::pair(key(b), b); });
  std::vector<double> priorities(lengths.size());
  FamilyValues before{};
  for (const std::size_t line : order)
  {
    const auto family = static_cast<std::size_t>(families[line]);
    priorities[line] = wholes[family] > 0.0 ? before[family] / wholes[family] : 0.0;
    before[family] += lengths[line];
  }
  return priorities;
}

/// What all lines have to be known for before the first is cut.
struct LineMeasures
{
  std::vector<double> Lengths;
  std::vector<int> Families; ///< 0 or 1
  FamilyValues Wholes{};     ///< the lengths of all lines of a family
};

/// @param families of the cells; null: all lines are of the first
/// @param progress is told before each line; whether to go on
/// @return nothing when stopped
std::optional<LineMeasures> Measure(
  const Lines& lines, vtkDataArray* families, const std::function<bool(vtkIdType)>& progress)
{
  LineMeasures measures;
  for (vtkIdType line = 0; line < lines.GetNumber(); ++line)
  {
    if (!progress(line))
    {
      return std::nullopt;
    }
    const std::vector<double> arcLengths = lines.FindArcLengths(line);
    measures.Lengths.push_back(arcLengths.empty() ? 0.0 : arcLengths.back());
    measures.Families.push_back(families && families->GetComponent(lines.GetCell(line), 0) > 0.0 ? 1 : 0);
    measures.Wholes[static_cast<std::size_t>(measures.Families.back())] += measures.Lengths.back();
  }
  return measures;
}

/// Strokes, with the cell arrays of the lines that they are parts of and with their own.
class StrokeList
{
public:
  /// @param data with the lines
  StrokeList(vtkPolyData* data, vtkPolyData* output)
    : Data(data)
    , Output(output)
  {
    this->Priorities->SetName("Priority");
    this->Spacings->SetName("Spacing");
    this->Families->SetName("LineFamily");
    for (const char* name : { "Priority", "Spacing", "LineFamily" })
    {
      output->GetCellData()->CopyFieldOff(name);
    }
    output->GetCellData()->CopyAllocate(data->GetCellData(), data->GetNumberOfLines());
  }

  /// @param cell of the line
  void Add(std::span<const vtkIdType> points, vtkIdType cell, double priority, double spacing, int family)
  {
    const vtkIdType stroke = this->Strokes->GetNumberOfCells();
    this->Strokes->InsertNextCell(static_cast<vtkIdType>(points.size()), points.data());
    this->Output->GetCellData()->CopyData(this->Data->GetCellData(), cell, stroke);
    this->Priorities->InsertNextValue(static_cast<float>(priority));
    this->Spacings->InsertNextValue(static_cast<float>(spacing));
    this->Families->InsertNextValue(static_cast<unsigned char>(family));
  }

  void Fill()
  {
    vtkCellData* cellData = this->Output->GetCellData();
    cellData->AddArray(this->Priorities);
    cellData->AddArray(this->Spacings);
    cellData->AddArray(this->Families);
    this->Output->SetPoints(this->Data->GetPoints());
    this->Output->GetPointData()->PassData(this->Data->GetPointData());
    this->Output->GetPointData()->RemoveArray("SpacingRatio"); // of other strokes
    this->Output->SetLines(this->Strokes);
  }

private:
  vtkPolyData* Data;
  vtkPolyData* Output;
  vtkNew<vtkCellArray> Strokes;
  vtkNew<vtkFloatArray> Priorities;
  vtkNew<vtkFloatArray> Spacings;
  vtkNew<vtkUnsignedCharArray> Families;
};

} // namespace

vtkInkHatching::vtkInkHatching()
{
  this->SetNumberOfInputPorts(2);
}

int vtkInkHatching::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

vtkInkHatching::~vtkInkHatching() = default;

void vtkInkHatching::SetRegion(vtkPlanes* region)
{
  if (this->Region != region)
  {
    this->Region = region;
    this->Modified();
  }
}

vtkPlanes* vtkInkHatching::GetRegion()
{
  return this->Region;
}

vtkMTimeType vtkInkHatching::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Region ? std::max(own, this->Region->GetMTime()) : own;
}

int vtkInkHatching::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  try
  {
    this->MakeStrokes(vtkPolyData::GetData(inputVector[0]), vtkPolyData::GetData(inputVector[1]), output);
  }
  catch (...)
  {
    InkReportException(this, output, "Lines cannot be made into hatching");
  }
  return 1;
}

void vtkInkHatching::MakeStrokes(vtkPolyData* data, vtkPolyData* surface, vtkPolyData* output)
{
  const Lines lines(data);
  if (lines.GetNumber() == 0)
  {
    return;
  }
  vtkDataArray* givenFamilies = FindCellArray(data, "LineFamily");
  vtkDataArray* givenPriorities = FindCellArray(data, "Priority");
  std::optional<InkMeshTriangles> triangles;
  double area = 0.0;
  if (surface && this->Spacing == 0.0)
  {
    constexpr auto order = InkMeshTriangles::Order::OfMesh;
    triangles.emplace(
      this->LocalSpacing ? InkOutwardTriangles(surface, order) : InkMeshTriangles(surface, false, order));
    if (this->Region)
    {
      std::vector<ink::Triangle> part;
      for (const std::uint32_t t : ink::trianglesWithin(triangles->GetMesh(), InkRegion(this->Region)))
      {
        part.push_back(triangles->Triangles[t]);
      }
      triangles->Triangles = std::move(part);
    }
    area = ink::cumulateArea(triangles->GetMesh()).area.back();
  }
  if (!(this->Spacing > 0.0 || area > 0.0))
  {
    throw std::invalid_argument("expected a surface with an area on the second input, or a Spacing; found " +
      std::string(surface ? "a surface without area" : "neither"));
  }

  // Told before a line; whether to go on.
  const auto progress = [&](vtkIdType line, double begun, double share)
  {
    if (line % ProgressInterval == 0)
    {
      this->UpdateProgress(
        begun + share * static_cast<double>(line) / static_cast<double>(lines.GetNumber()));
    }
    return !InkCheckAbort(this);
  };
  const std::optional<LineMeasures> measures =
    Measure(lines, givenFamilies, [&](vtkIdType line) { return progress(line, 0.0, LengthsShare); });
  if (!measures)
  {
    return;
  }
  const auto& [lengths, families, wholes] = *measures;
  const std::vector<double> priorities =
    givenPriorities ? std::vector<double>() : ShufflePriorities(lengths, families, wholes, this->Seed);

  StrokeList strokes(data, output);
  for (vtkIdType line = 0; line < lines.GetNumber(); ++line)
  {
    if (!progress(line, LengthsShare, CuttingShare))
    {
      output->Initialize();
      return;
    }
    const auto index = static_cast<std::size_t>(line);
    const double whole = wholes[static_cast<std::size_t>(families[index])];
    const double spacing = this->Spacing > 0.0 ? this->Spacing : whole > 0.0 ? area / whole : 0.0;
    const double priority =
      givenPriorities ? givenPriorities->GetComponent(lines.GetCell(line), 0) : priorities[index];
    const std::vector<double> arcLengths = lines.FindArcLengths(line);
    const std::vector<std::size_t> cuts = ink::cutStroke(arcLengths, this->StrokeLength,
      ink::hash(static_cast<std::uint64_t>(this->Seed), static_cast<std::uint64_t>(line)));
    const std::span<const vtkIdType> points = lines.GetPoints(line);
    for (std::size_t cut = 1; cut < cuts.size(); ++cut)
    {
      const std::size_t first = cuts[cut - 1];
      const std::size_t count = cuts[cut] - first + 1;
      strokes.Add(
        ThinOut(data, points.subspan(first, count), std::span(arcLengths).subspan(first, count), spacing),
        lines.GetCell(line), priority, spacing, families[index]);
    }
  }
  strokes.Fill();
  if (this->LocalSpacing && triangles)
  {
    this->AddSpacingRatios(*triangles, output);
  }
}

void vtkInkHatching::AddSpacingRatios(const InkMeshTriangles& triangles, vtkPolyData* output)
{
  constexpr double begun = LengthsShare + CuttingShare;
  const vtkSmartPointer<vtkFloatArray> ratios = InkSpacingRatios(output, triangles,
    [&](double done)
    {
      this->UpdateProgress(begun + (1.0 - begun) * done);
      return !InkCheckAbort(this);
    });
  output->GetPointData()->AddArray(ratios);
  if (InkCheckAbort(this))
  {
    output->Initialize();
  }
}

void vtkInkHatching::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Region: " << this->Region << "\n"
     << indent << "Spacing: " << this->Spacing << "\n"
     << indent << "LocalSpacing: " << this->LocalSpacing << "\n"
     << indent << "StrokeLength: " << this->StrokeLength << "\n"
     << indent << "Seed: " << this->Seed << "\n";
}
