// SPDX-License-Identifier: BSD-3-Clause
#include "InkLinePostProcess.h"

#include "InkViewUniforms.h"

#include "Raster/Dash.h"
#include "Raster/Dilate.h"
#include "Raster/Thin.h"
#include "Raster/Trace.h"

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

InkLinePostProcess::InkLinePostProcess(const InkSplatStyle& style, int layer, const InkViewUniforms& view)
{
  const InkSplatStyle::Layer& own = style.Layers[static_cast<std::size_t>(layer)];
  const double thousandth = 1e-3 * view.PictureHeight;
  this->SpeckleLength = static_cast<float>(style.SpeckleLength * view.TileScale);
  this->Thinning = style.Thinning;
  // Thinned lines are a pixel wide; in large pictures that would be no more than a gray hair.
  const double beyondPixel = this->Thinning ? std::max(thousandth - 1.0, 0.0) : 0.0;
  this->Growth = static_cast<float>(0.5 * (beyondPixel + own.LineWidth * thousandth));
  this->DashLength = static_cast<float>(own.DashLength * thousandth);
  // No dashes are the limit of short ones.
  this->GapLength = this->DashLength * static_cast<float>(std::min(own.DashLength / EvenDashes, 1.0));
  // Which borders of a tile are those of the picture is not known.
  const bool tile = view.TileScale > 1;
  this->Cut = { tile, tile, tile, tile };
}

bool InkLinePostProcess::IsNeeded() const
{
  return this->SpeckleLength > 0.0f || this->Thinning || this->Growth != 0.0f || this->DashLength > 0.0f;
}

int InkLinePostProcess::GetMargin() const
{
  // Thinning sees a line's half width.
  const float thinned = this->Thinning || this->DashLength > 0.0f ? 32.0f : 0.0f;
  return static_cast<int>(std::ceil(std::max({ std::abs(this->Growth), this->SpeckleLength, thinned })));
}

int InkLinePostProcess::GetReach() const
{
  return this->Growth > 0.0f ? static_cast<int>(std::ceil(this->Growth)) : 0;
}

void InkLinePostProcess::Apply(const ink::raster::CoverageImage& image) const
{
  if (this->SpeckleLength > 0.0f)
  {
    ink::raster::despeckle(image, this->SpeckleLength, Seen, this->Cut);
  }
  if (this->Thinning)
  {
    ink::raster::thin(image, Followed);
  }
  // Along the lines as they are before they grow together.
  std::vector<ink::raster::TracedLine> lines;
  if (this->DashLength > 0.0f)
  {
    std::vector<unsigned char> pixels(image.pixels.begin(), image.pixels.end());
    const ink::raster::CoverageImage thinned{ pixels, image.width, image.height };
    ink::raster::thin(thinned, Followed);
    lines = ink::raster::trace(thinned);
  }
  ink::raster::dilate(image, this->Growth);
  ink::raster::dash(image, lines, this->DashLength, this->GapLength);
}
