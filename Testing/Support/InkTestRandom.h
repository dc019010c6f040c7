// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkTestRandom_h
#define InkTestRandom_h

#include "InkTestChecks.h"

#include <cmath>
#include <cstdlib>
#include <random>

/// Random numbers that are the same with every standard library.
class InkTestRandom
{
public:
  explicit InkTestRandom(unsigned seed)
    : Engine(seed)
  {
  }
  /// 0 to n - 1.
  int UpTo(int n) { return static_cast<int>(this->Engine() % static_cast<unsigned>(n)); }
  bool Once(int in) { return this->UpTo(in) == 0; }
  /// From 0 to 1.
  double Share() { return this->Engine() / 4294967296.0; }
  /// From 10^least to 10^greatest.
  double Magnitude(double least, double greatest)
  {
    return std::pow(10.0, least + (greatest - least) * this->Share());
  }

private:
  std::mt19937 Engine;
};

/// The body of a test of many random inputs: checkSeed(check, seed) for the seeds 0 to count - 1, or for the
/// one that the command line names.
/// @return what a VTK-style test returns
template <class CheckSeed>
int InkTestSeeds(int argc, char* argv[], unsigned count, const CheckSeed& checkSeed)
{
  InkTestChecks check;
  if (argc > 1)
  {
    checkSeed(check, static_cast<unsigned>(std::strtoul(argv[1], nullptr, 10)));
    return check.Result();
  }
  // A defect shows with many seeds; the first tell enough.
  for (unsigned seed = 0; seed < count && check.Failed() < 10; ++seed)
  {
    checkSeed(check, seed);
  }
  return check.Result();
}

#endif
