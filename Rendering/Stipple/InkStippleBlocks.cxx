// SPDX-License-Identifier: BSD-3-Clause
#include "InkStippleBlocks.h"

#include "InkViewUniforms.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <numeric>

namespace
{

/// Runs with no more stipples between them than this become one: a run takes longer than a few stipples.
constexpr int SmallGap = 16;

/// For rounding, in cosines.
constexpr float Slack = 1e-3f;

/// An angle between 0 and pi.
struct Angle
{
  float Cosine = 1.0f;
  float Sine = 0.0f;

  explicit Angle(float cosine)
    : Cosine(std::clamp(cosine, -1.0f, 1.0f))
    , Sine(std::sqrt(1.0f - this->Cosine * this->Cosine))
  {
  }
  /// At most pi.
  Angle operator+(const Angle& other) const
  {
    return this->Sine * other.Cosine + this->Cosine * other.Sine < 0.0f
      ? Angle(-1.0f)
      : Angle(this->Cosine * other.Cosine - this->Sine * other.Sine);
  }
  /// At least 0.
  Angle operator-(const Angle& other) const
  {
    return this->Sine * other.Cosine - this->Cosine * other.Sine < 0.0f
      ? Angle(1.0f)
      : Angle(this->Cosine * other.Cosine + this->Sine * other.Sine);
  }
};

/// Blocks as a view sees them.
class BlockView
{
public:
  BlockView(
    const InkViewUniforms& view, const ink::stipple::Tone& tone, const InkStippleView& toneView, float margin)
    : ToView(glm::make_mat4(view.MCVC.data()))
    , Normal(glm::make_mat3(view.Normal.data()))
    , Tone(tone)
    , ToneView(toneView)
    , Parallel(view.Eye[3] == 0.0f)
  {
    const glm::mat4 rows = glm::transpose(glm::make_mat4(view.VCDC.data()) * this->ToView);
    const glm::vec2 reach(1.0f + 2.0f * margin / view.Size[0], 1.0f + 2.0f * margin / view.Size[1]);
    for (int side = 0; side < 6; ++side)
    {
      const int axis = side / 2;
      const float sign = side % 2 ? -1.0f : 1.0f;
      this->Sides[side] = (axis < 2 ? reach[axis] : 1.0f) * rows[3] + sign * rows[axis];
    }
    const glm::mat4 viewRows = glm::transpose(this->ToView);
    this->Depth = -viewRows[2];
    // Angles between normals are the same in the view where it neither shears nor stretches.
    const glm::mat3 steps(this->ToView);
    const glm::mat3 square = glm::transpose(steps) * steps;
    const float size = square[0][0];
    this->Unit = std::sqrt(size);
    this->KeepsAngles = std::abs(square[1][1] - size) < 1e-3f * size &&
      std::abs(square[2][2] - size) < 1e-3f * size && std::abs(square[0][1]) < 1e-3f * size &&
      std::abs(square[0][2]) < 1e-3f * size && std::abs(square[1][2]) < 1e-3f * size;
  }

  /// At least the T of all the block's elements; 0 where none is seen.
  float MostTone(const InkStippleBlock& block) const
  {
    const glm::vec3 low = glm::make_vec3(block.Low.data());
    const glm::vec3 high = glm::make_vec3(block.High.data());
    const glm::vec3 middle = 0.5f * (low + high);
    const glm::vec3 half = 0.5f * (high - low);
    for (const glm::vec4& side : this->Sides)
    {
      if (glm::dot(glm::vec3(side), middle) + side.w + glm::dot(glm::abs(glm::vec3(side)), half) < 0.0f)
      {
        return 0.0f;
      }
    }
    const float distance = glm::dot(glm::vec3(this->Depth), middle) + this->Depth.w;
    const float depth = glm::dot(glm::abs(glm::vec3(this->Depth)), half);
    return this->Tone.mostTone(this->ToneView.Tone, block.LargestValue, block.LargestGradient,
      static_cast<float>(block.Runs.size()), distance - depth, distance + depth,
      this->FindDirections(block, middle, glm::length(half)));
  }

private:
  struct Cosines
  {
    float Least;
    float Most;
  };

  /// Of the angles between the directions in two cones.
  static Cosines Between(const glm::vec3& a, const glm::vec3& b, const Angle& spread)
  {
    const Angle angle(glm::dot(a, b));
    return { (angle + spread).Cosine - Slack, (angle - spread).Cosine + Slack };
  }

