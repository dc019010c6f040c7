// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkImageSlabs_h
#define InkImageSlabs_h

#include "InkMemoryBudget.h"
#include "vtkInkFiltersSamplingModule.h" // for the export macro

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cstdint>
#include <string>

class vtkAlgorithm;
class vtkAlgorithmOutput;
class vtkInformation;

/// The slices along z of an image that an algorithm makes, a few at a time: those that are needed are asked
/// for, by update extents, where memory has no room for all. What is taken of it is a point array of one
/// component, as its scalars, with the marks of ghosts; of an image that has values in its cells alone, that
/// of their centers.
class VTKINKFILTERSSAMPLING_EXPORT InkImageSlabs
{
public:
  /// @param port of the algorithm, which delivers the extent that it is asked for, or all of the image
  /// @param array the name of the point array; empty: the active scalars
  /// @throws std::runtime_error if there is no such array, or if memory is not enough for a few slices
  InkImageSlabs(vtkAlgorithmOutput* port, const InkMemoryBudget& budget, const std::string& array = {});
  ~InkImageSlabs();
  InkImageSlabs(const InkImageSlabs&) = delete;
  void operator=(const InkImageSlabs&) = delete;

  /// The number of slices that are needed at a time: two that a layer of cells lies between, and one on
  /// either side for gradients.
  static constexpr int FewestAtOnce = 4;

  /// How many bytes an array of an image takes, of which nothing but this information has been made, with so
  /// many for each voxel beside its values.
  static std::uint64_t GetBytes(vtkInformation* info, const std::string& array = {}, int bytesBeside = 0);

  /// Where the voxels lie: extent, origin, spacing and direction, without values.
  vtkImageData* GetFrame() const { return this->Frame; }
  const std::array<int, 3>& GetDimensions() const { return this->Dimensions; }
  int GetScalarType() const { return this->ScalarType; } ///< as VTK_UNSIGNED_CHAR
  std::uint64_t GetBytes() const;

  /// How many slices can be had at a time.
  int GetAtOnce() const { return this->AtOnce; }
  /// How many can be worked with at a time, with so many bytes for each voxel beside its value.
  int GetAtOnce(int bytesBeside) const;
  /// The limit of memory with which so many can.
  std::uint64_t GetMemoryFor(int slices, int bytesBeside = 0) const;
  bool IsWhole() const { return this->AtOnce == this->Dimensions[2]; }

  /// Slices from `first` up to, but without, `end`, counted from 0, as a part of the whole image. It shows
  /// memory that the next call may reuse, but for slices that were there already.
  /// @throws std::runtime_error if the algorithm does not make them, which then has reported why
  vtkSmartPointer<vtkImageData> Get(int first, int end);

private:
  std::uint64_t GetSliceBytes() const;
  std::uint64_t GetBytesAtOnce(int slices, int bytesBeside = 0) const;
  vtkSmartPointer<vtkImageData> Make(const int wanted[6]);
  void Load(int first, int end);

  vtkSmartPointer<vtkAlgorithm> Producer;
  int Port;
  std::string Array;
  InkMemoryBudget Budget;
  vtkSmartPointer<vtkImageData> Frame;
  std::array<int, 3> Dimensions;
  int ScalarType;
  int AtOnce;
  bool OfCells = false;

  /// Slices LoadedFirst to LoadedEnd - 1.
  unsigned char* Values = nullptr;
  vtkSmartPointer<vtkImageData> Loaded;
  int LoadedFirst = 0;
  int LoadedEnd = 0;
};

#endif
