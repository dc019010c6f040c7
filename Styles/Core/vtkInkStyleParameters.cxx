// SPDX-License-Identifier: BSD-3-Clause
// A style's parameters by name.
#include "InkParameter.h"
#include "InkStyleFile.h"
#include "vtkInkStyle.h"

#include "Core/DidYouMean.h"

#include <map>
#include <string>
#include <vector>

namespace
{

/// The name that is like a mistyped one, or where none is, all.
std::string SuggestNames(const InkParameterTable& table, const std::string& found)
{
  std::vector<std::string> names;
  std::string list;
  for (const InkParameter& parameter : table.Parameters)
  {
    names.emplace_back(parameter.Name);
    list += (list.empty() ? "" : ", ") + names.back();
  }
  const std::string meant = ink::didYouMean(found, names);
  return meant.empty() ? "; expected one of " + list : meant;
}

/// Of an entry or of nothing.
const char* Or(const char* text, const char* otherwise)
{
  return text ? text : otherwise;
}

} // namespace

const InkParameter* vtkInkStyle::FindParameter(int parameter)
{
  const auto rows = this->GetParameterTable().Parameters;
  return parameter >= 0 && parameter < static_cast<int>(rows.size())
    ? &rows[static_cast<std::size_t>(parameter)]
    : nullptr;
}

int vtkInkStyle::GetNumberOfParameters()
{
  return static_cast<int>(this->GetParameterTable().Parameters.size());
}

const char* vtkInkStyle::GetParameterName(int parameter)
{
  const InkParameter* row = this->FindParameter(parameter);
  return row ? row->Name : nullptr;
}

const char* vtkInkStyle::GetParameterLabel(int parameter)
{
  const InkParameter* row = this->FindParameter(parameter);
  return Or(row ? row->Label : nullptr, "");
}

const char* vtkInkStyle::GetParameterType(int parameter)
{
  const InkParameter* row = this->FindParameter(parameter);
  return Or(row ? row->GetTypeAsString() : nullptr, "");
}

void vtkInkStyle::GetParameterRange(int parameter, double range[2])
{
  const InkParameter* row = this->FindParameter(parameter);
  range[0] = row ? row->GetLeast(this) : 0.0;
  range[1] = row ? row->GetGreatest(this) : 0.0;
}

const char* vtkInkStyle::GetParameterDefault(int parameter)
{
  const InkParameter* row = this->FindParameter(parameter);
  return Or(row ? row->Default : nullptr, "");
}

const char* vtkInkStyle::GetParameterUnit(int parameter)
{
  const InkParameter* row = this->FindParameter(parameter);
  return Or(row ? row->Unit : nullptr, "");
}

const char* vtkInkStyle::GetParameterGroup(int parameter)
{
  const InkParameter* row = this->FindParameter(parameter);
  return Or(row ? row->Group : nullptr, "");
}

const char* vtkInkStyle::GetParameterText(int parameter)
{
  const InkParameter* row = this->FindParameter(parameter);
  return Or(row ? row->Text : nullptr, "");
}

bool vtkInkStyle::IsParameterEssential(int parameter)
{
  const InkParameter* row = this->FindParameter(parameter);
  return row && row->Essential;
}

int vtkInkStyle::GetNumberOfParameterEntries(int parameter)
{
  const InkParameter* row = this->FindParameter(parameter);
  return row ? static_cast<int>(row->Entries.size()) : 0;
}

const char* vtkInkStyle::GetParameterEntry(int parameter, int entry)
{
  return entry >= 0 && entry < this->GetNumberOfParameterEntries(parameter)
    ? this->FindParameter(parameter)->Entries[static_cast<std::size_t>(entry)].Name
    : nullptr;
}

std::string vtkInkStyle::FindParameterRow(const std::string& name, const InkParameter*& row)
{
  row = this->GetParameterTable().Find(name);
  return row ? std::string()
             : "'" + name + "': " + this->GetName() + " has no such parameter" +
      SuggestNames(this->GetParameterTable(), name);
}

std::string vtkInkStyle::SetOne(const std::string& name, const InkParameterValue& value)
{
  const InkParameter* row = nullptr;
  std::string problem = this->FindParameterRow(name, row);
  if (row)
  {
    problem = row->Check(value, this);
    problem = problem.empty() ? problem : name + ": " + problem;
  }
  if (problem.empty())
  {
    row->Set(this, value);
  }
  return problem;
}

