// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkIsoSurfaceSampler
 * @brief points on the iso-surfaces of an image, one in each active cell
 *
 * In every active cell of a vtkImageData, that is every cell that an iso-surface intersects, one point is
 * placed at the mean of the surface's intersections with the cell's edges, with the surface normal there
 * (Zhang et al. 2014, section 5.1). The points suit vtkInkSplattingLinesMapper and any other point renderer;
 * no triangle mesh is extracted.
 *
 * The input array is set with SetInputArrayToProcess(0, ...); by default it is the active point scalars. An
 * array that is not contiguous in memory is copied first.
 *
 * Output point data: `Normals` (unit, along the negative gradient, away from larger values; see NormalMethod
 * and OutputNormalsPrecision), `Radius` (world units: half the diagonal of a cell, so that discs of this
 * radius around the points leave no holes), with several iso-values `SurfaceIndex` (int: the index of the
 * point's iso-value) and, with ComputeCellIds, `CellId`. Field data: `SampleCell` (the edges of a cell, three
 * world vectors). The output's only cell is a vertex cell of type VTK_POLY_VERTEX holding all points, unless
 * GenerateVertices is off.
 *
 * Points are sorted by iso-value, then by cell, and are the same for any number of threads (set by
 * VTK_SMP_MAX_THREADS) and for any partition of the image into pieces with one level of ghost cells, or two
 * with ProjectionSteps, and with Smoothing or Subdivision as many more as that takes, which the filter
 * requests. If the whole image arrives for every piece, as with
 * SetInputData, or only for the first one, as from readers without piece support, the first piece processes
 * all of it. Cells marked as duplicate, hidden or refined, and cells with a corner that is NaN, infinite or
 * hidden, yield no points; a NaN or hidden voxel nearby makes the central difference one-sided.
 *
 * All iso-values are sampled in one pass over the image, which also records the minimum and maximum of each
 * brick of 32 x 4 x 4 voxels (16 x 4 x 4 for types of four bytes and more), at most 1/128 of the image's
 * memory. As long as the input is unmodified, later runs for other iso-values read only the bricks that the
 * surface enters, see UseIndex. The inner loops are compiled for several instruction sets (SSE2, AVX2,
 * AVX-512), give bitwise identical results in each, and are chosen at run time; the environment variable
 * VTKINK_INSTRUCTION_SET (baseline, avx2, avx512) overrides the choice.
 *
 * With Smoothing or Subdivision, values are smoothed and cells divided tile by tile, and no more of the
 * resampled image exists at any time; "cell" then means such a smaller cell, and points are sorted by
 * iso-value, then by tile, then by cell.
 *
 * Output arrays that nobody else references when the filter runs again are reused, see ReuseArrays.
 *
 * Errors and warnings, each with an empty output: an input that is not an image (vtkResampleToImage converts
 * rectilinear, structured and unstructured grids), no such point array, ArrayComponent beyond its components,
 * an image of fewer than two samples along an axis, a spacing of zero or a singular direction matrix.
 *
 * @sa vtkInkSplattingLinesMapper vtkFlyingEdges3D
 */
#ifndef vtkInkIsoSurfaceSampler_h
#define vtkInkIsoSurfaceSampler_h

#include "InkSetters.h"
#include "vtkInkFiltersSamplingModule.h" // for the export macro
#include "vtkNew.h"                      // for the contour values
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the internals

class vtkContourValues;
class vtkDataArray;
class vtkImageData;

