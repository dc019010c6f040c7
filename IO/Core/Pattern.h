// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkInkIOCoreModule.h" // for the export macro

#include <memory>
#include <string>
#include <vector>

namespace ink::io
{

/// A regular expression in ECMAScript's grammar. A source that includes <regex> takes seconds more to
/// compile, and there are many that ask for a match.
class VTKINKIOCORE_EXPORT Pattern
{
public:
  /// @param ignoreCase letters match in either case
  explicit Pattern(const std::string& expression, bool ignoreCase = false);
  ~Pattern();
  Pattern(const Pattern&) = delete;
  Pattern& operator=(const Pattern&) = delete;

  /// @return where the expression matches all of a text: the text, then what each group matched, which is
  /// empty for a
  ///   group that is not in it; otherwise nothing
  std::vector<std::string> match(const std::string& text) const;

  /// As match(), for the first part of a text that the expression matches.
  std::vector<std::string> search(const std::string& text) const;

  /// A text with another one, in which $1 is what the first group matched, in place of each part that the
  /// expression matches.
  std::string replace(const std::string& text, const std::string& replacement) const;

private:
  struct Expression;
  std::unique_ptr<const Expression> Compiled;
};

} // namespace ink::io
