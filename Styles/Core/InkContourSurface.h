// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkContourSurface_h
#define InkContourSurface_h

#include "InkStyleProcesses.h"
#include "vtkInkStyle.h"
#include "vtkInkStylesModule.h" // for the export macro

#include <span>
#include <string>

class InkIsoSurface;
class vtkImageData;
class vtkInkSilhouetteMapper;
class vtkPolyData;

/// The surface that styles draw contours of, as a mesh with normals: for vtkInkSilhouetteMapper.
class VTKINKSTYLES_EXPORT InkContourSurface
{
public:
  explicit InkContourSurface(vtkInkStyle* style)
    : Style(style)
  {
  }

  /**
   * The iso-surfaces of the images of all processes, put together on the first one, so that no contour ends
   * where a process's part does; all processes call it at once, after InkIsoSurface::Prepare.
   * @param surface becomes them
   * @return what is wrong; empty if nothing is
   */
  std::string MakeOfImages(
    InkIsoSurface& isoSurface, std::span<vtkImageData* const> images, vtkPolyData* surface);

  /**
   * A mesh as it is; where it has no normals they are computed from its polygons, which is noted; at feature
   * edges each side has its own (InkWithFeatureNormals). Of points without polygons none, which is noted,
   * too.
   * @param surface becomes it
   * @param voxels whether silhouettes were to be segments through voxels, which is noted
   * @return what is wrong; empty if nothing is
   */
  std::string MakeOfMesh(vtkPolyData* mesh, vtkPolyData* surface, bool voxels = false);

  /**
   * A mesh with the normals of each side at its feature edges, if it has any, or a border.
   * @param surface becomes it; empty if there is neither
   * @return what is wrong; empty if nothing is
   */
  static std::string MakeOfEdges(vtkPolyData* mesh, vtkPolyData* surface);

  /// Borders up to this length, with all that they join, count as holes of a scan, of the diagonal.
  static constexpr double ShortestBorder = 0.05;

  /// Whether a surface, wherever it was delivered to, is an image's: what creases it has are its voxels'.
  static bool IsOfImage(vtkPolyData* surface);
  /// Sets what a mapper draws its input with: creases, but not those of an image's surface; and how far
  /// behind that surface silhouettes may lie, as its normals may be those of a smoother one.
  static void Follow(vtkInkSilhouetteMapper* mapper, bool creases);

private:
  vtkInkStyle* const Style;
};

#endif
