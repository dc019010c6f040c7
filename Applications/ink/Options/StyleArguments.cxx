// SPDX-License-Identifier: BSD-3-Clause
#include "StyleArguments.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>

namespace ink::cli
{
namespace
{

vtkSmartPointer<vtkInkStyle> create(const std::string& name)
{
  return vtk::TakeSmartPointer(vtkInkStyle::CreateStyle(name.c_str()));
}

/// Whether one of a style's presets has this name; the case of letters does not matter.
bool hasPreset(const std::string& styleName, const std::string& preset)
{
  const auto style = create(styleName);
  const InkParameter* parameter = style->GetParameterTable().Find("Preset");
  InkParameterValue value;
  return parameter && parameter->Parse(preset, style, value).empty();
}

/// The style that a preset is of: the first that has it; for one that there is not, the first that has any.
std::string styleOfPreset(const std::string& preset)
{
  std::string any;
  for (const std::string& name : StyleArguments::names())
  {
    if (hasPreset(name, preset))
    {
      return name;
    }
    const bool has = create(name)->GetParameterTable().Find("Preset") != nullptr;
    any = any.empty() && has ? name : any;
  }
  return any;
}

/// A sentence as the help has them: small, and without its dot.
std::string helpOf(const InkParameter& parameter)
{
  std::string text = parameter.Text;
  text.pop_back();
  // Not the first letter of a name.
  const bool name = text.size() > 1 && std::isupper(static_cast<unsigned char>(text[1]));
  text[0] = name ? text[0] : static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
  return text;
}

/// Of a switch's help, which says what is done, or what is the case.
std::string negationOf(const std::string& help)
{
  return (help.starts_with("draw ") ? "do not " : "switch off that ") + help;
}

const char* typeOf(const InkParameter& parameter)
{
  switch (parameter.Type)
  {
    case InkParameterType::Enum:
      return "NAME";
    case InkParameterType::Color:
      return "COLOR";
    case InkParameterType::Colors:
      return "COLOR,...";
    case InkParameterType::Vector:
      return parameter.Size == 2 ? "A,B" : "X,Y,Z";
    case InkParameterType::List:
      return "V";
    case InkParameterType::Int:
      return "N";
    case InkParameterType::String:
      return "TEXT";
    default:
      return "X";
  }
}

/// Options of all styles that take no value.
std::set<std::string> flagsOfAll()
{
  std::set<std::string> flags{ "--", "-h", "--help", "--help-all" };
  for (const std::string& name : StyleArguments::names())
  {
    const auto style = create(name);
    for (const InkParameter& parameter : style->GetParameterTable().Parameters)
    {
      if (parameter.Type == InkParameterType::Bool)
      {
        flags.insert(std::string("--") + parameter.Option);
        flags.insert(std::string("--no-") + parameter.Option);
      }
    }
  }
  return flags;
}

/// What follows a command and is neither an option nor an option's value; empty: nothing.
std::string firstWord(int argc, const char* const argv[])
{
  const std::set<std::string> flags = flagsOfAll();
  for (int i = 2; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (!argument.starts_with("-"))
    {
      return argument;
    }
    const bool alone = flags.contains(argument) || argument.find('=') != std::string::npos;
    i += alone ? 0 : 1;
  }
  return {};
}

} // namespace

std::string StyleArguments::findStyle(int argc, const char* const argv[])
{
  std::string named;
  std::string file;
  std::string preset;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    const auto take = [&](const std::string& option, std::string& text)
    {
      if (argument == option && i + 1 < argc)
      {
        text = argv[i + 1];
      }
      else if (argument.starts_with(option + "="))
      {
        text = argument.substr(option.size() + 1);
      }
    };
    take("--style", named);
    take("--style-file", file);
    take("--preset", preset);
  }
  if (argc > 1 && argv[1] == std::string("style"))
  {
    named = firstWord(argc, argv);
  }
  const std::string inFile =
    named.empty() && !file.empty() ? vtkInkStyle::FindStyleInJSON(contentsOf(file)) : "";
  return !named.empty() ? named
    : !inFile.empty()   ? inFile
    : !preset.empty()   ? styleOfPreset(preset)
                        : vtkInkStyle::GetStyleName(0);
}

std::vector<std::string> StyleArguments::names()
{
  std::vector<std::string> all;
  for (int i = 0; i < vtkInkStyle::GetNumberOfStyles(); ++i)
  {
    all.emplace_back(vtkInkStyle::GetStyleName(i));
  }
  return all;
}

std::map<std::string, StyleArguments::Words> StyleArguments::wordsOfOptions()
{
  std::map<std::string, Words> all;
  for (const std::string& name : names())
  {
    const auto style = create(name);
    for (const InkParameter& parameter : style->GetParameterTable().Parameters)
    {
      Words& option = all[dashed(parameter.Option)];
      option.text = option.text.empty() ? helpOf(parameter) : option.text;
      for (const InkParameter::Entry& entry : parameter.Entries)
      {
        // Styles may have different words for an option of the same name.
        if (std::find(option.words.begin(), option.words.end(), entry.Name) == option.words.end())
        {
          option.words.emplace_back(entry.Name);
        }
      }
      if (parameter.Type == InkParameterType::Bool)
      {
        all[dashed("no-" + std::string(parameter.Option))].text = negationOf(helpOf(parameter));
      }
    }
    for (const InkShorthand& shorthand : style->GetParameterTable().Shorthands)
    {
      Words& option = all[dashed(shorthand.Option)];
      option.text = option.text.empty() ? shorthand.Text : option.text;
      for (const InkShorthand::Word& word : shorthand.Words)
      {
        option.words.emplace_back(word.Word);
      }
    }
  }
  return all;
}