  ink::stipple::Tone::Directions FindDirections(
    const InkStippleBlock& block, const glm::vec3& middle, float radius) const
  {
    ink::stipple::Tone::Directions directions;
    if (!this->KeepsAngles || !(block.LeastCosine > -1.0f))
    {
      return directions;
    }
    const glm::vec3 axis = glm::normalize(this->Normal * glm::make_vec3(block.Axis.data()));
    glm::vec3 toEye(0.0f, 0.0f, 1.0f);
    const Angle spread(block.LeastCosine);
    Angle across(1.0f);
    if (!this->Parallel)
    {
      toEye = -glm::vec3(this->ToView * glm::vec4(middle, 1.0f));
      const float length = glm::length(toEye);
      if (length <= radius * this->Unit)
      {
        return directions;
      }
      toEye /= length;
      const float sine = radius * this->Unit / length;
      across = Angle(std::sqrt(1.0f - sine * sine));
    }
    const Cosines eye = Between(axis, toEye, spread + across);
    directions.leastCosine = eye.Least;
    directions.mostCosine = eye.Most;
    // Normals on the back are turned round there.
    if (this->Tone.lighting.on && this->Tone.isSeen(eye.Most) &&
      !(this->Tone.surface && this->Tone.twoSided && eye.Least < 0.0f))
    {
      this->FindLight(axis, spread, directions);
    }
    return directions;
  }

  void FindLight(const glm::vec3& axis, const Angle& spread, ink::stipple::Tone::Directions& directions) const
  {
    float least = 0.0f;
    float most = 0.0f;
    for (const ink::Light& light : this->ToneView.Lights)
    {
      if (light.isLamp())
      {
        most = 1.0f;
        continue;
      }
      const Cosines cosines = Between(axis, glm::vec3(light.position), spread);
      const auto lit = [&](float cosine)
      {
        return cosine > 0.0f
          ? light.intensity * std::pow(std::min(cosine, 1.0f), this->Tone.lighting.exponent)
          : 0.0f;
      };
      least += lit(cosines.Least);
      most += lit(cosines.Most);
    }
    directions.leastLit = std::clamp(least, 0.0f, 1.0f);
    directions.mostLit = std::clamp(most, 0.0f, 1.0f);
  }

  glm::mat4 ToView;
  glm::mat3 Normal;
  const ink::stipple::Tone& Tone;
  const InkStippleView& ToneView;
  bool Parallel;
  bool KeepsAngles;
  float Unit;
  glm::vec4 Sides[6]; ///< of the view: what is inside has positive products with all of them
  glm::vec4 Depth;    ///< the product with it is the distance from the eye along the view
};

} // namespace

void InkStippleRuns::Find(const std::vector<InkStippleBlock>& blocks, const InkViewUniforms& view,
  const ink::stipple::Tone& tone, const InkStippleView& toneView, float margin)
{
  this->Firsts.clear();
  this->Counts.clear();
  const BlockView seen(view, tone, toneView, margin);
  std::vector<std::size_t> ranks; // to be drawn, of each block of the group
  for (std::size_t first = 0, last; first < blocks.size(); first = last)
  {
    ranks.clear();
    std::size_t most = 0;
    for (last = first; last < blocks.size() && blocks[last].Group == blocks[first].Group; ++last)
    {
      // The last stipple drawn has a rank below T, by random values, too; a little for rounding.
      const double tonesRanks = std::ceil(1.001 * seen.MostTone(blocks[last]));
      const std::size_t all = blocks[last].Runs.size();
      // All where the tone is not a number, as that of positions which single precision does not hold.
      ranks.push_back(tonesRanks < static_cast<double>(all) ? static_cast<std::size_t>(tonesRanks) : all);
      most = std::max(most, ranks.back());
    }
    for (std::size_t rank = 0; rank < most; ++rank)
    {
      for (std::size_t block = first; block < last; ++block)
      {
        if (rank < ranks[block - first])
        {
          this->Add(blocks[block].Runs[rank]);
        }
      }
    }
  }
}

void InkStippleRuns::Add(const InkStippleBlock::Run& run)
{
  if (!this->Firsts.empty() && run.First - (this->Firsts.back() + this->Counts.back()) <= SmallGap)
  {
    this->Counts.back() = run.First + run.Count - this->Firsts.back();
  }
  else
  {
    this->Firsts.push_back(run.First);
    this->Counts.push_back(run.Count);
  }
}

void InkStippleRuns::Fill(int numberOfStipples)
{
  this->Firsts = { 0 };
  this->Counts = { numberOfStipples };
}

long long InkStippleRuns::GetNumberOfStipples() const
{
  return std::accumulate(this->Counts.begin(), this->Counts.end(), 0LL);
}
