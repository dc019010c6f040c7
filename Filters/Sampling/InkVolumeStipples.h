// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkVolumeStipples_h
#define InkVolumeStipples_h

#include "Fields/Gradients.h"
#include "Fields/SampleBox.h"
#include "Sampling/VolumeStipples.h"

class vtkDataArray;
class vtkImageData;
class vtkPolyData;

/// What vtkInkStippleGenerator is asked for when its input is an image.
struct InkVolumeStippleRequest
{
  vtkDataArray* Scalars = nullptr; ///< one tuple a point
  int Component = 0;
  ink::GradientOptions Gradient;
  bool ByPercentile = true;
  double Percentile = 0.0;
  double Threshold = 0.0;
  double Window[2]; ///< voxels outside get no stipples
  /// Whether Value and GradientMagnitude are relative to the given numbers instead of the image's own.
  bool GivenRanges = false;
  double ScalarRange[2] = { 0.0, 1.0 };
  double SteepestGradient = 1.0;
  /// What percentile and ranges are of; null: of the samples whose voxels are stippled.
  const ink::VolumeStatistics* Statistics = nullptr;
  ink::VolumeStippleOptions Stipples;
  ink::SampleBox Own;             ///< the samples whose voxels are stippled
  bool Doubles = false;           ///< the points' type
  vtkDataArray* Colors = nullptr; ///< passed on; may be null
  ink::Progress Progress;
};

/// Adds the samples whose voxels would be stippled to the statistics.
/// @returns false when the progress asks to stop
/// @throws std::invalid_argument with what is wrong with the image
bool InkMeasureVolume(
  vtkImageData* image, const InkVolumeStippleRequest& request, ink::VolumeStatistics& statistics);

/// Writes the stipples of an image to an empty output; leaves it empty when the progress asks to stop.
/// @throws std::invalid_argument with what is wrong with the image or the request
void InkMakeVolumeStipples(vtkImageData* image, const InkVolumeStippleRequest& request, vtkPolyData* output);

#endif