class VTKINKFILTERSSAMPLING_EXPORT vtkInkIsoSurfaceSampler : public vtkPolyDataAlgorithm
{
public:
  static vtkInkIsoSurfaceSampler* New();
  vtkTypeMacro(vtkInkIsoSurfaceSampler, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The iso-values, as in vtkContourFilter. Default: none, which yields no points.
   */
  void SetValue(int i, double value);
  double GetValue(int i);
  void SetNumberOfContours(int number);
  vtkIdType GetNumberOfContours();
  void GenerateValues(int numContours, double rangeStart, double rangeEnd);
  ///@}

  /// Which cell edges the surface intersects, see SetCrossingRule.
  enum CrossingRuleType
  {
    HALF_OPEN = 0,
    STRICT = 1
  };

  ///@{
  /**
   * Which cell edges the surface at f0 intersects. HALF_OPEN (default): those with one end below f0 and the
   * other at or above it, so that a surface through voxel centers has neither holes nor duplicates. STRICT:
   * the rule as printed in Zhang et al., (f1 - f0)(f2 - f0) < 0, and the edge's midpoint where f1 = f2 = f0;
   * where voxels have exactly the value f0, as in integer data, it leaves holes and finds flat regions twice.
   */
  vtkSetClampMacro(CrossingRule, int, HALF_OPEN, STRICT);
  vtkGetMacro(CrossingRule, int);
  void SetCrossingRuleToHalfOpen() { this->SetCrossingRule(HALF_OPEN); }
  void SetCrossingRuleToStrict() { this->SetCrossingRule(STRICT); }
  const char* GetCrossingRuleAsString();
  ///@}

  ///@{
  /**
   * Compute the point array `Normals`. Default: on.
   */
  vtkSetMacro(ComputeNormals, bool);
  vtkGetMacro(ComputeNormals, bool);
  vtkBooleanMacro(ComputeNormals, bool);
  ///@}

  ///@{
  /**
   * The standard deviation of the Gaussian that values are smoothed with before the surface is sampled, in
   * multiples of the smallest spacing, the same in all world directions; 0 to 8. Default: 0, values as they
   * are. Where voxels are not cubes, cells then are divided until they are about cubes, as with
   * Subdivision. Removes what noise, few gray levels and the distance of slices do to normals, and with it
   * parts thinner than the Gaussian, see SmoothingTarget; Common/Statistics/NoiseEstimate.h suggests a value.
   * NaN is refused with a warning.
   */
  InkSetClampMacro(Smoothing, 0.0, 8.0);
  vtkGetMacro(Smoothing, double);
  ///@}

  /// What is smoothed, see SetSmoothingTarget.
  enum SmoothingTargetType
  {
    SURFACE = 0,
    NORMALS = 1
  };

  ///@{
  /**
   * What is made of the smoothed values. SURFACE (default): the surface and its normals; surfaces shrink
   * where they are bent, and parts as thin as the Gaussian vanish. NORMALS: the normals (by central
   * differences, interpolated). The surface then is that of values smoothed by a kernel that keeps parabolas,
   * a Gaussian of fourth order of 0.7 times the deviation: it stays where it is, and so do thin parts.
   */
  vtkSetClampMacro(SmoothingTarget, int, SURFACE, NORMALS);
  vtkGetMacro(SmoothingTarget, int);
  void SetSmoothingTargetToSurface() { this->SetSmoothingTarget(SURFACE); }
  void SetSmoothingTargetToNormals() { this->SetSmoothingTarget(NORMALS); }
  const char* GetSmoothingTargetAsString();
  ///@}

  ///@{
  /**
   * How many cells take the place of one along the axis of the smallest spacing, 1 to 8; along others more,
   * so that cells are about cubes, but at most 8. Default: 1. Values in between are interpolated by cubics
   * (Catmull and Rom) or come from the Gaussian of Smoothing; Radius is that of the smaller cells. Above 1,
   * cells are divided also where Smoothing is 0.
   */
  vtkSetClampMacro(Subdivision, int, 1, 8);
  vtkGetMacro(Subdivision, int);
  ///@}

  /// How normals are estimated, see SetNormalMethod.
  enum NormalMethodType
  {
    CELL = 0,
    INTERPOLATED_GRADIENT = 1,
    INTERPOLATED_NORMAL = 2,
    REGRESSION = 3
  };

  ///@{
  /**
   * How normals are estimated. CELL: the gradient of the trilinear interpolant of the cell's own eight
   * voxels; the fastest, but faceted. INTERPOLATED_GRADIENT: gradients by central differences at the corners
   * are interpolated, then normalized. INTERPOLATED_NORMAL (default): the same gradients are normalized
   * first, then interpolated, as Zhang et al. do; more accurate at sharp boundaries and for anisotropic
   * voxels. REGRESSION: the same with gradients by linear regression over each corner's 26 neighbors (Neumann
   * et al. 2000, equal weights); smoother for noisy data, but rounds off features smaller than two voxels.
   */
  vtkSetClampMacro(NormalMethod, int, CELL, REGRESSION);
  vtkGetMacro(NormalMethod, int);
  void SetNormalMethodToCell() { this->SetNormalMethod(CELL); }
  void SetNormalMethodToInterpolatedGradient() { this->SetNormalMethod(INTERPOLATED_GRADIENT); }
  void SetNormalMethodToInterpolatedNormal() { this->SetNormalMethod(INTERPOLATED_NORMAL); }
  void SetNormalMethodToRegression() { this->SetNormalMethod(REGRESSION); }
  const char* GetNormalMethodAsString();
  ///@}

  /// Precisions below vtkAlgorithm::SINGLE_PRECISION, see SetOutputNormalsPrecision.
  enum OutputNormalsPrecisionType
  {
    CHAR_PRECISION = -2,
    SHORT_PRECISION = -1
  };

  ///@{
  /**
   * The type of the array `Normals`. vtkAlgorithm::SINGLE_PRECISION (default): unit vectors as float, 12
   * bytes per point. SHORT_PRECISION: scaled by 32767 and rounded, 6 bytes, an error of up to .002 degrees.
   * CHAR_PRECISION: scaled by 127 and rounded, 3 bytes, an error of up to .4 degrees. Mappers that normalize
   * their normals draw the quantized ones without conversion.
   */
  vtkSetClampMacro(OutputNormalsPrecision, int, CHAR_PRECISION, SINGLE_PRECISION);
  vtkGetMacro(OutputNormalsPrecision, int);
  void SetOutputNormalsPrecisionToSingle() { this->SetOutputNormalsPrecision(SINGLE_PRECISION); }
  void SetOutputNormalsPrecisionToShort() { this->SetOutputNormalsPrecision(SHORT_PRECISION); }
  void SetOutputNormalsPrecisionToChar() { this->SetOutputNormalsPrecision(CHAR_PRECISION); }
  const char* GetOutputNormalsPrecisionAsString();
  ///@}

  ///@{
  /**
   * Compute the point array `SurfaceIndex`: the index of the iso-value that a point belongs to. Default: on.
   * It is omitted when there is only one iso-value.
   */
  vtkSetMacro(ComputeSurfaceIndex, bool);
  vtkGetMacro(ComputeSurfaceIndex, bool);
  vtkBooleanMacro(ComputeSurfaceIndex, bool);
  ///@}

  ///@{
  /**
   * Compute the point array `Radius`. Default: on.
   */
  vtkSetMacro(ComputeRadius, bool);
  vtkGetMacro(ComputeRadius, bool);
  vtkBooleanMacro(ComputeRadius, bool);
  ///@}

  ///@{
  /**
   * Make one poly-vertex cell over all points, so that any VTK mapper draws them. Default: on.
   */
  vtkSetMacro(GenerateVertices, bool);
  vtkGetMacro(GenerateVertices, bool);
  vtkBooleanMacro(GenerateVertices, bool);
  ///@}

  /// What is added where a surface leaves the image, see SetCut.
  enum CutType
  {
    OPEN = 0,
    RIM = 1,
    CAP = 2
  };

  ///@{
  /**
   * What is added where a surface leaves the image. OPEN (default): nothing; the surface ends somewhere in
   * the last voxels, and lines along its edge are broken. RIM: points along the cut, with normals from the
   * surface's to that of the image's side, which makes the edge one clean line. CAP: also points all over
   * the part of the side that is inside, as if all beyond the image were below the iso-value. The points
   * follow those of their surface. They are found in the image's values as they are.
   */
  vtkSetClampMacro(Cut, int, OPEN, CAP);
  vtkGetMacro(Cut, int);
  void SetCutToOpen() { this->SetCut(OPEN); }
  void SetCutToRim() { this->SetCut(RIM); }
  void SetCutToCap() { this->SetCut(CAP); }
  const char* GetCutAsString();
  ///@}

  ///@{
  /**
   * Leave out parts of a surface that have less than this share of its largest part's points: noise and
   * floaters. A part is a connected component of active cells, which are neighbors if they share a face. 0
   * (default): none; negative: automatic, parts with less than a thousandth, or up to two voxels large. Parts
   * are those of the piece that is sampled: for those of the whole, sample pieces with ComputeCellIds and put
   * them together first.
   */
  InkSetClampMacro(SmallestPart, -1.0, 1.0);
  vtkGetMacro(SmallestPart, double);
  ///@}

  ///@{
  /**
   * Keep only that many of the largest parts of each surface; a skull without its headrest is 1. 0 (default):
   * all. See SmallestPart for what a part is.
   */
  vtkSetClampMacro(LargestParts, int, 0, 1000000);
  vtkGetMacro(LargestParts, int);
  ///@}

  ///@{
  /**
   * Compute the point array `CellId` (64-bit integers): the cell that a point lies in, as ink::activeCellId
   * of its index in the whole image. It ascends within a surface, up to the points of its Cut. Default: off.
   */
  vtkSetMacro(ComputeCellIds, bool);
  vtkGetMacro(ComputeCellIds, bool);
  vtkBooleanMacro(ComputeCellIds, bool);
  ///@}

  ///@{
  /**
   * The component of the input scalars that is sampled. Default: 0.
   */
  vtkSetClampMacro(ArrayComponent, int, 0, VTK_INT_MAX);
  vtkGetMacro(ArrayComponent, int);
  ///@}

  ///@{
  /**
   * The type of the point coordinates: vtkAlgorithm::SINGLE_PRECISION, DOUBLE_PRECISION or DEFAULT_PRECISION
   * (default), which is single unless the image lies so far from the origin that single precision would move
   * points by more than a thousandth of the smallest spacing.
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
   * How many steps at most move each point onto the iso-surface of the trilinear interpolation, 0 to 8.
   * Default: 0, the points of Zhang et al. 2014: the mean of a cell's intersections lies off the surface by
   * some hundredths of the spacing. Each step (Newton's, along the central-difference gradient) leaves about
   * a tenth of the distance, more where boundaries are sharp; a point within 1e-4 of the smallest spacing is
   * moved no further, one that would have to leave its cell by more than a cell's width not at all. Normals
   * stay those at the point's old position. Takes a second level of ghost cells.
   */
  vtkSetClampMacro(ProjectionSteps, int, 0, 8);
  vtkGetMacro(ProjectionSteps, int);
  ///@}

  ///@{
  /**
   * The precision in which points and normals are computed: vtkAlgorithm::SINGLE_PRECISION (default) or
   * DOUBLE_PRECISION. Single precision applies to voxels of 8 and 16 bits and float; its points and normals
   * differ from those in double by about 1e-6 of a voxel and 1e-5 radians. Other types, and points in double,
   * are always computed in double. Classifying voxels as inside or outside is exact in both.
   */
  vtkSetClampMacro(ArithmeticPrecision, int, SINGLE_PRECISION, DOUBLE_PRECISION);
  vtkGetMacro(ArithmeticPrecision, int);
  void SetArithmeticPrecisionToSingle() { this->SetArithmeticPrecision(SINGLE_PRECISION); }
  void SetArithmeticPrecisionToDouble() { this->SetArithmeticPrecision(DOUBLE_PRECISION); }
  const char* GetArithmeticPrecisionAsString();
  ///@}

  ///@{
  /**
   * Keep the minimum and maximum of each brick of voxels from the first run on, so that the time for other
   * iso-values depends on the size of the surface instead of the image. Default: on. The index is rebuilt
   * when the input array or the image is modified, and exists only for images sampled as a whole. The points
   * do not depend on it.
   */
  vtkSetMacro(UseIndex, bool);
  vtkGetMacro(UseIndex, bool);
  vtkBooleanMacro(UseIndex, bool);
  ///@}

  /// The memory of the index in bytes; 0 without an index.
  vtkIdType GetIndexMemory();
  /// Frees the index. The next run rebuilds it, unless UseIndex is off.
  void ReleaseIndex();

  ///@{
  /**
   * Reuse the last run's output arrays when nobody else references them any more, instead of allocating new
   * ones, whose pages the system has to clear first. Default: on. Off: the filter holds no reference to its
   * output's memory.
   */
  vtkSetMacro(ReuseArrays, bool);
  vtkGetMacro(ReuseArrays, bool);
  vtkBooleanMacro(ReuseArrays, bool);
  ///@}

  /// Includes the iso-values.
  vtkMTimeType GetMTime() override;

protected:
  vtkInkIsoSurfaceSampler();
  ~vtkInkIsoSurfaceSampler() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkInkIsoSurfaceSampler(const vtkInkIsoSurfaceSampler&) = delete;
  void operator=(const vtkInkIsoSurfaceSampler&) = delete;

  class vtkInternals;

  void SampleImage(vtkInformationVector** input, vtkInformationVector* output);
  /// Warns if no iso-value lies within the range of the values.

  vtkNew<vtkContourValues> ContourValues;
  int CrossingRule = HALF_OPEN;
  int NormalMethod = INTERPOLATED_NORMAL;
  int OutputNormalsPrecision = SINGLE_PRECISION;
  int ArithmeticPrecision = SINGLE_PRECISION;
  bool ComputeNormals = true;
  bool ComputeSurfaceIndex = true;
  bool ComputeRadius = true;
  bool GenerateVertices = true;
  int Cut = OPEN;
  double SmallestPart = 0.0;
  int LargestParts = 0;
  bool ComputeCellIds = false;
  int ArrayComponent = 0;
  int OutputPointsPrecision = DEFAULT_PRECISION;
  int ProjectionSteps = 0;
  double Smoothing = 0.0;
  int SmoothingTarget = SURFACE;
  int Subdivision = 1;
  bool UseIndex = true;
  bool ReuseArrays = true;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
