// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkSplattingLinesRepresentation
 * @brief   "Splatting Lines": shows images, meshes, grids and points as a line drawing in ParaView's render
 * views
 *
 * Of images, also several in a composite dataset, iso-surfaces are drawn: at values that suit them or that
 * are given, sampled as finely as the view shows them (vtkSMInkRepresentationProxy). Otherwise all leaves are
 * drawn as one surface, so that lines run across them: meshes and the outer surfaces of grids by samples of
 * it, and points with normals and radii estimated where they have none, as vtkInkSplattingLinesStyle makes
 * them on the first process. Meshes whose points lie closely enough (vtkInkIsDense.h), and points that have
 * the arrays `Normals` and `Radius`, are drawn by their own points, each process's by itself; ghost points
 * are left out.
 *
 * What is selected is the point of the data that a sample is nearest to. Colors: the array that is chosen for
 * the representation, of points or cells; none: the ink. While ParaView renders with a lower level of detail,
 * as many points are drawn as PointsWhileMoving says, with larger radii.
 *
 * @sa vtkInkSplattingLinesStyle vtkInkIsoSurfaceSampler
 */
#ifndef vtkInkSplattingLinesRepresentation_h
#define vtkInkSplattingLinesRepresentation_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkInkRepresentation.h"
#include "vtkNew.h"          // for the points
#include "vtkSmartPointer.h" // for meshes

#include <vector> // for meshes

class vtkInkSplattingLinesStyle;
class vtkPolyData;
struct InkLeaves;

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

  /// Whether lines are drawn of the points that the data has; the same on all processes, which call it at
  /// once.
  /// @param meshes of the leaves
  bool TakesOwnPoints(const InkLeaves& leaves, const std::vector<vtkSmartPointer<vtkPolyData>>& meshes);
  /// Takes these. @return what is wrong
  std::string TakePoints(
    vtkDataObject* input, const InkLeaves& leaves, const std::vector<vtkSmartPointer<vtkPolyData>>& meshes);

  vtkInkSplattingLinesStyle* const Style;
  vtkNew<vtkPolyData> Drawn;  ///< what the style is shown
  vtkMTimeType DrawnTime = 0; ///< of the points that Drawn was made from
  int PointsWhileMoving = 200000;
};

#endif
