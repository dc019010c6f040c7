// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkCameraFit
 * @brief   places a camera so that points just fit into the picture
 *
 * The points themselves are fitted into the four sides of the view, not their bounding sphere: each side asks
 * for one distance, and opposite sides share the center. A camera keeps its orientation, view angle and kind
 * of projection. Points may be added for several orientations: whichever of them a camera has then, it turns
 * about the pivot at a fixed distance.
 *
 *     vtkNew<vtkInkCameraFit> fit;
 *     fit->SetAspect(width / height);
 *     fit->AddPoints(style->GetFramePoints(), camera);
 *     fit->Apply(camera);
 *
 * @sa vtkInkStyle::GetFramePoints
 */
#ifndef vtkInkCameraFit_h
#define vtkInkCameraFit_h

#include "vtkInkStylesModule.h" // for the export macro
#include "vtkObject.h"

#include <limits> // for empty intervals

class vtkCamera;
class vtkPoints;

class VTKINKSTYLES_EXPORT vtkInkCameraFit : public vtkObject
{
public:
  static vtkInkCameraFit* New();
  vtkTypeMacro(vtkInkCameraFit, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The width of the picture by its height. 1e-5 to 1e5; default: 1.
  vtkSetClampMacro(Aspect, double, 1e-5, 1e5);
  vtkGetMacro(Aspect, double);
  ///@}

  ///@{
  /// The part of the picture's half width and height that stays free. 0 to 0.9; default: 0.05.
  vtkSetClampMacro(Margin, double, 0.0, 0.9);
  vtkGetMacro(Margin, double);
  ///@}

  ///@{
  /// What a camera turns about. To be set before points are added. Default: the origin.
  vtkSetVector3Macro(Pivot, double);
  vtkGetVector3Macro(Pivot, double);
  ///@}

  /// Adds points as a camera of this orientation, view angle and projection sees them. Those that are not
  /// finite are skipped.
  void AddPoints(vtkPoints* points, vtkCamera* camera);

  /// Moves the camera. Nothing happens if no finite point was added.
  void Apply(vtkCamera* camera);

protected:
  vtkInkCameraFit();
  ~vtkInkCameraFit() override;

private:
  vtkInkCameraFit(const vtkInkCameraFit&) = delete;
  void operator=(const vtkInkCameraFit&) = delete;

  /// Least and greatest of a number of values.
  struct Interval
  {
    double Least = std::numeric_limits<double>::max();
    double Greatest = std::numeric_limits<double>::lowest();

    void Add(double value);
  };

  double Aspect = 1.0;
  double Margin = 0.05;
  double Pivot[3] = { 0.0, 0.0, 0.0 };
  Interval Sides[4]; ///< left, right, bottom, top
  Interval Depths;
};

#endif
