// SPDX-License-Identifier: BSD-3-Clause
#include "InkStyleFile.h"

#include "InkParameter.h"

// clang-format off
#include "vtk_nlohmannjson.h"
#include VTK_NLOHMANN_JSON(json.hpp)
// clang-format on

#include <exception>

namespace
{

using Json = nlohmann::ordered_json;
using Type = InkParameterType;

Json WriteValue(const InkParameter& row, const InkParameterValue& value)
{
  switch (row.Type)
  {
    case Type::Bool:
      return value.Numbers.front() != 0.0;
    case Type::Int:
      return static_cast<long long>(value.Numbers.front());
    case Type::Double:
      return value.Numbers.front();
    case Type::Enum:
    case Type::String:
      return row.Format(value);
    default:
      return value.Numbers;
  }
}

/// @return what is wrong; empty if nothing is
std::string ReadValue(const InkParameter& row, const Json& json, vtkInkStyle* style, InkParameterValue& value)
{
  value = {};
  const std::string wrong = "expected " + row.Expected(style) + ", found " + json.dump();
  const bool isBool = row.Type == Type::Bool;
  if (json.is_string() && !isBool)
  {
    return row.Parse(json.get<std::string>(), style, value);
  }
  if (json.is_boolean() && isBool)
  {
    value.Numbers = { json.get<bool>() ? 1.0 : 0.0 };
    return {};
  }
  const bool single = row.GetNumberOfNumbers() == 1;
  // A list may be one number.
  const bool list = row.Type == Type::List && json.is_number();
  const Json numbers = json.is_array() ? json : Json::array({ json });
  if (isBool || row.Type == Type::Enum || row.Type == Type::String || (json.is_array() == single && !list))
  {
    return wrong;
  }
  for (const Json& number : numbers)
  {
    if (!number.is_number())
    {
      return wrong;
    }
    value.Numbers.push_back(number.get<double>());
  }
  return row.Check(value, style).empty() ? std::string() : wrong;
}

/// The style that a file has to name, or, where it names none that there is, all of them.
std::string ExpectedStyle(const Json& found, vtkInkStyle* style)
{
  std::string names;
  for (int i = 0; i < vtkInkStyle::GetNumberOfStyles(); ++i)
  {
    if (found == vtkInkStyle::GetStyleName(i))
    {
      return Json(style->GetName()).dump();
    }
    names += (i > 0 ? ", " : "") + std::string(vtkInkStyle::GetStyleName(i));
  }
  return "one of " + names;
}

} // namespace

std::string InkWriteStyleFile(vtkInkStyle* style)
{
  // A line for each parameter.
  std::string lines;
  for (const InkParameter& row : style->GetParameterTable().Parameters)
  {
    lines += lines.empty() ? "" : ",\n";
    lines += "    " + Json(row.Name).dump() + ": " + WriteValue(row, row.Get(style)).dump();
  }
  return "{\n  \"style\": " + Json(style->GetName()).dump() + ",\n  \"parameters\": {\n" + lines +
    "\n  }\n}\n";
}

std::string InkReadStyleFile(const std::string& json, vtkInkStyle* style, vtkInkStyle::Settings& settings)
{
  Json file;
  try
  {
    file = Json::parse(json);
  }
  catch (const Json::exception& error)
  {
    // "[json.exception.parse_error.101] parse error at line 1, column 2: ..."
    const std::string found = error.what();
    return "expected JSON, found a " + found.substr(found.find("] ") + 2);
  }
  if (!file.is_object() || !file.contains("style") || !file.contains("parameters") ||
    !file["parameters"].is_object())
  {
    return R"(expected {"style": ..., "parameters": {...}}, found )" + file.dump().substr(0, 60);
  }
  if (file["style"] != style->GetName())
  {
    return "style: expected " + ExpectedStyle(file["style"], style) + ", found " + file["style"].dump();
  }
  for (const auto& [key, value] : file.items())
  {
    if (key != "style" && key != "parameters")
    {
      return "'" + key + "': expected style and parameters, and nothing else";
    }
  }
  for (const auto& [name, value] : file["parameters"].items())
  {
    const InkParameter* row = nullptr;
    std::string problem = style->FindParameterRow(name, row);
    settings.emplace_back(name, InkParameterValue());
    if (row)
    {
      problem = ReadValue(*row, value, style, settings.back().second);
      problem = problem.empty() ? problem : name + ": " + problem;
    }
    if (!problem.empty())
    {
      return problem;
    }
  }
  return {};
}

std::string vtkInkStyle::FindStyleInJSON(const std::string& json)
{
  const Json file = Json::parse(json, nullptr, false);
  const bool says = file.is_object() && file.contains("style") && file["style"].is_string();
  return says ? file["style"].get<std::string>() : std::string();
}
