// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkStipplePasses_h
#define InkStipplePasses_h

#include "InkStippleBlocks.h"
#include "InkStippleTextures.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

class InkRenderPasses;
class InkStipplePoints;
struct InkStippleDepth;
struct InkStippleView;
struct InkView;
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

  /// @param packed whether in 8 bytes a stipple, see InkPackedStipples, instead of 16
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
    const InkView& View;
    const InkStipplePoints& Points;
    const ink::StippleTone& Tone;
    const InkStippleView& ToneView;
    InkStippleDepth* Occluder; ///< null: nothing hides stipples
    float OccluderOffset;      ///< view units
    const double* InkColor;
  };

  /// The stipples into the caller's framebuffer, viewport and blending; the viewport's origin is given. The
  /// render passes that the actor takes part in may change the shader.
  void Draw(
    const Scene& scene, const int viewportOrigin[2], double opacity, const InkRenderPasses& renderPasses);

  /// The stipples in the colors that encode 24 bits of their ids, from bit idShift on, or, if idShift is
  /// negative, in propColor.
  void DrawIds(const Scene& scene, const int viewportOrigin[2], int idShift, const float propColor[3]);

  /// What each of `count` points of the input comes to: T, opacity, diameter, red, green, blue; opacity 0 for
  /// what is not drawn. Empty if this OpenGL cannot do it.
  std::vector<float> FindResults(const Scene& scene, vtkIdType count);

  /// How many pixels the largest dots of a view reach beyond their centers.
  float FindReach(const InkView& view, const ink::StippleTone& tone, const InkStippleView& toneView) const;

  /// How many stipples the last Draw had to look at.
  vtkIdType GetNumberOfProcessedStipples() const { return this->Processed; }

private:
  struct Pass;

  /// Definitions for what of the shaders the scene needs.
  std::string FindFeatures(const Scene& scene) const;
  Pass& FindPass(
    const std::string& vertexShader, const std::string& geometryShader, const std::string& fragmentShader);
  void BindAttributes(Pass& pass, vtkShaderProgram* program);
  vtkShaderProgram* Begin(Pass& pass, const Scene& scene);
  InkStippleRuns FindRuns(const Scene& scene) const;
  void DrawRuns(const InkStippleRuns& runs);
  void End(Pass& pass, const Scene& scene);

  vtkOpenGLRenderWindow* Window;
  vtkNew<vtkOpenGLBufferObject> Buffer;
  InkStippleTextures Textures;
  bool Packed = false;
  std::array<float, 3> PackedStep{}; ///< of a packed place at scale 1
  vtkMTimeType UploadTime = 0;
  vtkMTimeType ColorUploadTime = 0;
  vtkIdType Processed = 0;
  float LargestPoint = 1.0f;
  int LastTextureUnit = 0;
  /// One for each form that scenes and render passes give the shaders.
  std::map<std::string, std::unique_ptr<Pass>> Passes;
};

#endif
