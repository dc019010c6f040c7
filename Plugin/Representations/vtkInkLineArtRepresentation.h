// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkLineArtRepresentation
 * @brief   "Line Art": shows images, meshes and grids as hatching along lines of curvature, with contours, in
 * ParaView's render views
 *
 * What a vtkInkLineArtStyle makes of them and how it draws that. Surfaces come together on the first process
 * as those of vtkInkContoursRepresentation do, and their lines of curvature are traced there. The view's
 * lights fall on them. Which lines are drawn and how wide is found for each picture where it is drawn.
 *
 * @sa vtkInkLineArtStyle
 */
#ifndef vtkInkLineArtRepresentation_h
#define vtkInkLineArtRepresentation_h

#include "vtkInkContoursRepresentation.h"
#include "vtkInkPluginRepresentationsModule.h" // for the export macro

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkInkLineArtRepresentation : public vtkInkContoursRepresentation
{
public:
  static vtkInkLineArtRepresentation* New();
  vtkTypeMacro(vtkInkLineArtRepresentation, vtkInkContoursRepresentation);

  std::vector<double> GetUsedIsoValues() override;

  /// Changes nothing: lines are traced for a view of all of them, as that takes long.
  void SetMagnification(double magnification) override;

protected:
  vtkInkLineArtRepresentation();
  ~vtkInkLineArtRepresentation() override;

private:
  vtkInkLineArtRepresentation(const vtkInkLineArtRepresentation&) = delete;
  void operator=(const vtkInkLineArtRepresentation&) = delete;
};

#endif
