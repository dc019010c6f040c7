// SPDX-License-Identifier: BSD-3-Clause
#include "InkStipplePoints.h"

#include "InkStippleInput.h"

#include "Core/Hash.h"
#include "Core/MortonOrder.h"

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
#include <limits>
#include <sstream>
#include <tuple>

namespace
{

/// Blocks are what lies in cubes of this many elements along an edge and has similar normals and gradients,
/// cut in two where it is very much: large enough that their number is small beside that of the stipples,
/// small enough that they are cut off closely.
constexpr double BlockEdge = 8.0;
constexpr int MostElementsPerBlock = 512;
constexpr double GradientBins = 4.0; // GradientBits of them

/// What separates the random values of elements from other uses of their ids.
constexpr std::uint64_t RandomSeed = 0x5717b1e;

/// Along each axis; ten bits.
constexpr double MortonCells = 1024.0;

/// A position in Morton order.
std::uint64_t MortonCode(const float position[3])
{
  glm::uvec3 cell;
  for (int axis = 0; axis < 3; ++axis)
  {
    // The local frame's box lies within -1/2 .. 1/2.
    cell[axis] =
      static_cast<unsigned int>(std::clamp((position[axis] + 0.5) * MortonCells, 0.0, MortonCells - 1.0));
  }
  return ink::mortonOf(cell);
}

/// A number for each of the 98 directions to the outer cells of a grid of 5^3, the nearest to a direction: so
/// that the axes, along which many things are built, lie in the middle of theirs.
std::uint64_t DirectionBin(const double direction[3])
{
  const double largest = std::max({ std::abs(direction[0]), std::abs(direction[1]), std::abs(direction[2]) });
  std::uint64_t bin = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double share = direction[axis] / largest;
    bin = 5 * bin + static_cast<std::uint64_t>(std::clamp(std::floor(2.5 + 2.0 * share), 0.0, 4.0));
  }
  return bin;
}

/// Groups are 2^3 cubes along each axis, and all gradients.
constexpr int CubeBits = 9;
constexpr int GradientBits = 2;

/// The same for elements that may share a block. In its order, what looks into the same direction comes
/// together, so that what is drawn in a view stands in few runs.
std::uint64_t BlockKey(std::uint64_t cube, std::uint64_t direction, std::uint64_t steepness)
{
  const std::uint64_t group = direction << 32 | cube >> CubeBits;
  return (group << GradientBits | steepness) << CubeBits | (cube & ((1u << CubeBits) - 1));
}

std::uint64_t GroupOf(std::uint64_t blockKey)
{
  return blockKey >> (GradientBits + CubeBits);
}

} // namespace

struct InkStipplePoints::Element
{
  std::uint64_t Block;  ///< the same for elements that may share one
  std::uint64_t Random; ///< of this element alone
  std::uint32_t Code;   ///< along a curve through the data's box
  int Length;
  vtkIdType Id;
  vtkIdType First;

  /// By what elements are, not by where they stand in the input.
  bool operator<(const Element& other) const
  {
    return std::tie(this->Block, this->Code, this->Random, this->Id) <
      std::tie(other.Block, other.Code, other.Random, other.Id);
  }
};

namespace
{

/// Random bits of an element: of its global id where the input has those, else of its first stipple's
/// position. A local id depends on how many processes share the data, and the picture must not.
std::uint64_t FindRandom(const InkStippleInput& input, vtkIdType id, const double firstStipple[3])
{
  if (input.GlobalIds)
  {
    return ink::hash(RandomSeed, static_cast<std::uint64_t>(input.GlobalIds->GetComponent(id, 0)));
  }
  // Adding zero takes the sign from a negative one.
  const auto bits = [&](int axis) { return std::bit_cast<std::uint64_t>(firstStipple[axis] + 0.0); };
  return ink::hash(ink::hash(RandomSeed, bits(0), bits(1)), bits(2));
}

} // namespace

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
      const std::uint64_t code = finite ? MortonCode(local) : 0;
      elements.push_back({ BlockKey(code >> shift, DirectionBin(normal), steepness), FindRandom(input, id, p),
        static_cast<std::uint32_t>(code), static_cast<int>(std::min(length, longest)), id, first });
    }
    first += length;
  }
  std::sort(elements.begin(), elements.end());
  return elements;
}

