// SPDX-License-Identifier: BSD-3-Clause
#include "IsoSurface/CutSamples.h"

#include "Core/OtherAxes.h"
#include "Core/ParallelFor.h"
#include "Fields/Grid/GridField.h"
#include "Fields/Resampling/TileResampler.h"
#include "Fields/ScalarDifference.h"
#include "IsoSurface/ResampledSampler.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace ink
{
namespace
{

/// Half of a difference.
double half(double from, double to)
{
  return to / 2 - from / 2;
}

/// The values at the corners (0, 0), (1, 0), (1, 1) and (0, 1) of a face, bilinear in between.
struct Face
{
  double values[4];

  double at(const glm::dvec2& p) const
  {
    return glm::mix(
      glm::mix(this->values[0], this->values[1], p.x), glm::mix(this->values[3], this->values[2], p.x), p.y);
  }
  /// Half of it, as differences of large values may overflow.
  glm::dvec2 halfGradient(const glm::dvec2& p) const
  {
    const auto& v = this->values;
    return { glm::mix(half(v[0], v[1]), half(v[3], v[2]), p.y),
      glm::mix(half(v[0], v[3]), half(v[1], v[2]), p.x) };
  }
};

/// The mean of the surface's intersections with a face's edges, if it crosses them.
std::optional<glm::dvec2> meanCrossing(const Face& face, double isoValue)
{
  constexpr glm::dvec2 corners[4] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
  glm::dvec2 sum(0.0);
  int crossings = 0;
  for (int n = 0; n < 4; ++n)
  {
    const int next = (n + 1) % 4;
    const double here = face.values[n];
    const double there = face.values[next];
    if ((here < isoValue) != (there < isoValue))
    {
      sum += glm::mix(corners[n], corners[next], half(here, isoValue) / half(here, there));
      ++crossings;
    }
  }
  return crossings > 0 ? std::optional(sum / static_cast<double>(crossings)) : std::nullopt;
}

/// The global indices of the whole volume's first and last sample.
struct VolumeEnds
{
  glm::ivec3 first;
  glm::ivec3 last;
};

/// A side of the volume, and the axes along it.
struct CutSide
{
  CutSide(int across, bool isUpper)
    : axis(across)
    , u(otherAxes(across)[0])
    , v(otherAxes(across)[1])
    , upper(isUpper)
  {
  }
  int axis;
  int u;
  int v;
  bool upper;
};

/// Samples the faces on one side of the volume.
template <class T>
class SideSampler
{
public:
  SideSampler(const GridField<T>& field, double isoValue, CutSurface kind, const VolumeEnds& ends,
    const CutSide& side, CutSamples& samples)
    : Field(field)
    , IsoValue(isoValue)
    , Kind(kind)
    , Ends(ends)
    , Axis(side.axis)
    , U(side.u)
    , V(side.v)
    , Upper(side.upper)
    , Samples(samples)
  {
    this->Normal = this->normalOf(side.axis, side.upper);
  }

  bool hasFace(const glm::ivec3& cell, int layer) const { return this->faceOf(cell, layer).has_value(); }

  /// @param layer the index of the side's samples along its axis
  void sampleFace(const glm::ivec3& cell, int layer)
  {
    const std::optional<Face> face = this->faceOf(cell, layer);
    // NaN is on no side.
    if (!face || std::isnan(this->IsoValue))
    {
      return;
    }
    const ActiveCellId own = activeCellId(this->Field.geometry().first() + cell);
    if (const auto crossing = meanCrossing(*face, this->IsoValue))
    {
      this->addRim(cell, layer, *face, *crossing, own);
    }
    else if (this->Kind == CutSurface::Cap && face->values[0] >= this->IsoValue)
    {
      this->add(this->toWorld(cell, layer, glm::dvec2(0.5)), this->Normal, own);
    }
    if (this->Kind == CutSurface::Cap)
    {
      this->addEdges(cell, layer, *face, own);
    }
  }

private:
  /// Out of the volume.
  glm::dvec3 normalOf(int axis, bool upper) const
  {
    glm::dvec3 outwards(0.0);
    outwards[axis] = upper ? 1.0 : -1.0;
    return glm::normalize(this->Field.geometry().gradientDirection() * outwards);
  }

  /// The face of a cell with that index along the axis; nothing if a corner is missing.
  std::optional<Face> faceOf(const glm::ivec3& cell, int layer) const
  {
    Face face = {};
    for (int n = 0; n < 4; ++n)
    {
      glm::ivec3 sample = cell;
      sample[this->Axis] = layer;
      sample[this->U] += n == 1 || n == 2;
      sample[this->V] += n >= 2;
      if (!this->Field.has(sample))
      {
        return std::nullopt;
      }
      face.values[n] = static_cast<double>(this->Field.at(sample));
    }
    return face;
  }

  void addRim(
    const glm::ivec3& cell, int layer, const Face& face, const glm::dvec2& position, ActiveCellId own)
  {
    const glm::dvec2 gradient = face.halfGradient(position);
    glm::dvec3 downwards(0.0);
    downwards[this->U] = -gradient.x;
    downwards[this->V] = -gradient.y;
    if (const auto inner = this->faceOf(cell, this->Upper ? layer - 1 : layer + 1))
    {
      const double step = half(inner->at(position), face.at(position));
      downwards[this->Axis] = this->Upper ? -step : step;
    }
    // Scaled first, as squares of large values may overflow.
    const double largest =
      std::max({ std::abs(downwards.x), std::abs(downwards.y), std::abs(downwards.z), 1e-300 });
    const glm::dvec3 along = this->Field.geometry().gradientDirection() * (downwards / largest);
    const double length = glm::length(along);
    const glm::dvec3 surface = length > 0.0 ? along / length : this->Normal;
    const glm::dvec3 across = this->Normal - glm::dot(this->Normal, surface) * surface;
    const double apart = glm::length(across);
    // A surface along the side has no edge with it.
    constexpr double leastApart = 1e-6;
    constexpr double turn = 3.14159265358979323846 / (rimNormals - 1);
    for (int n = 1; n <= rimNormals && apart > leastApart; ++n)
    {
      const glm::dvec3 normal = std::cos(n * turn) * surface + std::sin(n * turn) / apart * across;
      this->add(this->toWorld(cell, layer, position), normal, own);
    }
  }

  /// Where this cap meets those of the sides across later axes.
  void addEdges(const glm::ivec3& cell, int layer, const Face& face, ActiveCellId own)
  {
    const auto addEdge = [&](int across, bool upper, int one, int other, const glm::dvec2& middle)
    {
      const int sample = this->Field.geometry().first()[across] + cell[across] + (upper ? 1 : 0);
      if (across > this->Axis && sample == (upper ? this->Ends.last : this->Ends.first)[across] &&
        face.values[one] >= this->IsoValue && face.values[other] >= this->IsoValue)
      {
        this->addFan(this->toWorld(cell, layer, middle), this->normalOf(across, upper), own);
      }
    };
    addEdge(this->U, false, 0, 3, { 0.0, 0.5 });
    addEdge(this->U, true, 1, 2, { 1.0, 0.5 });
    addEdge(this->V, false, 0, 1, { 0.5, 0.0 });
    addEdge(this->V, true, 2, 3, { 0.5, 1.0 });
  }

  /// Samples whose normals turn from the side's to another one's.
  void addFan(const glm::dvec3& point, const glm::dvec3& other, ActiveCellId own)
  {
    const double cosine = glm::dot(this->Normal, other);
    const glm::dvec3 across = glm::normalize(other - cosine * this->Normal);
    const double turn = std::acos(cosine) / (capEdgeNormals - 1);
    for (int n = 0; n < capEdgeNormals; ++n)
    {
      this->add(point, std::cos(n * turn) * this->Normal + std::sin(n * turn) * across, own);
    }
  }

  /// Not relative to the grid's own first sample, which differs between pieces.
  glm::dvec3 toWorld(const glm::ivec3& cell, int layer, const glm::dvec2& position) const
  {
    const GridGeometry& geometry = this->Field.geometry();
    glm::ivec3 corner = cell;
    corner[this->Axis] = layer;
    glm::dvec3 index(geometry.first() + corner);
    index[this->U] += position.x;
    index[this->V] += position.y;
    return geometry.origin() + geometry.stepToWorld() * index;
  }

  void add(const glm::dvec3& point, const glm::dvec3& normal, ActiveCellId cell)
  {
    this->Samples.points.push_back(point);
    this->Samples.normals.push_back(normal);
    this->Samples.cells.push_back(cell);
  }

  const GridField<T>& Field;
  double IsoValue;
  CutSurface Kind;
  const VolumeEnds& Ends; ///< of the field's own indices
  int Axis;
  int U; ///< the side's own axes
  int V;
  bool Upper;
  glm::dvec3 Normal;
  CutSamples& Samples;
};

/// Some of the cells on a side.
struct CutStrip
{
  CutSide side;
  int layer; ///< the index of the side's samples along its axis
  int begin; ///< the first cell along the side's second axis
  int end;   ///< after the last one
};

/// Calls work with each selected cell of a strip.
template <class Work>
void forEachCell(
  const GridGeometry& geometry, const CellSelection& selection, const CutStrip& strip, const Work& work)
{
  const CutSide& side = strip.side;
  const GridGeometry cells(glm::max(geometry.dimensions() - 1, glm::ivec3(0)));
  const glm::ivec3 begin = glm::max(selection.begin, glm::ivec3(0));
  const glm::ivec3 end = glm::min(selection.end, geometry.dimensions() - 1);
  glm::ivec3 cell(0);
  cell[side.axis] = side.upper ? strip.layer - 1 : strip.layer;
  if (cell[side.axis] < begin[side.axis] || cell[side.axis] >= end[side.axis])
  {
    return;
  }
  for (cell[side.v] = std::max(begin[side.v], strip.begin); cell[side.v] < std::min(end[side.v], strip.end);
       ++cell[side.v])
  {
    for (cell[side.u] = begin[side.u]; cell[side.u] < end[side.u]; ++cell[side.u])
    {
      if (selection.skipped.empty() || !selection.skipped[cells.offset(cell)])
      {
        work(cell);
      }
    }
  }
}

/// What all strips are sampled by, see sampleCut.
template <class T>
struct CutRequest
{
  const GridField<T>& field;
  double isoValue;
  CutSurface kind;
  VolumeEnds ends;
  const CellSelection& selection;
  const IsoSurfaceResampling& resampling;
  GridResampling ofSurface; ///< the kernels of the resampling
};

/// Samples the side's own faces.
template <class T>
void sampleFaces(const CutRequest<T>& request, const CutStrip& strip, CutSamples& samples)
{
  SideSampler sampler(request.field, request.isoValue, request.kind, request.ends, strip.side, samples);
  forEachCell(request.field.geometry(), request.selection, strip,
    [&](const glm::ivec3& cell) { sampler.sampleFace(cell, strip.layer); });
}

/// Samples faces of the resampled grid.
template <class T>
void sampleResampledFaces(const CutRequest<T>& request, const CutStrip& strip, CutSamples& samples)
{
  // So that no difference overflows; a power of two rounds nothing.
  constexpr double scale = 1.0 / 256.0;
  const CutSide& side = strip.side;
  const GridGeometry& own = request.field.geometry();
  const glm::ivec3& parts = request.resampling.subdivision;
  const GridResampling& ofSurface = request.ofSurface;
  const GridGeometry all = resampledGeometry(own, parts);
  // The side's positions, and those next to them.
  SampleBox box{ glm::ivec3(0), all.dimensions() };
  box.begin[side.axis] = strip.layer * parts[side.axis] - (side.upper ? 1 : 0);
  box.end[side.axis] = box.begin[side.axis] + 2;
  box.begin[side.v] = strip.begin * parts[side.v];
  box.end[side.v] = strip.end * parts[side.v] + 1;
  const int around = std::max({ ofSurface[0].reach(), ofSurface[1].reach(), ofSurface[2].reach() });
  TileResampler<double> resampler;
  resampler.read(request.field, box, parts, glm::ivec3(around));
  if (!(resampler.greatest() >= resampler.least()))
  {
    return;
  }
  double isoValueHere = scale * request.isoValue;
  if (request.resampling.ofMask)
  {
    resampler.makeMask(request.isoValue);
    isoValueHere = maskIsoValue;
  }
  else
  {
    resampler.scale(scale);
  }
  std::vector<double> values;
  resampler.resample(ofSurface, box, values);
  const GridField<double> fine(
    GridGeometry(box.size(), all.origin(), all.spacing(), all.direction(), all.first() + box.begin), values);
  const SideSampler ownFaces(request.field, request.isoValue, request.kind, request.ends, side, samples);
  const VolumeEnds ends{ request.ends.first * parts, request.ends.last * parts };
  SideSampler faces(fine, isoValueHere, request.kind, ends, side, samples);
  forEachCell(own, request.selection, strip,
    [&](const glm::ivec3& cell)
    {
      if (!ownFaces.hasFace(cell, strip.layer))
      {
        return;
      }
      glm::ivec3 part = cell * parts - box.begin;
      part[side.axis] = 0;
      const glm::ivec3 first = part;
      for (part[side.v] = first[side.v]; part[side.v] < first[side.v] + parts[side.v]; ++part[side.v])
      {
        for (part[side.u] = first[side.u]; part[side.u] < first[side.u] + parts[side.u]; ++part[side.u])
        {
          faces.sampleFace(part, side.upper ? 1 : 0);
        }
      }
    });
}

/// All of the volume's sides that a grid has.
std::vector<CutStrip> cutStrips(const GridGeometry& geometry, const glm::ivec3& first, const glm::ivec3& last)
{
  constexpr int stripCells = 32;
  const glm::ivec3& dimensions = geometry.dimensions();
  std::vector<CutStrip> strips;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const bool upper : { false, true })
    {
      const CutSide side(axis, upper);
      const int layer = (upper ? last : first)[axis] - geometry.first()[axis];
      if (layer < (upper ? 1 : 0) || layer >= dimensions[axis] - (upper ? 0 : 1))
      {
        continue;
      }
      const int cells = dimensions[side.v] - 1;
      for (int begin = 0; begin < cells; begin += stripCells)
      {
        strips.push_back({ side, layer, begin, std::min(begin + stripCells, cells) });
      }
    }
  }
  return strips;
}

} // namespace

