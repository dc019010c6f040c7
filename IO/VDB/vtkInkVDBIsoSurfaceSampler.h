// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkVDBIsoSurfaceSampler
 * @brief points on the iso-surfaces of an OpenVDB grid, without converting it to an image
 *
 * Combines vtkInkVDBReader and vtkInkIsoSurfaceSampler, with bitwise equal points and normals (for an image
 * with Padding 2 or more, 3 with ProjectionSteps), but works on the tree itself: only leaves and the borders
 * of tiles are read, so that time and memory scale with the surface, not with its bounding box. A class of
 * its own, since the output type of a VTK source is fixed before execution.
 *
 * Points are sorted by iso-value, then by block of 8 x 8 x 8 cells, by z, then y, then x of the block's first
 * cell; within a block by cell in the same order. They are the same for any number of threads. Each piece has
 * a share of the blocks; all pieces together have exactly the points of the whole.
 *
 * With Smoothing, Subdivision, a Cut or parts left out, tiles of 32 x 32 x 32 voxels take the place of
 * blocks: each is copied with what its values depend on. Points and normals then are those of
 * vtkInkIsoSurfaceSampler on an image with as large a Padding as the Gaussian reaches.
 *
 * Readable grids, their names, the sign of level sets and errors are as in vtkInkVDBReader; point arrays and
 * iso-values as in vtkInkIsoSurfaceSampler. The grid is cached for the next iso-value.
 *
 * @sa vtkInkVDBReader vtkInkIsoSurfaceSampler
 */
#ifndef vtkInkVDBIsoSurfaceSampler_h
#define vtkInkVDBIsoSurfaceSampler_h

#include "InkSetters.h"
#include "vtkInkIOVDBModule.h" // for the export macro
#include "vtkNew.h"            // for the contour values
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the file

class vtkContourValues;
class vtkFloatArray;
class vtkIntArray;
class vtkPoints;
class vtkStringArray;
class InkVDBSource;

