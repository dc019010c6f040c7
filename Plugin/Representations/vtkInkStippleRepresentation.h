// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkStippleRepresentation
 * @brief   "Stipple": shows images and meshes as stipple drawings in ParaView's render views
 *
 * What a vtkInkStippleStyle makes of them and how it draws that, on all processes as on one: percentiles
 * and ranges are those of the whole image, of which each process stipples its part; meshes are put together
 * and stippled by the first process. Five levels of ghost cells are asked for, six where values are those
 * of cells; images in composite datasets have none, and stipples there do not mind those of their
 * neighbors.
 *
 * Colors: the array that is chosen for the representation, of an image's points, or of points or cells of
 * other data; none: the ink. The active scalars, or the array chosen last, go with the stipples in any case,
 * so that coloring by them, or not, makes no new ones.
 *
 * @sa vtkInkStippleStyle vtkSMInkStippleRepresentationProxy
 */
#ifndef vtkInkStippleRepresentation_h
#define vtkInkStippleRepresentation_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkInkRepresentation.h"

#include <memory> // for the members

class vtkInkEarlyFXAA;
class vtkInkStippleStyle;

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkInkStippleRepresentation : public vtkInkRepresentation
{
public:
  static vtkInkStippleRepresentation* New();
  vtkTypeMacro(vtkInkStippleRepresentation, vtkInkRepresentation);

  /// Changes nothing: SetPictureSize says how large the picture is.
  void SetMagnification(double magnification) override;

  /// The side of the picture whose room says how many stipples a mesh gets, and an image with a projected
  /// number of them. 100 to 100000 pixels; default: 600.
  void SetPictureSize(double pixels);

  void SetVisibility(bool visible) override;

protected:
  vtkInkStippleRepresentation();
  ~vtkInkStippleRepresentation() override;

  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  std::string MakeMarks(const vtkInkStyle::Input& input) override;
  bool ServesFor(const std::string& name, int association) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkInkStippleRepresentation(const vtkInkStippleRepresentation&) = delete;
  void operator=(const vtkInkStippleRepresentation&) = delete;

  explicit vtkInkStippleRepresentation(vtkSmartPointer<vtkInkStippleStyle> style);

  vtkInkStippleStyle* const Style;
  const std::unique_ptr<vtkInkEarlyFXAA> FXAA;
};

#endif