bool vtkInkStyle::SetParameter(const char* name, double value)
{
  return this->ReportProblem(this->SetOne(name ? name : "", { { value }, {} }));
}

bool vtkInkStyle::SetParameter(const char* name, double first, double second)
{
  return this->ReportProblem(this->SetOne(name ? name : "", { { first, second }, {} }));
}

bool vtkInkStyle::SetParameter(const char* name, double first, double second, double third)
{
  return this->ReportProblem(this->SetOne(name ? name : "", { { first, second, third }, {} }));
}

bool vtkInkStyle::SetParameterAsString(const char* name, const char* text)
{
  const InkParameter* row = nullptr;
  std::string problem = this->FindParameterRow(name ? name : "", row);
  InkParameterValue value;
  if (row)
  {
    problem = row->Parse(text ? text : "", this, value);
    problem = problem.empty() ? this->SetOne(name, value) : name + (": " + problem);
  }
  return this->ReportProblem(problem);
}

std::string vtkInkStyle::GetParameterAsString(const char* name)
{
  const InkParameter* row = nullptr;
  const std::string problem = this->FindParameterRow(name ? name : "", row);
  this->ReportProblem(problem);
  return row ? row->Format(row->Get(this)) : std::string();
}

double vtkInkStyle::GetParameter(const char* name)
{
  const InkParameter* row = nullptr;
  const std::string problem = this->FindParameterRow(name ? name : "", row);
  this->ReportProblem(problem);
  const std::vector<double> numbers = row ? row->Get(this).Numbers : std::vector<double>();
  return numbers.empty() ? 0.0 : numbers.front();
}

void vtkInkStyle::ResetParameters()
{
  for (const InkParameter& row : this->GetParameterTable().Parameters)
  {
    InkParameterValue value;
    row.Parse(row.Default, this, value);
    row.Set(this, value);
  }
}

std::string vtkInkStyle::SetParameters(const Settings& given)
{
  std::map<const InkParameter*, InkParameterValue> values;
  for (const auto& [name, value] : given)
  {
    const InkParameter* row = nullptr;
    std::string problem = this->FindParameterRow(name, row);
    problem = problem.empty() ? row->Check(value, this) : problem;
    if (!problem.empty())
    {
      return row ? name + ": " + problem : problem;
    }
    values[row] = value;
  }
  const InkParameterTable& table = this->GetParameterTable();
  const auto all = values;
  for (const InkParameter& row : table.Parameters)
  {
    if (row.Follows && !all.contains(&row))
    {
      if (const auto followed = all.find(table.Find(row.Follows)); followed != all.end())
      {
        values[&row] = followed->second;
      }
    }
    for (const InkParameter::Setting& setting : all.contains(&row) ? row.Implies : decltype(row.Implies)())
    {
      const InkParameter* implied = table.Find(setting.Name);
      if (!all.contains(implied))
      {
        implied->Parse(setting.Text, this, values[implied]);
      }
    }
  }
  // In the table's order: what sets others comes before them.
  for (const InkParameter& row : table.Parameters)
  {
    if (const auto value = values.find(&row); value != values.end())
    {
      row.Set(this, value->second);
    }
  }
  this->FollowParameters(given);
  return {};
}

int vtkInkStyle::GetNumberOfPresets()
{
  const InkParameter* presets = this->GetParameterTable().Find("Preset");
  return presets ? static_cast<int>(presets->Entries.size()) : 0;
}

const char* vtkInkStyle::GetPresetName(int preset)
{
  return preset >= 0 && preset < this->GetNumberOfPresets()
    ? this->GetParameterTable().Find("Preset")->Entries[static_cast<std::size_t>(preset)].Name
    : nullptr;
}

bool vtkInkStyle::ApplyPreset(const char* name)
{
  return this->SetParameterAsString("Preset", name);
}

std::string vtkInkStyle::GetParametersAsJSON()
{
  return InkWriteStyleFile(this);
}

std::string vtkInkStyle::SetParametersFromJSON(const std::string& json)
{
  Settings settings;
  const std::string problem = InkReadStyleFile(json, this, settings);
  return problem.empty() ? this->SetParameters(settings) : problem;
}
