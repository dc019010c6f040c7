// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/SilhouetteVoxels.h"

#include "Core/ParallelChunks.h"
#include "Core/ParallelFor.h"
#include "Fields/Derivatives/LaplacianOfGaussian.h"
#include "Fields/Grid/GridField.h"
#include "Fields/ScalarDifference.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <span>

namespace ink
{
namespace
{

/// Layers whose Laplacian is in memory at a time.
constexpr int LayersAtOnce = 32;

template <class To>
void append(To& to, const To& from)
{
  to.insert(to.end(), from.begin(), from.end());
}

/// Calls visit(sample) for all samples of a layer, in order.
template <class Visit>
void forEachSample(const glm::ivec3& dimensions, int layer, const Visit& visit)
{
  for (int j = 0; j < dimensions.y; ++j)
  {
    for (int i = 0; i < dimensions.x; ++i)
    {
      visit(glm::ivec3(i, j, layer));
    }
  }
}

/// The Laplacian at the samples of a few layers.
struct LaplacianLayers
{
  SampleBox box;
  std::vector<float> values;

  float at(const glm::ivec3& sample) const
  {
    const glm::ivec3 in = sample - this->box.begin;
    const glm::ivec3 size = this->box.size();
    return this
      ->values[in.x + static_cast<std::size_t>(size.x) * (in.y + static_cast<std::size_t>(size.y) * in.z)];
  }
};

template <class T>
void add(EdgeVoxels& voxels, const GridField<T>& field, const glm::ivec3& sample, const glm::dvec3& gradient)
{
  const GridGeometry& geometry = field.geometry();
  voxels.samples.push_back(geometry.offset(sample));
  voxels.positions.push_back(geometry.toWorld(sample));
  voxels.gradients.emplace_back(gradient);
  voxels.values.push_back(static_cast<float>(field.at(sample)));
}

template <class T>
bool isZeroCrossing(const GridField<T>& field, const LaplacianLayers& laplacian, const glm::ivec3& sample)
{
  const float here = laplacian.at(sample);
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int step : { -1, 1 })
    {
      glm::ivec3 neighbor = sample;
      neighbor[axis] += step;
      if (field.has(neighbor))
      {
        const float there = laplacian.at(neighbor);
        // Of two as far from zero, one.
        if ((here < 0.0f) != (there < 0.0f) &&
          (std::abs(here) < std::abs(there) || (std::abs(here) == std::abs(there) && here < 0.0f)))
        {
          return true;
        }
      }
    }
  }
  return false;
}

} // namespace

template <class T>
EdgeVoxels findEdgeVoxels(
  const GridField<T>& field, const glm::dvec3& deviation, double leastMagnitude, const Progress& progress)
{
  const GridGeometry& geometry = field.geometry();
  const glm::ivec3 n = geometry.dimensions();
  EdgeVoxels voxels;
  for (int begin = 0; begin < n.z && geometry.sampleCount() > 0; begin += LayersAtOnce)
  {
    const int end = std::min(begin + LayersAtOnce, n.z);
    LaplacianLayers laplacian;
    laplacian.box = { { 0, 0, std::max(begin - 1, 0) }, { n.x, n.y, std::min(end + 1, n.z) } };
    laplacian.values.resize(laplacian.box.count());
    const Progress part = [&](double done)
    { return !progress || progress((begin + done * (end - begin)) / n.z); };
    if (!laplacianOfGaussian(field, laplacian.box, deviation, std::span<float>(laplacian.values), part))
    {
      return {};
    }
    std::vector<EdgeVoxels> layers(static_cast<std::size_t>(end - begin));
    parallelFor(layers.size(),
      [&](std::size_t layer)
      {
        EdgeVoxels& found = layers[layer];
        forEachSample(n, begin + static_cast<int>(layer),
          [&](const glm::ivec3& sample)
          {
            if (!field.has(sample) || !isZeroCrossing(field, laplacian, sample))
            {
              return;
            }
            const glm::dvec3 gradient = geometry.gradientToWorld(field.gradientAt(sample));
            const double magnitude = glm::length(gradient);
            if (magnitude > 0.0 && magnitude >= leastMagnitude)
            {
              add(found, field, sample, gradient);
            }
          });
      });
    for (const EdgeVoxels& layer : layers)
    {
      append(voxels.samples, layer.samples);
      append(voxels.positions, layer.positions);
      append(voxels.gradients, layer.gradients);
      append(voxels.values, layer.values);
    }
  }
  return voxels;
}

bool SilhouetteCriteria::accept(float value, const glm::vec3& gradient, const glm::vec3& toEye) const
{
  const float magnitude = glm::length(gradient);
  return value >= this->lowest && value <= this->highest && magnitude >= this->leastMagnitude &&
    std::abs(glm::dot(gradient, toEye)) <= this->largestCosine * magnitude * glm::length(toEye);
}

std::vector<std::uint32_t> selectSilhouetteVoxels(
  const EdgeVoxels& voxels, const SilhouetteCriteria& criteria, const Eye& eye)
{
  eye.check();
  return parallelSelect(voxels.samples.size(),
    [&](std::size_t n) {
      return criteria.accept(voxels.values[n], voxels.gradients[n], glm::vec3(eye.from(voxels.positions[n])));
    });
}

