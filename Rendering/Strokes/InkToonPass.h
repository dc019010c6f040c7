// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkToonPass_h
#define InkToonPass_h

#include "InkShaderPass.h"
#include "InkShiftScale.h"
#include "InkTextureBuffer.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkType.h"

#include <string>

class InkRenderPasses;
class vtkOpenGLRenderWindow;
class vtkPolyData;
class vtkShaderProgram;
struct InkFrame;
struct InkOccluderDepth;
struct InkViewUniforms;

/// Silhouettes by toon shading (Lu et al. 2003, section 5.6): a surface on the GPU that is ink where it is
/// seen from its side.
class InkToonPass
{
public:
  explicit InkToonPass(vtkOpenGLRenderWindow* window);
  ~InkToonPass();

  /// Takes a surface's polygons and strips with their normals. Does nothing when they are those that it has.
  /// @return what is wrong where they are too many to draw, or to select; empty otherwise
  std::string Update(vtkPolyData* surface);
  const InkShiftScale& GetFrame() const { return this->Frame; }   ///< of the surface
  vtkMTimeType GetUploadTime() const { return this->UploadTime; } ///< 0: never

  struct Scene
  {
    const InkViewUniforms& View;
    const InkOccluderDepth& Occluder; ///< of the same surface
    float LargestCosine;              ///< of the angle between normal and eye
    float Lift;                       ///< pixels towards the eye
    const double* Color;
    float Opacity;
  };

  /// Draws the ink, and its depth where no render pass asks for depth itself; or ids.
  void Draw(const Scene& scene, const InkFrame& frame, const InkRenderPasses& renderPasses);

private:
  void SetUniforms(vtkShaderProgram* program, const Scene& scene, const InkFrame& frame);

  vtkOpenGLRenderWindow* Window;
  vtkNew<vtkOpenGLBufferObject> Corners; ///< position and normal of each
  InkTextureBuffer Ids;
  int NumberOfCorners = 0;
  InkShiftScale Frame;
  vtkMTimeType SurfaceTime = 0; ///< of the surface that Frame and the corners are of
  vtkMTimeType UploadTime = 0;
  InkShaderPasses Passes;
};

#endif
