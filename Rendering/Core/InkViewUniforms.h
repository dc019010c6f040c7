// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkViewUniforms_h
#define InkViewUniforms_h

#include "vtkInkRenderingCoreModule.h" // for the export macro

#include <array>
#include <string>

struct InkShiftScale;
class vtkActor;
class vtkAbstractMapper;
class vtkRenderer;
class vtkShaderProgram;

/// What the marks' position on the screen depends on: camera, actor, viewport and clipping planes. Two equal
/// views of the same points give the same picture. Matrices are stored column by column, as OpenGL takes
/// them.
struct VTKINKRENDERINGCORE_EXPORT InkViewUniforms
{
  /// @param size of the viewport in pixels
  InkViewUniforms(vtkRenderer* renderer, vtkActor* actor, vtkAbstractMapper* mapper,
    const InkShiftScale& frame, const int size[2]);

  bool operator==(const InkViewUniforms&) const = default;

  /// Takes in more on each side, as wide as a margin.
  /// @param margin pixels
  void Widen(int margin);

  /// Shows the same with more pixels.
  /// @param factor for one of before, on each axis
  void Refine(int factor);

  /// The definitions that Shaders/InkClipping.glsl needs.
  std::string FindFeatures() const;

  /// The uniforms of Shaders/InkViewUniforms.glsl and InkClipping.glsl; those that a shader lacks are left
  /// out.
  void SetUniforms(vtkShaderProgram* program) const;

  static constexpr int MaximumClippingPlanes = 6;

  std::array<float, 16> MCVC;  ///< points' unit to view coordinates
  std::array<float, 9> Normal; ///< inverse transpose of MCVC's rotation and scale
  std::array<float, 16> VCDC;
  std::array<float, 4> Eye;         ///< (0,0,0,1), or with a parallel projection the direction to the viewer
  std::array<float, 2> DepthRange;  ///< distances of the clipping planes from the eye along the view
  std::array<float, 4> DepthToClip; ///< clip z = [0] * view z + [1], clip w = [2] * view z + [3]
  std::array<int, 2> Size;          ///< pixels, margins included
  int Margin = 0;                   ///< pixels on each side that are not shown
  float Unit;                       ///< view units per unit of the points
  float Pixel;                      ///< view units per pixel where clip w is 1
  int PictureHeight;                ///< pixels of the whole picture, also where this view is a tile of it
  int TileScale;                    ///< how many times larger the picture is than the window: lengths in the
                                    ///< window's pixels, which the user sets, are enlarged by it
  bool BackFaces;                   ///< whether surfaces are seen from behind, too
  int NumberOfClippingPlanes = 0;
  std::array<float, 4 * MaximumClippingPlanes> ClippingPlanes{}; ///< in view coordinates, kept side positive
};

#endif
