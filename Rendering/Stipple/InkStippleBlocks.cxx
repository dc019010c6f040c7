// SPDX-License-Identifier: BSD-3-Clause
#include "InkStippleBlocks.h"

#include "InkView.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <numeric>

namespace
{

/// Whether all corners of a box lie beyond one side of the view, and how far they are from the eye.
struct Seen
{
  bool Outside;
  float Nearest;
  float Farthest;
};

Seen LookAt(
  const InkStippleBlock& block, const glm::mat4& toView, const glm::mat4& toClip, const glm::vec2& reach)
{
  bool beyond[6] = { true, true, true, true, true, true };
  Seen seen{ false, INFINITY, -INFINITY };
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::vec4 place((corner & 1 ? block.High : block.Low)[0], (corner & 2 ? block.High : block.Low)[1],
      (corner & 4 ? block.High : block.Low)[2], 1.0f);
    const glm::vec4 view = toView * place;
    const glm::vec4 clip = toClip * view;
    seen.Nearest = std::min(seen.Nearest, -view.z);
    seen.Farthest = std::max(seen.Farthest, -view.z);
    beyond[0] = beyond[0] && clip.x < -reach.x * clip.w;
    beyond[1] = beyond[1] && clip.x > reach.x * clip.w;
    beyond[2] = beyond[2] && clip.y < -reach.y * clip.w;
    beyond[3] = beyond[3] && clip.y > reach.y * clip.w;
    beyond[4] = beyond[4] && clip.z < -clip.w;
    beyond[5] = beyond[5] && clip.z > clip.w;
  }
  seen.Outside = std::any_of(beyond, beyond + 6, [](bool b) { return b; });
  return seen;
}

} // namespace

void InkStippleRuns::Find(const std::vector<InkStippleBlock>& blocks, const InkView& view,
  const ink::StippleTone& tone, const ink::StippleTone::View& toneView, float margin)
{
  this->Firsts.clear();
  this->Counts.clear();
  const glm::mat4 toView = glm::make_mat4(view.MCVC.data());
  const glm::mat4 toClip = glm::make_mat4(view.VCDC.data());
  const glm::vec2 reach(1.0f + 2.0f * margin / view.Size[0], 1.0f + 2.0f * margin / view.Size[1]);
  for (const InkStippleBlock& block : blocks)
  {
    const Seen seen = LookAt(block, toView, toClip, reach);
    if (seen.Outside)
    {
      continue;
    }
    const float most = tone.mostTone(toneView, block.LargestValue, block.LargestGradient,
      static_cast<float>(block.Ends.size()), seen.Nearest, seen.Farthest);
    // By random values, a stipple may be drawn that is one beyond; and a little for rounding.
    const double ranks = most > 0.0f ? std::ceil(1.0001 * most + 1.0) : 0.0;
    if (ranks >= 1.0)
    {
      const auto last = static_cast<std::size_t>(std::min<double>(ranks, block.Ends.size())) - 1;
      this->Firsts.push_back(block.First);
      this->Counts.push_back(block.Ends[last]);
    }
  }
}

void InkStippleRuns::Fill(const std::vector<InkStippleBlock>& blocks)
{
  this->Firsts.clear();
  this->Counts.clear();
  for (const InkStippleBlock& block : blocks)
  {
    this->Firsts.push_back(block.First);
    this->Counts.push_back(block.Ends.back());
  }
}

long long InkStippleRuns::GetNumberOfStipples() const
{
  return std::accumulate(this->Counts.begin(), this->Counts.end(), 0LL);
}
