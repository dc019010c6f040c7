// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace ink::cli
{

/// How long the steps take that a picture is made in, by the clock.
class Timings
{
public:
  /// The first step begins.
  Timings();

  /// A step ends and the next one begins.
  void end(const std::string& step);

  /// A drawing ends: what mappers took to upload their marks is a step of its own.
  void endDrawing();

  /// "reading 0.41 s (12 %), ..." in the order in which they ended.
  std::string text() const;

private:
  double Begin;
  std::vector<std::pair<std::string, double>> Steps; ///< seconds
};

} // namespace ink::cli
