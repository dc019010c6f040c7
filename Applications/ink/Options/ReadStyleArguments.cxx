// SPDX-License-Identifier: BSD-3-Clause
// What the options of a style come to.
#include "Errors.h"
#include "StyleArguments.h"

#include "Core/DidYouMean.h"

// clang-format off
#include "vtk_nlohmannjson.h"
#include VTK_NLOHMANN_JSON(json.hpp)
// clang-format on

#include <CLI/CLI.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace ink::cli
{
namespace
{

const char* nameOf(InkParameterData data)
{
  return data == InkParameterData::Image ? "a volume"
    : data == InkParameterData::Mesh     ? "a mesh"
                                         : "points without polygons";
}

} // namespace

std::string StyleArguments::contentsOf(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
}

std::string StyleArguments::dashed(const std::string& option)
{
  return "--" + option;
}

void StyleArguments::readFile()
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(this->file, error) || !std::ifstream(this->file).is_open())
  {
    throw Failure("cannot read '" + this->file + "': expected a file as 'ink style NAME' prints it");
  }
  const std::string contents = contentsOf(this->file);
  if (const std::string problem = this->style->SetParametersFromJSON(contents); !problem.empty())
  {
    throw Failure("cannot read '" + this->file + "': " + problem);
  }
  const auto json = nlohmann::json::parse(contents);
  for (const auto& [name, value] : json.at("parameters").items())
  {
    this->inFile.insert(this->table().Find(name));
  }
}

void StyleArguments::keepFile()
{
  std::set<const InkParameter*> changed;
  for (const InkParameter& parameter : this->table().Parameters)
  {
    if (parameter.Follows && this->values.contains(this->table().Find(parameter.Follows)))
    {
      changed.insert(&parameter);
    }
    for (const InkParameter::Setting& setting :
      this->values.contains(&parameter) ? parameter.Implies : decltype(parameter.Implies)())
    {
      const InkParameter* implied = this->table().Find(setting.Name);
      if (implied->Type != InkParameterType::Bool && implied->Type != InkParameterType::Enum)
      {
        changed.insert(implied);
      }
    }
  }
  for (const InkParameter* parameter : changed)
  {
    const InkParameterValue value = parameter->Get(this->style);
    if (this->inFile.contains(parameter) && parameter->Format(value) != parameter->Default)
    {
      this->values.try_emplace(parameter, value);
    }
  }
}

void StyleArguments::set(const InkParameter& parameter, const std::string& option, const std::string& text,
  const std::string& otherwise)
{
  InkParameterValue value;
  if (const std::string problem = parameter.Parse(text, this->style, value); !problem.empty())
  {
    std::vector<std::string> entries;
    for (const InkParameter::Entry& entry : parameter.Entries)
    {
      entries.emplace_back(entry.Name);
    }
    throw UsageError(option + " '" + text +
      "': " + (parameter.CheckText ? problem : "expected " + parameter.Expected(this->style)) + otherwise +
      didYouMean(text, entries) +
      (option == "--paper-color" && text == "none" ? "; --transparent leaves the page out" : ""));
  }
  this->values[&parameter] = value;
  this->givenBy[&parameter] = option;
}

void StyleArguments::readShorthand(const Option& option, const std::string& text)
{
  const InkShorthand& shorthand = *option.shorthand;
  const std::string& name = option.name;
  std::string words;
  for (const InkShorthand::Word& word : shorthand.Words)
  {
    if (text == word.Word)
    {
      for (const InkParameter::Setting& setting : word.Settings)
      {
        this->set(*this->table().Find(setting.Name), name, setting.Text);
      }
      return;
    }
    words += (words.empty() ? "" : &word == &shorthand.Words.back() ? " or " : ", ") + std::string(word.Word);
  }
  if (option.parameter)
  {
    this->set(*option.parameter, name, text, ", or " + words);
    return;
  }
  std::vector<std::string> parts;
  for (const std::string& part : CLI::detail::split(text, ','))
  {
    parts.push_back(part);
  }
  const std::size_t count = shorthand.Numbers.size();
  if (count == 0 || parts.size() != count)
  {
    std::string names;
    for (const char* one : shorthand.Names)
    {
      names += (names.empty() ? "" : ",") + std::string(one);
    }
    const std::string numbers = std::to_string(count) + (count == 1 ? " number" : " numbers");
    throw UsageError(name + " '" + text + "': expected " + (count > 0 ? names + " (" + numbers + "), " : "") +
      words + (count > 0 ? "; found " + std::to_string(parts.size()) : ""));
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    this->set(
      *this->table().Find(shorthand.Numbers[i]), name + " '" + text + "': " + shorthand.Names[i], parts[i]);
  }
}

