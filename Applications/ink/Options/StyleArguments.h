// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "InkParameter.h"

#include "vtkInkStyle.h"
#include "vtkSmartPointer.h"

#include <deque>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace CLI
{
class App;
class Option;
} // namespace CLI

namespace ink::cli
{

/// The group of options that the help leaves out.
inline constexpr const char* unlisted = "unlisted";

/// The options that set a style's parameters, made of its table, and the style that they come to.
class StyleArguments
{
public:
  /// The style that a command line names, where options cannot be parsed yet because they depend on it: after
  /// --style, in a --style-file, or as the argument of `ink style`; else the one that a --preset is of, or
  /// the first of all. The name may be wrong.
  static std::string findStyle(int argc, const char* const argv[]);
  static std::vector<std::string> names();

  /// What there is to say of an option of styles.
  struct Words
  {
    std::vector<std::string> words; ///< the values it can have; empty: any, or none
    std::string text;
  };
  /// Of the options of all styles, by their names with dashes.
  static std::map<std::string, Words> wordsOfOptions();

  /// Adds a style's options, after all others. Those that only other styles have are known, too, to be
  /// refused by name.
  /// @param name unknown: the first style
  /// @param all whether the help has advanced ones, too
  void add(CLI::App* command, const std::string& name, bool all);

  /// The style, set up as the file and then the options say.
  /// @param pixelScale see vtkInkStyle::SetPixelScale
  /// @throws UsageError, Failure
  vtkSmartPointer<vtkInkStyle> make(double pixelScale);

  /// Refuses options that need other data. @throws UsageError
  void checkData(InkParameterData data) const;

  /// Whether the file or an option gives a parameter.
  bool gives(const char* name) const;

private:
  struct Option
  {
    std::string name;                        ///< with its dashes
    const InkParameter* parameter;           ///< null: only a shorthand
    const InkShorthand* shorthand = nullptr; ///< null: only a parameter
    bool negated = false;
    CLI::Option* option = nullptr;
    std::vector<std::string> texts = {};
  };

  static std::string contentsOf(const std::string& file);
  static std::string dashed(const std::string& option);
  void addParameter(CLI::App* command, const InkParameter& parameter, bool all);
  void addFlags(CLI::App* command, const InkParameter& parameter, const std::string& group);
  void addShorthand(CLI::App* command, const InkShorthand& shorthand, bool all);
  void addOthers(CLI::App* command);
  void readFile();
  /// What the file gives and the options would change by the way: it stays. Not what an option switches on to
  /// count, nor what is as by default, as most of a whole file.
  void keepFile();
  void read(const Option& option);
  void readShorthand(const Option& option, const std::string& text);
  /// @param otherwise what else was expected, for the message
  void set(const InkParameter& parameter, const std::string& option, const std::string& text,
    const std::string& otherwise = {});
  void checkConflicts() const;
  void checkConditions() const;
  /// The options that give a parameter a value, by itself or by what they imply, but one.
  std::string optionsFor(const char* name, const std::string& text, const InkParameter* but) const;
  const InkParameterTable& table() const { return this->style->GetParameterTable(); }

  std::string file;                     ///< --style-file
  std::set<const InkParameter*> inFile; ///< given by it
  vtkSmartPointer<vtkInkStyle> style;
  std::deque<Option> options; ///< a deque: CLI11 keeps pointers to the texts
  std::map<std::string, std::pair<CLI::Option*, std::string>> others; ///< with the styles that have them
  std::string ignored;                                                ///< by these
  std::map<const InkParameter*, InkParameterValue> values;
  std::map<const InkParameter*, std::string> givenBy; ///< the option
};

} // namespace ink::cli
