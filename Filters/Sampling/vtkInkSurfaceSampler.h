// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkSurfaceSampler
 * @brief samples meshes: white-noise or blue-noise points with normals, in progressive order
 *
 * Input: a vtkPolyData, or the boundary surface of another vtkPointSet (vtkUnstructuredGrid,
 * vtkStructuredGrid). Polygons and triangle strips are sampled (Zhang et al. 2014, section 4): independently
 * and uniformly by area (WHITE_NOISE, Osada et al. 2002), or so that no two samples are closer along the
 * surface than a radius and no further sample fits (BLUE_NOISE, maximal Poisson-disk sampling after Cline et
 * al. 2009). Distances are geodesic, so that both sides of a thin sheet get their samples; see
 * ink::GeodesicUnfolding. Degenerate triangles are skipped; non-manifold edges, boundaries, inconsistent
 * orientation and unconnected triangles are allowed.
 *
 * Output point data: `Normals` (unit; interpolated from the mesh's point normals, or where it has none from
 * the mean normals of the faces around each point, on one side of feature edges: see InkWithFeatureNormals),
 * `Radius` (discs of this radius leave no holes), `Priority`, and on request `FaceId`, `FacePoints` and
 * `BarycentricCoordinates`. The output's only cell is a vertex cell of type VTK_POLY_VERTEX holding all
 * points, unless GenerateVertices is off.
 *
 * Points are sorted by `Priority`, which is uniform in [0, 1): for every p, the points with a priority below
 * p are evenly distributed themselves. With ComputePriority off, points stay in the order of generation,
 * which is faster.
 *
 * `Radius`: the paper's A / n has the unit of an area. Here it is a length: for blue noise the covering
 * radius, about 1.1 sqrt(A / n), within which every position has a sample; for white noise the radius that
 * leaves less than one hole in a hundred samplings, about 2.4 sqrt(A / n) for a million samples.
 *
 * Density: a point or cell array with one component, set with SetInputArrayToProcess(0, 0, 0, association,
 * name), is the relative sampling density. Where it is 0 there are no samples, nor where it is negative or
 * NaN, which is a warning. Without a name (default) the density is uniform.
 *
 * Animation (Zhang et al. 2014, section 6): with FollowDeformation on, a mesh that changes with time is
 * sampled once, and its samples keep their barycentric coordinates and move with their faces; `Priority` does
 * not change, `Radius` grows with the stretch of the surface around each sample. To do this by hand, connect
 * the first frame's output, made with KeepFaces, to the second input and a deformed copy of the mesh to the
 * first.
 *
 * Point clouds: an input of points without faces is not sampled. Its points get a `Priority` and, where
 * missing, a `Radius` from the distances to their neighbors, so that uneven scans are covered without closing
 * real holes (see ink::pointRadii), and normals, see NormalNeighbors. Isolated points are removed, see
 * RemoveIsolated, as are points that `vtkGhostType` marks as hidden or duplicate.
 *
 * The same input gives the same output for any number of threads and any numbering of its points and faces.
 * In parallel each piece is sampled by itself: ghost cells are ignored, and NumberOfSamples is per piece.
 * With WHITE_NOISE, SampleRadius, global cell ids and no density, the pieces together have the points of the
 * whole. Blue-noise samples of different pieces are independent and may be closer than the radius where
 * pieces meet; no point is duplicated.
 *
 * Errors, each with an empty output: a SampleRadius of 0 or less when the amount is set by it, a mesh without
 * area, a density that does not have one component or is 0 everywhere, more samples than memory, first-frame
 * samples made without KeepFaces or of a mesh with other faces.
 *
 * @sa vtkInkPointPriority vtkInkIsoSurfaceSampler vtkInkSplattingLinesMapper
 */
#ifndef vtkInkSurfaceSampler_h
#define vtkInkSurfaceSampler_h

#include "InkSetters.h"
#include "vtkInkFiltersSamplingModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for samples that are kept

#include <string> // for what they depend on

