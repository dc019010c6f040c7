// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkIsoSurfaceMesh_h
#define InkIsoSurfaceMesh_h

#include <functional>
#include <string>

class vtkAlgorithm;
class vtkDataArray;
class vtkImageData;
class vtkInkIsoSurfaceSampler;
class vtkPolyData;

/// The iso-surfaces of an image as triangles with Normals, for what needs a mesh in place of points: of the
/// values, smoothed and interpolated, that a sampler with the same settings places its points in, with the
/// same parts and the same missing and hidden cells, and closed where its Cut is a cap.
///
/// The resampled image is in memory as a whole; so Subdivision is halved until that has no more than 2^27
/// values, and then the division of long voxels. Smoothed normals place a contour between triangles, so that
/// it needs it less than points do.
///
/// @param scalars the image's point array, of one component
/// @param settings iso-values, Smoothing, SmoothingTarget, Subdivision, Cut, SmallestPart and LargestParts
/// @param update brings an algorithm up to date; returns what is wrong, or nothing
/// @param mesh becomes the surfaces of all iso-values, one after the other
/// @return what is wrong; empty if nothing is
std::string InkMakeIsoSurfaceMesh(vtkImageData* image, vtkDataArray* scalars,
  vtkInkIsoSurfaceSampler* settings, const std::function<std::string(vtkAlgorithm*)>& update,
  vtkPolyData* mesh);

#endif
