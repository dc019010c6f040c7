// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkSplatPasses_h
#define InkSplatPasses_h

#include "InkShaderPass.h"
#include "InkSplatSettings.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>

class InkRenderTarget;
class InkSplatPoints;
class InkDrawingProgress;
struct InkFrame;
struct InkViewUniforms;
class vtkIdTypeArray;
class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexBufferObjectGroup;
class vtkShaderProgram;
class vtkUnsignedCharArray;

/// The points on the GPU and the draw calls over them, for one window.
class InkSplatPasses
{
public:
  explicit InkSplatPasses(vtkOpenGLRenderWindow* window);
  ~InkSplatPasses();
  InkSplatPasses(const InkSplatPasses&) = delete;
  void operator=(const InkSplatPasses&) = delete;

  vtkOpenGLRenderWindow* GetWindow() const { return this->Window; }

  /// @param colors RGBA, one a point, or null
  /// @param sources the points' ids for selection, or null: their numbers
  void Upload(InkSplatPoints& points, vtkUnsignedCharArray* colors, vtkIdTypeArray* sources);
  /// When Upload was last called, on VTK's clock; 0: never.
  vtkMTimeType GetUploadTime() const;
  double GetLargestRadius() const { return this->LargestRadius; }

  /// The points in the order in which they are drawn where not all of them are. Forgotten by Upload.
  void SetOrder(std::span<const std::uint32_t> order);
  bool HasOrder() const { return this->Ordered; }

  /// How many texels the narrower radius of a splat must have for it to be summed up in them.
  static double FewestTexels(double sigma);

  /// The least radius of illumination splats in pixels.
  static double FindMinimumRadius(const InkViewUniforms& view, const InkSplatSettings& splatting);

  /// The part of the viewport that the discs may cover, and some pixels around: x, y, width, height in
  /// pixels.
  std::array<int, 4> FindExtent(
    const InkViewUniforms& view, const InkSplatSettings& splatting, int around) const;

  /// The side of the largest squares of pixels that it pays to sum up splats for: 1, 2, ... up to a limit.
  int FindTexel(const InkViewUniforms& view, const InkSplatSettings& splatting, int limit) const;

  /// Which depth splats to draw.
  enum class Sheet
  {
    Whole,  ///< all, or those that face the viewer if only these are seen
    Front,  ///< those that face the viewer
    Back,   ///< those that face away and are not hidden by the others, which the image shows
    Hidden, ///< those behind the layer that the image shows
  };

  /// The depth splats of a layer, into the bound surface (and colors) with its z-buffer, both cleared
  /// before.
  /// @param image see Sheet; else null
  void DrawDepth(const InkViewUniforms& view, const InkSplatSettings& splatting, InkDrawingProgress& progress,
    Sheet sheet, const InkRenderTarget* image = nullptr);

  /// The illumination splats of a layer whose narrower radius on the screen is within two limits, added to
  /// the bound sums.
  /// @param texel of the sums, in pixels
  /// @param widths pixels
  void DrawLight(const InkViewUniforms& view, const InkSplatSettings& splatting, InkDrawingProgress& progress,
    const InkRenderTarget& surface, bool hidden, int texel, const std::array<double, 2>& widths);

  /// The points' discs in the frame's colors of ids.
  void DrawIds(const InkViewUniforms& view, const InkFrame& frame);

private:
  /// How the splats of a pass lie on the screen.
  struct Splats
  {
    double RadiusScale;
    double MinimumRadius; ///< pixels
    double Slack;         ///< of the depth test by slope, in pixels
    bool Uniform = true;  ///< whether the depth test's tolerance is the same for all of a disc
    int Texel = 1;        ///< of the target, in pixels
  };

  vtkShaderProgram* Begin(
    const char* fragmentShader, std::string features, const InkViewUniforms& view, const Splats& splats);
  void DrawPoints(double fraction, InkDrawingProgress& progress);

  vtkOpenGLRenderWindow* Window;
  vtkNew<vtkOpenGLVertexBufferObjectGroup> Buffers;
  vtkNew<vtkOpenGLBufferObject> Order;
  bool Ordered = false;
  int NumberOfPoints = 0;
  bool HasSources = false;
  bool HasEdges = false;
  double LargestRadius = 0.0;
  std::array<float, 6> Bounds{};
  double LargestSprite = 0.0;
  InkShaderPasses Passes;
  InkShaderPass* Current = nullptr;
};

#endif
