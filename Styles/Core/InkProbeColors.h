// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkProbeColors_h
#define InkProbeColors_h

#include <string>

class vtkDataSet;
class vtkImageData;
class vtkInkIsoSurfaceSampler;
class vtkPolyData;

/// Under this name points have the values of an array to color by, which may have that of another one of
/// theirs.
inline constexpr const char* InkColorsName = "InkColors";
/// And under this one those of labels as their order: in equal steps from 0, the least of a volume, to 1.
inline constexpr const char* InkLabelOrderName = "InkLabelOrder";

/// Which of both points have; null: neither.
const char* InkFindColors(vtkDataSet* points);

/// Gives points on the surface of an image the values there of one of its point arrays, as active scalars;
/// none if the image lacks it. Values are interpolated but for those of labels, which are as the nearest
/// voxel within the surface has them.
/// @param array its name; empty: the active scalars, of which the surface is
/// @param inOrder whether labels of which the surface is become their order
/// @param sampler that has made the points
void InkProbeColors(vtkImageData* image, const std::string& array, bool inOrder,
  vtkInkIsoSurfaceSampler* sampler, vtkPolyData* points);

#endif