std::array<glm::dvec3, 2> silhouetteSegment(
  const glm::dvec3& center, const glm::vec3& gradient, const glm::dvec3& toEye, double length)
{
  const glm::dvec3 along = glm::cross(glm::dvec3(gradient), toEye);
  const double size = glm::length(along);
  const glm::dvec3 half = size > 0.0 ? 0.5 * length / size * along : glm::dvec3(0.0);
  return { center - half, center + half };
}

Contours silhouetteSegments(const EdgeVoxels& voxels, std::span<const std::uint32_t> selected, const Eye& eye,
  double length, const ContourArrays& arrays)
{
  Contours contours;
  contours.kinds.assign(selected.size(), ContourKind::Silhouette);
  contours.chains.closed.assign(selected.size(), 0);
  for (const std::uint32_t n : selected)
  {
    const glm::dvec3& center = voxels.positions[n];
    const glm::vec3& gradient = voxels.gradients[n];
    double along = 0.0;
    for (const glm::dvec3& end : silhouetteSegment(center, gradient, eye.from(center), length))
    {
      contours.positions.push_back(end);
      if (arrays.normals)
      {
        contours.normals.push_back(-glm::normalize(gradient));
      }
      if (arrays.radialCurvature)
      {
        contours.radialCurvature.push_back(0.0f);
      }
      if (arrays.arcLength)
      {
        contours.arcLength.push_back(along);
        along = length;
      }
      if (arrays.elements)
      {
        contours.elements.push_back(static_cast<std::int64_t>(voxels.samples[n]));
      }
    }
    contours.chains.offsets.push_back(contours.positions.size());
  }
  return contours;
}

template <class T>
std::vector<std::size_t> searchSilhouetteVoxels(
  const GridField<T>& field, const SilhouetteCriteria& criteria, const Eye& eye)
{
  eye.check();
  const GridGeometry& geometry = field.geometry();
  const glm::ivec3 n = geometry.dimensions();
  const glm::dmat3 toSteps = glm::inverse(geometry.stepToWorld());
  const auto gradientAt = [&](const glm::ivec3& sample)
  { return geometry.gradientToWorld(field.gradientAt(sample)); };
  const auto isEdge = [&](const glm::ivec3& sample, const glm::dvec3& gradient)
  {
    const glm::dvec3 line = toSteps * gradient;
    const glm::dvec3 size = glm::abs(line);
    const glm::ivec3 step(glm::round(line / std::max({ size.x, size.y, size.z })));
    for (const glm::ivec3& neighbor : { sample + step, sample - step })
    {
      if (field.has(neighbor) && glm::length(gradientAt(neighbor)) > glm::length(gradient))
      {
        return false;
      }
    }
    return true;
  };
  const auto isSilhouette = [&](const glm::ivec3& sample)
  {
    bool towards = false;
    bool away = false;
    for (int at = 0; at < 27; ++at)
    {
      const glm::ivec3 neighbor = sample + glm::ivec3(at % 3, at / 3 % 3, at / 9) - 1;
      if (field.has(neighbor))
      {
        const glm::dvec3 gradient = gradientAt(neighbor);
        const bool enough = glm::length(gradient) >= criteria.leastMagnitude;
        const double facing = glm::dot(gradient, eye.from(geometry.toWorld(neighbor)));
        towards = towards || (enough && facing < 0.0);
        away = away || (enough && facing > 0.0);
      }
    }
    return towards && away;
  };
  std::vector<std::vector<std::size_t>> layers(static_cast<std::size_t>(n.z));
  parallelFor(layers.size(),
    [&](std::size_t layer)
    {
      forEachSample(n, static_cast<int>(layer),
        [&](const glm::ivec3& sample)
        {
          if (!field.has(sample))
          {
            return;
          }
          const auto value = static_cast<float>(field.at(sample));
          const glm::dvec3 gradient = gradientAt(sample);
          const double magnitude = glm::length(gradient);
          if (magnitude > 0.0 && magnitude >= criteria.leastMagnitude && value >= criteria.lowest &&
            value <= criteria.highest && isEdge(sample, gradient) && isSilhouette(sample))
          {
            layers[layer].push_back(geometry.offset(sample));
          }
        });
    });
  std::vector<std::size_t> found;
  for (const std::vector<std::size_t>& layer : layers)
  {
    append(found, layer);
  }
  return found;
}

template <class T>
EdgeVoxels describeVoxels(const GridField<T>& field, std::span<const std::size_t> samples)
{
  const GridGeometry& geometry = field.geometry();
  const glm::ivec3 n = geometry.dimensions();
  EdgeVoxels voxels;
  for (const std::size_t offset : samples)
  {
    const std::size_t row = offset / n.x;
    const glm::ivec3 sample(offset % n.x, row % n.y, row / n.y);
    add(voxels, field, sample, geometry.gradientToWorld(field.gradientAt(sample)));
  }
  return voxels;
}

#define INK_INSTANTIATE(T)                                                                                   \
  template EdgeVoxels findEdgeVoxels(const GridField<T>&, const glm::dvec3&, double, const Progress&);       \
  template std::vector<std::size_t> searchSilhouetteVoxels(                                                  \
    const GridField<T>&, const SilhouetteCriteria&, const Eye&);                                             \
  template EdgeVoxels describeVoxels(const GridField<T>&, std::span<const std::size_t>);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)

} // namespace ink
