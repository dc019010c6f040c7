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
 * iso-value, then by tile, then by cell. With ShapeBasedInterpolation of thick slices, distances take 4 bytes
 * for each voxel while points are made, and other iso-values read the whole image again.
 *
 * With MaximumMemory, a large image is asked for a few slices at a time, see there. The index then is of no
 * use.
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

#include "vtkInkFiltersSamplingModule.h" // for the export macro
#include "vtkInkIsoSurfaceAlgorithm.h"

#include <memory> // for the internals
#include <string> // for the array
#include <vector> // for iso-values

class vtkDataArray;
class vtkImageData;

class VTKINKFILTERSSAMPLING_EXPORT vtkInkIsoSurfaceSampler : public vtkInkIsoSurfaceAlgorithm
{
public:
  static vtkInkIsoSurfaceSampler* New();
  vtkTypeMacro(vtkInkIsoSurfaceSampler, vtkInkIsoSurfaceAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

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

  vtkIdType CountActiveCells(double isoValue) override;

#ifndef __VTK_WRAP__
  ink::SuggestedSmoothing SuggestSmoothings(double isoValue) override;
  vtkSmartPointer<vtkImageData> MakeFrame() override;
  bool SampleParts(const PartSink& sink) override;
  ink::FiniteRange FindRange() override;
#endif

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
  struct Run;

  void SampleImage(vtkInformationVector** input, vtkInformationVector* output);
  /// Whether the image is asked for a few slices at a time.
  bool TakesSlabs(vtkInformation* input, vtkInformation* output);
  void SampleSlabs(vtkPolyData* output);
  /// Calls use(InkImageSlabs&) with the input's; reports what goes wrong.
  template <class Use>
  void UseSlabs(const Use& use);
  /// @throws std::exception
  void SampleParts(const PartSink& sink, const std::vector<double>& isoValues, bool cellIds);
  /// The name of the array to process; empty: the active scalars.
  std::string GetArrayName();
  /// The input's image; null where there is none to sample, which then was said.
  vtkImageData* TakeImage(vtkInformation* info);
  /// What the properties say of a run over an image, or a piece of one.
  Run MakeRun(vtkImageData* image, vtkInformation* input, vtkInformation* output);
  /// Warns if no iso-value lies within the range of the values.
  void WarnIfOutside(const std::vector<double>& isoValues, double least, double greatest);

  int OutputNormalsPrecision = SINGLE_PRECISION;
  bool ComputeCellIds = false;
  int ArrayComponent = 0;
  bool UseIndex = true;
  bool ReuseArrays = true;
  double FoundRange[2] = { 0.0, 0.0 }; ///< of the values that were sampled in parts
  std::unique_ptr<vtkInternals> Internals;
};

#endif
