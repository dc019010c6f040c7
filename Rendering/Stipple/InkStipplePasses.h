// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStipplePasses_h
#define InkStipplePasses_h

#include "InkShaderPass.h"
#include "InkStippleBlocks.h"
#include "InkStippleTextures.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class InkDrawingProgress;
class InkRenderPasses;
struct InkFrame;
class InkStipplePoints;
struct InkOccluderDepth;
struct InkStippleView;
struct InkViewUniforms;
class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;

/// The stipples on the GPU and the draw calls over them, for one window.
class InkStipplePasses
{
public:
  explicit InkStipplePasses(vtkOpenGLRenderWindow* window);
  ~InkStipplePasses();
  InkStipplePasses(const InkStipplePasses&) = delete;
  void operator=(const InkStipplePasses&) = delete;

  vtkOpenGLRenderWindow* GetWindow() const { return this->Window; }

  /// @param packed whether in 8 bytes a stipple, see InkQuantizedStipples, instead of 16
  /// @return why that cannot be done, for the user; empty if it can
  std::string Upload(const InkStipplePoints& points, bool packed);
  /// @param colors RGBA of each element, in the order of the points uploaded; empty: all have the ink's color
  void UploadColors(const std::vector<std::uint32_t>& colors);
  /// When these were last called, on VTK's clock; 0: never.
  vtkMTimeType GetUploadTime() const { return this->UploadTime; }
  vtkMTimeType GetColorUploadTime() const { return this->ColorUploadTime; }

  /// All that a picture depends on.
  struct Scene
  {
    const InkViewUniforms& View;
    const InkStipplePoints& Points;
    const ink::stipple::Tone& Tone;
    const InkStippleView& ToneView;
    InkOccluderDepth* Occluder; ///< null: nothing hides stipples
    float OccluderOffset;       ///< view units
    float OccluderPixels;       ///< the same at most
    const double* InkColor;
  };

  /// The stipples. The render passes that the actor takes part in may change the shader.
  void Draw(const Scene& scene, const InkFrame& frame, double opacity, const InkRenderPasses& renderPasses);

  /// The stipples in the frame's colors of ids.
  void DrawIds(const Scene& scene, const InkFrame& frame);

  /// What each of `count` points of the input comes to: T, opacity, diameter, red, green, blue; opacity 0 for
  /// what is not drawn. Empty if this OpenGL cannot do it.
  std::vector<float> FindResults(const Scene& scene, vtkIdType count);

  /// How many pixels the largest dots of a view reach beyond their centers.
  float FindReach(
    const InkViewUniforms& view, const ink::stipple::Tone& tone, const InkStippleView& toneView) const;

  /// How many stipples the last Draw had to look at.
  vtkIdType GetNumberOfProcessedStipples() const { return this->Processed; }

private:
  /// Definitions for what of the shaders the scene needs.
  std::string FindFeatures(const Scene& scene) const;
  void BindAttributes(vtkShaderProgram* program, vtkOpenGLVertexArrayObject* vertexArray);
  vtkShaderProgram* Begin(InkShaderPass& pass, const Scene& scene);
  InkStippleRuns FindRuns(const Scene& scene) const;
  void DrawRuns(const InkStippleRuns& runs, InkDrawingProgress* progress = nullptr);
  void End(InkShaderPass& pass, const Scene& scene);

  vtkOpenGLRenderWindow* Window;
  vtkNew<vtkOpenGLBufferObject> Buffer;
  InkStippleTextures Textures;
  bool Packed = false;
  std::array<float, 3> PackedStep{}; ///< of a quantized position at scale 1
  vtkMTimeType UploadTime = 0;
  vtkMTimeType ColorUploadTime = 0;
  vtkIdType Processed = 0;
  float LargestPoint = 1.0f;
  int LastTextureUnit = 0;
  InkShaderPasses Passes;
};

#endif