template <class T>
CutSamples sampleCut(const GridField<T>& field, double isoValue, CutSurface kind, const glm::ivec3& first,
  const glm::ivec3& last, const CellSelection& selection, const IsoSurfaceResampling& resampling)
{
  CutSamples all;
  const glm::ivec3& dimensions = field.geometry().dimensions();
  if (kind == CutSurface::Open || std::min({ dimensions.x, dimensions.y, dimensions.z }) < 2)
  {
    return all;
  }
  const std::vector<CutStrip> strips = cutStrips(field.geometry(), first, last);
  if (resampling.slices && !strips.empty())
  {
    const std::vector<float> distances =
      sliceDistances(field, isoValue, resampling.ofMask, *resampling.slices);
    return sampleCut(GridField<float>(field.geometry(), distances), 0.0, kind, first, last, selection,
      resampling.ofDistances());
  }
  const CutRequest<T> request{ field, isoValue, kind, { first, last }, selection, resampling,
    resamplingOfSurface(resampling, dimensions) };
  std::vector<CutSamples> samples(strips.size());
  parallelFor(strips.size(),
    [&](std::size_t i)
    {
      if (resampling.isIdentity())
      {
        sampleFaces(request, strips[i], samples[i]);
      }
      else
      {
        sampleResampledFaces(request, strips[i], samples[i]);
      }
    });
  for (const CutSamples& some : samples)
  {
    all.points.insert(all.points.end(), some.points.begin(), some.points.end());
    all.normals.insert(all.normals.end(), some.normals.begin(), some.normals.end());
    all.cells.insert(all.cells.end(), some.cells.begin(), some.cells.end());
  }
  return all;
}

#define INK_INSTANTIATE(T)                                                                                   \
  template CutSamples sampleCut(const GridField<T>&, double, CutSurface, const glm::ivec3&,                  \
    const glm::ivec3&, const CellSelection&, const IsoSurfaceResampling&);
INK_FOR_EACH_SCALAR(INK_INSTANTIATE)
#undef INK_INSTANTIATE

} // namespace ink
