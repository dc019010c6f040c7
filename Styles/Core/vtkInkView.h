// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkView
 * @brief   from which side a subject is seen in a picture
 *
 * World axes are read as DICOM's: +x is the subject's left, +y its back, +z its top; Up makes another axis
 * its top. A mesh or a cloud of points, of whose axes nobody says anything, is looked at: Choose finds how it
 * seems to stand, and the side that shows most of it.
 *
 *     vtkNew<vtkInkView> view;
 *     view->Choose(mesh, "bunny.ply");
 *     view->ChooseForFrame(style->GetFramePoints(), style->IsSeenThrough());
 *     view->Apply(camera);
 *     fit->AddPoints(style->GetFramePoints(), camera);
 *     fit->Apply(camera);
 *
 * @sa vtkInkCameraFit
 */
#ifndef vtkInkView_h
#define vtkInkView_h

#include "InkSetters.h"
#include "vtkInkStylesModule.h" // for the export macro
#include "vtkObject.h"
#include "vtkSmartPointer.h" // for the image

#include <array>    // for the sides of an image
#include <optional> // for what is given
#include <string>   // for names

class vtkCamera;
class vtkDataObject;
class vtkImageData;
class vtkPoints;

class VTKINKSTYLES_EXPORT vtkInkView : public vtkObject
{
public:
  static vtkInkView* New();
  vtkTypeMacro(vtkInkView, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The side that the subject is seen from: front, back, left, right, top, bottom, or iso, which is from its
   * front, left and top at equal angles. Default: front, or what Choose found. An unknown name is an error
   * and changes nothing.
   */
  void SetName(const std::string& name);
  const std::string& GetName() { return this->Name; }
  static int GetNumberOfNames();
  static const char* GetNameOfView(int view); ///< null out of range
  ///@}

  ///@{
  /**
   * The axis of the world that is the subject's top: x, y or z, or one of these with a minus. Default: z, or
   * what Choose found. An unknown one is an error and changes nothing.
   */
  void SetUp(const std::string& axis);
  const std::string& GetUp() { return this->Up; }
  static int GetNumberOfAxes();
  static const char* GetAxis(int axis); ///< null out of range
  ///@}

  ///@{
  /// How many degrees the viewer goes to the right, -360 to 360. Default: 0, or what Choose found.
  void SetAzimuth(double degrees);
  vtkGetMacro(Azimuth, double);
  ///@}

  ///@{
  /// How many degrees the viewer goes up after that, -360 to 360. Default: 0, or what Choose found.
  void SetElevation(double degrees);
  vtkGetMacro(Elevation, double);
  ///@}

  /**
   * Finds what was not set, for a mesh or for points; of all else it is as by default. Up is z, or y where
   * the mesh rests on a clearly larger base then; OBJ files have y up unless z is clearly better, and what
   * has the coordinates of a map z. Of the four sides the one is chosen from which most is seen, the front
   * unless another shows clearly more. What lies flat, or on a map, is seen from 30 degrees above, and where
   * all that is seen is one flat face, from 30 degrees to the right and 20 above; unless Name was set.
   * @param fileName of the data; null or empty: none
   */
  void Choose(vtkDataObject* data, const char* fileName = nullptr);

  /**
   * Finds from which side a volume is seen, of which only by now it is known what is drawn; after Choose. It
   * is the front, unless the left or the top shows 1.6 times as much: what lies flat is seen from above, and
   * what is long from its side. Does nothing where Name was set, and for meshes and points. What reaches from
   * one end of an image to the other then, as in scans of a few slices, shows no more than a cut there: it is
   * seen from its front or, where the cut is twice as large, from 45 degrees above that, or to the right of
   * its left. What covers more than half of the image's front, left and top, as a block that was cut out of a
   * rock, or of the box around it, as a block of its own, is seen from the corner between them, "iso", unless
   * an angle was set. Where nothing hides what lies within it, both are seen straight ahead.
   * @param frame the points that the picture is fitted to, see vtkInkStyle::GetFramePoints; null: none
   * @param seenThrough see vtkInkStyle::IsSeenThrough
   */
  void ChooseForFrame(vtkPoints* frame, bool seenThrough = false);

  /**
   * Makes a camera look from this side at the origin, from nowhere in particular: see vtkInkCameraFit.
   * @param turned degrees that the viewer goes further to the right, around what stands upright
   */
  void Apply(vtkCamera* camera, double turned = 0.0);

  ///@{
  /**
   * By how much what is rendered for a picture should be larger on either side, and made smaller then, so
   * that lines are smooth: 2; up to 4 for pictures of less than 500 pixels on both sides, until 500 of height
   * are rendered, as splats that measure a few pixels at least, and parts of the height otherwise, would get
   * broader lines there. See vtkInkStyle::SetPixelScale.
   */
  static int GetSupersampling(int width, int height);
  enum SupersamplingType
  {
    LEAST_SUPERSAMPLING = 2,
    MOST_SUPERSAMPLING = 4
  };
  ///@}

protected:
  vtkInkView() = default;
  ~vtkInkView() override = default;

private:
  vtkInkView(const vtkInkView&) = delete;
  void operator=(const vtkInkView&) = delete;

  /// @param covered the shares of the image's sides that what is drawn covers, see InkFindCutSides
  /// @param frame the points of what is drawn
  void TurnToSides(const std::array<double, 6>& covered, vtkPoints* frame);
  /// Whether what is drawn covers the three sides of a block that BlockView shows.
  bool IsBlock(const std::array<double, 6>& covered) const;
  /// Whether what is drawn reaches across the image in the direction of the view, so that both ends cut it.
  bool IsCutAcross(const std::array<double, 6>& covered) const;

  std::string Name = "front";
  std::string Up = "z";
  double Azimuth = 0.0;
  double Elevation = 0.0;
  bool OfMesh = false;                 ///< what was chosen last
  vtkSmartPointer<vtkImageData> Image; ///< where its voxels lie
  std::optional<std::string> GivenName;
  std::optional<std::string> GivenUp;
  std::optional<double> GivenAzimuth;
  std::optional<double> GivenElevation;
};

#endif
