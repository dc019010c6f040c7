// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkSplattingLinesRepresentation
 * @brief   "Splatting Lines": shows points with normals as a line drawing in ParaView's render views
 *
 * Takes any vtkPointSet, or a composite dataset of them, whose points carry the array `Normals` (or other
 * active normals), and draws it with an actor and a vtkInkSplattingLinesMapper of its own. A point array
 * `Radius` is used if there is one. The leaves of a composite dataset are drawn as one set of points, so
 * that lines run across them; ghost points are left out. Points without normals draw nothing and give one
 * warning.
 *
 * On several processes every one gets all the points: a splat near the border of a process's part needs
 * its neighbours on the other side. All draw the same marks, of which compositing by depth keeps one. With
 * translucent marks in the view (no paper, or opacity below 1) images are blended instead: then the root
 * process draws alone, and the marks are not hidden by what only other processes hold.
 *
 * @sa vtkInkSplattingLinesMapper vtkInkIsoSurfaceSampler
 */
#ifndef vtkInkSplattingLinesRepresentation_h
#define vtkInkSplattingLinesRepresentation_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkNew.h"                            // for the members
#include "vtkPVDataRepresentation.h"

class vtkActor;
class vtkInkSplattingLinesMapper;
class vtkPolyData;

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkInkSplattingLinesRepresentation : public vtkPVDataRepresentation
{
public:
  static vtkInkSplattingLinesRepresentation* New();
  vtkTypeMacro(vtkInkSplattingLinesRepresentation, vtkPVDataRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The mapper's parameters: see vtkInkSplattingLinesMapper for meaning, range and default.
   */
  void SetLambda(double lambda);
  void SetTau(double tau);
  void SetPhi(double phi);
  void SetSigma(double sigma);
  void SetAsPublished(bool asPublished);
  void SetRadius(double radius);
  void SetInkColor(double red, double green, double blue);
  void SetPaperColor(double red, double green, double blue);
  void SetPaperVisibility(bool visible);
  ///@}

  ///@{
  /**
   * The actor's state: opacity of ink and paper together (0 to 1), and where the points stand, as
   * vtkProp3D defines it.
   */
  void SetOpacity(double opacity);
  void SetPosition(double x, double y, double z);
  void SetScale(double x, double y, double z);
  void SetOrientation(double x, double y, double z);
  void SetOrigin(double x, double y, double z);
  void SetUserTransform(const double matrix[16]);
  ///@}

  /// Whether points can be picked in the view. Default: on. Points put together from several datasets, or
  /// left over from ghost points, cannot be: their ids are not those of the input.
  void SetPickable(bool pickable);

  void SetVisibility(bool visible) override;

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

  /// The points as they are drawn, with their `Normals` and `Radius`; empty before the first update.
  vtkDataObject* GetRenderedDataObject(int port) override;

protected:
  vtkInkSplattingLinesRepresentation();
  ~vtkInkSplattingLinesRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkInkSplattingLinesRepresentation(const vtkInkSplattingLinesRepresentation&) = delete;
  void operator=(const vtkInkSplattingLinesRepresentation&) = delete;

  bool DrawsOnThisProcess();
  void UpdatePickable();

  vtkNew<vtkPolyData> Points;
  vtkNew<vtkInkSplattingLinesMapper> Mapper;
  vtkNew<vtkActor> Actor;
  bool Pickable = true;
  bool PointIdsAreInputs = false;
};

#endif
