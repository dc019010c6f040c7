// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStipplePoints_h
#define InkStipplePoints_h

#include "InkShiftScale.h"
#include "InkStippleBlocks.h"

#include "vtkType.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

struct InkStippleInput;
class vtkUnsignedCharArray;

/// Stipples and elements in the form that the shader reads, in blocks of elements that lie close together.
class InkStipplePoints
{
public:
  /// 16 bytes a stipple.
  struct Vertex
  {
    float Position[3];            ///< in the local frame
    std::uint32_t ElementAndRank; ///< the rank in the lowest bits
  };
  static_assert(sizeof(Vertex) == 16);
  struct Shape
  {
    float Normal[3];
    float GradientMagnitude;
  };
  struct Value
  {
    float Value;
    float Length; ///< of the element's list
  };
  struct Ids
  {
    std::uint32_t First;  ///< the id of the element's first point in the input
    std::uint32_t Random; ///< 24 bits
  };

  /// Reads input without problems. Elements without a finite normal, gradient magnitude or value, or whose
  /// normal is zero, and points whose position is not finite are passed over.
  /// @return what had to be left out because ids have 32 bits, for the user; empty if nothing
  std::string Read(const InkStippleInput& input);

  /// RGBA of each element of the input, in the order of the elements here.
  std::vector<std::uint32_t> OrderColors(vtkUnsignedCharArray* colors) const;

  /// Frees what only the GPU needs.
  void ReleaseArrays();

  const InkShiftScale& GetFrame() const { return this->Frame; }
  const std::array<double, 6>& GetLocalBounds() const { return this->LocalBounds; }
  bool IsSurface() const { return this->Surface; }
  float GetElementSize() const { return this->ElementSize; } ///< in the frame's unit
  float GetListed() const { return this->Listed; }           ///< N_max of the lists
  int GetRankBits() const { return this->RankBits; }
  vtkIdType GetNumberOfStipples() const { return this->NumberOfStipples; }
  const std::vector<InkStippleBlock>& GetBlocks() const { return this->Blocks; }

  const std::vector<Vertex>& GetVertices() const { return this->Vertices; }
  const std::vector<Shape>& GetShapes() const { return this->Shapes; }
  const std::vector<Value>& GetValues() const { return this->Values; }
  const std::vector<Ids>& GetIds() const { return this->ElementIds; }

private:
  struct Element;
  std::vector<Element> ReadElements(const InkStippleInput& input, vtkIdType longest);
  void AddGroup(const InkStippleInput& input, const Element* elements, int count, int group);
  /// Adds what the elements of a block are and finds the block's cone and limits.
  InkStippleBlock ReadBlock(const InkStippleInput& input, const Element* elements, int count);
  void AddStipple(
    const InkStippleInput& input, vtkIdType point, std::uint32_t element, int rank, InkStippleBlock& block);

  InkShiftScale Frame;
  std::array<double, 6> LocalBounds{};
  bool Surface = false;
  float ElementSize = 0.0f;
  float Listed = 1.0f;
  int RankBits = 0;
  vtkIdType NumberOfStipples = 0;
  std::vector<InkStippleBlock> Blocks;
  std::vector<Vertex> Vertices;
  std::vector<Shape> Shapes;
  std::vector<Value> Values;
  std::vector<Ids> ElementIds;
  std::vector<std::uint32_t> Order; ///< the elements' ids in the input
};

#endif
