// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Contours/GridContours.h"

#include "Core/ParallelFor.h"
#include "Curves/Contours/BrickContour.h"
#include "Curves/Contours/BrickSamples.h"
#include "Curves/Contours/ContourLinks.h"
#include "Curves/Contours/DescribeContours.h"
#include "Curves/Contours/GridBorder.h"
#include "Fields/ScalarDifference.h"
#include "IsoSurface/IsoOffset.h"
#include "IsoSurface/IsoSurfaceSamples.h"
#include "Simd/KernelDispatch.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <span>

namespace ink
{
namespace
{

/// Bricks that a thread searches at a time.
constexpr std::size_t BricksAtOnce = 32;

/// The eye in steps of the whole grid. There v is a vector and grad f a covector, so that grad f . v is the
/// same number as in the world.
Eye eyeInSteps(const GridGeometry& geometry, const Eye& eye)
{
  return eye.parallel ? Eye::along(glm::inverse(geometry.stepToWorld()) * eye.direction)
                      : Eye::at(geometry.toGlobalIndex(eye.position));
}

/// The direction of a vector of any length; zero or NaN where it has none.
glm::dvec3 directionOf(const glm::dvec3& vector)
{
  const glm::dvec3 size = glm::abs(vector);
  const double scale = std::max({ size.x, size.y, size.z });
  return scale > 0.0 ? glm::normalize(vector / scale) : glm::dvec3(0.0);
}

/// Looks at the samples of bricks of one field from one eye.
template <class T>
class BrickViewer
{
public:
  BrickViewer(const GridField<T>& field, double isoValue, const Eye& eye)
    : Samples(field)
    , Offset(isoValue)
    , InSteps(eyeInSteps(field.geometry(), eye))
    , AllAtOnce(
        field.hidden().empty() && field.stride() == 1 ? kernelsFor<T>(samplingKernels()).view : nullptr)
  {
    this->Source.y = field.geometry().dimensions().x;
    this->Source.z = this->Source.y * field.geometry().dimensions().y;
    this->Source.scale = IsoOffset<T>::Scale;
    this->Source.iso = isoValue * IsoOffset<T>::Scale;
  }

  void look(const CellBrick& brick, BrickView& view)
  {
    const GridGeometry& geometry = this->Samples.geometry();
    const BrickSamples samples(brick.cells);
    for (int n = 0; n < BrickView::width; ++n)
    {
      const glm::dvec3 v = this->InSteps.from(glm::dvec3(geometry.first() + brick.first + n));
      for (int axis = 0; axis < 3; ++axis)
      {
        this->Source.view[axis][n] = v[axis];
      }
    }
    if (this->AllAtOnce && this->Samples.isInner(brick.first) &&
      this->Samples.isInner(brick.first + CellBrick::width))
    {
      std::ranges::copy(samples.layers(), this->Source.needed);
      this->Source.first =
        reinterpret_cast<const KernelScalar<T>*>(this->Samples.data() + geometry.offset(brick.first));
      if (this->AllAtOnce(this->Source, view))
      {
        return;
      }
    }
    std::ranges::fill(view.front, 0u);
    std::ranges::fill(view.inside, 0u);
    samples.forEach(
      [&](const glm::ivec3& inBrick)
      {
        const int index = BrickSamples::indexOf(inBrick);
        const int bit = inBrick.x + BrickView::width * inBrick.y;
        view.facing[index] = this->facingAt(brick.first + inBrick);
        view.offsets[index] = this->offsetAt(brick.first + inBrick);
        view.front[inBrick.z] |= static_cast<std::uint32_t>(view.facing[index] >= 0.0) << bit;
        view.inside[inBrick.z] |= static_cast<std::uint32_t>(view.offsets[index] >= 0.0) << bit;
      });
  }

  /// The position in the world of the node on a face as in ContourLinks::OpenEnd.
  glm::dvec3 nodeOf(std::uint64_t face) const
  {
    const GridGeometry& geometry = this->Samples.geometry();
    const glm::u64vec3 n(geometry.dimensions());
    const std::uint64_t offset = face >> 4;
    const int shape = static_cast<int>(face & 15);
    const glm::ivec3 lowest(offset % n.x, offset / n.x % n.y, offset / (n.x * n.y));
    std::array<double, 3> offsets{};
    std::array<double, 3> facing{};
    for (int corner = 0; const int bits :
         { 0, int(ContourFace::shapeOf[shape].middle), int(ContourFace::shapeOf[shape].high) })
    {
      const glm::ivec3 sample = lowest + glm::ivec3(bits & 1, bits >> 1 & 1, bits >> 2);
      offsets[corner] = this->offsetAt(sample);
      facing[corner++] = this->facingAt(sample);
    }
    return geometry.toWorld(glm::dvec3(geometry.first() + lowest) + contourNode(shape, offsets, facing) -
      glm::dvec3(geometry.first()));
  }

private:
  double offsetAt(const glm::ivec3& sample) const { return this->Offset(this->Samples.at(sample)); }
  /// n . v, of any scale.
  double facingAt(const glm::ivec3& sample) const
  {
    return -glm::dot(this->Samples.gradientAt(sample),
      this->InSteps.from(glm::dvec3(this->Samples.geometry().first() + sample)));
  }

