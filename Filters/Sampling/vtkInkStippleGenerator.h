// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkStippleGenerator
 * @brief   volumes and meshes to lists of stipples, each in order of priority
 *
 * The preprocessing of Lu et al. (2003, section 4): every element of the data, a voxel of a vtkImageData or a
 * polygon of a vtkPolyData, gets a list of stipples once. Whatever depends on the camera, vtkInkStippleMapper
 * does by drawing the beginnings of these lists.
 *
 * Volumes: a voxel, the cube of one sample step around a point of the image, gets MaximumStipples stipples
 * when its gradient is steep enough, see SetThresholdMode, and it has values in the ScalarWindow, if there
 * is one. They lie in the voxel between the planes p1 and p2 beside its tangent plane, see SetLayerThickness,
 * and are spread evenly in it and across its neighbors: seen along the surface's normal they are close to a
 * Poisson-disc sampling, and so are the first n of all voxels for every n. The gradient is by default that of
 * the 4D linear regression that the paper uses (section 4.1), see vtkInkGradient.
 *
 * Surfaces: the whole mesh is sampled as by vtkInkSurfaceSampler, as blue noise in order of priority, and
 * each polygon gets those of the samples that lie in it. So their number follows the area, and their pattern
 * does not depend on how the surface is cut into polygons.
 *
 * Output: the points are the stipples, element by element; one VTK_POLY_VERTEX cell (which
 * VTK calls VTK_VERTEX where it holds one point) for each element that has any holds its list, in order of
 * priority. Cell data: `Normals` (unit; out of the denser side, or out of the front of the polygon: the mean
 * of its points' normals where the mesh has some); of volumes also `GradientMagnitude` (0 to 1, relative to
 * the magnitude below which 99 of 100 stippled voxels lie) and `Value` (0 to 1, relative to the image's
 * range); with PassScalars the scalars for colors, as active scalars and under their own name, or that after
 * `Input` if it is one of the above. Point data,
 * of surfaces only: `Priority`, of all stipples together. Field data: `ElementKind` (0 volume, 1 surface),
 * `ElementSize` (world units: the voxel's edge, or the root of the polygons' mean area), `StipplesPerElement`
 * (MaximumStipples; for surfaces the mean over all polygons), of volumes also `ScalarRange` and
 * `GradientMagnitudeRange`, which 0 and 1 stand for.
 *
 * The same input gives the same stipples on any number of threads and of pieces. Percentiles and ranges are
 * those of the whole image, so the whole is asked for whatever piece is asked of this filter, and the first
 * piece has all stipples. With UseReferenceRanges and a GradientThreshold nothing of the whole is needed:
 * then each piece is asked for with five levels of ghost cells, and an image of which no process has the
 * whole, as in a simulation, gives exactly the same stipples if its parts have as many (cells that are
 * another part's being marked as duplicates). So do statistics of all parts, see SetStatistics. Without, such
 * a part has percentiles and ranges of its own. A whole image that is given for every piece, or for the first
 * one only, is the first piece's. Pieces of a mesh are sampled each for itself.
 *
 * Hidden points, NaN and infinite values get no stipples. An image without any gradient that is steep enough
 * gives none, which is no error. Errors, each with an empty output: data that are neither an image nor a mesh
 * (vtkResampleToImage and vtkDataSetSurfaceFilter make them), no such point array, ArrayComponent
 * beyond its components, a spacing of zero or a direction matrix without inverse, a mesh without polygons or
 * without area, an array to pass that is not there, more stipples than memory.
 *
 * @sa vtkInkStippleMapper vtkInkGradient vtkInkSurfaceSampler
 */
#ifndef vtkInkStippleGenerator_h
#define vtkInkStippleGenerator_h

#include "vtkInkFiltersSamplingModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for std::shared_ptr

namespace ink
{
struct VolumeStatistics;
}

class vtkDataArray;
class vtkDataSet;
class vtkImageData;

class VTKINKFILTERSSAMPLING_EXPORT vtkInkStippleGenerator : public vtkPolyDataAlgorithm
{
public:
  static vtkInkStippleGenerator* New();
  vtkTypeMacro(vtkInkStippleGenerator, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * N_max: the stipples in a voxel's list, and on average in a polygon's. Default: 8; range 1 to 64. More
   * let the mapper go nearer before the lists are used up, and take memory in proportion.
   */
  vtkSetClampMacro(MaximumStipples, int, 1, 64);
  vtkGetMacro(MaximumStipples, int);
  ///@}

  ///@{
  /**
   * Surfaces: the number of all stipples. 0, the default: MaximumStipples for each polygon, so that it
   * does depend on the number of polygons. With a number given, the pattern depends on the surface alone.
   */
  vtkSetClampMacro(NumberOfSurfaceStipples, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(NumberOfSurfaceStipples, vtkIdType);
  ///@}

  /// What a gradient is compared with, see SetThresholdMode.
  enum ThresholdModeType
  {
    PERCENTILE = 0,
    MAGNITUDE = 1
  };

  ///@{
  /**
   * Which voxels are stippled. PERCENTILE (default): those with a gradient as steep as that of the upper part
   * of all voxels, see SetGradientPercentile. MAGNITUDE: those with at least GradientThreshold. A gradient of
   * 0 never passes.
   */
  vtkSetClampMacro(ThresholdMode, int, PERCENTILE, MAGNITUDE);
  vtkGetMacro(ThresholdMode, int);
  void SetThresholdModeToPercentile() { this->SetThresholdMode(PERCENTILE); }
  void SetThresholdModeToMagnitude() { this->SetThresholdMode(MAGNITUDE); }
  const char* GetThresholdModeAsString();
  ///@}

  ///@{
  /**
   * How many percent of the image's voxels have a gradient too small for stipples, to within a hundredth of
   * the gradient. Default: 95; range 0 to 100. Less shows weaker boundaries, and more noise.
   */
  void SetGradientPercentile(double value);
  double GetGradientPercentileMinValue() { return 0.0; }
  double GetGradientPercentileMaxValue() { return 100.0; }
  vtkGetMacro(GradientPercentile, double);
  ///@}

  ///@{
  /**
   * The smallest gradient magnitude with stipples, in value per world unit. Default: 0, all that is not
   * constant; range from 0 on.
   */
  void SetGradientThreshold(double value);
  double GetGradientThresholdMinValue() { return 0.0; }
  double GetGradientThresholdMaxValue() { return VTK_DOUBLE_MAX; }
  vtkGetMacro(GradientThreshold, double);
  ///@}

  ///@{
  /**
   * The distance between the planes p1 and p2 in voxel edges. Default: 1, which fills flat surfaces without
   * gaps between layers of voxels; range 0 (all on the tangent plane) to 2 (from 1.73 on anywhere in the
   * voxel). Thin layers are sharper seen from the side, but show the voxels there.
   */
  void SetLayerThickness(double value);
  double GetLayerThicknessMinValue() { return 0.0; }
  double GetLayerThicknessMaxValue() { return 2.0; }
  vtkGetMacro(LayerThickness, double);
  ///@}

  /// How gradients are estimated, see SetGradientMethod.
  enum GradientMethodType
  {
    CENTRAL_DIFFERENCE = 0,
    REGRESSION = 1
  };

  ///@{
  /**
   * CENTRAL_DIFFERENCE: sharper, for data without noise. REGRESSION (default): 4D linear regression over 3 x
   * 3 x 3 points, which also smooths the value.
   */
  vtkSetClampMacro(GradientMethod, int, CENTRAL_DIFFERENCE, REGRESSION);
  vtkGetMacro(GradientMethod, int);
  void SetGradientMethodToCentralDifference() { this->SetGradientMethod(CENTRAL_DIFFERENCE); }
  void SetGradientMethodToRegression() { this->SetGradientMethod(REGRESSION); }
  const char* GetGradientMethodAsString();
  ///@}

  ///@{
  /**
   * Volumes: stipple only voxels with values in ScalarWindow, by the value, smoothed by the regression, and
   * the gradient in their middle: a material, or a band around an iso-value, also one of no width. Default:
   * off.
   */
  vtkSetMacro(UseScalarWindow, bool);
  vtkGetMacro(UseScalarWindow, bool);
  vtkBooleanMacro(UseScalarWindow, bool);
  ///@}

  ///@{
  /**
   * The lowest and the highest value with stipples, in the scalars' unit. Default: 0 and 0. NaN, and a
   * highest below the lowest, are refused with a warning.
   */
  void SetScalarWindow(double lowest, double highest);
  void SetScalarWindow(const double window[2]) { this->SetScalarWindow(window[0], window[1]); }
  vtkGetVector2Macro(ScalarWindow, double);
  ///@}

  ///@{
  /**
   * Volumes: whether Value and GradientMagnitude are relative to ReferenceScalarRange and ReferenceGradient
   * instead of the image's own ranges, so that several images, as those of a time series or the parts of a
   * distributed one, look alike. Default: off.
   */
  vtkSetMacro(UseReferenceRanges, bool);
  vtkGetMacro(UseReferenceRanges, bool);
  vtkBooleanMacro(UseReferenceRanges, bool);
  ///@}

  ///@{
  /**
   * The values at which Value is 0 and 1, in the scalars' unit; what an output's `ScalarRange` says of its
   * own image. Default: 0 and 1. NaN, and the second below the first, are refused with a warning.
   */
  void SetReferenceScalarRange(double lowest, double highest);
  void SetReferenceScalarRange(const double range[2]) { this->SetReferenceScalarRange(range[0], range[1]); }
  vtkGetVector2Macro(ReferenceScalarRange, double);
  ///@}

  ///@{
  /**
   * The gradient's magnitude at which GradientMagnitude is 1, in value per world unit; what an output's
   * `GradientMagnitudeRange` says of its own image. Default: 1; range from 0 on.
   */
  void SetReferenceGradient(double value);
  double GetReferenceGradientMinValue() { return 0.0; }
  double GetReferenceGradientMaxValue() { return VTK_DOUBLE_MAX; }
  vtkGetMacro(ReferenceGradient, double);
  ///@}

  ///@{
  /**
   * Give the elements scalars to be colored by: the array that SetInputArrayToProcess(1, ...) names, of the
   * image's points or of the mesh's points or cells, or without a name the active point scalars. A polygon
   * takes the mean of its first three points. Default: off.
   */
  vtkSetMacro(PassScalars, bool);
  vtkGetMacro(PassScalars, bool);
  vtkBooleanMacro(PassScalars, bool);
  ///@}

  ///@{
  /**
   * Another seed gives other stipples, just as good. Default: 0.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * Volumes: the component of the input scalars that counts. Default: 0.
   */
  vtkSetClampMacro(ArrayComponent, int, 0, VTK_INT_MAX);
  vtkGetMacro(ArrayComponent, int);
  ///@}

  ///@{
  /**
   * The type of the stipples' coordinates: vtkAlgorithm::SINGLE_PRECISION, DOUBLE_PRECISION or
   * DEFAULT_PRECISION (default), which is that of a mesh's points, and for an image single unless it lies so
   * far from the origin that single precision would move points by more than a thousandth of the smallest
   * spacing.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  void SetOutputPointsPrecisionToSingle() { this->SetOutputPointsPrecision(SINGLE_PRECISION); }
  void SetOutputPointsPrecisionToDouble() { this->SetOutputPointsPrecision(DOUBLE_PRECISION); }
  void SetOutputPointsPrecisionToDefault() { this->SetOutputPointsPrecision(DEFAULT_PRECISION); }
  const char* GetOutputPointsPrecisionAsString();
  ///@}

  ///@{
  /**
   * For an image of which several processes hold parts, and for several images that are drawn together:
   * percentiles and ranges of them all, so that nothing of the whole image is asked for. Measure adds what
   * this input's own voxels are like, with the input brought up to date as `request` says (as
   * vtkAlgorithm::Update takes it); it returns false, after one error, where they cannot be measured. Null
   * (default): those of the input.
   */
  bool Measure(vtkInformation* request, ink::VolumeStatistics& statistics);
  void SetStatistics(std::shared_ptr<const ink::VolumeStatistics> statistics);
  ///@}

  /**
   * How many stipples a mesh needs so that a picture of it has room for no more, its far side included.
   * `pixels` is what the longest side of its bounds measures in the picture; a stipple takes
   * `pixelsPerStipple`. Between 20,000 and 2,000,000; 0 without polygons.
   */
  static vtkIdType CountForPicture(vtkPolyData* mesh, double pixels, double pixelsPerStipple);

protected:
  vtkInkStippleGenerator();
  ~vtkInkStippleGenerator() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkInkStippleGenerator(const vtkInkStippleGenerator&) = delete;
  void operator=(const vtkInkStippleGenerator&) = delete;

  void StippleVolume(vtkInformationVector** input, vtkInformation* outInfo, vtkPolyData* output);
  /// Warns that no voxel of the whole image is stippled.
  void ReportNothing(vtkDataArray* scalars);
  void StippleSurface(vtkPolyData* mesh, vtkInformationVector** input, vtkPolyData* output);
  /// The array for colors, null when none is wanted; `ofCells` says whose it is.
  vtkDataArray* GetColors(vtkDataSet* data, vtkInformationVector** input, bool& ofCells);
  bool NeedsWholeImage() const;
  bool ReportProgress(double share);

  int MaximumStipples = 8;
  vtkIdType NumberOfSurfaceStipples = 0;
  int ThresholdMode = PERCENTILE;
  double GradientPercentile = 95.0;
  double GradientThreshold = 0.0;
  double LayerThickness = 1.0;
  int GradientMethod = REGRESSION;
  bool UseScalarWindow = false;
  double ScalarWindow[2] = { 0.0, 0.0 };
  bool UseReferenceRanges = false;
  double ReferenceScalarRange[2] = { 0.0, 1.0 };
  double ReferenceGradient = 1.0;
  bool PassScalars = false;
  int Seed = 0;
  int ArrayComponent = 0;
  int OutputPointsPrecision = DEFAULT_PRECISION;
  std::shared_ptr<const ink::VolumeStatistics> Statistics;
  ink::VolumeStatistics* Measured = nullptr; ///< to be filled in place of making stipples; null: done
};

#endif
