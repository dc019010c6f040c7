// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkImageVoxels_h
#define InkImageVoxels_h

#include "Core/Progress.h"
#include "Curves/Contours/SilhouetteVoxels.h"
#include "Fields/SampleBox.h"

#include "vtkDataArray.h"
#include "vtkSmartPointer.h"

#include <glm/vec3.hpp>

class vtkAlgorithm;
class vtkImageData;
class vtkInformationVector;

/// The image that edge voxels are looked for in, and the part of it that the requested piece owns.
struct InkVoxelInput
{
  vtkImageData* Image = nullptr;
  vtkDataArray* Array = nullptr;         ///< of its points
  vtkSmartPointer<vtkDataArray> Scalars; ///< the same, contiguous
  int Component = 0;                     ///< of these
  ink::SampleBox Own;

  /// The filter's first input; without Scalars if it has none or too few, which was reported then.
  /// @param found, association from GetInputArrayToProcess
  static InkVoxelInput Take(vtkAlgorithm* filter, vtkDataArray* found, int association,
    vtkInformationVector** input, vtkInformationVector* output, int component);
};

/// Edge voxels of the piece (Lu et al. 2003, section 5.6).
/// @param scale deviation of the Gaussian, in samples
/// @param leastMagnitude of the gradient, in value per world unit
/// @param progress when it asks to stop, there are none
/// @throws std::invalid_argument as InkMakeGrid
ink::EdgeVoxels InkFindEdgeVoxels(
  const InkVoxelInput& input, double scale, double leastMagnitude, const ink::Progress& progress);

/// Silhouette voxels of the piece for one eye, by the exhaustive search that edge voxels replace.
/// @throws std::invalid_argument as InkMakeGrid
ink::EdgeVoxels InkSearchSilhouetteVoxels(
  const InkVoxelInput& input, const ink::SilhouetteCriteria& criteria, const ink::Eye& eye);

/// The ghost levels that a piece needs so that its voxels are those of the whole.
int InkGetVoxelGhostLevels(double scale);

/// Half of a voxel's diagonal, in world units.
double InkGetVoxelRadius(vtkImageData* image);

#endif