void StyleArguments::add(CLI::App* command, const std::string& name, bool all)
{
  this->style = create(name);
  if (!this->style)
  {
    this->style = create(vtkInkStyle::GetStyleName(0));
  }
  command
    ->add_option("--style-file", this->file,
      "a file with a style's parameters, as 'ink style NAME' prints them; options on the command line come "
      "after it")
    ->type_name("FILE.json");
  // Essentials first.
  for (const bool essential : { true, false })
  {
    for (const InkParameter& parameter : this->table().Parameters)
    {
      if (parameter.Essential == essential)
      {
        this->addParameter(command, parameter, all);
      }
    }
  }
  for (const InkShorthand& shorthand : this->table().Shorthands)
  {
    this->addShorthand(command, shorthand, all);
  }
  this->addOthers(command);
}

void StyleArguments::addParameter(CLI::App* command, const InkParameter& parameter, bool all)
{
  const std::string label = this->style->GetLabel();
  const std::string group = parameter.Essential ? label + ": " + parameter.Group
    : all                                       ? label + ", advanced: " + parameter.Group
                                                : unlisted;
  if (parameter.Type == InkParameterType::Bool)
  {
    this->addFlags(command, parameter, group);
    return;
  }
  std::string details = parameter.Default;
  details = details.empty() ? "none" : details;
  if (parameter.Type == InkParameterType::Int || parameter.Type == InkParameterType::Double)
  {
    const bool ends = parameter.Greatest < InkUnlimited;
    details +=
      ends ? "; " + InkFormatNumber(parameter.Least) + " to " + InkFormatNumber(parameter.Greatest) : "";
  }
  details += *parameter.Unit ? std::string("; ") + parameter.Unit : "";
  details += parameter.Type == InkParameterType::Enum ? "; " + parameter.Expected(this->style) : "";
  Option& added = this->options.emplace_back(Option{ dashed(parameter.Option), &parameter });
  const bool list = parameter.Type == InkParameterType::List;
  added.option =
    command->add_option(added.name, added.texts, helpOf(parameter) + " (" + details + ")")
      ->type_name(typeOf(parameter))
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(list ? CLI::MultiOptionPolicy::TakeAll : CLI::MultiOptionPolicy::Throw)
      ->group(group);
}

void StyleArguments::addFlags(CLI::App* command, const InkParameter& parameter, const std::string& group)
{
  const bool on = parameter.Default == std::string("on");
  for (const bool negated : { false, true })
  {
    const std::string name = dashed((negated ? "no-" : "") + std::string(parameter.Option));
    Option& added = this->options.emplace_back(Option{ name, &parameter, nullptr, negated });
    // The one that changes something is in the help.
    added.option = command->add_flag(name)
                     ->description(negated ? negationOf(helpOf(parameter)) : helpOf(parameter))
                     ->group(negated == on ? group : unlisted);
  }
}

void StyleArguments::addShorthand(CLI::App* command, const InkShorthand& shorthand, bool all)
{
  const auto found = std::find_if(this->options.begin(), this->options.end(),
    [&](const Option& option) { return option.name == dashed(shorthand.Option); });
  std::string words;
  for (const InkShorthand::Word& word : shorthand.Words)
  {
    words += (words.empty() ? "" : "|") + std::string(word.Word);
  }
  if (found != this->options.end())
  {
    found->shorthand = &shorthand;
    found->option->description(found->option->get_description() + "; " + words + ": " + shorthand.Text);
    return;
  }
  std::string type;
  for (const char* name : shorthand.Names)
  {
    type += (type.empty() ? "" : ",") + std::string(name);
  }
  Option& added = this->options.emplace_back(Option{ dashed(shorthand.Option), nullptr, &shorthand });
  added.option =
    command->add_option(added.name, added.texts, shorthand.Text)
      ->type_name(type.empty() ? words : type)
      ->expected(1)
      ->allow_extra_args(false)
      ->group(all ? std::string(this->style->GetLabel()) + ", advanced: " + shorthand.Group : unlisted);
}

void StyleArguments::addOthers(CLI::App* command)
{
  const auto addOther = [&](const std::string& option, bool flag, const std::string& owner)
  {
    if (const auto known = this->others.find(option); known != this->others.end())
    {
      known->second.second += " or " + owner;
    }
    else if (!command->get_option_no_throw(option))
    {
      CLI::Option* added = flag ? command->add_flag(option) : command->add_option(option, this->ignored);
      added->group(unlisted);
      this->others[option] = { added, owner };
    }
  };
  for (const std::string& name : names())
  {
    const auto other = create(name);
    if (name == this->style->GetName())
    {
      continue;
    }
    for (const InkParameter& parameter : other->GetParameterTable().Parameters)
    {
      const bool flag = parameter.Type == InkParameterType::Bool;
      addOther(dashed(parameter.Option), flag, name);
      if (flag)
      {
        addOther(dashed("no-" + std::string(parameter.Option)), flag, name);
      }
    }
    for (const InkShorthand& shorthand : other->GetParameterTable().Shorthands)
    {
      addOther(dashed(shorthand.Option), false, name);
    }
  }
}

} // namespace ink::cli