  GridField<T> Samples;
  IsoOffset<T> Offset;
  Eye InSteps;
  BrickSource<KernelScalar<T>> Source{};
  /// For bricks whose samples all have neighbors; null where that does not do.
  bool (*AllAtOnce)(const BrickSource<KernelScalar<T>>&, BrickView&);
};

} // namespace

template <class T>
GridContours<T>::GridContours(const GridField<T>& field, double isoValue, const CellSelection& selection,
  MinMaxBricks* ranges, const Progress& progress)
  : Samples(field)
  , IsoValue(isoValue)
{
  const std::vector<ActiveCells> cells = findActiveCells(
    field, std::span<const double>(&isoValue, 1), CrossingRule::HalfOpen, selection, progress, ranges);
  if (cells.front().count == 0)
  {
    return;
  }
  this->Bricks = collectBricks(cells.front());
  this->Normals = NormalClusters(
    this->Bricks.size(),
    [this](std::size_t begin, std::size_t end, std::vector<NormalCone::Item>& items)
    {
      for (std::size_t n = begin; n < end; ++n)
      {
        const CellBrick& brick = this->Bricks[n];
        BrickSamples(brick.cells)
          .forEach(
            [&](const glm::ivec3& inBrick)
            {
              const glm::ivec3 sample = brick.first + inBrick;
              items.push_back({ glm::dvec3(this->Samples.geometry().first() + sample),
                -directionOf(this->Samples.gradientAt(sample)) });
            });
      }
    },
    1);
}

template <class T>
Contours GridContours<T>::border(const ContourArrays& arrays) const
{
  return gridBorder(this->Samples, this->IsoValue, this->Bricks, arrays);
}

template <class T>
std::size_t GridContours<T>::searchedBrickCount(const Eye& eye) const
{
  return this->Normals.straddling(eyeInSteps(this->Samples.geometry(), eye)).size();
}

template <class T>
Contours GridContours<T>::find(
  const Eye& eye, const ContourArrays& arrays, const GridContourOptions& options) const
{
  eye.check();
  const GridGeometry& geometry = this->Samples.geometry();
  std::vector<std::uint32_t> bricks;
  if (options.search == SilhouetteSearch::Exhaustive)
  {
    bricks.resize(this->Bricks.size());
    std::iota(bricks.begin(), bricks.end(), 0u);
  }
  else
  {
    bricks = this->Normals.straddling(eyeInSteps(geometry, eye));
  }
  // Otherwise left would be right.
  const bool mirrored = glm::determinant(geometry.stepToWorld()) < 0.0;
  std::vector<ContourLinks> parts((bricks.size() + BricksAtOnce - 1) / BricksAtOnce);
  parallelFor(parts.size(),
    [&](std::size_t part)
    {
      BrickViewer<T> viewer(this->Samples, this->IsoValue, eye);
      BrickView view;
      BrickSegments found;
      std::vector<std::uint32_t> begins(ContourFace::inBrick);
      const std::size_t end = std::min(bricks.size(), (part + 1) * BricksAtOnce);
      for (std::size_t n = part * BricksAtOnce; n < end; ++n)
      {
        const CellBrick& brick = this->Bricks[bricks[n]];
        viewer.look(brick, view);
        findBrickContour(view, brick.cells, mirrored, found);
        parts[part].add(part, geometry, brick, found, begins);
      }
    });
  const BrickViewer<T> viewer(this->Samples, this->IsoValue, eye);
  Contours contours = joinContour(parts, [&](std::uint64_t face) { return viewer.nodeOf(face); });
  ContourProjection projection;
  projection.steps = options.projectionSteps;
  projection.reach = 2.0 * isoSurfaceSampleRadius(geometry);
  describeContours(this->Samples, this->IsoValue, eye, arrays, projection, contours);
  return contours;
}

#define INK_INSTANTIATE(T) template class GridContours<T>;
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
