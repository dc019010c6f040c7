// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkProbeColors_h
#define InkProbeColors_h

#include <string>

class vtkImageData;
class vtkInkIsoSurfaceSampler;
class vtkPolyData;

/// Under this name points have the values of an array to color by, which may have that of another one of
/// theirs.
inline constexpr const char* InkColorsName = "InkColors";

/// Gives points on the surface of an image the values there of one of its point arrays, as active scalars;
/// none if the image lacks it. Values are interpolated but for those of labels, which are as the nearest
/// voxel within the surface has them.
/// @param array its name; empty: the active scalars, of which the surface is
/// @param sampler that has made the points
void InkProbeColors(
  vtkImageData* image, const std::string& array, vtkInkIsoSurfaceSampler* sampler, vtkPolyData* points);

#endif
