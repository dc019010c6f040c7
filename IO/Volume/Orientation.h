// SPDX-License-Identifier: BSD-3-Clause
#pragma once

class vtkImageData;

namespace ink::io
{

/// Where the voxels of a volume lie: what medical files say about it, turned to DICOM's axes (+x to the left
/// of the patient, +y to the back, +z to the head).
struct Orientation
{
  double direction[3][3]; ///< direction[i] is the unit vector along which voxel index i grows
  double origin[3];       ///< of the first voxel

  /// From the vectors between neighboring voxels, those of each index one after the other, and the position
  /// of the first, both as in the file. @param sign turns the file's axes to DICOM's.
  Orientation(const double steps[9], const double firstVoxel[3], const double sign[3]);

  enum class Axes
  {
    AtRightAngles,
    Sheared, ///< as those of a CT scanner's tilted gantry
    InAPlane ///< or not finite
  };
  /// Sets origin and direction of image, whose axes VTK has at right angles: for sheared ones those of the
  /// nearest rotation (Horn 1987), for axes in a plane nothing.
  Axes apply(vtkImageData* image) const;
};

} // namespace ink::io
