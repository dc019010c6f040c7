// SPDX-License-Identifier: BSD-3-Clause
#include "InkStipplePoints.h"

#include "InkStippleInput.h"

#include "Sampling/Hash.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <sstream>

namespace
{

/// Blocks are what lies in cubes of this many elements along an edge and has similar normals and gradients,
/// cut in two where it is very much: large enough that their number is small beside that of the stipples,
/// small enough that they are cut off closely.
constexpr double BlockEdge = 16.0;
constexpr std::size_t MostElementsPerBlock = 512;
constexpr double GradientBins = 4.0;

/// What separates the random values of elements from other uses of their ids.
constexpr std::uint64_t RandomSeed = 0x5717b1e;

/// Along each axis; ten bits.
constexpr double MortonCells = 1024.0;

/// Places along a curve that keeps close together what is close: the bits of x, y and z in turn.
std::uint64_t MortonCode(const float position[3])
{
  std::uint64_t code = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    // The local frame's box lies within -1/2 .. 1/2.
    const double place = std::clamp((position[axis] + 0.5) * MortonCells, 0.0, MortonCells - 1.0);
    auto bits = static_cast<std::uint64_t>(place);
    for (int i = 0; i < 10; ++i, bits >>= 1)
    {
      code |= (bits & 1u) << (3 * i + axis);
    }
  }
  return code;
}

/// A number for each of the 26 directions to the neighbours in a grid, the nearest to a direction: so that
/// the axes, along which many things are built, lie in the middle of theirs.
std::uint64_t DirectionBin(const double direction[3])
{
  const double largest = std::max({ std::abs(direction[0]), std::abs(direction[1]), std::abs(direction[2]) });
  std::uint64_t bin = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double share = direction[axis] / largest;
    bin = 3 * bin + (share < -0.5 ? 0 : share > 0.5 ? 2 : 1);
  }
  return bin;
}

} // namespace

struct InkStipplePoints::Element
{
  std::uint64_t Block; ///< the same for elements that may share one
  vtkIdType Id;
  vtkIdType First;
  int Length;
};

std::vector<InkStipplePoints::Element> InkStipplePoints::ReadElements(
  const InkStippleInput& input, vtkIdType longest)
{
  // A cube of 2^k cells of the curve along an edge is what has all but the lowest 3 k bits in common.
  const double edge = std::clamp(BlockEdge * this->ElementSize * MortonCells, 1.0, MortonCells);
  const int shift = 3 * static_cast<int>(std::lround(std::log2(edge)));
  vtkCellArray* cells = input.Data->GetVerts();
  std::vector<Element> elements;
  elements.reserve(cells->GetNumberOfCells());
  vtkIdType first = 0;
  for (vtkIdType id = 0; id < cells->GetNumberOfCells(); ++id)
  {
    const vtkIdType length = cells->GetCellSize(id);
    double normal[3];
    input.Normals->GetTuple(id, normal);
    const double norm = vtkMath::Norm(normal);
    const bool usable = length > 0 && norm > 0.0 && std::isfinite(norm) &&
      (input.Surface ||
        (std::isfinite(input.GradientMagnitudes->GetComponent(id, 0)) &&
          std::isfinite(input.Values->GetComponent(id, 0))));
    if (usable)
    {
      double p[3];
      float local[3];
      input.Data->GetPoint(first, p);
      this->Frame.ToLocal(p, local);
      const bool finite = std::isfinite(local[0]) && std::isfinite(local[1]) && std::isfinite(local[2]);
      const double gradient =
        input.Surface ? 1.0 : std::clamp(input.GradientMagnitudes->GetComponent(id, 0), 0.0, 1.0);
      const auto steepness =
        static_cast<std::uint64_t>(std::min(gradient * GradientBins, GradientBins - 1.0));
      const std::uint64_t cube = finite ? MortonCode(local) >> shift : 0;
      elements.push_back({ (cube << 5 | DirectionBin(normal)) << 2 | steepness, id, first,
        static_cast<int>(std::min(length, longest)) });
    }
    first += length;
  }
  std::sort(elements.begin(), elements.end(),
    [](const Element& a, const Element& b) { return a.Block != b.Block ? a.Block < b.Block : a.Id < b.Id; });
  return elements;
}

