// SPDX-License-Identifier: BSD-3-Clause
#include "InkSplatLineWork.h"

#include "InkView.h"

#include "Lines/DashLines.h"
#include "Lines/GrowLines.h"
#include "Lines/ThinLines.h"
#include "Lines/TraceLines.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

/// Ink from which on it makes lines that can be followed, of 255.
constexpr unsigned char Followed = 51;

/// Ink from which on spots are told from each other: a tenth.
constexpr unsigned char Seen = 26;

/// From this length on, in thousandths of the height, gaps are as long as dashes.
constexpr double EvenDashes = 4.0;

} // namespace

InkSplatLineWork::InkSplatLineWork(const InkSplatStyle& style, int layer, const InkView& view)
{
  const InkSplatStyle::Layer& own = style.Layers[static_cast<std::size_t>(layer)];
  const double thousandth = 1e-3 * view.GetShownHeight() * view.TileScale;
  this->SpeckleLength = static_cast<float>(style.SpeckleLength * view.TileScale);
  this->Thinning = style.Thinning;
  this->Growth = static_cast<float>(0.5 * own.LineWidth * thousandth);
  this->DashLength = static_cast<float>(own.DashLength * thousandth);
  // No dashes are the limit of short ones.
  this->GapLength = this->DashLength * static_cast<float>(std::min(own.DashLength / EvenDashes, 1.0));
  // Which borders of a tile are those of the picture is not known.
  const bool tile = view.TileScale > 1;
  this->Cut = { tile, tile, tile, tile };
}

bool InkSplatLineWork::IsNeeded() const
{
  return this->SpeckleLength > 0.0f || this->Thinning || this->Growth != 0.0f || this->DashLength > 0.0f;
}

int InkSplatLineWork::GetMargin() const
{
  // Thinning sees a line's half width.
  const float thinned = this->Thinning || this->DashLength > 0.0f ? 32.0f : 0.0f;
  return static_cast<int>(std::ceil(std::max({ std::abs(this->Growth), this->SpeckleLength, thinned })));
}

int InkSplatLineWork::GetReach() const
{
  return this->Growth > 0.0f ? static_cast<int>(std::ceil(this->Growth)) : 0;
}

void InkSplatLineWork::Apply(const ink::InkImage& image) const
{
  if (this->SpeckleLength > 0.0f)
  {
    ink::removeSpeckles(image, this->SpeckleLength, Seen, this->Cut);
  }
  if (this->Thinning)
  {
    ink::thinLines(image, Followed);
  }
  // Along the lines as they are before they grow together.
  std::vector<ink::TracedLine> lines;
  if (this->DashLength > 0.0f)
  {
    std::vector<unsigned char> pixels(image.pixels.begin(), image.pixels.end());
    const ink::InkImage thinned{ pixels, image.width, image.height };
    ink::thinLines(thinned, Followed);
    lines = ink::traceLines(thinned);
  }
  ink::growLines(image, this->Growth);
  ink::dashLines(image, lines, this->DashLength, this->GapLength);
}
