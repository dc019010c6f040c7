// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkSplattingLinesRepresentation
 * @brief   "Splatting Lines": shows points with normals as a line drawing in ParaView's render views
 *
 * Takes any vtkPointSet, or a composite dataset of them, whose points carry the array `Normals` (or other
 * active normals), and draws it with a vtkInkSplattingLinesMapper of its own. A point array `Radius` is used
 * if there is one. The leaves of a composite dataset are drawn as one set of points, so that lines run across
 * them; ghost points are left out. Points without normals draw nothing and give one warning.
 *
 * Colors: the array that is chosen for the representation, of points or cells; none: the ink. While ParaView
 * renders with a lower level of detail, as many points are drawn as PointsWhileMoving says, with larger
 * radii.
 *
 * @sa vtkInkSplattingLinesMapper vtkInkIsoSurfaceSampler
 */
#ifndef vtkInkSplattingLinesRepresentation_h
#define vtkInkSplattingLinesRepresentation_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkInkRepresentation.h"
#include "vtkNew.h" // for the mapper

class vtkInkSplattingLinesMapper;
class vtkScalarsToColors;

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkInkSplattingLinesRepresentation : public vtkInkRepresentation
{
public:
  static vtkInkSplattingLinesRepresentation* New();
  vtkTypeMacro(vtkInkSplattingLinesRepresentation, vtkInkRepresentation);

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
  void SetPaperVisibility(bool visible);
  void SetMinimumRadius(double radius);
  void SetHardness(double hardness);
  void SetLineWidth(double width);
  void SetSpeckleLength(double length);
  void SetThinning(bool thinning);
  void SetToneColor(double red, double green, double blue);
  void SetCoarsestTexel(int pixels);
  void SetHalfFloats(bool halfFloats);
  void SetHiddenLayers(bool hiddenLayers);
  void SetNumberOfLayers(int layers);
  void SetPeelBackFaces(bool peel);
  ///@}

  /// The color of the surface between the lines, and of the paper behind all. Default: white.
  void SetPaperColor(double red, double green, double blue);

  /// Where no array is chosen: lines go from the ink at contours to ToneColor where the surface faces the
  /// viewer. Default: off.
  void SetColorByTone(bool byTone);

  ///@{
  /**
   * The lines of hidden layers. The second layer gets HiddenStrength of its ink, each further one two thirds
   * of that before. HiddenColor holds with UseHiddenColor, else they have the ink's color or the array's.
   * Width and length of dashes as in vtkInkSplattingLinesMapper. Defaults: those of the mapper's second
   * layer; UseHiddenColor: off; HiddenColor: a blue (0.2, 0.4, 0.7).
   */
  void SetHiddenStrength(double strength);
  void SetUseHiddenColor(bool use);
  void SetHiddenColor(double red, double green, double blue);
  void SetHiddenLineWidth(double width);
  void SetHiddenDashLength(double length);
  ///@}

  /// Leave out what faces away from the viewer: right for closed surfaces, and faster. Default: off.
  void SetCullBackFaces(bool cull);

  /// The most points that are drawn at a lower level of detail; 0: all. Default: 200000.
  void SetPointsWhileMoving(int points);

  ///@{
  /**
   * Colors of scalars; MapScalars off takes bytes, and numbers from 0 to 1, for colors. Default: on.
   */
  void SetLookupTable(vtkScalarsToColors* table);
  void SetMapScalars(bool map);
  ///@}

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkInkSplattingLinesRepresentation();
  ~vtkInkSplattingLinesRepresentation() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  void Show(const std::vector<vtkPolyData*>& delivered) override;

private:
  vtkInkSplattingLinesRepresentation(const vtkInkSplattingLinesRepresentation&) = delete;
  void operator=(const vtkInkSplattingLinesRepresentation&) = delete;

  void UpdateColors();

  vtkNew<vtkInkSplattingLinesMapper> Mapper;
  vtkNew<vtkPolyData> Drawn;  ///< the mapper's input
  vtkMTimeType DrawnTime = 0; ///< of the points that Drawn was made from
  bool ColorByTone = false;
  bool UseHiddenColor = false;
  double HiddenColor[3] = { 0.2, 0.4, 0.7 };
  int PointsWhileMoving = 200000;
};

#endif
