// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkTestRandom_h
#define InkTestRandom_h

#include <cmath>
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

#endif