class VTKINKIOVDB_EXPORT vtkInkVDBIsoSurfaceSampler : public vtkPolyDataAlgorithm
{
public:
  static vtkInkVDBIsoSurfaceSampler* New();
  vtkTypeMacro(vtkInkVDBIsoSurfaceSampler, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read. Default: none, which is an error.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * The name of the grid to sample. Default: none, which selects the first readable grid.
   */
  vtkSetStringMacro(GridName);
  vtkGetStringMacro(GridName);
  ///@}

  /**
   * The names of the grids that can be sampled, after UpdateInformation().
   */
  vtkStringArray* GetGridNames();

  ///@{
  /**
   * The iso-values, as in vtkContourFilter. Without any (default), level sets are sampled at 0 and other
   * grids not at all.
   */
  void SetValue(int i, double value);
  double GetValue(int i);
  void SetNumberOfContours(int number);
  vtkIdType GetNumberOfContours();
  void GenerateValues(int numContours, double rangeStart, double rangeEnd);
  ///@}

  ///@{
  /**
   * Multiply the values of level sets by -1, so that their inside is the denser side and normals point
   * outwards. Iso-values refer to the result. Default: on.
   */
  vtkSetMacro(InvertLevelSets, bool);
  vtkGetMacro(InvertLevelSets, bool);
  vtkBooleanMacro(InvertLevelSets, bool);
  ///@}

  /// Which cell edges the surface intersects, see SetCrossingRule.
  enum CrossingRuleType
  {
    HALF_OPEN = 0,
    STRICT = 1
  };

  ///@{
  /**
   * Which cell edges the surface intersects, as in vtkInkIsoSurfaceSampler. Default: HALF_OPEN.
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
   * The standard deviation of the Gaussian that values are smoothed with before the surface is sampled, as in
   * vtkInkIsoSurfaceSampler: in multiples of the smallest spacing, 0 to 8. Default: 0, values as they are. A
   * tile of the grid is smoothed at a time. NaN is refused with a warning.
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
   * What is made of the smoothed values, as in vtkInkIsoSurfaceSampler: SURFACE (default) or NORMALS.
   */
  vtkSetClampMacro(SmoothingTarget, int, SURFACE, NORMALS);
  vtkGetMacro(SmoothingTarget, int);
  void SetSmoothingTargetToSurface() { this->SetSmoothingTarget(SURFACE); }
  void SetSmoothingTargetToNormals() { this->SetSmoothingTarget(NORMALS); }
  const char* GetSmoothingTargetAsString();
  ///@}

  ///@{
  /**
   * How many cells take the place of one along the axis of the smallest spacing, as in
   * vtkInkIsoSurfaceSampler, 1 to 8. Default: 1.
   */
  vtkSetClampMacro(Subdivision, int, 1, 8);
  vtkGetMacro(Subdivision, int);
  ///@}

  /// What is added where a surface leaves the grid, see SetCut.
  enum CutType
  {
    OPEN = 0,
    RIM = 1,
    CAP = 2
  };

  ///@{
  /**
   * What is added where a surface leaves the volume that the grid was made of, as in vtkInkIsoSurfaceSampler:
   * OPEN (default), RIM or CAP. Grids that vtkInk did not write end nowhere.
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
   * Leave out parts of a surface that have less than this share of its largest part's points, as in
   * vtkInkIsoSurfaceSampler: 0 (default): none; negative: automatic. Parts are those of the whole grid,
   * whichever piece of it is asked for.
   */
  InkSetClampMacro(SmallestPart, -1.0, 1.0);
  vtkGetMacro(SmallestPart, double);
  ///@}

  ///@{
  /**
   * Keep only that many of the largest parts of each surface. 0 (default): all.
   */
  vtkSetClampMacro(LargestParts, int, 0, 1000000);
  vtkGetMacro(LargestParts, int);
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
   * How normals are estimated, as in vtkInkIsoSurfaceSampler. Default: INTERPOLATED_NORMAL.
   */
  vtkSetClampMacro(NormalMethod, int, CELL, REGRESSION);
  vtkGetMacro(NormalMethod, int);
  void SetNormalMethodToCell() { this->SetNormalMethod(CELL); }
  void SetNormalMethodToInterpolatedGradient() { this->SetNormalMethod(INTERPOLATED_GRADIENT); }
  void SetNormalMethodToInterpolatedNormal() { this->SetNormalMethod(INTERPOLATED_NORMAL); }
  void SetNormalMethodToRegression() { this->SetNormalMethod(REGRESSION); }
  const char* GetNormalMethodAsString();
  ///@}

  ///@{
  /**
   * With several iso-values, compute the point array `SurfaceIndex`: the index of the iso-value that a point
   * belongs to. Default: on.
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
   * The type of the point coordinates: vtkAlgorithm::SINGLE_PRECISION, DOUBLE_PRECISION or DEFAULT_PRECISION
   * (default), which is single unless the grid's active voxels lie so far from the origin that single
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
   * How many steps at most move each point onto the iso-surface of the trilinear interpolation, as in
   * vtkInkIsoSurfaceSampler, 0 to 8. Default: 0, which moves none.
   */
  vtkSetClampMacro(ProjectionSteps, int, 0, 8);
  vtkGetMacro(ProjectionSteps, int);
  ///@}

  ///@{
  /**
   * The precision in which points and normals of a float grid are computed, as in vtkInkIsoSurfaceSampler:
   * vtkAlgorithm::SINGLE_PRECISION (default) or DOUBLE_PRECISION. Grids of doubles, and points in double
   * precision, are always computed in double.
   */
  vtkSetClampMacro(ArithmeticPrecision, int, SINGLE_PRECISION, DOUBLE_PRECISION);
  vtkGetMacro(ArithmeticPrecision, int);
  void SetArithmeticPrecisionToSingle() { this->SetArithmeticPrecision(SINGLE_PRECISION); }
  void SetArithmeticPrecisionToDouble() { this->SetArithmeticPrecision(DOUBLE_PRECISION); }
  const char* GetArithmeticPrecisionAsString();
  ///@}

  ///@{
  /**
   * The memory limit in MiB for the grid and the points of its surfaces; 0: none. Exceeding it is an error
   * that names the memory needed. 0 to 16777216 (16 TiB). Default: 4096.
   */
  vtkSetClampMacro(MaximumMemory, int, 0, 16777216);
  vtkGetMacro(MaximumMemory, int);
  ///@}

  /// Includes the iso-values.
  vtkMTimeType GetMTime() override;

protected:
  vtkInkVDBIsoSurfaceSampler();
  ~vtkInkVDBIsoSurfaceSampler() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkInkVDBIsoSurfaceSampler(const vtkInkVDBIsoSurfaceSampler&) = delete;
  void operator=(const vtkInkVDBIsoSurfaceSampler&) = delete;

  /// Whether surfaces are smoothed, divided, cut or of some parts only.
  bool SamplesTiles() const;
  /// `normals` and `surfaceIndex` may be null.
  void FillOutput(
    vtkPoints* points, vtkFloatArray* normals, vtkIntArray* surfaceIndex, double radius, vtkPolyData* output);

  char* FileName = nullptr;
  char* GridName = nullptr;
  vtkNew<vtkContourValues> ContourValues;
  bool InvertLevelSets = true;
  int CrossingRule = HALF_OPEN;
  int NormalMethod = INTERPOLATED_NORMAL;
  bool ComputeNormals = true;
  bool ComputeSurfaceIndex = true;
  bool ComputeRadius = true;
  bool GenerateVertices = true;
  int OutputPointsPrecision = DEFAULT_PRECISION;
  int ProjectionSteps = 0;
  double Smoothing = 0.0;
  int SmoothingTarget = SURFACE;
  int Subdivision = 1;
  int Cut = OPEN;
  double SmallestPart = 0.0;
  int LargestParts = 0;
  int ArithmeticPrecision = SINGLE_PRECISION;
  int MaximumMemory = 4096;
  /// Whether reading the list of grids failed, which has been reported.
  bool Failed = false;
  std::unique_ptr<InkVDBSource> Source;
  vtkNew<vtkStringArray> Names;
};

#endif
