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
 * Output point data: `Normals` (unit, out of the denser side, that is along the negative gradient; the
 * trilinear interpolation of the unit normals that central differences give the cell's corners) and
 * `Radius` (world units: half the diagonal of a cell, so that discs of this radius around the points leave
 * no holes). The output has no cells but one vertex cell of type VTK_POLY_VERTEX holding all points, unless
 * GenerateVertices is off.
 *
 * Points come in the order of their cells, iso-value by iso-value, and are the same for any number of
 * threads (VTK_SMP_MAX_THREADS sets it) and for any split of the image into pieces with one level of
 * ghost cells, which are asked for. An image given by SetInputData is taken to be whole for every piece.
 * Cells marked as duplicate, hidden or refined, and cells with a corner that is NaN, infinite or hidden, make
 * no points; a NaN or hidden voxel nearby makes the central difference one-sided.
 *
 * Errors and warnings, each with an empty output: no such point array, ArrayComponent beyond its components,
 * an image of fewer than two samples along an axis, a spacing of zero or a direction matrix without inverse.
 *
 * @sa vtkInkSplattingLinesMapper vtkFlyingEdges3D
 */
#ifndef vtkInkIsoSurfaceSampler_h
#define vtkInkIsoSurfaceSampler_h

#include "vtkInkFiltersSamplingModule.h" // for the export macro
#include "vtkNew.h"                      // for the contour values
#include "vtkPolyDataAlgorithm.h"

class vtkContourValues;
class vtkDataArray;
class vtkFloatArray;
class vtkImageData;
class vtkPoints;

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
   * the other at or above it, so that a surface through voxel centres has neither holes nor doubles.
   * STRICT: the rule as Zhang et al. write it, (f1 - f0)(f2 - f0) < 0, and the edge's middle where
   * f1 = f2 = f0; where f0 is a value that voxels have, as in integer data, it
   * leaves holes and finds flat pieces twice.
   */
  vtkSetClampMacro(CrossingRule, int, HALF_OPEN, STRICT);
  vtkGetMacro(CrossingRule, int);
  void SetCrossingRuleToHalfOpen() { this->SetCrossingRule(HALF_OPEN); }
  void SetCrossingRuleToStrict() { this->SetCrossingRule(STRICT); }
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
   * vtkAlgorithm::SINGLE_PRECISION, DOUBLE_PRECISION or DEFAULT_PRECISION (default): single unless the
   * image lies so far from the origin that single precision would move points by more than a
   * thousandth of the smallest spacing.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
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

  /// The array to sample, or null after an error.
  vtkDataArray* GetScalars(vtkImageData* image, vtkInformationVector** input);
  void FillOutput(vtkPoints* points, vtkFloatArray* normals, double radius, vtkPolyData* output);

  vtkNew<vtkContourValues> ContourValues;
  int CrossingRule = HALF_OPEN;
  bool ComputeNormals = true;
  bool ComputeRadius = true;
  bool GenerateVertices = true;
  int ArrayComponent = 0;
  int OutputPointsPrecision = DEFAULT_PRECISION;
};

#endif
