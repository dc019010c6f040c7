// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStippleOccluder_h
#define InkStippleOccluder_h

#include "InkRenderTarget.h"
#include "InkShaderPass.h"
#include "InkViewUniforms.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <memory>
#include <optional>
#include <vector>

struct InkShiftScale;
class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkPolyData;

/// The depth image of a view of the surface that hides stipples.
struct InkStippleDepth
{
  InkStippleDepth(vtkOpenGLRenderWindow* window, const std::array<int, 2>& size)
    : Image(window, InkRenderTarget::Format::Depth, size[0], size[1])
  {
  }

  InkRenderTarget Image;
  std::optional<InkViewUniforms> View; ///< that it shows, with margins
  vtkMTimeType UploadTime = 0;         ///< of the surface that it shows
};

/// A surface on the GPU that hides stipples behind it (Lu et al. 2003, section 3): it is only ever drawn into
/// depth images, with a polygon offset.
class InkStippleOccluder
{
public:
  explicit InkStippleOccluder(vtkOpenGLRenderWindow* window);
  ~InkStippleOccluder();
  InkStippleOccluder(const InkStippleOccluder&) = delete;
  void operator=(const InkStippleOccluder&) = delete;

  /// Takes a surface's polygons and strips, or where it has none the discs around its points, of their
  /// `Normals` and `Radius`. Does nothing when they are those that it has.
  void Update(vtkPolyData* surface, const InkShiftScale& frame);
  bool IsEmpty() const { return this->NumberOfVertices == 0; }
  /// The largest of the discs, in the frame's unit; 0 for polygons.
  float GetLargestRadius() const { return this->LargestRadius; }

  /// Brings a depth image up to date; an image of another size is made anew. It shows more than the view, on
  /// each side, so that dots whose centers lie beyond the view's border are hidden by what is there: those of
  /// a tile are the same in the next one.
  /// @param shown the view
  /// @param reach how many pixels dots reach beyond their centers
  void Draw(const InkViewUniforms& shown, float reach, std::unique_ptr<InkStippleDepth>& depth);

private:
  void UploadTriangles(vtkPolyData* surface, const InkShiftScale& frame);
  void UploadDiscs(vtkPolyData* points, const InkShiftScale& frame);
  void Upload(const std::vector<float>& numbers, int numbersPerVertex);
  void DrawTriangles(const InkViewUniforms& view);
  void DrawDiscs(const InkViewUniforms& view);

  vtkOpenGLRenderWindow* Window;
  vtkNew<vtkOpenGLBufferObject> Buffer;
  InkShaderPasses Passes;
  float LargestRadius = 0.0f; ///< above 0: discs
  int NumberOfVertices = 0;
  vtkMTimeType SurfaceTime = 0;
  std::array<double, 4> Frame{};
  vtkMTimeType UploadTime = 0;
};

#endif
