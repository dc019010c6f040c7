// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkRepresentation
 * @brief   what vtkInk's styles have in common as representations in ParaView's render views
 *
 * A subclass makes pieces of poly data from its input in RequestData, and shows them with a mapper; this
 * class owns the actor, brings the pieces to where they are drawn, and has the actor's properties.
 *
 * On several processes every one gets all pieces whole: a mark near the border of a process's part needs its
 * neighbors on the other side. All draw the same marks, of which compositing by depth keeps one. With
 * translucent marks in the view images are blended instead: then the root process draws alone, and the marks
 * are not hidden by what only other processes hold.
 *
 * @sa vtkInkSplattingLinesRepresentation vtkInkStippleRepresentation
 */
#ifndef vtkInkRepresentation_h
#define vtkInkRepresentation_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkPVDataRepresentation.h"
#include "vtkSmartPointer.h" // for the pieces

#include <memory> // for the paper
#include <string> // for arrays' names
#include <vector> // for the pieces

class vtkActor;
class vtkInkPaper;
class vtkPolyData;

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkInkRepresentation : public vtkPVDataRepresentation
{
public:
  vtkTypeMacro(vtkInkRepresentation, vtkPVDataRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The actor's state: opacity of all that is drawn (0 to 1), and where it stands, as vtkProp3D defines it.
   */
  void SetOpacity(double opacity);
  void SetPosition(double x, double y, double z);
  void SetScale(double x, double y, double z);
  void SetOrientation(double x, double y, double z);
  void SetOrigin(double x, double y, double z);
  void SetUserTransform(const double matrix[16]);
  ///@}

  /// Whether points can be picked in the view. Default: on. Points whose ids are not those of the input, as
  /// those put together from several datasets, cannot be.
  void SetPickable(bool pickable);

  ///@{
  /**
   * Paper: whether the view behind all that is drawn has the paper's color in place of its own background,
   * as long as this is visible; a picture with a transparent background stays transparent. Default: on,
   * white.
   */
  void SetPaper(bool paper);
  void SetPaperColor(double red, double green, double blue);
  ///@}

  void SetVisibility(bool visible) override;

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

  /// The points as they are drawn; empty before the first update.
  vtkDataObject* GetRenderedDataObject(int port) override;

protected:
  /// @param actor to which the subclass gives its mapper
  /// @param pieces how many pieces of poly data the subclass draws from
  /// @param arrays how many arrays of its input it draws by, with SetInputArrayToProcess; the first is the
  /// one to color by. Without one, the name is empty. RequestData is run again when one is
  /// chosen that the pieces do not serve for.
  vtkInkRepresentation(vtkSmartPointer<vtkActor> actor, int pieces, int arrays);
  ~vtkInkRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

  vtkActor* GetActor();
  /// Those of this process, never null; RequestData changes what they hold. The first has the points that
  /// are drawn.
  vtkPolyData* GetPiece(int piece);
  /// To be called in RequestData, for a first piece whose points have the ids of the input.
  void MarkIdsAsInputs();
  ///@{
  /// What SetInputArrayToProcess was told of an array.
  std::string GetArrayName(int array);
  int GetArrayAssociation(int array);
  ///@}
  /// Whether the pieces, made for another array, do for the one that is chosen now. The same on all processes
  /// that have the data. Here: no.
  virtual bool ServesFor(int array);
  /// Hands the pieces of all processes to the mapper, each where it has been delivered, else null.
  virtual void Show(const std::vector<vtkPolyData*>& delivered) = 0;

private:
  vtkInkRepresentation(const vtkInkRepresentation&) = delete;
  void operator=(const vtkInkRepresentation&) = delete;

  void Deliver(vtkInformation* inInfo, vtkInformation* outInfo);
  bool DrawsOnThisProcess();
  void UpdatePickable();
  bool ArraysChanged();

  std::vector<vtkSmartPointer<vtkPolyData>> Pieces;
  const vtkSmartPointer<vtkActor> Actor;
  const std::unique_ptr<vtkInkPaper> Paper;
  const int NumberOfArrays;
  std::vector<std::string> Arrays; ///< that the pieces were made with
  bool Pickable = true;
  bool PointIdsAreInputs = false;
};

#endif
