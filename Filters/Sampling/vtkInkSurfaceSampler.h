// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkSurfaceSampler
 * @brief   meshes to points with normals: white or blue noise, in an order that can be cut off anywhere
 *
 * Input: a vtkPolyData, or another vtkPointSet, of whose cells the surface is taken (vtkUnstructuredGrid,
 * vtkStructuredGrid). Polygons and triangle strips are sampled (Zhang et al. 2014, section 4): by area
 * alone, each sample for itself (WHITE_NOISE, Osada et al. 2002), or so that no two samples are nearer along
 * the surface than a radius and none fits in between (BLUE_NOISE, a Poisson-disc sampling after Cline et al.
 * 2009). Distances are measured on the mesh, so that both sides of a thin sheet get their samples; see
 * ink::SurfaceUnfolding. Triangles without area are passed over; edges of many triangles, borders,
 * inconsistent orientation and unconnected triangles are taken as they are.
 *
 * Output point data: `Normals` (unit; barycentric in the mesh's point normals, or where it has none in the
 * mean normals of the faces around each point), `Radius` (discs of this radius leave no holes), `Priority`,
 * and on request `FaceId`, `FacePoints` and `BarycentricCoordinates`. The output's one cell is a vertex cell
 * of type VTK_POLY_VERTEX holding all points, unless GenerateVertices is off.
 *
 * Points come in the order of `Priority`, which runs evenly from 0 to below 1: the points of a priority below
 * p are for every p spread evenly themselves. ComputePriority off leaves points in the order in which they
 * were made, and is faster.
 *
 * `Radius`: the paper's A / n has the unit of an area. Here it is a length: for blue noise the distance up to
 * which no place is free of samples, about 1.1 sqrt(A / n); for white noise as large as it must be for less
 * than one hole in a hundred samplings, about 2.4 sqrt(A / n) for a million samples.
 *
 * Density: an array of one component by SetInputArrayToProcess(0, 0, 0, association, name), of points or
 * cells, says how densely to sample relative to elsewhere; 0: not at all, nor where it is negative or NaN, of
 * which a warning tells. Without a name all is sampled alike, the default.
 *
 * Animation (Zhang et al. 2014, section 6): with FollowDeformation on, a mesh that changes with time is
 * sampled once, and its samples stay in their faces and move with them; `Priority` stays what it is, `Radius`
 * grows by how much the surface is stretched around each sample. Or by hand: give the second input the output
 * for the first frame, made with KeepFaces, and the first input a deformed copy of the mesh.
 *
 * Point clouds: an input of points without faces is not sampled. Its points get their `Priority`, and where
 * they have none, a `Radius`, each by the distances to its neighbors, so that uneven scans have neither
 * holes nor real holes closed (see ink::pointRadii), and normals, see NormalNeighbors. Points that belong to
 * no surface are left out, see RemoveIsolated, and those that `vtkGhostType` marks as hidden or duplicate.
 *
 * The same input gives the same output on any number of threads, and however its points and faces are
 * numbered. In parallel each piece is sampled for itself: ghost cells are left out, and NumberOfSamples
 * counts per piece. With WHITE_NOISE, SampleRadius, global ids of cells and no density, pieces have the
 * whole's points. Blue-noise samples of two pieces do not know of each other, and may be nearer than the
 * radius where pieces meet; no point is made twice.
 *
 * Errors, each with an empty output: a Radius of 0 or less where it is asked for, faces without area, density
 * that is no array of one component or is 0 everywhere, more samples than memory, the first frame's samples
 * without their faces or of a mesh with other faces.
 *
 * @sa vtkInkPointPriority vtkInkIsoSurfaceSampler vtkInkSplattingLinesMapper
 */
