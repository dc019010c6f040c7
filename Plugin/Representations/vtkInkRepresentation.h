// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkRepresentation
 * @brief   what vtkInk's styles have in common as representations in ParaView's render views
 *
 * A vtkInkStyle makes pieces of poly data from the input and draws them with its actor; this class brings the
 * pieces to where they are drawn, sets the style's parameters by their names, and has the actor's properties.
 * A subclass names the style, and does what of its data or of ParaView's views is its own.
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

#include "vtkBoundingBox.h"                    // for bounds
#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkInkStyle.h"                       // for its input
#include "vtkPVDataRepresentation.h"
#include "vtkSmartPointer.h" // for the pieces

#include <memory>  // for the paper
#include <string>  // for arrays' names
#include <utility> // for the array to color by
#include <vector>  // for the pieces

class vtkImageData;
class vtkInkPaper;
class vtkPolyData;
class vtkScalarsToColors;
class vtkTrivialProducer;

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkInkRepresentation : public vtkPVDataRepresentation
{
public:
  vtkTypeMacro(vtkInkRepresentation, vtkPVDataRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Sets a parameter of the style to its numbers; see vtkInkStyle. Marks are made again where they depend on
   * it. PaperColor is the color of the paper behind all, too.
   */
  void SetParameter(const char* name, double value);
  void SetParameter(const char* name, double first, double second);
  void SetParameter(const char* name, double first, double second, double third);
  ///@}

  /// The same as text, of a parameter that is no number.
  void SetParameterAsString(const char* name, const char* text);

  /// The array of images that is drawn, of points or else of cells, as SetInputArrayToProcess names it;
  /// "Active Scalars" (default): the active one. Of styles with Scalars.
  void SelectScalars(int, int, int, int, const char* name);

  ///@{
  /// The surface of an image: at a value that suits it (default), or at this one. Of styles with IsoValues.
  void SetAutomaticIsoValue(bool automatic);
  void SetIsoValue(double value);
  ///@}

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
   * Colors of scalars; MapScalars off takes bytes, and numbers from 0 to 1, for colors. Default: on.
   */
  void SetLookupTable(vtkScalarsToColors* table);
  void SetMapScalars(bool map);
  ///@}

  /// Paper: whether the view behind all that is drawn has the paper's color in place of its own background,
  /// as long as this is visible; a picture with a transparent background stays transparent. Default: on.
  void SetPaper(bool paper);

  /// Whether this process draws for a picture on a transparent background.
  void SetTransparentBackground(bool transparent);

  void SetVisibility(bool visible) override;

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

  /**
   * How large the data is seen, relative to a view of all of it (vtkInkMagnification.h): the style makes
   * marks for a picture that is so much larger, as far as it makes others then. Default: 1.
   */
  virtual void SetMagnification(double magnification);

  /// While this is on, the marks of images of many points are made of fewer of these (vtkInkCoarseImage.h),
  /// for a smaller picture, if one process has all; of all when it is switched off. Default: off.
  void SetPreview(bool preview);

  /// A valid box around data, where the actor is in the world.
  vtkBoundingBox ToWorld(const vtkBoundingBox& box);

  /// The iso-values of the surfaces that were made last, given or chosen, one of each kind: of the only
  /// or the inner surface, then of the outer one. Here: none.
  virtual std::vector<double> GetUsedIsoValues();

protected:
  explicit vtkInkRepresentation(vtkSmartPointer<vtkInkStyle> style);
  ~vtkInkRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

  /// Makes the pieces of this process, on all processes at once. Here: as the style does. @return what is
  /// wrong with the data, said once; empty if nothing is
  virtual std::string MakeMarks(const vtkInkStyle::Input& input);

  vtkInkStyle* GetStyle() const { return this->Style; }

  /// Whether marks are blended, so that those of several processes have to be put into an order. The same on
  /// all of them, and before there is a picture.
  virtual bool BlendsMarks();
  /// Hands the pieces of all processes, each where it has been delivered, else null, to the style. Here: as
  /// they are.
  virtual void Show(const std::vector<vtkPolyData*>& delivered);
  /// Whether the pieces, made with another array to color by, do for this one. The same on all processes that
  /// have the data. Here: they don't.
  virtual bool ServesFor(const std::string& name, int association);

  /// Those of this process, never null; MakeMarks changes what they hold. The first has the points that are
  /// drawn.
  vtkPolyData* GetPiece(int piece);
  /// To be called in MakeMarks, for a first piece whose points have the ids of the input.
  void MarkIdsAsInputs();
  ///@{
  /// The array to color by, as SetInputArrayToProcess was told; an empty name: none.
  std::string GetColorArray();
  int GetColorAssociation();
  ///@}

  /// A number that may be automatic.
  struct Choice
  {
    bool Automatic = true;
    double Value = 0.0;
  };
  /// Sets a parameter of the style that is automatic without a number.
  void ApplyChoice(const char* parameter, const Choice& choice);

  /// Asks for the ghost cells that tell the outer surface of a grid. For RequestUpdateExtent.
  static void AskForGhostsOfGrids(vtkInformationVector** inputVector);

  /// Calls a function that changes the style; marks are made again where they depend on what it changes.
  template <class Change>
  void ChangeStyle(const Change& change)
  {
    const vtkMTimeType before = this->Style->GetMTime();
    change(this->Style.Get());
    if (this->Style->GetMTime() > before)
    {
      this->MarkModified();
    }
  }

private:
  vtkInkRepresentation(const vtkInkRepresentation&) = delete;
  void operator=(const vtkInkRepresentation&) = delete;

  void Deliver(vtkInformation* inInfo, vtkInformation* outInfo);
  bool DrawsOnThisProcess();
  void UpdatePickable();
  bool LacksColors();
  /// Has marks be made of fewer points of the input's image.
  void TakeCoarse(vtkInkStyle::Input& input, vtkImageData* image);
  void ReportProgress();

  const vtkSmartPointer<vtkInkStyle> Style;
  std::vector<vtkSmartPointer<vtkPolyData>> Pieces;
  const std::unique_ptr<vtkInkPaper> Paper;
  /// The array to color by and its association when marks were made last.
  std::pair<std::string, int> MadeColors;
  Choice IsoValue;
  bool Preview = false;
  vtkSmartPointer<vtkTrivialProducer> Coarse; ///< of what marks are made in place of the input; null: of that
  vtkMTimeType CoarseTime = 0;                ///< when the input had changed last
  double Magnification = 1.0;
  int TimesMade = 0;
  bool Pickable = true;
  bool PointIdsAreInputs = false;
};

#endif