void StyleArguments::read(const Option& option)
{
  const std::string& name = option.name;
  if (option.parameter && option.parameter->Type == InkParameterType::Bool)
  {
    this->set(*option.parameter, name, option.negated ? "off" : "on");
    return;
  }
  std::string text;
  for (const std::string& one : option.texts)
  {
    // A list's numbers can be given one by one.
    text += (&one == &option.texts.front() ? "" : ",") + one;
  }
  if (option.shorthand)
  {
    this->readShorthand(option, text);
  }
  else
  {
    this->set(*option.parameter, name, text);
  }
}

std::string StyleArguments::optionsFor(
  const char* name, const std::string& text, const InkParameter* but) const
{
  const InkParameter* wanted = this->table().Find(name);
  std::string found = wanted->Type == InkParameterType::Bool
    ? dashed((text == "off" ? "no-" : "") + std::string(wanted->Option))
    : dashed(wanted->Option) + (text.empty() ? "" : " " + text);
  for (const InkParameter& parameter : this->table().Parameters)
  {
    for (const InkParameter::Setting& setting : parameter.Implies)
    {
      if (&parameter != but && setting.Name == std::string(name) && (text.empty() || text == setting.Text))
      {
        found += " or " + dashed(parameter.Option);
      }
    }
  }
  return found;
}

void StyleArguments::checkConflicts() const
{
  std::map<std::string, std::pair<const InkParameter*, std::string>> implied;
  for (const auto& [parameter, value] : this->values)
  {
    for (const InkParameter::Setting& setting : parameter->Implies)
    {
      const auto& [first, text] = implied.try_emplace(setting.Name, parameter, setting.Text).first->second;
      if (text != setting.Text && !this->values.contains(this->table().Find(setting.Name)))
      {
        throw UsageError(this->givenBy.at(parameter) + ": expected without " + this->givenBy.at(first));
      }
    }
  }
}

void StyleArguments::checkConditions() const
{
  for (const auto& [parameter, option] : this->givenBy)
  {
    const InkParameter::Setting& condition = parameter->Condition;
    if (condition.Name && this->style->GetParameterAsString(condition.Name) != condition.Text)
    {
      throw UsageError(
        option + ": expected with " + this->optionsFor(condition.Name, condition.Text, parameter));
    }
    const std::string needed = parameter->Needs ? this->style->GetParameterAsString(parameter->Needs) : "on";
    if (needed.empty() || needed == "off")
    {
      throw UsageError(option + ": expected with " + this->optionsFor(parameter->Needs, "", parameter));
    }
  }
}

vtkSmartPointer<vtkInkStyle> StyleArguments::make(double pixelScale)
{
  for (const auto& [name, other] : this->others)
  {
    if (other.first->count() > 0)
    {
      throw UsageError(
        name + ": expected with --style " + other.second + ", found --style " + this->style->GetName());
    }
  }
  this->style->SetPixelScale(pixelScale);
  if (!this->file.empty())
  {
    this->readFile();
  }
  for (const Option& option : this->options)
  {
    if (option.option->count() > 0)
    {
      this->read(option);
    }
  }
  this->checkConflicts();
  this->keepFile();
  vtkInkStyle::Settings settings;
  for (const auto& [parameter, value] : this->values)
  {
    settings.emplace_back(parameter->Name, value);
  }
  if (const std::string problem = this->style->SetParameters(settings); !problem.empty())
  {
    throw UsageError(problem);
  }
  this->checkConditions();
  return this->style;
}

bool StyleArguments::gives(const char* name) const
{
  const InkParameter* parameter = this->table().Find(name);
  return this->inFile.contains(parameter) || this->givenBy.contains(parameter);
}

void StyleArguments::checkData(InkParameterData data) const
{
  for (const auto& [parameter, option] : this->givenBy)
  {
    if (parameter->Data != InkParameterData::Any && parameter->Data != data)
    {
      throw UsageError(option + ": expected " + nameOf(parameter->Data) + ", found " + nameOf(data));
    }
  }
}

} // namespace ink::cli
