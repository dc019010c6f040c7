// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SampleMesh.h"

#include <vector>

namespace CLI
{
class App;
class Option;
} // namespace CLI

namespace ink::cli
{

/// Options of points without polygons, in a group of their own.
struct CloudArguments
{
  CloudSampling sampling;
  std::vector<double> viewpoint;

  void add(CLI::App* command);

  CloudSampling options() const;

private:
  std::vector<CLI::Option*> All;
};

} // namespace ink::cli