std::string InkStipplePoints::Read(const InkStippleInput& input, vtkUnsignedCharArray* colors)
{
  this->ReleaseArrays();
  this->Blocks.clear();
  double bounds[6];
  InkLocalFrame::FindFiniteBounds(input.Data->GetPoints(), bounds);
  this->Frame = InkLocalFrame::FromBounds(bounds);
  for (int i = 0; i < 6 && vtkMath::AreBoundsInitialized(bounds); ++i)
  {
    this->LocalBounds[i] = (bounds[i] - this->Frame.Center[i / 2]) / this->Frame.Unit;
  }
  this->Surface = input.Surface;
  this->ElementSize = static_cast<float>(input.ElementSize / this->Frame.Unit);
  vtkCellArray* cells = input.Data->GetVerts();
  const vtkIdType longest = cells->GetMaxCellSize();
  this->Listed = static_cast<float>(input.StipplesPerElement > 0.0 && std::isfinite(input.StipplesPerElement)
      ? input.StipplesPerElement
      : std::max<double>(longest, 1.0));

  // As many bits for the rank as the elements' numbers leave.
  const auto count = static_cast<std::uint64_t>(cells->GetNumberOfCells());
  const int elementBits = static_cast<int>(std::bit_width(count > 0 ? count - 1 : 0));
  const int wantedBits =
    static_cast<int>(std::bit_width(static_cast<std::uint64_t>(std::max<vtkIdType>(longest - 1, 0))));
  this->RankBits = std::min(wantedBits, std::max(32 - elementBits, 0));
  const vtkIdType most = vtkIdType(1) << this->RankBits;

  std::vector<Element> elements = this->ReadElements(input, most);
  std::ostringstream left;
  if (elementBits > 32)
  {
    elements.clear();
    left << "Expected at most 2^32 elements, found " << count << '.';
  }
  else if (most < longest)
  {
    left << "Of each of the " << count << " elements only the first " << most << " of up to " << longest
         << " stipples are drawn: the numbers of element and stipple have 32 bits together.";
  }
  this->Vertices.reserve(static_cast<std::size_t>(input.Data->GetNumberOfPoints()));
  for (std::size_t first = 0, last; first < elements.size(); first = last)
  {
    last = first + 1;
    while (last < elements.size() && last - first < MostElementsPerBlock &&
      elements[last].Block == elements[first].Block)
    {
      ++last;
    }
    this->AddBlock(input, &elements[first], static_cast<int>(last - first));
  }
  this->NumberOfStipples = static_cast<vtkIdType>(this->Vertices.size());
  if (colors)
  {
    for (const Element& element : elements)
    {
      std::uint32_t color;
      std::memcpy(&color, colors->GetPointer(4 * element.Id), sizeof color);
      this->Colors.push_back(color);
    }
  }
  return left.str();
}

void InkStipplePoints::AddBlock(const InkStippleInput& input, const Element* elements, int count)
{
  InkStippleBlock block;
  block.Low.fill(INFINITY);
  block.High.fill(-INFINITY);
  block.First = static_cast<int>(this->Vertices.size());
  const auto firstElement = static_cast<std::uint32_t>(this->Shapes.size());
  int longest = 0;
  double mean[3] = { 0.0, 0.0, 0.0 };
  for (int i = 0; i < count; ++i)
  {
    const Element& element = elements[i];
    double normal[3];
    input.Normals->GetTuple(element.Id, normal);
    vtkMath::Normalize(normal);
    vtkMath::Add(mean, normal, mean);
    const auto limited = [&](vtkDataArray* array)
    { return array ? static_cast<float>(std::clamp(array->GetComponent(element.Id, 0), 0.0, 1.0)) : 1.0f; };
    const float gradient = this->Surface ? 1.0f : limited(input.GradientMagnitudes);
    const float value = this->Surface ? 1.0f : limited(input.Values);
    this->Shapes.push_back(
      { { static_cast<float>(normal[0]), static_cast<float>(normal[1]), static_cast<float>(normal[2]) },
        gradient });
    const auto bits = ink::hash(RandomSeed, static_cast<std::uint64_t>(element.Id));
    this->Values.push_back({ value, ink::unitFloat(bits) });
    this->Lists.push_back(
      { static_cast<std::uint32_t>(element.First), static_cast<std::uint32_t>(element.Length) });
    block.LargestValue = std::max(block.LargestValue, value);
    block.LargestGradient = std::max(block.LargestGradient, gradient);
    longest = std::max(longest, element.Length);
  }
  if (vtkMath::Normalize(mean) > 0.0)
  {
    double least = 1.0;
    for (std::size_t e = firstElement; e < this->Shapes.size(); ++e)
    {
      const float* normal = this->Shapes[e].Normal;
      least = std::min(least, mean[0] * normal[0] + mean[1] * normal[1] + mean[2] * normal[2]);
    }
    std::copy_n(mean, 3, block.Axis.begin());
    block.Spread = static_cast<float>(std::acos(std::clamp(least, -1.0, 1.0)));
  }
  for (int rank = 0; rank < longest; ++rank)
  {
    for (int i = 0; i < count; ++i)
    {
      if (rank >= elements[i].Length)
      {
        continue;
      }
      double p[3];
      input.Data->GetPoint(elements[i].First + rank, p);
      Vertex vertex;
      this->Frame.ToLocal(p, vertex.Position);
      if (!std::isfinite(vertex.Position[0]) || !std::isfinite(vertex.Position[1]) ||
        !std::isfinite(vertex.Position[2]))
      {
        continue;
      }
      vertex.ElementAndRank =
        (this->RankBits < 32 ? (firstElement + static_cast<std::uint32_t>(i)) << this->RankBits : 0u) |
        static_cast<std::uint32_t>(rank);
      this->Vertices.push_back(vertex);
      for (int axis = 0; axis < 3; ++axis)
      {
        block.Low[axis] = std::min(block.Low[axis], vertex.Position[axis]);
        block.High[axis] = std::max(block.High[axis], vertex.Position[axis]);
      }
    }
    block.Ends.push_back(static_cast<int>(this->Vertices.size()) - block.First);
  }
  if (!block.Ends.empty() && block.Ends.back() > 0)
  {
    this->Blocks.push_back(std::move(block));
  }
}

void InkStipplePoints::ReleaseArrays()
{
  this->Vertices = {};
  this->Shapes = {};
  this->Values = {};
  this->Lists = {};
  this->Colors = {};
}
