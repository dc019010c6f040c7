// SPDX-License-Identifier: BSD-3-Clause
#include "InfoCommand.h"

#include "Core/FormatNumber.h"
#include "Errors.h"
#include "MakeMarks.h"
#include "Progress.h"
#include "VtkMessages.h"

#include "InkImageSlabs.h"
#include "InkVolumeValues.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

// clang-format off
#include "vtk_nlohmannjson.h"
#include VTK_NLOHMANN_JSON(json.hpp)
// clang-format on

#include <algorithm>
#include <array>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ink::cli
{
namespace
{

/// What there is to say of a file, as lines of text and as JSON.
class Description
{
public:
  /// @param name as people read it; underscores take the place of its spaces in JSON. An empty one continues
  /// the line before, in the same entry of JSON
  void add(const std::string& name, const std::string& line, nlohmann::ordered_json value)
  {
    this->Lines.emplace_back(name, line);
    if (!name.empty())
    {
      std::string key = name;
      std::replace(key.begin(), key.end(), ' ', '_');
      this->Values[key] = std::move(value);
    }
  }
  void add(const std::string& name, const std::string& line) { this->add(name, line, line); }

  void print(std::ostream& stream) const
  {
    constexpr int width = 15;
    for (const auto& [name, line] : this->Lines)
    {
      stream << std::left << std::setw(width) << name << line << '\n';
    }
  }
  const nlohmann::ordered_json& json() const { return this->Values; }

private:
  std::vector<std::pair<std::string, std::string>> Lines;
  nlohmann::ordered_json Values = nlohmann::ordered_json::object();
};

/// What is not finite becomes null, as JSON has no number for it.
nlohmann::ordered_json listOf(const double* numbers, int count)
{
  return std::vector<double>(numbers, numbers + count);
}

std::string boundsText(const double b[6])
{
  return formatNumber(b[0]) + " to " + formatNumber(b[1]) + ", " + formatNumber(b[2]) + " to " +
    formatNumber(b[3]) + ", " + formatNumber(b[4]) + " to " + formatNumber(b[5]);
}

/// What only all values together tell.
struct Statistics
{
  FiniteRange values;
  std::vector<IsoSuggestion> suggestions;
};

Statistics examine(InkImageSlabs& slabs, Progress& progress)
{
  progress.step("looking at the values");
  const FiniteRange values = InkFindFiniteRange(slabs);
  return { values, InkSuggestIsoValues(slabs, [&](double done) { return progress.at(done), true; }) };
}

/// The least and the greatest finite value of all components; nothing if there is none.
std::optional<std::array<double, 2>> rangeOf(vtkDataArray* array)
{
  std::array<double, 2> all{ std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };
  for (int component = 0; component < array->GetNumberOfComponents(); ++component)
  {
    double range[2];
    array->GetFiniteRange(range, component);
    all = { std::min(all[0], range[0]), std::max(all[1], range[1]) };
  }
  return all[0] <= all[1] ? std::optional(all) : std::nullopt;
}

/// @param name "point arrays" or "cell arrays"
/// @param rangeOfArray see rangeOf
template <class Range>
void describeArrays(Description& description, const std::string& name, vtkDataSetAttributes* attributes,
  const Range& rangeOfArray)
{
  auto arrays = nlohmann::ordered_json::array();
  std::vector<std::string> lines;
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = attributes->GetAbstractArray(i);
    const std::string called = array->GetName() ? array->GetName() : "(no name)";
    const std::string type = array->GetDataTypeAsString();
    const int components = array->GetNumberOfComponents();
    auto* numeric = vtkDataArray::SafeDownCast(array);
    const std::optional<std::array<double, 2>> range = numeric ? rangeOfArray(numeric) : std::nullopt;
    arrays.push_back({ { "name", called }, { "type", type }, { "components", components },
      { "range", range ? nlohmann::ordered_json(*range) : nlohmann::ordered_json() } });
    lines.push_back(called + ": " + type + ", " + std::to_string(components) +
      (components == 1 ? " component" : " components") +
      (range ? ", " + formatNumber((*range)[0]) + " to " + formatNumber((*range)[1]) : ""));
  }
  for (const std::string& line : lines)
  {
    description.add(&line == &lines.front() ? name : "", line, arrays);
  }
}

void describeVolume(
  Description& description, const InkImageSlabs& slabs, const Input& input, const Statistics& statistics)
{
  const auto& [values, suggestions] = statistics;
  vtkImageData* image = slabs.GetFrame();
  const int* dimensions = image->GetDimensions();
  description.add("dimensions", formatDimensions(dimensions), std::vector<int>(dimensions, dimensions + 3));
  description.add("spacing", formatTriple(image->GetSpacing()), listOf(image->GetSpacing(), 3));
  description.add("origin", formatTriple(image->GetOrigin()), listOf(image->GetOrigin(), 3));
  const double* b = image->GetBounds();
  description.add("bounds", boundsText(b), listOf(b, 6));
  vtkMatrix3x3* direction = image->GetDirectionMatrix();
  if (!direction->IsIdentity())
  {
    const double* d = direction->GetData();
    description.add(
      "direction", formatTriple(d) + ", " + formatTriple(d + 3) + ", " + formatTriple(d + 6), listOf(d, 9));
  }
  const std::string type = vtkImageScalarTypeNameMacro(slabs.GetScalarType());
  description.add("type",
    type + " (" + std::to_string(8 * vtkDataArray::GetDataTypeSize(slabs.GetScalarType())) + " bits)", type);
  description.add("components", std::to_string(input.components), input.components);
  if (values.least > values.greatest)
  {
    description.add("range", "none", nullptr);
  }
  else
  {
    description.add("range", formatNumber(values.least) + " to " + formatNumber(values.greatest),
      { values.least, values.greatest });
  }
  if (values.notFinite > 0)
  {
    description.add("not finite", std::to_string(values.notFinite) + " voxels", values.notFinite);
  }
  // Those of cells are those of voxels by now. Files that are read in parts have one array.
  const auto ofAll = values.least <= values.greatest
    ? std::optional(std::array{ values.least, values.greatest })
    : std::nullopt;
  auto* held = vtkImageData::SafeDownCast(input.image->GetOutputDataObject(0));
  describeArrays(description, "point arrays", held->GetPointData(),
    [&](vtkDataArray* array) { return input.data ? rangeOf(array) : ofAll; });
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  std::vector<std::string> lines;
  const auto add = [&](double value, const std::string& shows, const nlohmann::ordered_json& keptShare)
  {
    list.push_back({ { "value", value }, { "shows", shows }, { "kept_share", keptShare } });
    lines.push_back(formatNumber(value) + " (" + shows + ")");
  };
  if (input.surfaceValue)
  {
    add(*input.surfaceValue, "that of the file's surface", nullptr);
  }
  else
  {
    if (!suggestions.empty() && suggestions.front().labels > 0)
    {
      const std::int64_t labels = suggestions.front().labels;
      description.add("labels", std::to_string(labels), labels);
    }
    for (const IsoSuggestion& suggestion : suggestions)
    {
      add(suggestion.value, InkDescribe(suggestion), suggestion.keptShare);
    }
  }
  if (lines.empty())
  {
    lines.emplace_back("none: the volume has no two values");
  }
  for (const std::string& line : lines)
  {
    description.add(&line == &lines.front() ? "suggested iso" : "", line, list);
  }
}

void describeMesh(Description& description, vtkPolyData* mesh)
{
  description.add("points", std::to_string(mesh->GetNumberOfPoints()), mesh->GetNumberOfPoints());
  description.add("cells", std::to_string(mesh->GetNumberOfCells()), mesh->GetNumberOfCells());
  const double* b = mesh->GetBounds();
  description.add("bounds", boundsText(b), listOf(b, 6));
  describeArrays(description, "point arrays", mesh->GetPointData(), rangeOf);
  describeArrays(description, "cell arrays", mesh->GetCellData(), rangeOf);
}

Description describe(const InputOptions& options, Progress& progress)
{
  const Input input = readInput(options, progress);
  Description description;
  description.add("file", options.file.string());
  description.add("format", input.format);
  if (input.image)
  {
    const VtkMessages messages;
    try
    {
      InkImageSlabs slabs(input.image->GetOutputPort(), options.memory);
      const Statistics statistics = examine(slabs, progress);
      describeVolume(description, slabs, input, statistics);
    }
    catch (const std::runtime_error& error)
    {
      throw Failure(inTermsOfInk(messages.error().empty() ? error.what() : messages.error()));
    }
  }
  else
  {
    describeMesh(description, vtkPolyData::SafeDownCast(input.data));
  }
  progress.finish();
  for (const std::string& note : input.notes)
  {
    description.add("note", note, input.notes);
  }
  return description;
}

} // namespace