#ifndef vtkInkSurfaceSampler_h
#define vtkInkSurfaceSampler_h

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

  /// How samples are spread, see SetMethod.
  enum MethodType
  {
    WHITE_NOISE = 0,
    BLUE_NOISE = 1,
    PROGRESSIVE_BLUE_NOISE = 2,
    AUTOMATIC = 3
  };

  ///@{
  /**
   * WHITE_NOISE: independent samples; some lie close together, and gaps stay. BLUE_NOISE: samples
   * keep a distance and leave no gaps. PROGRESSIVE_BLUE_NOISE: samples keep an eighth less of a distance and
   * leave wider gaps, but are made several times as fast, in the order of their priorities, the first of
   * which are the more even ones; with a density it is BLUE_NOISE. AUTOMATIC (default): BLUE_NOISE below
   * half a million samples and for a SampleRadius, else WHITE_NOISE, as Zhang et al. do (2014, section 6),
   * for from there on the difference is hard to see in a drawing.
   */
  vtkSetClampMacro(Method, int, WHITE_NOISE, AUTOMATIC);
  vtkGetMacro(Method, int);
  void SetMethodToWhiteNoise() { this->SetMethod(WHITE_NOISE); }
  void SetMethodToBlueNoise() { this->SetMethod(BLUE_NOISE); }
  void SetMethodToProgressiveBlueNoise() { this->SetMethod(PROGRESSIVE_BLUE_NOISE); }
  void SetMethodToAutomatic() { this->SetMethod(AUTOMATIC); }
  const char* GetMethodAsString();
  ///@}

  /// What says how many samples are made, see SetAmount.
  enum AmountType
  {
    NUMBER_OF_SAMPLES = 0,
    SAMPLE_RADIUS = 1
  };

  ///@{
  /**
   * Whether NumberOfSamples (default) or SampleRadius says how many samples there are.
   */
  vtkSetClampMacro(Amount, int, NUMBER_OF_SAMPLES, SAMPLE_RADIUS);
  vtkGetMacro(Amount, int);
  void SetAmountToNumberOfSamples() { this->SetAmount(NUMBER_OF_SAMPLES); }
  void SetAmountToSampleRadius() { this->SetAmount(SAMPLE_RADIUS); }
  const char* GetAmountAsString();
  ///@}

  ///@{
  /**
   * How many samples are made, exactly. Default: 100000; at least 1. More show finer detail.
   */
  vtkSetClampMacro(NumberOfSamples, vtkIdType, 1, VTK_ID_MAX);
  vtkGetMacro(NumberOfSamples, vtkIdType);
  ///@}

  ///@{
  /**
   * The least distance between samples along the surface, in world units. With WHITE_NOISE, as many samples
   * are made as a blue noise of this radius has; with PROGRESSIVE_BLUE_NOISE, as many as keep about this
   * distance. Above 0; default: 0, which is an error where the radius
   * counts.
   */
  vtkSetMacro(SampleRadius, double);
  vtkGetMacro(SampleRadius, double);
  ///@}

  ///@{
  /**
   * How far beyond the radius, as a part of it, a place may be from all samples before BLUE_NOISE puts one
   * there: 0.02 to 1; default: 0.06. The larger, the fewer samples a radius has, the wider their `Radius`
   * must be to leave no holes, and the sooner they are made: at 1, in six to eight tenths of
   * the time.
   */
  void SetGap(double value);
  double GetGapMinValue() { return 0.02; }
  double GetGapMaxValue() { return 1.0; }
  vtkGetMacro(Gap, double);
  ///@}

  ///@{
  /**
   * Another seed gives other samples, just as good. Default: 0.
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
   * Order the points and make the point array `Priority`. Default: on.
   */
  vtkSetMacro(ComputePriority, bool);
  vtkGetMacro(ComputePriority, bool);
  vtkBooleanMacro(ComputePriority, bool);
  ///@}

  ///@{
  /**
   * Make the point arrays `FaceId` (the cell a sample lies in), `FacePoints` (the three points of the
   * triangle, a part of that cell) and `BarycentricCoordinates` (their weights), with which another run
   * moves the samples. Default: off.
   */
  vtkSetMacro(KeepFaces, bool);
  vtkGetMacro(KeepFaces, bool);
  vtkBooleanMacro(KeepFaces, bool);
  ///@}

  ///@{
  /**
   * Sample a mesh that changes once, and move the samples with it. Default: off, each update samples anew.
   * An input with time steps is sampled at the first of them, whichever is asked for first, and whenever
   * anything else than the time changes. Without time steps, the first mesh is sampled, and the next one
   * after a change of what samples depend on. Where faces differ from those that were sampled, the mesh is
   * sampled anew, and these samples are moved as long as faces stay the same; so in a series whose faces
   * change, they are those of the step that was first asked for. Points without faces, and the second input,
   * are not concerned.
   */
  vtkSetMacro(FollowDeformation, bool);
  vtkGetMacro(FollowDeformation, bool);
  vtkBooleanMacro(FollowDeformation, bool);
  ///@}

  /**
   * How often a mesh has been sampled, rather than samples moved, since this filter was made.
   */
  int GetNumberOfSamplings() { return this->NumberOfSamplings; }

  ///@{
  /**
   * Of point clouds: from how many neighbors, itself included, a normal is estimated. 3 to 64; default: 16.
   * More smooth noise and rounded edges.
   */
  vtkSetClampMacro(NormalNeighbors, int, 3, 64);
  vtkGetMacro(NormalNeighbors, int);
  ///@}

  ///@{
  /**
   * Of point clouds: whether estimated normals point to the side of Viewpoint, as is right for the points of
   * one range scan, or all to the same side and outwards on closed surfaces (default: off).
   */
  vtkSetMacro(OrientTowardsViewpoint, bool);
  vtkGetMacro(OrientTowardsViewpoint, bool);
  vtkBooleanMacro(OrientTowardsViewpoint, bool);
  ///@}

  ///@{
  /**
   * Where the scanner stood, in world coordinates. Default: the origin. What is not finite is refused with a
   * warning.
   */
  void SetViewpoint(double x, double y, double z);
  void SetViewpoint(const double point[3]) { this->SetViewpoint(point[0], point[1], point[2]); }
  vtkGetVector3Macro(Viewpoint, double);
  ///@}

  ///@{
  /**
   * Of point clouds: one radius for all points, the median distance to the sixth neighbor, instead of each
   * point's own; for points that lie evenly. Default: off.
   */
  vtkSetMacro(UniformRadius, bool);
  vtkGetMacro(UniformRadius, bool);
  vtkBooleanMacro(UniformRadius, bool);
  ///@}

  ///@{
  /**
   * Of point clouds: leave out isolated points, those that are far from all others for the distances among
   * these (see ink::PointRadii). Default: on. Off: they have the radius 0, with which they are not drawn.
   * UniformRadius and points with a `Radius` of their own have none.
   */
  vtkSetMacro(RemoveIsolated, bool);
  vtkGetMacro(RemoveIsolated, bool);
  vtkBooleanMacro(RemoveIsolated, bool);
  ///@}

  /**
   * How many isolated points the last run found.
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
   * The type of the points' coordinates: vtkAlgorithm::SINGLE_PRECISION, DOUBLE_PRECISION or
   * DEFAULT_PRECISION (default), which is that of the input's points.
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
   * The samples of the first frame, which are moved instead of made anew. Default: none.
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

  void SampleMesh(vtkPolyData* mesh, vtkPolyData* output, bool keepFaces);
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
  double Gap = 0.06;
  int Seed = 0;
  bool ComputeNormals = true;
  bool ComputeRadius = true;
  bool ComputePriority = true;
  bool KeepFaces = false;
  bool FollowDeformation = false;
  int NumberOfSamplings = 0;
  /// Of the first step or mesh, and of the last one with other faces. Null: not sampled yet.
  vtkSmartPointer<vtkPolyData> FirstSamples;
  vtkSmartPointer<vtkPolyData> LaterSamples;
  std::string SampledAs;            ///< DescribeSampling() when FirstSamples were made
  vtkMTimeType SampledUpstream = 0; ///< GetUpstreamMTime() then
  bool AtFirstStep = false;         ///< whether the first time step was asked for instead of the wanted one
  bool TriedFirstStep = false;      ///< whether it was asked for just before, with or without success
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
