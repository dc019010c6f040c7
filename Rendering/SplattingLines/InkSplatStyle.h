// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSplatStyle_h
#define InkSplatStyle_h

#include <array>

/// How illumination becomes ink. Lengths on the picture are in thousandths of the viewport's height.
struct InkSplatStyle
{
  static constexpr int MostLayers = 8;

  struct Layer
  {
    std::array<double, 3> Color;
    bool ScalarColors; ///< by the points' scalars instead
    double Strength;
    double LineWidth;
    double DashLength; ///< 0: solid
    bool operator==(const Layer&) const = default;
  };

  double Tau;
  double Phi;
  double Hardness;
  double SpeckleLength; ///< pixels of the window; 0: none is removed
  bool Thinning;
  bool ToneColors;
  std::array<double, 3> ToneColor;
  std::array<Layer, MostLayers> Layers;
  bool Paper; ///< whether all layers are seen on the first, or each in its own place

  bool operator==(const InkSplatStyle&) const = default;
};

#endif