void info(const InfoOptions& options)
{
  auto all = nlohmann::ordered_json::array();
  std::vector<std::string> problems;
  bool isUsage = false;
  bool isFirst = true;
  for (const std::filesystem::path& file : options.files)
  {
    InputOptions one = options.input;
    one.file = file;
    try
    {
      Progress progress(options.quiet);
      const Description description = describe(one, progress);
      if (options.json)
      {
        all.push_back(description.json());
        continue;
      }
      std::cout << (std::exchange(isFirst, false) ? "" : "\n");
      description.print(std::cout);
    }
    catch (const std::runtime_error& error)
    {
      // The others are described all the same.
      isUsage = isUsage || dynamic_cast<const UsageError*>(&error);
      const std::string problem = error.what();
      const bool isNamed = options.files.size() == 1 || problem.find(file.string()) != std::string::npos;
      problems.push_back(isNamed ? problem : "'" + file.string() + "': " + problem);
    }
  }
  if (!all.empty())
  {
    // Names of files may be no UTF-8.
    std::cout << all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
  }
  if (!problems.empty())
  {
    const std::string last = problems.back();
    problems.pop_back();
    std::for_each(problems.begin(), problems.end(), reportError);
    if (isUsage)
    {
      throw UsageError(last);
    }
    throw Failure(last);
  }
}

} // namespace ink::cli