std::string InkStipplePoints::Read(const InkStippleInput& input)
{
  this->ReleaseArrays();
  this->Blocks.clear();
  double bounds[6];
  InkShiftScale::FindFiniteBounds(input.Data->GetPoints(), bounds);
  this->Frame = InkShiftScale::FromBounds(bounds);
  for (int i = 0; i < 6 && vtkMath::AreBoundsInitialized(bounds); ++i)
  {
    this->LocalBounds[i] = (bounds[i] - this->Frame.Center[i / 2]) / this->Frame.Unit;
  }
  this->Surface = input.Surface;
  this->ElementSize = static_cast<float>(input.ElementSize / this->Frame.Unit);
  vtkCellArray* cells = input.Data->GetVerts();
  const vtkIdType longest = cells->GetMaxCellSize();
  this->Listed = static_cast<float>(
    input.StipplesPerElement > 0.0 ? input.StipplesPerElement : std::max<double>(longest, 1.0));

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
  else if (input.Data->GetNumberOfPoints() > std::numeric_limits<int>::max())
  {
    elements.clear();
    left << "Expected at most 2^31 - 1 stipples, which OpenGL can count, found "
         << input.Data->GetNumberOfPoints() << '.';
  }
  else if (most < longest)
  {
    left << "Of each of the " << count << " elements only the first " << most << " of up to " << longest
         << " stipples are drawn: the numbers of element and stipple have 32 bits together.";
  }
  this->Vertices.reserve(static_cast<std::size_t>(input.Data->GetNumberOfPoints()));
  int group = 0;
  for (std::size_t first = 0, last; first < elements.size(); first = last, ++group)
  {
    last = first + 1;
    while (last < elements.size() && GroupOf(elements[last].Block) == GroupOf(elements[first].Block))
    {
      ++last;
    }
    this->AddGroup(input, &elements[first], static_cast<int>(last - first), group);
  }
  this->NumberOfStipples = static_cast<vtkIdType>(this->Vertices.size());
  this->Order.resize(elements.size());
  std::transform(elements.begin(), elements.end(), this->Order.begin(),
    [](const Element& element) { return static_cast<std::uint32_t>(element.Id); });
  return left.str();
}

std::vector<std::uint32_t> InkStipplePoints::OrderColors(vtkUnsignedCharArray* colors) const
{
  std::vector<std::uint32_t> ordered(this->Order.size());
  for (std::size_t i = 0; i < ordered.size(); ++i)
  {
    std::memcpy(
      &ordered[i], colors->GetPointer(4 * static_cast<vtkIdType>(this->Order[i])), sizeof ordered[i]);
  }
  return ordered;
}

void InkStipplePoints::AddGroup(const InkStippleInput& input, const Element* elements, int count, int group)
{
  const auto firstElement = static_cast<std::uint32_t>(this->Shapes.size());
  const std::size_t firstBlock = this->Blocks.size();
  std::vector<int> ends; // of the blocks, in elements
  int longest = 0;
  for (int first = 0, last; first < count; first = last)
  {
    last = first + 1;
    while (
      last < count && last - first < MostElementsPerBlock && elements[last].Block == elements[first].Block)
    {
      ++last;
    }
    this->Blocks.push_back(this->ReadBlock(input, elements + first, last - first));
    this->Blocks.back().Group = group;
    ends.push_back(last);
    longest = std::max(longest, static_cast<int>(this->Blocks.back().Runs.size()));
  }
  for (int rank = 0; rank < longest; ++rank)
  {
    int i = 0;
    for (std::size_t b = 0; b < ends.size(); ++b)
    {
      InkStippleBlock& block = this->Blocks[firstBlock + b];
      if (rank >= static_cast<int>(block.Runs.size()))
      {
        i = ends[b];
        continue;
      }
      const std::size_t start = this->Vertices.size();
      for (; i < ends[b]; ++i)
      {
        if (rank < elements[i].Length)
        {
          this->AddStipple(
            input, elements[i].First + rank, firstElement + static_cast<std::uint32_t>(i), rank, block);
        }
      }
      block.Runs[rank] = { static_cast<int>(start), static_cast<int>(this->Vertices.size() - start) };
    }
  }
}

InkStippleBlock InkStipplePoints::ReadBlock(const InkStippleInput& input, const Element* elements, int count)
{
  InkStippleBlock block;
  block.Low.fill(INFINITY);
  block.High.fill(-INFINITY);
  const std::size_t firstElement = this->Shapes.size();
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
    this->Values.push_back({ value, static_cast<float>(element.Length) });
    this->ElementIds.push_back({ static_cast<std::uint32_t>(element.First),
      static_cast<std::uint32_t>(ink::unitFloat(element.Random) * 0x1p24f) });
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
    block.LeastCosine = static_cast<float>(least);
  }
  block.Runs.resize(longest);
  return block;
}

void InkStipplePoints::AddStipple(
  const InkStippleInput& input, vtkIdType point, std::uint32_t element, int rank, InkStippleBlock& block)
{
  double p[3];
  input.Data->GetPoint(point, p);
  Vertex vertex;
  this->Frame.ToLocal(p, vertex.Position);
  if (!std::isfinite(vertex.Position[0]) || !std::isfinite(vertex.Position[1]) ||
    !std::isfinite(vertex.Position[2]))
  {
    return;
  }
  vertex.ElementAndRank =
    (this->RankBits < 32 ? element << this->RankBits : 0u) | static_cast<std::uint32_t>(rank);
  this->Vertices.push_back(vertex);
  for (int axis = 0; axis < 3; ++axis)
  {
    block.Low[axis] = std::min(block.Low[axis], vertex.Position[axis]);
    block.High[axis] = std::max(block.High[axis], vertex.Position[axis]);
  }
}

void InkStipplePoints::ReleaseArrays()
{
  this->Vertices = {};
  this->Shapes = {};
  this->Values = {};
  this->ElementIds = {};
}
