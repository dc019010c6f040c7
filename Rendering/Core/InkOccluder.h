// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkOccluder_h
#define InkOccluder_h

#include "vtkInkRenderingCoreModule.h" // for the export macro

#include "InkRenderTarget.h"
#include "InkShaderPass.h"
#include "InkViewUniforms.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

struct InkShiftScale;
class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkPolyData;
class vtkShaderProgram;

/// The depth image of a view of the surface that hides marks.
struct InkOccluderDepth
{
  InkOccluderDepth(vtkOpenGLRenderWindow* window, const std::array<int, 2>& size)
    : Image(window, InkRenderTarget::Format::Depth, size[0], size[1])
  {
  }

  /// Where a view's pixels are in the image, for shaders: `occluderScale` and `occluderMargin`.
  VTKINKRENDERINGCORE_EXPORT void SetUniforms(vtkShaderProgram* program, const InkViewUniforms& view) const;

  InkRenderTarget Image;
  std::unique_ptr<InkRenderTarget> Facing; ///< of discs that face the viewer, kept for the next picture
  std::optional<InkViewUniforms> View;     ///< that it shows, with margins
  vtkMTimeType UploadTime = 0;             ///< of the surface that it shows
};

/// A surface on the GPU that hides marks behind it (Lu et al. 2003, section 3): it is only ever drawn into
/// depth images.
class VTKINKRENDERINGCORE_EXPORT InkOccluder
{
public:
  /// @param offset whether depths are those of the surface pushed back a little, by a polygon offset, for
  ///   marks that lie on it
  explicit InkOccluder(vtkOpenGLRenderWindow* window, bool offset = true);
  ~InkOccluder();
  InkOccluder(const InkOccluder&) = delete;
  void operator=(const InkOccluder&) = delete;

  /// Takes a surface's polygons and strips, or where it has none the discs around its points, of their
  /// `Normals` and `Radius`. Does nothing when they are those that it has.
  /// @return what is wrong where it takes none as they are too many; empty otherwise
  std::string Update(vtkPolyData* surface, const InkShiftScale& frame);
  bool IsEmpty() const { return this->NumberOfVertices == 0; }
  /// The largest of the discs, in the frame's unit; 0 for polygons.
  float GetLargestRadius() const { return this->LargestRadius; }

  /// Brings a depth image up to date; an image of another size is made anew. It shows more than the view, on
  /// each side, so that dots whose centers lie beyond the view's border are hidden by what is there: those of
  /// a tile are the same in the next one.
  /// @param shown the view
  /// @param reach how many pixels dots reach beyond their centers
  /// @param finer the image has so many pixels for one of the view, on each axis; fewer where they are more
  ///   than this OpenGL draws
  void Draw(
    const InkViewUniforms& shown, float reach, std::unique_ptr<InkOccluderDepth>& depth, int finer = 1);

private:
  std::string UploadTriangles(vtkPolyData* surface, const InkShiftScale& frame);
  std::string UploadDiscs(vtkPolyData* points, const InkShiftScale& frame);
  std::string Upload(const std::vector<float>& numbers, std::size_t numbersPerVertex);
  void DrawTriangles(const InkViewUniforms& view);
  void DrawDiscs(const InkViewUniforms& view, InkOccluderDepth& depth);
  /// @param facing the depth of the discs that face the viewer, to draw the others; null to draw the former
  void DrawDiscs(const InkViewUniforms& view, const InkRenderTarget* facing);

  vtkOpenGLRenderWindow* Window;
  bool Offset;
  vtkNew<vtkOpenGLBufferObject> Buffer;
  InkShaderPasses Passes;
  float LargestRadius = 0.0f; ///< above 0: discs
  int NumberOfVertices = 0;
  vtkMTimeType SurfaceTime = 0;
  std::array<double, 4> Frame{};
  vtkMTimeType UploadTime = 0;
};

#endif
