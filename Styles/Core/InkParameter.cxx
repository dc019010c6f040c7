// SPDX-License-Identifier: BSD-3-Clause
#include "InkParameter.h"

#include "InkColorNames.h"
#include "vtkInkStyle.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <sstream>

namespace
{

using Type = InkParameterType;

/// A finite number and nothing else.
std::optional<double> ParseNumber(const std::string& text)
{
  double number = 0.0;
  const char* end = text.data() + text.size();
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const auto [stopped, error] = std::from_chars(begin, end, number);
  const bool whole = error == std::errc() && stopped == end && std::isfinite(number);
  return whole ? std::optional(number) : std::nullopt;
}

std::vector<std::string> Split(const std::string& list)
{
  std::vector<std::string> parts;
  std::istringstream stream(list);
  for (std::string part; std::getline(stream, part, ',');)
  {
    parts.push_back(part);
  }
  if (!list.empty() && list.back() == ',')
  {
    parts.emplace_back();
  }
  return parts;
}

/// Letters and digits, in lower case, and a number's sign and point: what counts in an entry's name.
std::string LettersOf(const std::string& name)
{
  const auto is = [&](std::size_t i, int (*kind)(int))
  { return i < name.size() && kind(static_cast<unsigned char>(name[i])) != 0; };
  std::string letters;
  for (std::size_t i = 0; i < name.size(); ++i)
  {
    const bool ofNumber = is(i + 1, std::isdigit) && (name[i] == '.' || (name[i] == '-' && letters.empty()));
    if (ofNumber || is(i, std::isalnum))
    {
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
    }
  }
  return letters;
}

std::string Found(const std::string& text)
{
  return std::string(", found '").append(text).append("'");
}

} // namespace

std::string InkFormatNumber(double number)
{
  std::array<char, 32> digits;
  // Plus zero: no -0.
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number + 0.0).ptr;
  return { digits.data(), end };
}

int InkParameter::GetNumberOfNumbers() const
{
  switch (this->Type)
  {
    case Type::Color:
      return 3;
    case Type::Vector:
      return this->Size;
    case Type::Colors:
    case Type::List:
    case Type::String:
      return 0;
    default:
      return 1;
  }
}

const char* InkParameter::GetTypeAsString() const
{
  static constexpr std::array names{ "bool", "int", "double", "enum", "color", "colors", "vector", "list",
    "string" };
  return names[static_cast<std::size_t>(this->Type)];
}

double InkParameter::GetLeast(vtkInkStyle* style) const
{
  return this->Least / std::pow(style->GetPixelScale(), this->PixelPower);
}

double InkParameter::GetGreatest(vtkInkStyle* style) const
{
  return this->Greatest / std::pow(style->GetPixelScale(), this->PixelPower);
}

std::string InkParameter::Expected(vtkInkStyle* style) const
{
  std::string range;
  if (this->Greatest < InkUnlimited)
  {
    range.append(" from ").append(InkFormatNumber(this->GetLeast(style)));
    range.append(" to ").append(InkFormatNumber(this->GetGreatest(style)));
  }
  else if (this->Least > -InkUnlimited)
  {
    range.append(" of at least ").append(InkFormatNumber(this->GetLeast(style)));
  }
  const std::string empty = this->Optional ? ", or none" : "";
  switch (this->Type)
  {
    case Type::Bool:
      return "on or off";
    case Type::Int:
      return "a whole number" + range;
    case Type::Double:
      return "a number" + range;
    case Type::Enum: {
      std::string names;
      for (const Entry& entry : this->Entries)
      {
        names.append(names.empty() ? "" : &entry == &this->Entries.back() ? " or " : ", ").append(entry.Name);
      }
      return names;
    }
    case Type::Color:
      return "a color name as in HTML, #rrggbb, #rgb or three numbers from 0 to 1" + empty;
    case Type::Colors:
      return "color names as in HTML, #rrggbb or #rgb with commas between them" + empty;
    case Type::Vector:
      return std::to_string(this->Size) + " numbers" + range +
        (this->Order > 0 ? ", the lower value first" : "") + empty;
    case Type::List:
      return "any number of numbers" + range;
    case Type::String:
      break;
  }
  return "text";
}

