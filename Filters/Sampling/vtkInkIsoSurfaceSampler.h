// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkIsoSurfaceSampler
 * @brief   image data to points on its iso-surfaces, one in each cell that a surface crosses
 *
 * For every cell of a vtkImageData that an iso-surface crosses, one point is placed at the mean of the
 * surface's intersections with the cell's edges, with the surface's normal there (Zhang et al. 2014,
 * section 5.1). The points suit vtkInkSplattingLinesMapper and any other point renderer; no triangles
 * are made on the way.
 *
 * The input array is the one that SetInputArrayToProcess(0, ...) names, the active point scalars by default.
 * An array that is not contiguous in memory is copied first.
 *
 * Output point data: `Normals` (unit, out of the denser side, that is along the negative gradient; see
 * NormalMethod and OutputNormalsPrecision), `Radius` (world units: half the diagonal of a cell, so that discs
 * of this radius around the points leave no holes) and, with several iso-values, `SurfaceIndex` (int: which
 * of them the point belongs to). The output has no cells but one vertex cell of type VTK_POLY_VERTEX holding
 * all points, unless GenerateVertices is off.
 *
 * Points come in the order of their cells, iso-value by iso-value, and are the same for any number of
 * threads (VTK_SMP_MAX_THREADS sets it) and for any split of the image into pieces with one level of
 * ghost cells, which are asked for. A whole image that is given for every piece, as by SetInputData, or for
 * the first one only, as by readers that know no pieces, is the first piece's.
 * Cells marked as duplicate, hidden or refined, and cells with a corner that is NaN, infinite or hidden, make
 * no points; a NaN or hidden voxel nearby makes the central difference one-sided.
 *
 * All iso-values are sampled in one pass over the image. On the way the least and largest value of each brick
 * of 32 x 4 x 4 voxels (16 x 4 x 4 for types of four bytes and more) is kept, at most 1/128 of the image's
 * memory. As long as the input stays the same, later runs for other iso-values read only bricks that the
 * surface enters, see UseIndex. The inner loops are compiled for several instruction sets (SSE2, AVX2,
 * AVX-512), give the same bits in each, and are chosen at run time; the environment variable
 * VTKINK_INSTRUCTION_SET (baseline, avx2, avx512) names another one.
 *
 * Output arrays that nobody else holds when the filter runs again are filled anew instead of made anew, see
 * ReuseArrays.
 *
 * Errors and warnings, each with an empty output: data that are no image (vtkResampleToImage makes one of
 * rectilinear, structured and unstructured grids), no such point array, ArrayComponent beyond its components,
 * an image of fewer than two samples along an axis, a spacing of zero or a direction matrix without inverse.
 *
 * @sa vtkInkSplattingLinesMapper vtkFlyingEdges3D
 */
