// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkLineArtMapper
 * @brief   hatching, and contours over it, as one
 *
 * Draws what two mappers draw, one after the other, for one actor: the strokes of hatching, then contours.
 * Clipping planes are handed on to both. Hardware selection finds the contours' points, those of the surface.
 *
 * @sa vtkInkLineArtStyle vtkInkStrokeMapper vtkInkSilhouetteMapper
 */
#ifndef vtkInkLineArtMapper_h
#define vtkInkLineArtMapper_h

#include "vtkInkStylesModule.h" // for the export macro
#include "vtkPolyDataMapper.h"
#include "vtkSmartPointer.h" // for the mappers

class vtkInkSilhouetteMapper;
class vtkInkStrokeMapper;

class VTKINKSTYLES_EXPORT vtkInkLineArtMapper : public vtkPolyDataMapper
{
public:
  static vtkInkLineArtMapper* New();
  vtkTypeMacro(vtkInkLineArtMapper, vtkPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The mappers of the two, whose inputs are what is drawn; one without input draws nothing.
  void SetMappers(vtkInkStrokeMapper* strokes, vtkInkSilhouetteMapper* contours);

  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  double* GetBounds() override;
  using vtkPolyDataMapper::GetBounds;
  bool HasOpaqueGeometry() override { return false; }
  bool HasTranslucentPolygonalGeometry() override { return true; }
  bool GetSupportsSelection() override { return true; }
  /// Includes the mappers.
  vtkMTimeType GetMTime() override;

protected:
  vtkInkLineArtMapper();
  ~vtkInkLineArtMapper() override;

private:
  vtkInkLineArtMapper(const vtkInkLineArtMapper&) = delete;
  void operator=(const vtkInkLineArtMapper&) = delete;

  vtkSmartPointer<vtkInkStrokeMapper> Strokes;
  vtkSmartPointer<vtkInkSilhouetteMapper> Contours;
};

#endif