std::string InkParameter::Check(const InkParameterValue& value, vtkInkStyle* style) const
{
  const std::vector<double>& numbers = value.Numbers;
  const std::string wrong = "expected " + this->Expected(style);
  if (this->Type == Type::String)
  {
    return !numbers.empty() ? wrong + ", found numbers" : this->CheckText ? this->CheckText(value.Text) : "";
  }
  const auto count = static_cast<int>(numbers.size());
  const int wanted = this->GetNumberOfNumbers();
  const bool right = (this->Optional && count == 0) ||
    (wanted > 0 ? count == wanted : this->Type != Type::Colors || (count > 0 && count % 3 == 0));
  if (!right || !value.Text.empty())
  {
    return wrong + Found(value.Text.empty() ? this->Format(value) : value.Text);
  }
  const double least = this->GetLeast(style);
  const double greatest = this->GetGreatest(style);
  const auto fits = [&](double number)
  {
    switch (this->Type)
    {
      case Type::Bool:
        return number == 0.0 || number == 1.0;
      case Type::Enum:
        return std::any_of(this->Entries.begin(), this->Entries.end(),
          [number](const Entry& entry) { return entry.Value == number; });
      case Type::Color:
      case Type::Colors:
        return number >= 0.0 && number <= 1.0;
      case Type::Int:
        return number >= least && number <= greatest && number == std::floor(number);
      default:
        return std::isfinite(number) && number >= least && number <= greatest;
    }
  };
  const bool ordered = this->Order == 0 || count < 2 || numbers[0] < numbers[1] ||
    (this->Order == 1 && numbers[0] == numbers[1]);
  return ordered && std::all_of(numbers.begin(), numbers.end(), fits) ? std::string()
                                                                      : wrong + Found(this->Format(value));
}

std::string InkParameter::Format(const InkParameterValue& value) const
{
  const std::vector<double>& numbers = value.Numbers;
  if (this->Type == Type::String)
  {
    return value.Text;
  }
  if (this->Type == Type::Bool && numbers.size() == 1 && (numbers[0] == 0.0 || numbers[0] == 1.0))
  {
    return numbers[0] == 0.0 ? "off" : "on";
  }
  for (const Entry& entry : this->Entries)
  {
    if (numbers.size() == 1 && entry.Value == numbers[0])
    {
      return entry.Name;
    }
  }
  std::string text;
  for (const double number : numbers)
  {
    text.append(text.empty() ? "" : ",").append(InkFormatNumber(number));
  }
  return text;
}

std::string InkParameter::Parse(const std::string& text, vtkInkStyle* style, InkParameterValue& value) const
{
  value = {};
  const std::string wrong = "expected " + this->Expected(style) + Found(text);
  if (this->Type == Type::String)
  {
    value.Text = text;
    return this->Check(value, style);
  }
  const std::string letters = LettersOf(text);
  if (this->Type == Type::Bool)
  {
    const bool on = letters == "on" || letters == "true" || letters == "yes" || letters == "1";
    const bool off = letters == "off" || letters == "false" || letters == "no" || letters == "0";
    value.Numbers = { on ? 1.0 : 0.0 };
    return on || off ? std::string() : wrong;
  }
  if (this->Type == Type::Enum)
  {
    for (const Entry& entry : this->Entries)
    {
      if (letters == LettersOf(entry.Name) && !letters.empty())
      {
        value.Numbers = { entry.Value };
        return {};
      }
    }
    return wrong;
  }
  const bool colors = this->Type == Type::Color || this->Type == Type::Colors;
  for (const std::string& part : Split(text))
  {
    if (const auto number = ParseNumber(part))
    {
      value.Numbers.push_back(*number);
    }
    else if (const auto color = colors ? InkParseColor(part) : std::nullopt)
    {
      value.Numbers.insert(value.Numbers.end(), color->begin(), color->end());
    }
    else
    {
      return wrong;
    }
  }
  return this->Check(value, style).empty() ? std::string() : wrong;
}

const InkParameter* InkParameterTable::Find(const std::string& name) const
{
  const auto found = std::find_if(this->Parameters.begin(), this->Parameters.end(),
    [&](const InkParameter& parameter) { return name == parameter.Name; });
  return found == this->Parameters.end() ? nullptr : &*found;
}