#ifndef vtkInkIsoSurfaceSampler_h
#define vtkInkIsoSurfaceSampler_h

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
   * The iso-values, as in vtkContourFilter. None by default, which gives no points.
   */
  void SetValue(int i, double value);
  double GetValue(int i);
  void SetNumberOfContours(int number);
  vtkIdType GetNumberOfContours();
  void GenerateValues(int numContours, double rangeStart, double rangeEnd);
  ///@}

  /// Which edges count as crossed, see SetCrossingRule.
  enum CrossingRuleType
  {
    HALF_OPEN = 0,
    STRICT = 1
  };

  ///@{
  /**
   * Which cell edges the surface at f0 intersects. HALF_OPEN (default): those with one end below f0 and
   * the other at or above it, so that a surface through voxel centers has neither holes nor doubles.
   * STRICT: the rule as Zhang et al. write it, (f1 - f0)(f2 - f0) < 0, and the edge's middle where
   * f1 = f2 = f0; where f0 is a value that voxels have, as in integer data, it
   * leaves holes and finds flat pieces twice.
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

  /// How normals are found, see SetNormalMethod.
  enum NormalMethodType
  {
    CELL = 0,
    GRADIENT = 1,
    CENTRAL_DIFFERENCE = 2,
    REGRESSION = 3
  };

  ///@{
  /**
   * How normals are found. CELL: from the gradient of the trilinear interpolation of the cell's own eight
   * voxels; the fastest, and with facets. GRADIENT: central differences give the corners gradients, which are
   * interpolated. CENTRAL_DIFFERENCE (default): their unit vectors are, as Zhang et al. do it; more exact
   * where a boundary is sharp or voxels are not cubes. REGRESSION: the same with gradients by linear
   * regression over each corner's 26 neighbors (Neumann et al. 2000, equal weights); smoother where there is
   * noise, and rounds off what is smaller than two voxels.
   */
  vtkSetClampMacro(NormalMethod, int, CELL, REGRESSION);
  vtkGetMacro(NormalMethod, int);
  void SetNormalMethodToCell() { this->SetNormalMethod(CELL); }
  void SetNormalMethodToGradient() { this->SetNormalMethod(GRADIENT); }
  void SetNormalMethodToCentralDifference() { this->SetNormalMethod(CENTRAL_DIFFERENCE); }
  void SetNormalMethodToRegression() { this->SetNormalMethod(REGRESSION); }
  const char* GetNormalMethodAsString();
  ///@}

  /// Below vtkAlgorithm::SINGLE_PRECISION, see SetOutputNormalsPrecision.
  enum OutputNormalsPrecisionType
  {
    CHAR_PRECISION = -2,
    SHORT_PRECISION = -1
  };

  ///@{
  /**
   * What the array `Normals` holds. vtkAlgorithm::SINGLE_PRECISION (default): unit vectors as float, 12 bytes
   * a point. SHORT_PRECISION: times 32767 and rounded, 6 bytes, off by up to .002 degrees. CHAR_PRECISION:
   * times 127 and rounded, 3 bytes, off by up to .4 degrees. Mappers that normalize their normals draw them
   * as they are.
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
   * Compute the point array `SurfaceIndex`: the number of the iso-value that a point belongs to. Default: on.
   * It is only made when there are several iso-values; with one it would say nothing.
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

  ///@{
  /**
   * The component of the input scalars that is sampled. Default: 0.
   */
  vtkSetClampMacro(ArrayComponent, int, 0, VTK_INT_MAX);
  vtkGetMacro(ArrayComponent, int);
  ///@}

  ///@{
  /**
   * The type of the points' coordinates: vtkAlgorithm::SINGLE_PRECISION, DOUBLE_PRECISION or
   * DEFAULT_PRECISION (default), which is single unless the image lies so far from the origin that single
   * precision would move points by more than a thousandth of the smallest spacing.
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
   * What points and normals are computed in: vtkAlgorithm::SINGLE_PRECISION (default) or DOUBLE_PRECISION.
   * Single is meant for voxels of 8 and 16 bits and float; points and normals differ from double's by about
   * 1e-6 of a voxel and 1e-5 radians. Other types, and points in double, are always computed in double. Which
   * voxels are inside is exact in both.
   */
  vtkSetClampMacro(ArithmeticPrecision, int, SINGLE_PRECISION, DOUBLE_PRECISION);
  vtkGetMacro(ArithmeticPrecision, int);
  void SetArithmeticPrecisionToSingle() { this->SetArithmeticPrecision(SINGLE_PRECISION); }
  void SetArithmeticPrecisionToDouble() { this->SetArithmeticPrecision(DOUBLE_PRECISION); }
  const char* GetArithmeticPrecisionAsString();
  ///@}

  ///@{
  /**
   * Keep the least and largest value of each brick of voxels from the first run on, so that runs for other
   * iso-values take time by the size of the surface instead of the image. Default: on. They are made anew
   * when the input array or the image is modified, and only for images sampled as a whole. The points are the
   * same.
   */
  vtkSetMacro(UseIndex, bool);
  vtkGetMacro(UseIndex, bool);
  vtkBooleanMacro(UseIndex, bool);
  ///@}

  /// The memory that the index takes, in bytes; 0 while there is none.
  vtkIdType GetIndexMemory();
  /// Gives the index's memory back. The next run makes it again, unless UseIndex is off.
  void ReleaseIndex();

  ///@{
  /**
   * Fill the last run's output arrays anew when nobody else holds them any more, instead of making new ones,
   * whose pages the system has to clear first. Default: on. Off: the filter keeps none of its output's
   * memory.
   */
  vtkSetMacro(ReuseArrays, bool);
  vtkGetMacro(ReuseArrays, bool);
  vtkBooleanMacro(ReuseArrays, bool);
  ///@}

  /// The iso-values count.
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
  void FillOutput(double radius, vtkPolyData* output);
  /// Warns where no iso-value lies within the values' range.
  void ReportOutside(vtkDataArray* scalars);

  vtkNew<vtkContourValues> ContourValues;
  int CrossingRule = HALF_OPEN;
  int NormalMethod = CENTRAL_DIFFERENCE;
  int OutputNormalsPrecision = SINGLE_PRECISION;
  int ArithmeticPrecision = SINGLE_PRECISION;
  bool ComputeNormals = true;
  bool ComputeSurfaceIndex = true;
  bool ComputeRadius = true;
  bool GenerateVertices = true;
  int ArrayComponent = 0;
  int OutputPointsPrecision = DEFAULT_PRECISION;
  bool UseIndex = true;
  bool ReuseArrays = true;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
