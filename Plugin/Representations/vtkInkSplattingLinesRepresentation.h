// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkSplattingLinesRepresentation
 * @brief   "Splatting Lines": shows images, and points with normals, as a line drawing in ParaView's render
 *          views
 *
 * Of images, also several in a composite dataset, iso-surfaces are drawn: at values that suit them or that
 * are given, sampled more finely in larger views, in steps of two. Otherwise it takes any vtkPointSet, or a
 * composite dataset of them, whose points carry the array `Normals` (or other active normals), and draws it
 * as vtkInkSplattingLinesStyle does. A point array `Radius` is used if there is one. The leaves of a
 * composite dataset are drawn as one set of points, so that lines run across them; ghost points are left out.
 * Points without normals draw nothing and give one warning.
 *
 * Colors: the array that is chosen for the representation, of points or cells; none: the ink. While ParaView
 * renders with a lower level of detail, as many points are drawn as PointsWhileMoving says, with larger
 * radii.
 *
 * @sa vtkInkSplattingLinesStyle vtkInkIsoSurfaceSampler
 */
#ifndef vtkInkSplattingLinesRepresentation_h
#define vtkInkSplattingLinesRepresentation_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkInkRepresentation.h"
#include "vtkNew.h" // for the points

class vtkInkSplattingLinesStyle;

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkInkSplattingLinesRepresentation : public vtkInkRepresentation
{
public:
  static vtkInkSplattingLinesRepresentation* New();
  vtkTypeMacro(vtkInkSplattingLinesRepresentation, vtkInkRepresentation);

  std::vector<double> GetUsedIsoValues() override;

  /// The most points that are drawn at a lower level of detail; 0: all. Default: 200000.
  void SetPointsWhileMoving(int points);

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkInkSplattingLinesRepresentation();
  ~vtkInkSplattingLinesRepresentation() override;

  std::string MakeMarks(const vtkInkStyle::Input& input) override;
  void Show(const std::vector<vtkPolyData*>& delivered) override;

private:
  vtkInkSplattingLinesRepresentation(const vtkInkSplattingLinesRepresentation&) = delete;
  void operator=(const vtkInkSplattingLinesRepresentation&) = delete;

  explicit vtkInkSplattingLinesRepresentation(vtkSmartPointer<vtkInkSplattingLinesStyle> style);

  vtkInkSplattingLinesStyle* const Style;
  vtkNew<vtkPolyData> Drawn;  ///< what the style is shown
  vtkMTimeType DrawnTime = 0; ///< of the points that Drawn was made from
  int PointsWhileMoving = 200000;
};

#endif
