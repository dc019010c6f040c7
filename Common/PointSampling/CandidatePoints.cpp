// SPDX-License-Identifier: BSD-3-Clause
#include "PointSampling/CandidatePoints.h"

#include "Mesh/SurfaceSides.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>

namespace ink
{

namespace
{

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr std::size_t lanes = 8; // numbers in a vector

} // namespace

void CandidatePoints::clear()
{
  this->Unsorted.clear();
}

void CandidatePoints::sort(float cell)
{
  const std::size_t count = this->Unsorted.size();
  this->Cell = cell;
  this->Low = glm::vec3(infinity);
  this->High = -this->Low;
  for (const SpacedSample& candidate : this->Unsorted)
  {
    this->Low = glm::min(this->Low, candidate.position);
    this->High = glm::max(this->High, candidate.position);
  }
  this->Size = count > 0 ? glm::ivec3((this->High - this->Low) / cell) + 1 : glm::ivec3(0);
  this->Begin.assign(static_cast<std::size_t>(this->Size.x) * this->Size.y * this->Size.z + 1, 0);
  this->Cells.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const glm::ivec3 at((this->Unsorted[i].position - this->Low) / cell);
    this->Cells[i] = static_cast<std::uint32_t>((at.z * this->Size.y + at.y) * this->Size.x + at.x);
    ++this->Begin[this->Cells[i]];
  }
  std::exclusive_scan(this->Begin.begin(), this->Begin.end(), this->Begin.begin(), 0u);
  this->Sorted.resize(count);
  for (std::vector<float>* values :
    { &this->X, &this->Y, &this->Z, &this->NormalX, &this->NormalY, &this->NormalZ })
  {
    values->resize(count + lanes);
    std::fill_n(values->begin() + static_cast<std::ptrdiff_t>(count), lanes, 0.0f);
  }
  // Beyond the last one nothing is near.
  std::fill_n(this->X.begin() + static_cast<std::ptrdiff_t>(count), lanes, infinity);
  this->Square.assign(count + lanes, infinity);
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::uint32_t to = this->Begin[this->Cells[i]]++;
    const SpacedSample& candidate = this->Unsorted[i];
    this->Sorted[to] = static_cast<std::uint32_t>(i);
    this->X[to] = candidate.position.x;
    this->Y[to] = candidate.position.y;
    this->Z[to] = candidate.position.z;
    this->NormalX[to] = candidate.normal.x;
    this->NormalY[to] = candidate.normal.y;
    this->NormalZ[to] = candidate.normal.z;
  }
  // Each cell's begin is now its end, that is the next one's begin.
  std::copy_backward(this->Begin.begin(), this->Begin.end() - 1, this->Begin.end());
  this->Begin[0] = 0;
}

void CandidatePoints::keepAway(const SpacedSample& sample, float radius)
{
  const glm::vec3 low = (sample.position - radius - this->Low) / this->Cell;
  const glm::vec3 high = (sample.position + radius - this->Low) / this->Cell;
  if (high.x < 0.0f || high.y < 0.0f || high.z < 0.0f)
  {
    return;
  }
  const glm::ivec3 first(glm::max(low, 0.0f));
  const glm::ivec3 last = glm::min(glm::ivec3(high), this->Size - 1);
  const auto [px, py, pz] = std::array{ sample.position.x, sample.position.y, sample.position.z };
  const auto [nx, ny, nz] = std::array{ sample.normal.x, sample.normal.y, sample.normal.z };
  const float limit = radius * radius;
  const float* const x = this->X.data();
  const float* const y = this->Y.data();
  const float* const z = this->Z.data();
  const float* const normalX = this->NormalX.data();
  const float* const normalY = this->NormalY.data();
  const float* const normalZ = this->NormalZ.data();
  float* const square = this->Square.data();
  for (int k = first.z; k <= last.z; ++k)
  {
    for (int j = first.y; j <= last.y; ++j)
    {
      if (first.x > last.x)
      {
        return;
      }
      const std::size_t row = static_cast<std::size_t>(k * this->Size.y + j) * this->Size.x;
      const std::uint32_t end = this->Begin[row + last.x + 1];
      // To whole vectors: what comes after the row's end is tested against all the same.
      for (std::size_t from = this->Begin[row + first.x]; from < end; from += lanes)
      {
#pragma GCC ivdep
        for (std::size_t lane = 0; lane < lanes; ++lane)
        {
          const std::size_t i = from + lane;
          const float ox = x[i] - px;
          const float oy = y[i] - py;
          const float oz = z[i] - pz;
          const float squared = ox * ox + oy * oy + oz * oz;
          const float likeness = nx * normalX[i] + ny * normalY[i] + nz * normalZ[i];
          const float up = nx * ox + ny * oy + nz * oz;
          const float otherUp = normalX[i] * ox + normalY[i] * oy + normalZ[i] * oz;
          const bool near = (squared < limit) & (squared < square[i]) &
            !areApart(likeness, up * up, otherUp * otherUp, squared);
          square[i] = near ? squared : square[i];
        }
      }
    }
  }
}

} // namespace ink
