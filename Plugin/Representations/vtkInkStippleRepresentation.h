// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkStippleRepresentation
 * @brief   "Stipple": shows images and meshes as stipple drawings in ParaView's render views
 *
 * An image, or each image of a composite dataset, is stippled by its gradients; of other data the outer
 * surface is. Stipples that a vtkInkStippleGenerator made are drawn as they are. The drawing is a
 * vtkInkStippleMapper's. Stipples are made again when the data or a property of the generator changes; the
 * mapper's properties only change what is drawn of them.
 *
 * On several processes percentiles and ranges are those of the whole image, of which each process stipples
 * its part, so that the picture is that of one process. Meshes are put together and stippled by the first
 * process. Five levels of ghost cells are asked for; images in composite datasets have none, and stipples
 * there do not mind those of their neighbors.
 *
 * Colors: the array that is chosen for the representation, of an image's points, or of points or cells of
 * other data; none: the ink. The active scalars, or the array chosen last, go with the stipples in any case,
 * so that coloring by them, or not, makes no new ones.
 *
 * @sa vtkInkStippleGenerator vtkInkStippleMapper vtkSMInkStippleRepresentationProxy
 */
#ifndef vtkInkStippleRepresentation_h
#define vtkInkStippleRepresentation_h

#include "vtkInkPluginRepresentationsModule.h" // for the export macro
#include "vtkInkRepresentation.h"
#include "vtkNew.h" // for the members

#include <memory> // for the members

class vtkInkEarlyFXAA;
class vtkInkStippleGenerator;
class vtkInkStippleMapper;
class vtkScalarsToColors;

class VTKINKPLUGINREPRESENTATIONS_EXPORT vtkInkStippleRepresentation : public vtkInkRepresentation
{
public:
  static vtkInkStippleRepresentation* New();
  vtkTypeMacro(vtkInkStippleRepresentation, vtkInkRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How stipples are made: see vtkInkStippleGenerator for meaning, range and default. NumberOfSurfaceStipples
   * 0 stands for as many as a picture of PictureSize pixels has room for that shows the whole mesh, two
   * million at most. PictureSize: 100 to 10000 pixels; default 600.
   */
  void SetMaximumStipples(int maximumStipples);
  void SetNumberOfSurfaceStipples(vtkIdType numberOfSurfaceStipples);
  void SetPictureSize(double pixels);
  void SetThresholdMode(int thresholdMode);
  void SetGradientPercentile(double gradientPercentile);
  void SetGradientThreshold(double gradientThreshold);
  void SetLayerThickness(double layerThickness);
  void SetGradientMethod(int gradientMethod);
  void SetUseScalarWindow(bool useScalarWindow);
  void SetUseReferenceRanges(bool useReferenceRanges);
  void SetReferenceGradient(double referenceGradient);
  void SetSeed(int seed);
  void SetScalarWindow(double lowest, double highest);
  void SetReferenceScalarRange(double lowest, double highest);
  ///@}

  void SetVisibility(bool visible) override;

  /// The point array of images whose gradients are stippled, with vtkAlgorithm::SetInputArrayToProcess's
  /// parameters, of which the last two count. An empty name, and "Active Scalars", stands for these.
  /// Default: these.
  void SelectStippleArray(int, int, int, int association, const char* name);

  ///@{
  /**
   * Whether an image's iso-surface at IsoValue hides what lies behind it; stipples are made only of what it
   * encloses then, unless there is a ScalarWindow, and each takes less room. Default: off, 0.
   */
  void SetIsoSurfaceHides(bool hides);
  void SetIsoValue(double value);
  ///@}

  /// Whether a mesh hides what lies behind it. Default: on.
  void SetSurfaceHides(bool hides);

  ///@{
  /**
   * The mapper's parameters: see vtkInkStippleMapper for meaning, range and default.
   */
  void SetBoundary(bool boundary);
  void SetKgc(double kgc);
  void SetKgs(double kgs);
  void SetKge(double kge);
  void SetSilhouette(bool silhouette);
  void SetKsc(double ksc);
  void SetKss(double kss);
  void SetKse(double kse);
  void SetResolution(bool resolution);
  void SetKrc(double krc);
  void SetKnz(double knz);
  void SetLighting(bool lighting);
  void SetKle(double kle);
  void SetFacingAngle(double facingAngle);
  void SetHeadlight(bool headlight);
  void SetLightInk(bool lightInk);
  void SetDistance(bool distance);
  void SetKde(double kde);
  void SetDistanceSize(double distanceSize);
  void SetInterior(bool interior);
  void SetKie(double kie);
  void SetInteriorSize(double interiorSize);
  void SetValueEffect(double valueEffect);
  void SetGrowing(bool growing);
  void SetSmallElements(int smallElements);
  void SetMinimumCoverage(double minimumCoverage);
  void SetFade(double fade);
  void SetAppearBySize(bool appearBySize);
  void SetPositionPrecision(int positionPrecision);
  void SetWarmCool(double warmCool);
  void SetToneWeight(double toneWeight);
  void SetDistanceWeight(double distanceWeight);
  void SetOccluderOffset(double occluderOffset);
  void SetPixelsPerStipple(double pixels);
  void SetStippleSize(double pixels);
  void SetWarmColor(double red, double green, double blue);
  void SetCoolColor(double red, double green, double blue);
  void SetInkColor(double red, double green, double blue);
  ///@}

  ///@{
  /**
   * Colors of scalars; MapScalars off takes bytes, and numbers from 0 to 1, for colors. Default: on.
   */
  void SetLookupTable(vtkScalarsToColors* table);
  void SetMapScalars(bool map);
  ///@}

protected:
  vtkInkStippleRepresentation();
  ~vtkInkStippleRepresentation() override;

  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  bool ServesFor(int array) override;
  void Show(const std::vector<vtkPolyData*>& delivered) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkInkStippleRepresentation(const vtkInkStippleRepresentation&) = delete;
  void operator=(const vtkInkStippleRepresentation&) = delete;

  void ReportProgress();
  template <class Change>
  void ChangeGenerator(const Change& change);
  template <class Value>
  void ChangeValue(Value& value, Value changed);

  vtkNew<vtkInkStippleGenerator> Generator;
  bool IsoSurfaceHides = false;
  double IsoValue = 0.0;
  bool SurfaceHides = true;
  double PictureSize = 600.0;
  std::string Colors; ///< the array that the stipples have, to be colored by; empty: none
  int ColorsAssociation = 0;

  vtkNew<vtkInkStippleMapper> Mapper;
  double PixelsPerStipple;
  const std::unique_ptr<vtkInkEarlyFXAA> FXAA;
  /// What is drawn: the delivered stipples with the numbers that belong to them.
  vtkNew<vtkPolyData> Drawn;
  vtkMTimeType DrawnTime = 0; ///< when what it was put together from was last changed
};

#endif
