// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkStippleGenerator
 * @brief stipple lists of volumes and meshes, each in order of priority
 *
 * The preprocessing of Lu et al. (2003, section 4): every element of the data, a voxel of a vtkImageData or a
 * polygon of a vtkPolyData, gets a list of stipples once. Everything that depends on the camera is done by
 * vtkInkStippleMapper, which draws a prefix of each list.
 *
 * Volumes: a voxel, the cube of one sample step around a point of the image, gets MaximumStipples stipples,
 * or as many as its projection has pixels, see SetMaximumStipplesMode, if its gradient magnitude reaches the
 * threshold, see SetThresholdMode, and it has values in the ScalarWindow, if there is one. They lie in the
 * voxel between the planes p1 and p2 on both sides of its tangent plane, see SetLayerThickness, and are
 * evenly distributed within the voxel and across its neighbors: seen along the surface normal they are close
 * to a Poisson-disk sampling, and so are the first n stipples of all voxels for every n. By default the
 * gradient is estimated by the paper's 4D linear regression (section 4.1), see vtkInkGradient.
 *
 * Surfaces: the whole mesh is sampled as by vtkInkSurfaceSampler, with blue noise in order of priority, and
 * each polygon gets the samples that lie in it. So their number follows the area, and their pattern does not
 * depend on the tessellation. Polygons with room for fewer than four share lists: an element is then a group
 * of about eight neighbors on one side of the surface, with the mean of their polygons' normals.
 *
 * Points without polygons that have `Normals` and `Radius`, as vtkInkIsoSurfaceSampler and
 * vtkInkSurfaceSampler make them: the surface that discs of these radii cover is sampled with blue noise in
 * order of priority, as densely as is asked for, however dense the points are. Elements are such groups, too,
 * with the mean normal of the discs that they lie on.
 *
 * Output: the points are the stipples, element by element; for each element with stipples one VTK_POLY_VERTEX
 * cell (which VTK reports as VTK_VERTEX where it holds one point) with its list, in order of priority. Cell
 * data: `Normals` (unit; along the negative gradient, or the polygon's: the mean of its point normals where
 * the mesh has some); of volumes also `GradientMagnitude` (0 to 1, relative to the magnitude below which 99
 * of 100 stippled voxels lie) and `Value` (0 to 1, relative to the image's range); with PassScalars the
 * scalars for colors, as active scalars and under their own name, prefixed with `Input` if it is one of the
 * above. Point data, of surfaces only: `Priority`, among all stipples. Field data: `ElementKind` (0 volume, 1
 * surface), `ElementSize` (world units: the voxel's edge, or the root of the elements' mean area),
 * `StipplesPerElement` (N_max; for surfaces the mean over all elements), of volumes also `ScalarRange` and
 * `GradientMagnitudeRange`, the values that 0 and 1 stand for.
 *
 * The same input gives the same stipples for any number of threads and pieces. Percentiles and ranges are
 * those of the whole image, so the filter requests the whole image for any piece, and the first piece has all
 * stipples. With UseReferenceRanges and a GradientThreshold no global statistics are needed: each piece is
 * requested with five levels of ghost cells, and a distributed image that no process holds as a whole, as in
 * a simulation, gives exactly the same stipples if its parts have five ghost levels (cells of other parts
 * being marked as duplicates), with Smoothing as many more as the Gaussian reaches. The same holds for given
 * statistics of all parts, see SetStatistics. Otherwise each part has percentiles and ranges of its own. If
 * the whole image arrives for every piece, or only for the first one, the first piece processes all of it.
 * Pieces of a mesh are sampled independently.
 *
 * Hidden points, NaN and infinite values get no stipples. An image in which no gradient reaches the threshold
 * gives none, which is not an error. Errors, each with an empty output: an input that is neither an image nor
 * a mesh (vtkResampleToImage and vtkDataSetSurfaceFilter make them), no such point array, ArrayComponent
 * beyond its components, a spacing of zero or a singular direction matrix, a mesh without polygons or without
 * area, a missing array to pass, more stipples than memory.
 *
 * @sa vtkInkStippleMapper vtkInkGradient vtkInkSurfaceSampler
 */
#ifndef vtkInkStippleGenerator_h
#define vtkInkStippleGenerator_h

#include "InkSetters.h"
#include "vtkInkFiltersSamplingModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for std::shared_ptr

namespace ink
{
namespace stipple // nested, as the wrapper of VTK wants it
{
struct VolumeStatistics;
}
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

  /// What sets the length of stipple lists, see SetMaximumStipplesMode.
  enum MaximumStipplesModeType
  {
    FIXED = 0,
    PROJECTED = 1
  };

  ///@{
  /**
   * What sets N_max, the number of stipples in a voxel's list and on average in a polygon's. FIXED (default):
   * MaximumStipples, whatever the picture; in close-ups the mapper enlarges stipples. PROJECTED: as many as
   * an element's largest projection has pixels (section 4.3) in a picture of PictureSize: 1 to 64 for a
   * voxel, 20,000 to 2,000,000 for a whole mesh, distributed by area; NumberOfSurfaceStipples takes
   * precedence.
   */
  vtkSetClampMacro(MaximumStipplesMode, int, FIXED, PROJECTED);
  vtkGetMacro(MaximumStipplesMode, int);
  void SetMaximumStipplesModeToFixed() { this->SetMaximumStipplesMode(FIXED); }
  void SetMaximumStipplesModeToProjected() { this->SetMaximumStipplesMode(PROJECTED); }
  const char* GetMaximumStipplesModeAsString();
  ///@}

  ///@{
  /**
   * With PROJECTED: the length in pixels of the longest side of the data's bounds in the picture. Default:
   * 600; range 100 to 100,000. Larger values make longer lists, for larger pictures and close-ups; time and
   * memory grow quadratically.
   */
  InkSetClampMacro(PictureSize, 100.0, 100000.0);
  vtkGetMacro(PictureSize, double);
  ///@}

  ///@{
  /**
   * With FIXED: the number of stipples in a voxel's list, and on average in a polygon's. Default: 8; range 1
   * to 64. More let the camera come closer before the lists are exhausted; memory is proportional.
   */
  vtkSetClampMacro(MaximumStipples, int, 1, 64);
  vtkGetMacro(MaximumStipples, int);
  ///@}

  ///@{
  /**
   * Surfaces: the total number of stipples. 0, the default: with FIXED, MaximumStipples per polygon, so that
   * it does depend on the tessellation; with PROJECTED, set by the surface's area. With a number given, or
   * PROJECTED, the pattern depends on the surface alone. On points' discs there are about so many (0 with
   * FIXED: MaximumStipples per point): their area, by which stipples are spaced, is estimated.
   */
  vtkSetClampMacro(NumberOfSurfaceStipples, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(NumberOfSurfaceStipples, vtkIdType);
  ///@}

  ///@{
  /**
   * Volumes: the standard deviation of the Gaussian that values are smoothed with before anything else is
   * made of them, in multiples of the smallest spacing, the same in all world directions; 0 to 8. Default: 0,
   * values as they are. Removes stipples that are noise's, and with them boundaries thinner than the
   * Gaussian. Some slices are smoothed at a time, never a copy of the image. NaN is refused with a warning.
   */
  InkSetClampMacro(Smoothing, 0.0, 8.0);
  vtkGetMacro(Smoothing, double);
  ///@}

  /// What gradient magnitudes are compared with, see SetThresholdMode.
  enum ThresholdModeType
  {
    PERCENTILE = 0,
    MAGNITUDE = 1
  };

  ///@{
  /**
   * Which voxels are stippled. PERCENTILE (default): those whose gradient magnitude reaches a percentile of
   * all voxels, see SetGradientPercentile. MAGNITUDE: those where it is at least GradientThreshold. A
   * gradient of 0 never passes.
   */
  vtkSetClampMacro(ThresholdMode, int, PERCENTILE, MAGNITUDE);
  vtkGetMacro(ThresholdMode, int);
  void SetThresholdModeToPercentile() { this->SetThresholdMode(PERCENTILE); }
  void SetThresholdModeToMagnitude() { this->SetThresholdMode(MAGNITUDE); }
  const char* GetThresholdModeAsString();
  ///@}

  ///@{
  /**
   * The percentage of the image's voxels whose gradient is too small for stipples; the resulting threshold is
   * exact to a hundredth of itself. Default: 95; range 0 to 100. Lower values show weaker boundaries, and
   * more noise.
   */
  InkSetClampMacro(GradientPercentile, 0.0, 100.0);
  vtkGetMacro(GradientPercentile, double);
  ///@}

  ///@{
  /**
   * The smallest gradient magnitude with stipples, in value per world unit. Default: 0, which stipples
   * everything that is not constant; range 0 upwards.
   */
  InkSetClampMacro(GradientThreshold, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(GradientThreshold, double);
  ///@}

  ///@{
  /**
   * The distance between the planes p1 and p2 in voxel edges. Default: 1, which covers flat surfaces without
   * voids between layers of voxels; range 0 (all stipples on the tangent plane) to 2 (from 1.73 on anywhere
   * in the voxel). Thin layers are sharper in profile, but show the voxel grid there.
   */
  InkSetClampMacro(LayerThickness, 0.0, 2.0);
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
   * CENTRAL_DIFFERENCE: sharper, for noise-free data. REGRESSION (default): 4D linear regression over 3 x 3 x
   * 3 points, which also smooths the value.
   */
  vtkSetClampMacro(GradientMethod, int, CENTRAL_DIFFERENCE, REGRESSION);
  vtkGetMacro(GradientMethod, int);
  void SetGradientMethodToCentralDifference() { this->SetGradientMethod(CENTRAL_DIFFERENCE); }
  void SetGradientMethodToRegression() { this->SetGradientMethod(REGRESSION); }
  const char* GetGradientMethodAsString();
  ///@}

  /// The weights of neighbors in the regression, see SetGradientWeighting.
  enum GradientWeightingType
  {
    UNIFORM = 0,
    INVERSE_DISTANCE = 1
  };

  ///@{
  /**
   * UNIFORM (default): equal weights, which leave the least noise. INVERSE_DISTANCE: weights that fall with
   * the distance, as the regression's authors require, which blur less; see vtkInkGradient::SetWeighting.
   * Central differences do not use it.
   */
  vtkSetClampMacro(GradientWeighting, int, UNIFORM, INVERSE_DISTANCE);
  vtkGetMacro(GradientWeighting, int);
  void SetGradientWeightingToUniform() { this->SetGradientWeighting(UNIFORM); }
  void SetGradientWeightingToInverseDistance() { this->SetGradientWeighting(INVERSE_DISTANCE); }
  const char* GetGradientWeightingAsString();
  ///@}

  ///@{
  /**
   * Volumes: stipple only voxels that contain values in ScalarWindow, according to the value (smoothed by the
   * regression) and the gradient at their center: a material, or a band around an iso-value, which may have
   * no width. Default: off.
   */
  vtkSetMacro(UseScalarWindow, bool);
  vtkGetMacro(UseScalarWindow, bool);
  vtkBooleanMacro(UseScalarWindow, bool);
  ///@}

  ///@{
  /**
   * The lowest and the highest value with stipples, in the scalars' unit. Default: 0 and 0. NaN, and a
   * highest value below the lowest, are refused with a warning.
   */
  InkSetRangeMacro(ScalarWindow);
  vtkGetVector2Macro(ScalarWindow, double);
  ///@}

  ///@{
  /**
   * Volumes: whether Value and GradientMagnitude are relative to ReferenceScalarRange and ReferenceGradient
   * instead of the image's own ranges, so that several images, such as the steps of a time series or the
   * parts of a distributed image, look alike. Default: off.
   */
  vtkSetMacro(UseReferenceRanges, bool);
  vtkGetMacro(UseReferenceRanges, bool);
  vtkBooleanMacro(UseReferenceRanges, bool);
  ///@}

  ///@{
  /**
   * The scalars at which Value is 0 and 1; `ScalarRange` of an output has those of its own image. Default: 0
   * and 1. NaN, and a second value below the first, are refused with a warning.
   */
  InkSetRangeMacro(ReferenceScalarRange);
  vtkGetVector2Macro(ReferenceScalarRange, double);
  ///@}

  ///@{
  /**
   * The gradient magnitude at which GradientMagnitude is 1, in value per world unit; `GradientMagnitudeRange`
   * of an output has that of its own image. Default: 1; range 0 upwards.
   */
  InkSetClampMacro(ReferenceGradient, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(ReferenceGradient, double);
  ///@}

  ///@{
  /**
   * Pass scalars to color the elements by: the array set with SetInputArrayToProcess(1, ...), of the image's
   * points or of the mesh's points or cells, or without a name the active point scalars. A polygon gets the
   * mean of its first three points. Default: off.
   */
  vtkSetMacro(PassScalars, bool);
  vtkGetMacro(PassScalars, bool);
  vtkBooleanMacro(PassScalars, bool);
  ///@}

  ///@{
  /**
   * The random seed: each gives different stipples of the same quality. Default: 0.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  ///@{
  /**
   * Volumes: the component of the input scalars that is used. Default: 0.
   */
  vtkSetClampMacro(ArrayComponent, int, 0, VTK_INT_MAX);
  vtkGetMacro(ArrayComponent, int);
  ///@}

  ///@{
  /**
   * The type of the stipples' coordinates: vtkAlgorithm::SINGLE_PRECISION, DOUBLE_PRECISION or
   * DEFAULT_PRECISION (default): for a mesh that of its points, for an image single unless it lies so far
   * from the origin that single precision would move points by more than a thousandth of the smallest
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
   * Global statistics, for an image distributed over several processes and for several images that are drawn
   * together: percentiles and ranges of all of them, so that the filter need not request the whole image.
   * Measure adds those of this input's own voxels, after updating the input with `request` (as
   * vtkAlgorithm::Update does); it returns false, after one error, where they cannot be measured. Null
   * statistics (default): those of the input.
   */
  bool Measure(vtkInformation* request, ink::stipple::VolumeStatistics& statistics);
  void SetStatistics(std::shared_ptr<const ink::stipple::VolumeStatistics> statistics);
  ///@}

  /**
   * The number of stipples with which a picture of a mesh, its far side included, has room for no more.
   * `pixels` is the length of the longest side of its bounds in the picture; a stipple covers
   * `pixelsPerStipple`. Between 20,000 and 2,000,000; 0 without polygons or points with Normals and Radius.
   */
  static vtkIdType CountForPicture(vtkPolyData* mesh, double pixels, double pixelsPerStipple);

  /**
   * The ghost levels of points that a piece of an image needs for the stipples of the whole, by `smoothing`,
   * see SetSmoothing.
   */
  static int GetGhostLevels(double smoothing);

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
  /// Warns that no voxel of the image is stippled.
  void ReportNothing(vtkDataArray* scalars);
  void StippleSurface(vtkPolyData* given, vtkInformationVector** input, vtkPolyData* output);
  void StippleDiscs(vtkPolyData* points, vtkInformationVector** input, vtkPolyData* output);
  /// How many stipples a surface, or discs, are to have; 0: as many for each element as for voxels.
  vtkIdType CountForSurface(vtkPolyData* surface);
  bool MakesDoubles(vtkPolyData* surface);
  /// The array for colors, null if none is wanted; sets `ofCells` to whether it is cell data.
  vtkDataArray* GetColors(vtkDataSet* data, vtkInformationVector** input, bool& ofCells);
  bool NeedsWholeImage() const;
  bool ReportProgress(double share);

  int MaximumStipplesMode = FIXED;
  double PictureSize = 600.0;
  int MaximumStipples = 8;
  vtkIdType NumberOfSurfaceStipples = 0;
  double Smoothing = 0.0;
  int ThresholdMode = PERCENTILE;
  double GradientPercentile = 95.0;
  double GradientThreshold = 0.0;
  double LayerThickness = 1.0;
  int GradientMethod = REGRESSION;
  int GradientWeighting = UNIFORM;
  bool UseScalarWindow = false;
  double ScalarWindow[2] = { 0.0, 0.0 };
  bool UseReferenceRanges = false;
  double ReferenceScalarRange[2] = { 0.0, 1.0 };
  double ReferenceGradient = 1.0;
  bool PassScalars = false;
  int Seed = 0;
  int ArrayComponent = 0;
  int OutputPointsPrecision = DEFAULT_PRECISION;
  std::shared_ptr<const ink::stipple::VolumeStatistics> Statistics;
  ink::stipple::VolumeStatistics* Measured = nullptr; ///< to be filled instead of making stipples; null: done
};

#endif