class VTKINKFILTERSSAMPLING_EXPORT vtkInkSurfaceSampler : public vtkPolyDataAlgorithm
{
public:
  static vtkInkSurfaceSampler* New();
  vtkTypeMacro(vtkInkSurfaceSampler, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How samples are distributed, see SetMethod.
  enum MethodType
  {
    WHITE_NOISE = 0,
    BLUE_NOISE = 1,
    PROGRESSIVE_BLUE_NOISE = 2,
    AUTOMATIC = 3
  };

  ///@{
  /**
   * WHITE_NOISE: independent samples, with clusters and voids. BLUE_NOISE: Poisson-disk samples, with a
   * minimum distance and no voids. PROGRESSIVE_BLUE_NOISE: a minimum distance smaller by an eighth and larger
   * voids, but several times as fast; samples are generated in progressive order, and early subsets are more
   * even; with a density it falls back to BLUE_NOISE. AUTOMATIC (default): BLUE_NOISE below half a million
   * samples and for a SampleRadius, else WHITE_NOISE, as in Zhang et al. (2014, section 6), since the
   * difference is then hard to see in a drawing.
   */
  vtkSetClampMacro(Method, int, WHITE_NOISE, AUTOMATIC);
  vtkGetMacro(Method, int);
  void SetMethodToWhiteNoise() { this->SetMethod(WHITE_NOISE); }
  void SetMethodToBlueNoise() { this->SetMethod(BLUE_NOISE); }
  void SetMethodToProgressiveBlueNoise() { this->SetMethod(PROGRESSIVE_BLUE_NOISE); }
  void SetMethodToAutomatic() { this->SetMethod(AUTOMATIC); }
  const char* GetMethodAsString();
  ///@}

  /// What sets the number of samples, see SetAmount.
  enum AmountType
  {
    NUMBER_OF_SAMPLES = 0,
    SAMPLE_RADIUS = 1
  };

  ///@{
  /**
   * Whether NumberOfSamples (default) or SampleRadius sets the number of samples.
   */
  vtkSetClampMacro(Amount, int, NUMBER_OF_SAMPLES, SAMPLE_RADIUS);
  vtkGetMacro(Amount, int);
  void SetAmountToNumberOfSamples() { this->SetAmount(NUMBER_OF_SAMPLES); }
  void SetAmountToSampleRadius() { this->SetAmount(SAMPLE_RADIUS); }
  const char* GetAmountAsString();
  ///@}

  ///@{
  /**
   * The exact number of samples. Default: 100000; at least 1. More samples show finer detail.
   */
  vtkSetClampMacro(NumberOfSamples, vtkIdType, 1, VTK_ID_MAX);
  vtkGetMacro(NumberOfSamples, vtkIdType);
  ///@}

  ///@{
  /**
   * The minimum distance between samples along the surface, in world units. WHITE_NOISE makes as many samples
   * as BLUE_NOISE of this radius has; PROGRESSIVE_BLUE_NOISE as many as keep about this distance. Above 0;
   * default: 0, which is an error when the amount is SAMPLE_RADIUS.
   */
  vtkSetMacro(SampleRadius, double);
  vtkGetMacro(SampleRadius, double);
  ///@}

  ///@{
  /**
   * The coverage slack of BLUE_NOISE: every position has a sample within (1 + slack) times the sample radius.
   * 0.02 to 1; default: 0.06. Larger values give fewer samples with a larger `Radius`, and are faster: 1
   * takes six to eight tenths of the time.
   */
  InkSetClampMacro(CoverageSlack, 0.02, 1.0);
  vtkGetMacro(CoverageSlack, double);
  ///@}

  ///@{
  /**
   * The random seed: each gives a different sampling of the same quality. Default: 0.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
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
   * Sort the points into progressive order and make the point array `Priority`. Default: on.
   */
  vtkSetMacro(ComputePriority, bool);
  vtkGetMacro(ComputePriority, bool);
  vtkBooleanMacro(ComputePriority, bool);
  ///@}

  ///@{
  /**
   * Compute the point array `EdgeOffsets` where a mesh has sharp edges: six components, the vectors from each
   * sample to the nearest position on one and to the nearest in another direction, 0 where there is none
   * within four radii. vtkInkSplattingLinesMapper cuts discs there. Needs ComputeNormals. Default: off.
   */
  vtkSetMacro(ComputeEdgeOffsets, bool);
  vtkGetMacro(ComputeEdgeOffsets, bool);
  vtkBooleanMacro(ComputeEdgeOffsets, bool);
  ///@}

  ///@{
  /**
   * Make the point arrays `FaceId` (the cell that contains the sample), `FacePoints` (the three points of the
   * triangle of that cell) and `BarycentricCoordinates` (their weights), from which another run can move the
   * samples. Default: off.
   */
  vtkSetMacro(KeepFaces, bool);
  vtkGetMacro(KeepFaces, bool);
  vtkBooleanMacro(KeepFaces, bool);
  ///@}

  ///@{
  /**
   * Sample a deforming mesh once, and move the samples with it. Default: off, each update resamples. An input
   * with time steps is sampled at the first of them, whichever step is requested first, and resampled when
   * anything but the time changes. Without time steps, the first mesh is sampled, and the next one after a
   * change of any parameter of the sampling. A mesh whose faces differ from the sampled ones is resampled,
   * and these samples are moved as long as the faces stay the same; so in a series with changing
   * connectivity, samples depend on the step that was requested first. Point clouds and the second input are
   * not affected.
   */
  vtkSetMacro(FollowDeformation, bool);
  vtkGetMacro(FollowDeformation, bool);
  vtkBooleanMacro(FollowDeformation, bool);
  ///@}

  /**
   * The number of times that this filter has sampled a mesh rather than moved existing samples.
   */
  int GetNumberOfSamplings() { return this->NumberOfSamplings; }

  /**
   * Whether FollowDeformation is on and there are samples of a mesh with these faces, which are moved to it
   * as long as the parameters of the sampling stay.
   */
  bool HasSamplesOfFaces(vtkPolyData* mesh);

  ///@{
  /**
   * Point clouds: the number of neighbors, including the point itself, that a normal is estimated from. 3 to
   * 64; default: 16. More neighbors smooth noise, but round off edges.
   */
  vtkSetClampMacro(NormalNeighbors, int, 3, 64);
  vtkGetMacro(NormalNeighbors, int);
  ///@}

  ///@{
  /**
   * Point clouds: orient estimated normals towards Viewpoint, as suits a single range scan, instead of
   * consistently and outwards on closed surfaces. Default: off.
   */
  vtkSetMacro(OrientTowardsViewpoint, bool);
  vtkGetMacro(OrientTowardsViewpoint, bool);
  vtkBooleanMacro(OrientTowardsViewpoint, bool);
  ///@}

  ///@{
  /**
   * The position of the scanner, in world coordinates. Default: the origin. Coordinates that are not finite
   * are refused with a warning.
   */
  InkSetPointMacro(Viewpoint);
  vtkGetVector3Macro(Viewpoint, double);
  ///@}

  ///@{
  /**
   * Point clouds: use one radius for all points, the median distance to the sixth neighbor, instead of one
   * per point; for evenly spaced points. Default: off.
   */
  vtkSetMacro(UniformRadius, bool);
  vtkGetMacro(UniformRadius, bool);
  vtkBooleanMacro(UniformRadius, bool);
  ///@}

  ///@{
  /**
   * Point clouds: remove isolated points, those much farther from all others than these are from each other
   * (see ink::PointRadii). Default: on. Off: they have radius 0 and are not drawn. Without effect with
   * UniformRadius or an input array `Radius`.
   */
  vtkSetMacro(RemoveIsolated, bool);
  vtkGetMacro(RemoveIsolated, bool);
  vtkBooleanMacro(RemoveIsolated, bool);
  ///@}

  /**
   * The number of isolated points found in the last run.
   */
  vtkIdType GetNumberOfIsolatedPoints() { return this->NumberOfIsolatedPoints; }

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
   * (default), that of the input's points.
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
   * The samples of the first frame, which are moved instead of resampling. Default: none.
   */
  void SetFirstFrameConnection(vtkAlgorithmOutput* samples) { this->SetInputConnection(1, samples); }
  void SetFirstFrameData(vtkPolyData* samples);
  ///@}

protected:
  vtkInkSurfaceSampler();
  ~vtkInkSurfaceSampler() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkInkSurfaceSampler(const vtkInkSurfaceSampler&) = delete;
  void operator=(const vtkInkSurfaceSampler&) = delete;

  void SampleMesh(vtkPolyData* input, vtkPolyData* output, bool keepFaces);
  void FollowMesh(vtkInformation* request, vtkInformation* inputInfo, vtkInformation* outputInfo,
    vtkPolyData* mesh, vtkPolyData* output);
  bool HasFirstSamples(vtkInformation* inputInfo);
  vtkMTimeType GetUpstreamMTime();
  std::string DescribeSampling();
  void MoveSamples(vtkPolyData* mesh, vtkPolyData* samples, vtkPolyData* output);

  int Method = AUTOMATIC;
  int Amount = NUMBER_OF_SAMPLES;
  vtkIdType NumberOfSamples = 100000;
  double SampleRadius = 0.0;
  double CoverageSlack = 0.06;
  int Seed = 0;
  bool ComputeNormals = true;
  bool ComputeRadius = true;
  bool ComputePriority = true;
  bool ComputeEdgeOffsets = false;
  bool KeepFaces = false;
  bool FollowDeformation = false;
  int NumberOfSamplings = 0;
  /// Samples of the first step or mesh, and of the last one with different faces. Null: not sampled yet.
  vtkSmartPointer<vtkPolyData> FirstSamples;
  vtkSmartPointer<vtkPolyData> LaterSamples;
  std::string SampledAs;            ///< DescribeSampling() when FirstSamples were made
  vtkMTimeType SampledUpstream = 0; ///< GetUpstreamMTime() then
  bool AtFirstStep = false;         ///< whether the first time step was requested instead of the current one
  bool TriedFirstStep = false;      ///< whether it was requested just before, with or without success
  int NormalNeighbors = 16;
  bool OrientTowardsViewpoint = false;
  double Viewpoint[3] = { 0.0, 0.0, 0.0 };
  bool UniformRadius = false;
  bool RemoveIsolated = true;
  vtkIdType NumberOfIsolatedPoints = 0;
  bool GenerateVertices = true;
  int OutputPointsPrecision = DEFAULT_PRECISION;
};

#endif
