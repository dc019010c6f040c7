// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStrokePasses_h
#define InkStrokePasses_h

#include "InkRenderTarget.h"
#include "InkShaderPass.h"
#include "InkStrokeTexture.h"
#include "InkTextureBuffer.h"

#include "vtkType.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class InkRenderPasses;
class InkStrokePoints;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
struct InkFrame;
struct InkHatching;
struct InkOccluderDepth;
struct InkStrokeRuns;
struct InkStrokeStyle;
struct InkViewUniforms;

/// Runs of strokes on the GPU, as one view shows them.
struct InkStrokeRunBuffers
{
  explicit InkStrokeRunBuffers(vtkOpenGLRenderWindow* window);

  void Upload(const InkStrokeRuns& runs);

  InkTextureBuffer Points;
  InkTextureBuffer Runs;
  int NumberOfPoints = 0;
};

/// Strokes on the GPU and the draw calls over them, for one window. First a pass finds for each point where
/// the picture has it and how wide the stroke is there, as pixels of an image; then each segment is a
/// rectangle whose pixels know their distance from it and from the segments beside it. So a pixel belongs to
/// the segment that covers it most, and none is blended twice where segments meet.
class InkStrokePasses
{
public:
  explicit InkStrokePasses(vtkOpenGLRenderWindow* window);

  /// @return why that cannot be done, for the user; empty if it can
  std::string Upload(const InkStrokePoints& points);
  /// @param colors RGBA of each point; empty: all have the ink's color
  void UploadColors(const std::vector<std::uint32_t>& colors);
  /// @param image that strokes are drawn with; null: none
  /// @return what is wrong with it, for the user; empty if nothing is
  std::string UploadTexture(vtkImageData* image) { return this->Texture.Update(image); }
  vtkMTimeType GetUploadTime() const { return this->UploadTime; } ///< 0: never

  /// All that a picture depends on.
  struct Scene
  {
    const InkViewUniforms& View;
    const InkStrokeStyle& Style;
    InkStrokeRunBuffers& Runs;
    InkOccluderDepth* Occluder; ///< the surface that the strokes lie on, or null
    int NumberOfPoints;         ///< of the runs, from the first, that are drawn
  };

  /// Draws the strokes, and their depth where they cover half a pixel and no render pass asks for depth
  /// itself; or their ids, where the frame has these.
  /// @return whether this OpenGL can do it
  bool Draw(const Scene& scene, const InkFrame& frame, double opacity, const InkRenderPasses& renderPasses);

  /// How wide strokes are at each of the scene's points, pixels; empty where this OpenGL cannot do it.
  std::vector<float> FindWidths(const Scene& scene);

private:
  /// @return whether this OpenGL can do it
  bool FindPoints(const Scene& scene);
  void SetHatchingUniforms(vtkShaderProgram* program, const InkHatching& hatching);
  void SetUniforms(vtkShaderProgram* program, const Scene& scene, const InkFrame& frame, double opacity);
  void ActivateTextures(vtkShaderProgram* program, const Scene& scene, bool ids);
  void DeactivateTextures(const Scene& scene);

  vtkOpenGLRenderWindow* Window;
  InkTextureBuffer Points;
  InkTextureBuffer Shapes;
  InkTextureBuffer Strokes;
  InkTextureBuffer Hatches;
  InkTextureBuffer SpacingRatios;
  InkTextureBuffer Ids;
  InkTextureBuffer Colors;
  InkStrokeTexture Texture;
  std::unique_ptr<InkRenderTarget> PointShapes;    ///< half width, arc length, length
  std::unique_ptr<InkRenderTarget> PointPositions; ///< clip coordinates; drawn into with PointShapes
  vtkMTimeType UploadTime = 0;
  InkShaderPasses Passes;
};

#endif
