// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Memory.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInkIsoSurfaceAlgorithm.h"
#include "vtkSmartPointer.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ink::cli
{

class Progress;

/// How the voxels of a file without a header lie in it, x fastest.
struct RawLayout
{
  int dimensions[3];
  int type; ///< as VTK_UNSIGNED_CHAR
  bool bigEndian = false;

  /// From "WxHxD:type", the type being one of uint8, int8, uint16, ... int64, float32, float64.
  /// @throws UsageError
  static RawLayout parse(const std::string& layout);
};

/// What to read.
struct InputOptions
{
  std::filesystem::path file;
  std::optional<RawLayout> raw;             ///< given: the file has no header
  std::array<double, 3> spacing{ 0, 0, 0 }; ///< between voxels; 0: as the file says
  std::string grid;                         ///< of an OpenVDB file; empty: the first that can be read
  std::optional<std::array<double, 6>>
    crop; ///< the part to keep: x, y and z from and to, in world coordinates
  InkMemoryBudget memory = usualMemory();
};

/// What was read.
struct Input
{
  /// vtkImageData with point scalars of one component, or vtkPolyData with points. Null for a volume that is
  /// larger than memory.
  vtkSmartPointer<vtkDataObject> data;
  /// What makes the image of a volume, in parts where it is larger than memory. Null for a mesh, and for a
  /// sparse volume that only surfaces are wanted of.
  vtkSmartPointer<vtkAlgorithm> image;
  /// What samples the surfaces of a volume, a few slices at a time where memory asks for it. Null for a mesh.
  vtkSmartPointer<vtkInkIsoSurfaceAlgorithm> sampler;
  std::string format;
  /// What of the file was not used as it is, each a sentence without its dot.
  std::vector<std::string> notes;
  int components = 1;                 ///< that the file's voxels have
  std::optional<double> surfaceValue; ///< the iso-value that the file is about, if it says one

  bool isVolume() const { return this->sampler != nullptr; }
};

/// What of a volume is needed.
enum class Wanted
{
  Values,
  Surface, ///< that the file is about, or of a value that is chosen by looking at all values
  GivenSurfaces
};

/// Reads a volume or a mesh; which of them, and in which format, the file's name tells. Sparse volumes are
/// left to Input::sampler where surfaces are wanted and nothing else. @throws Failure if it cannot be
/// read whole, with the reason.
Input readInput(const InputOptions& options, Progress& progress, Wanted wanted = Wanted::Values);

/// Where the voxels of a volume lie, without values. Null for a mesh, and for a sparse volume that only
/// surfaces are wanted of.
vtkSmartPointer<vtkImageData> frameOf(const Input& input);

/// @throws Failure for a volume that is no more than a slice, in which nothing lies between voxels
void requireSlices(const Input& input);

/// Where no iso-value is given and the file says one, takes that and notes it.
void takeSurfaceValue(const Input& input, std::vector<double>& isoValues, std::vector<std::string>& notes);

} // namespace ink::cli
