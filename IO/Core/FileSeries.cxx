// SPDX-License-Identifier: BSD-3-Clause
#include "FileSeries.h"

#include "Core/FormatNumber.h"
#include "ReadError.h"
#include "VtkMessages.h"
#include "Words.h"

#include "vtkSmartPointer.h"
#include "vtkXMLDataElement.h"
#include "vtkXMLUtilities.h"

// clang-format off
#include "vtk_nlohmannjson.h"
#include VTK_NLOHMANN_JSON(json.hpp)
// clang-format on

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <utility>

#include <fnmatch.h>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

struct Step
{
  double time;
  fs::path file;
};

/// What of a name is a number as printf writes it: where it begins and how long it is.
std::optional<std::pair<std::size_t, std::size_t>> findNumber(const std::string& name)
{
  for (std::size_t begin = name.find('%'); begin != std::string::npos; begin = name.find('%', begin + 1))
  {
    std::size_t end = begin + 1;
    while (end < name.size() && std::isdigit(static_cast<unsigned char>(name[end])))
    {
      ++end;
    }
    if (end < name.size() && name[end] == 'd')
    {
      return std::pair(begin, end + 1 - begin);
    }
  }
  return std::nullopt;
}

bool isList(const fs::path& name)
{
  return name.extension() == ".pvd" || name.extension() == ".series";
}

/// Whether a file's name is one of a pattern's. Beside a number, which stands for digits, each character
/// stands for itself; a pattern without one is as in the shell.
bool matches(const std::string& pattern, const std::string& file)
{
  const auto number = findNumber(pattern);
  if (!number)
  {
    return fnmatch(pattern.c_str(), file.c_str(), FNM_PERIOD) == 0;
  }
  const std::string before = pattern.substr(0, number->first);
  const std::string after = pattern.substr(number->first + number->second);
  if (file.size() <= before.size() + after.size() || !file.starts_with(before) || !file.ends_with(after))
  {
    return false;
  }
  const std::string digits = file.substr(before.size(), file.size() - before.size() - after.size());
  return digits.find_first_not_of("0123456789") == std::string::npos;
}

std::vector<fs::path> matching(const fs::path& pattern)
{
  const std::string name = pattern.filename().string();
  const fs::path folder = pattern.has_parent_path() ? pattern.parent_path() : fs::path(".");
  std::vector<std::string> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
  {
    const std::string file = entry.path().filename().string();
    if (matches(name, file) && entry.is_regular_file())
    {
      found.push_back(file);
    }
  }
  std::sort(found.begin(), found.end(), comesBefore);
  std::vector<fs::path> files;
  for (const std::string& file : found)
  {
    files.push_back(pattern.has_parent_path() ? folder / file : fs::path(file));
  }
  return files;
}

std::vector<Step> readPvd(const fs::path& file)
{
  const VtkMessages messages;
  const auto root =
    vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromFile(file.c_str()));
  vtkXMLDataElement* collection = root ? root->FindNestedElementWithName("Collection") : nullptr;
  if (!collection)
  {
    failToRead(file, "it is no XML with an element Collection");
  }
  std::vector<Step> steps;
  for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i)
  {
    vtkXMLDataElement* element = collection->GetNestedElement(i);
    const char* name = element->GetAttribute("file");
    double time = 0.0;
    if (element->GetName() != std::string("DataSet") || !name ||
      !element->GetScalarAttribute("timestep", time))
    {
      failToRead(file, "an element of its Collection is no DataSet with a file and a timestep");
    }
    steps.push_back({ time, name });
  }
  return steps;
}

std::vector<Step> readSeries(const fs::path& file)
{
  std::vector<Step> steps;
  try
  {
    std::ifstream stream(file);
    const auto json = nlohmann::json::parse(stream);
    for (const auto& step : json.at("files"))
    {
      steps.push_back({ step.at("time").get<double>(), step.at("name").get<std::string>() });
    }
  }
  catch (const nlohmann::json::exception&)
  {
    failToRead(file, "it is no JSON with a list \"files\" of objects with a \"name\" and a \"time\"");
  }
  return steps;
}

} // namespace

bool isSeries(const fs::path& name)
{
  std::error_code error;
  const std::string file = name.filename().string();
  return isList(name) ||
    (!fs::exists(name, error) && (file.find_first_of("*?") != std::string::npos || findNumber(file)));
}

std::vector<fs::path> filesOfSeries(const fs::path& name)
{
  if (!isList(name))
  {
    std::vector<fs::path> files = matching(name);
    if (files.empty())
    {
      failToRead(name, "no file has a name of this pattern");
    }
    return files;
  }
  if (!fs::is_regular_file(name))
  {
    failToRead(name, "no such file");
  }
  std::vector<Step> steps = name.extension() == ".pvd" ? readPvd(name) : readSeries(name);
  if (steps.empty())
  {
    failToRead(name, "it names no files");
  }
  std::stable_sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.time < b.time; });
  std::vector<fs::path> files;
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    if (!std::isfinite(steps[i].time) || (i > 0 && steps[i].time == steps[i - 1].time))
    {
      failToRead(name,
        "it names several files, or none, for the time " + formatNumber(steps[i].time) + "; expected one");
    }
    // A path that is absolute replaces the folder.
    files.push_back(name.parent_path() / steps[i].file);
  }
  return files;
}

} // namespace ink::io
