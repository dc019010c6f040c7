// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkInkIOCoreModule.h" // for the export macro

#include <filesystem>
#include <fstream>
#include <functional>
#include <ios>
#include <string>

namespace ink::io
{

/// Values in a legacy VTK file that stand together.
struct LegacyArray
{
  std::string name;
  int type;                ///< as VTK_FLOAT, or VTK_BIT
  double components;       ///< a whole number
  double tuples;           ///< the same
  std::streamoff begin;    ///< in the file
  bool areScalars = false; ///< said to be the active ones
};

/// The words and arrays of a legacy VTK file, in which nothing is believed that there are no bytes for: VTK's
/// readers make room for whatever a file says, and take what comes next for it.
/// All functions that read throw ReadError where something else stands there.
class VTKINKIOCORE_EXPORT LegacyFile
{
public:
  /// Reads the first lines, up to the kind of dataset.
  explicit LegacyFile(const std::filesystem::path& file);

  bool isText() const { return this->IsText; }
  /// As "polydata".
  const std::string& kind() const { return this->Kind; }
  /// Of the format.
  int majorVersion() const { return this->MajorVersion; }

  /// The next word, in small letters, as the format does not tell them from large ones. @return false at the
  /// end
  bool tryWord(std::string& word);
  std::string word(const char* expected);
  /// As it is written.
  std::string name();
  double number(const char* expected);
  double whole(double least, const char* expected);
  /// Goes to where values begin: binary ones on the next line, others where the next word is.
  void beginValues();
  /// As VTK_FLOAT, by its name; VTK_VOID if it is not a number's.
  static int typeOf(const std::string& name);
  /// Where the next byte is.
  std::streamoff position() { return this->Stream.tellg(); }
  /// A number of cells: of 4 bytes where the file is binary.
  double cellNumber();

  /// Goes past values that begin here.
  void skip(double values, int type);
  /// Goes past what follows on the keyword METADATA, about the array before it.
  void skipMetadata();
  /// Goes past values of points or cells, where keyword is one that such follow, as SCALARS or FIELD.
  /// @param tuples how many points, or cells, have them
  /// @param take is told of each array, whether or not it has as many tuples; the rest is left to be read
  /// where it returns false
  /// @return whether keyword is one
  bool passValues(
    const std::string& keyword, double tuples, const std::function<bool(const LegacyArray&)>& take);

  [[noreturn]] void fail(const std::string& found, const std::string& expected) const;

private:
  /// @return whether to go on
  bool pass(LegacyArray array, const std::string& typeName, bool areValues,
    const std::function<bool(const LegacyArray&)>& take);
  void skipStrings(double strings, bool areVariants);
  void skipString();
  void endLine();

  std::filesystem::path File;
  std::ifstream Stream;
  double Size;
  int MajorVersion = 0;
  bool IsText = false;
  std::string Kind;
  double Components = 0.0; ///< of the last array
};

} // namespace ink::io
