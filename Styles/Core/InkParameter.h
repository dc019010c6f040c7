// SPDX-License-Identifier: BSD-3-Clause
/**
 * A parameter of a style: one row of its table. The rows are generated from the style's parameters.json by
 * Core/generate_parameters.py, which says what the entries of a row mean.
 */
#ifndef InkParameter_h
#define InkParameter_h

#include "vtkInkStylesModule.h" // for the export macro

#include <limits>
#include <span>
#include <string>
#include <vector>

class vtkInkStyle;

/// The end of a range that has none.
inline constexpr double InkUnlimited = std::numeric_limits<double>::infinity();

/// A parameter's value: its numbers, colors being three each in 0..1, or its text.
struct InkParameterValue
{
  std::vector<double> Numbers;
  std::string Text;

  bool operator==(const InkParameterValue&) const = default;
};

enum class InkParameterType
{
  Bool,
  Int,
  Double,
  Enum,   ///< the number of one of the entries; written by its name
  Color,  ///< three numbers
  Colors, ///< of one color or more
  Vector, ///< InkParameter::Size numbers
  List,   ///< any number of numbers
  String
};

/// What data has a parameter.
enum class InkParameterData
{
  Any,
  Image,
  Mesh,
  Points ///< without polygons
};

struct VTKINKSTYLES_EXPORT InkParameter
{
  struct Entry
  {
    const char* Name;
    const char* Label;
    double Value;
  };
  /// Another parameter and its value, as text.
  struct Setting
  {
    const char* Name;
    const char* Text;
  };

  const char* Name;
  const char* Label; ///< for people
  InkParameterType Type;
  int Size;        ///< how many numbers a vector has
  bool Optional;   ///< a vector or a color without numbers stands for an automatic choice
  double Least;    ///< for each number
  double Greatest; ///< for each number
  int Order;       ///< of a vector's numbers: 0 any, 1 ascending, 2 strictly so
  std::string (*CheckText)(const std::string&); ///< what is wrong with a text; or null
  const char* Default;
  const char* Unit;
  /// Which power of the length of a pixel the value is in: 1 for lengths, 2 for areas; see
  /// vtkInkStyle::SetPixelScale.
  int PixelPower;
  bool Essential;
  const char* Group;
  const char* Text;   ///< one sentence
  const char* Option; ///< on the command line, without its dashes
  std::span<const Entry> Entries;
  InkParameterData Data;
  Setting Condition; ///< what another parameter has to be for this one to count; without a name: none
  const char* Needs; ///< a parameter that must be on or not empty where this one is given; or null
  /// What else holds where this one is given without these.
  std::span<const Setting> Implies;
  const char* Follows; ///< the parameter whose value this one takes where only that is given; or null
  void (*Set)(vtkInkStyle*, const InkParameterValue&);
  InkParameterValue (*Get)(vtkInkStyle*);

  /// Of the parameter's numbers, as they are for this style.
  double GetLeast(vtkInkStyle* style) const;
  double GetGreatest(vtkInkStyle* style) const;

  /// A value as text: numbers with commas between them, an entry's name, on or off.
  std::string Format(const InkParameterValue& value) const;

  /// Reads a value from text as people write it, also colors by name and as #rrggbb.
  /// @return what was expected, and the found text; empty where the value is right
  std::string Parse(const std::string& text, vtkInkStyle* style, InkParameterValue& value) const;

  /// @return what was expected and what was found; empty where the value can be set
  std::string Check(const InkParameterValue& value, vtkInkStyle* style) const;

  /// "a number from 0 to 1", say.
  std::string Expected(vtkInkStyle* style) const;

  /// How many numbers a value has; 0: any number.
  int GetNumberOfNumbers() const;
  /// "bool", "int" and so on.
  const char* GetTypeAsString() const;
};

/// A way to set several parameters by one option of the command line; it is no parameter itself.
struct InkShorthand
{
  struct Word
  {
    const char* Word;
    std::span<const InkParameter::Setting> Settings;
  };
  const char* Option; ///< one of its own, or a parameter's, to which it adds words
  const char* Text;
  const char* Group;
  std::span<const Word> Words;
  std::span<const char* const> Numbers; ///< parameters, each a number, in the order in which they are given
  std::span<const char* const> Names;   ///< these numbers', as the user knows them
};

/// All there is to say of a style's parameters. Presets come first, then what they set.
struct InkParameterTable
{
  std::span<const InkParameter> Parameters;
  std::span<const InkShorthand> Shorthands;

  /// Null where there is none of that name.
  VTKINKSTYLES_EXPORT const InkParameter* Find(const std::string& name) const;
};

/// A number with as few digits as tell it from all others.
VTKINKSTYLES_EXPORT std::string InkFormatNumber(double number);

#endif
