// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkVolumeStipples_h
#define InkVolumeStipples_h

#include "Fields/Derivatives/Gradients.h"
#include "Fields/SampleBox.h"
#include "Stippling/VolumeStipples.h"

class vtkDataArray;
class vtkImageData;
class vtkPolyData;

/// The parameters of vtkInkStippleGenerator for an image.
struct InkVolumeStippleRequest
{
  vtkDataArray* Scalars = nullptr; ///< one tuple per point
  int Component = 0;
  double Smoothing = 0.0; ///< a Gaussian's deviation in the smallest spacing
  ink::GradientOptions Gradient;
  bool ByPercentile = true;
  double Percentile = 0.0;
  double Threshold = 0.0;
  double Window[2]; ///< voxels outside get no stipples
  /// Whether Value and GradientMagnitude are relative to the ranges below instead of the image's own.
  bool GivenRanges = false;
  double ScalarRange[2] = { 0.0, 1.0 };
  double SteepestGradient = 1.0;
  /// The source of percentile and ranges; null: the samples whose voxels are stippled.
  const ink::stipple::VolumeStatistics* Statistics = nullptr;
  ink::stipple::VolumeStippleOptions Stipples;
  ink::SampleBox Own;             ///< the samples whose voxels are stippled
  bool Doubles = false;           ///< whether points are double
  vtkDataArray* Colors = nullptr; ///< passed on; may be null
  ink::Progress Progress;
};

/// Adds the samples whose voxels would be stippled to the statistics.
/// @return false when aborted by the progress
/// @throws std::invalid_argument that says what is wrong with the image
bool InkMeasureVolume(
  vtkImageData* image, const InkVolumeStippleRequest& request, ink::stipple::VolumeStatistics& statistics);

/// Writes the stipples of an image to an empty output; leaves it empty when aborted by the progress.
/// @throws std::invalid_argument that says what is wrong with the image or the request
void InkMakeVolumeStipples(vtkImageData* image, const InkVolumeStippleRequest& request, vtkPolyData* output);

#endif
