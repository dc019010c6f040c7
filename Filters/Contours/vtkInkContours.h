// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkContours
 * @brief silhouettes, creases and borders of a mesh, or silhouettes of an image, for a camera, as polylines
 *
 * Silhouettes (occluding contours) are where a surface turns away from the eye: the zero set of n.v, with the
 * normals n interpolated across faces (Hertzmann and Zorin 2000), which is smooth; or, with Faceted, edges
 * between a face seen from its front and one seen from its back. Creases, borders and non-manifold edges do
 * not depend on the eye. All are chained to polylines; what is hidden by the surface is not left out.
 *
 * Input: a vtkPolyData with polygons or strips, or a vtkImageData. Of a mesh normals are its point normals,
 * or an array `Normals`; if it has none, the mean over the faces around each point is used, and the filter
 * warns once. Points of equal position count as one. Faces with a point that is not finite, and ghost and
 * hidden cells, are left out.
 *
 * Of an image the silhouettes of the iso-surfaces at its iso-values are found straight from the samples, cell
 * by cell, without a mesh (Burns et al. 2005): where f is the iso-value and grad f . v = 0. The input array
 * is set with SetInputArrayToProcess(0, ...); by default it is the active point scalars. Cells that are
 * ghosts, hidden or refined, and those with a corner that is hidden or not finite, are left out. Faceted,
 * Creases, Borders and NonManifoldEdges are of no effect.
 *
 * With the Method VOXEL_SEGMENTS an image has the silhouettes of Lu et al. (2003, section 5.6) instead: a
 * separate segment through the center of each voxel that lies on an edge and is seen from its side, of all
 * surfaces in the image at once; iso-values and ProjectionSteps are of no effect. A mesh has none, which is
 * an error.
 *
 * The eye is that of a vtkCamera, or given as a position or, for a parallel projection, as a direction.
 *
 * Output: lines, one polyline for each chain; a closed one ends with the id of its first point. The cell
 * array `ContourKind` says what each is (SILHOUETTE, CREASE, BORDER, NON_MANIFOLD_EDGE), and with several
 * iso-values the cell array `SurfaceIndex` (int) the index of its own; point arrays are made on request.
 * Points have the precision of the mesh's; of an image they are floats where these do for its coordinates.
 * Chains are in a defined order, the same for any number of threads.
 *
 * What does not depend on the eye, among it an index by which a new eye costs time for the contours' length
 * instead of the number of faces, is kept until the input or an option that it depends on changes.
 *
 * Errors, each with an empty output: no camera where one is expected, a face with a point that does not
 * exist, faces without area only, a camera whose position is not finite, no such point array of an image. A
 * mesh without polygons, no iso-value, one that is not a number, iso-values that are nowhere in the image,
 * and an image of fewer than two samples along an axis give a warning.
 *
 * @sa vtkPolyDataSilhouette vtkFeatureEdges vtkInkIsoSurfaceSampler
 */
#ifndef vtkInkContours_h
#define vtkInkContours_h

#include "InkSetters.h"
#include "vtkInkFiltersContoursModule.h" // for the export macro
#include "vtkNew.h"                      // for the contour values
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for the camera

#include <memory>

class vtkCamera;
class vtkContourValues;

class VTKINKFILTERSCONTOURS_EXPORT vtkInkContours : public vtkPolyDataAlgorithm
{
public:
  static vtkInkContours* New();
  vtkTypeMacro(vtkInkContours, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// What a line of the output is: the values of the cell array `ContourKind`.
  enum KindType
  {
    SILHOUETTE = 0,
    CREASE = 1,
    BORDER = 2,
    NON_MANIFOLD_EDGE = 3
  };

  /// How silhouettes are found, see SetMethod.
  enum MethodType
  {
    CHAINS = 0,
    VOXEL_SEGMENTS = 1,
    VOXEL_SEARCH = 2
  };

  /// What the eye is taken from, see SetEye.
  enum EyeType
  {
    CAMERA = 0,
    POSITION = 1,
    DIRECTION = 2
  };

  ///@{
  /**
   * CHAINS (default): exact curves, connected. VOXEL_SEGMENTS, of images: as published by Lu et al. (2003,
   * section 5.6), a segment along gradient x eye through the center of each voxel where the Laplacian of
   * Gaussian changes its sign, if value, gradient magnitude and the angle between gradient and eye are within
   * LowestValue, HighestValue, LeastGradientMagnitude and LargestCosine. VOXEL_SEARCH: the same segments
   * where the exhaustive search of each voxel's 3 x 3 x 3 neighbors finds a silhouette, which is slow, for
   * reference; EdgeScale and LargestCosine are of no effect on it.
   */
  vtkSetClampMacro(Method, int, CHAINS, VOXEL_SEARCH);
  vtkGetMacro(Method, int);
  void SetMethodToChains() { this->SetMethod(CHAINS); }
  void SetMethodToVoxelSegments() { this->SetMethod(VOXEL_SEGMENTS); }
  void SetMethodToVoxelSearch() { this->SetMethod(VOXEL_SEARCH); }
  const char* GetMethodAsString();
  ///@}

  ///@{
  /**
   * The eye. CAMERA (default): Camera, with its projection. POSITION: EyePosition.
   * DIRECTION: a parallel projection along EyeDirection.
   */
  vtkSetClampMacro(Eye, int, CAMERA, DIRECTION);
  vtkGetMacro(Eye, int);
  void SetEyeToCamera() { this->SetEye(CAMERA); }
  void SetEyeToPosition() { this->SetEye(POSITION); }
  void SetEyeToDirection() { this->SetEye(DIRECTION); }
  const char* GetEyeAsString();
  ///@}

  ///@{
  /**
   * The camera, when Eye is CAMERA; the filter runs again whenever it has changed. Default: none.
   */
  void SetCamera(vtkCamera* camera);
  vtkCamera* GetCamera();
  ///@}

  ///@{
  /**
   * The eye's position in world coordinates, when Eye is POSITION. Default: (0, 0, 1). Coordinates that are
   * not finite are refused with a warning.
   */
  InkSetPointMacro(EyePosition);
  vtkGetVector3Macro(EyePosition, double);
  ///@}

  ///@{
  /**
   * The direction from the eye into the scene, of any length, when Eye is DIRECTION. Default: (0, 0, -1).
   * Coordinates that are not finite are refused with a warning.
   */
  InkSetPointMacro(EyeDirection);
  vtkGetVector3Macro(EyeDirection, double);
  ///@}

  ///@{
  /**
   * The iso-values of an image, as in vtkContourFilter. Default: none, which yields no contours.
   */
  void SetValue(int i, double value);
  double GetValue(int i);
  void SetNumberOfContours(int number);
  vtkIdType GetNumberOfContours();
  void GenerateValues(int numContours, double rangeStart, double rangeEnd);
  ///@}

  ///@{
  /**
   * The component of an image's array that is contoured; from 0. Default: 0.
   */
  vtkSetClampMacro(ArrayComponent, int, 0, VTK_INT_MAX);
  vtkGetMacro(ArrayComponent, int);
  ///@}

  ///@{
  /**
   * Newton steps with which the points of an image's silhouettes are projected onto those of the interpolated
   * field; no point moves farther than a cell's diagonal. 0 (default: points stay where the silhouette of the
   * surface that is linear in tetrahedra passes their faces) to 20.
   */
  vtkSetClampMacro(ProjectionSteps, int, 0, 20);
  vtkGetMacro(ProjectionSteps, int);
  ///@}

  ///@{
  /**
   * Segments through voxels: the standard deviation of the Laplacian's Gaussian, in voxels; fewer edges of
   * noise with a larger one. 0 (not smoothed) to 16; default: 1. NaN is refused with a warning.
   */
  InkSetClampMacro(EdgeScale, 0.0, 16.0);
  vtkGetMacro(EdgeScale, double);
  ///@}

  ///@{
  /**
   * Segments through voxels: the least value of a voxel that has one. -1e38 (default) to 1e38. NaN is refused
   * with a warning.
   */
  InkSetClampMacro(LowestValue, -1e38, 1e38);
  vtkGetMacro(LowestValue, double);
  ///@}

  ///@{
  /**
   * Segments through voxels: the greatest value of a voxel that has one. -1e38 to 1e38 (default). NaN is
   * refused with a warning.
   */
  InkSetClampMacro(HighestValue, -1e38, 1e38);
  vtkGetMacro(HighestValue, double);
  ///@}

  ///@{
  /**
   * Segments through voxels: the least gradient magnitude of a voxel that has one, in value per world unit. 0
   * (default) to 1e38. NaN is refused with a warning.
   */
  InkSetClampMacro(LeastGradientMagnitude, 0.0, 1e38);
  vtkGetMacro(LeastGradientMagnitude, double);
  ///@}

  ///@{
  /**
   * Segments through voxels: the largest cosine of the angle between a voxel's gradient and the direction to
   * the eye, regardless of its sign; broader bands of segments with a larger one. 0 to 1; default: 0.1. NaN
   * is refused with a warning.
   */
  InkSetClampMacro(LargestCosine, 0.0, 1.0);
  vtkGetMacro(LargestCosine, double);
  ///@}

  ///@{
  /**
   * The length of segments through voxels, in edges of a cube with the voxels' diagonal. 0 to 100;
   * default: 1. NaN is refused with a warning.
   */
  InkSetClampMacro(SegmentLength, 0.0, 100.0);
  vtkGetMacro(SegmentLength, double);
  ///@}

  ///@{
  /**
   * Find silhouettes. Default: on.
   */
  vtkSetMacro(Silhouettes, bool);
  vtkGetMacro(Silhouettes, bool);
  vtkBooleanMacro(Silhouettes, bool);
  ///@}

  ///@{
  /**
   * Find silhouettes along edges, between faces seen from front and back, instead of across faces. They need
   * no normals, and zigzag. Default: off.
   */
  vtkSetMacro(Faceted, bool);
  vtkGetMacro(Faceted, bool);
  vtkBooleanMacro(Faceted, bool);
  ///@}

  ///@{
  /**
   * Find creases: edges whose two faces enclose more than FeatureAngle. Default: off.
   */
  vtkSetMacro(Creases, bool);
  vtkGetMacro(Creases, bool);
  vtkBooleanMacro(Creases, bool);
  ///@}

  ///@{
  /**
   * The angle between the normals of two faces, in degrees, beyond which their edge is a crease. Larger ones
   * leave only sharper edges. 0 to 180; default: 30. NaN is refused with a warning.
   */
  InkSetClampMacro(FeatureAngle, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Creases that end within the surface, and with all creases and borders that they join are no longer than
   * this share of its diagonal, are left out: specks, as the noise of scans makes them. Edges of a machine
   * part, however short, end at others and stay. 0 (default: none is left out) to 1. NaN is refused with a
   * warning.
   */
  InkSetClampMacro(ShortestCrease, 0.0, 1.0);
  vtkGetMacro(ShortestCrease, double);
  ///@}

  ///@{
  /**
   * Find borders: edges of one face. Default: on.
   */
  vtkSetMacro(Borders, bool);
  vtkGetMacro(Borders, bool);
  vtkBooleanMacro(Borders, bool);
  ///@}

  ///@{
  /**
   * Borders that, with all borders that they join, are no longer than this share of the surface's diagonal,
   * are left out: those around triangles that scans lack. With Borders, interpolated silhouettes go straight
   * on across such holes. 0 (default: none is left out) to 1. NaN is refused with a warning.
   */
  InkSetClampMacro(ShortestBorder, 0.0, 1.0);
  vtkGetMacro(ShortestBorder, double);
  ///@}

  ///@{
  /**
   * Find non-manifold edges: those of more than two faces. Default: off.
   */
  vtkSetMacro(NonManifoldEdges, bool);
  vtkGetMacro(NonManifoldEdges, bool);
  vtkBooleanMacro(NonManifoldEdges, bool);
  ///@}

  ///@{
  /**
   * Make the point array `Normals`: the surface's unit normal. Default: off.
   */
  vtkSetMacro(ComputeNormals, bool);
  vtkGetMacro(ComputeNormals, bool);
  vtkBooleanMacro(ComputeNormals, bool);
  ///@}

  ///@{
  /**
   * Make the point array `RadialCurvature`: of silhouettes, the surface's normal curvature in the direction
   * to the eye, in 1 / world unit; where it is negative, the surface itself hides the contour. 0 on other
   * lines. Default: off.
   */
  vtkSetMacro(ComputeRadialCurvature, bool);
  vtkGetMacro(ComputeRadialCurvature, bool);
  vtkBooleanMacro(ComputeRadialCurvature, bool);
  ///@}

  ///@{
  /**
   * Make the point array `ArcLength`: along the line from its first point, in world units. Default: off.
   */
  vtkSetMacro(ComputeArcLength, bool);
  vtkGetMacro(ComputeArcLength, bool);
  vtkBooleanMacro(ComputeArcLength, bool);
  ///@}

  ///@{
  /**
   * Make the point array `CellId`: the input's cell that the segment to the line's next point lies in.
   * Default: off.
   */
  vtkSetMacro(ComputeCellIds, bool);
  vtkGetMacro(ComputeCellIds, bool);
  vtkBooleanMacro(ComputeCellIds, bool);
  ///@}

  /**
   * The number of times that the filter has prepared a mesh, or an iso-surface of an image, which it does not
   * when only the eye changes.
   */
  int GetNumberOfIndexBuilds();

  /**
   * Those of the camera and the iso-values included.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkInkContours();
  ~vtkInkContours() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkInkContours(const vtkInkContours&) = delete;
  void operator=(const vtkInkContours&) = delete;

  class vtkInternals;

  void FindContoursOfMesh(vtkPolyData* mesh, vtkPolyData* output);
  void FindContoursOfImage(vtkInformationVector** inputVector, vtkInformationVector* outputVector);
  void FindVoxelSegments(vtkInformationVector** inputVector, vtkInformationVector* outputVector);

  std::unique_ptr<vtkInternals> Internals;
  vtkSmartPointer<vtkCamera> Camera;
  int Method = CHAINS;
  int Eye = CAMERA;
  double EyePosition[3] = { 0.0, 0.0, 1.0 };
  double EyeDirection[3] = { 0.0, 0.0, -1.0 };
  vtkNew<vtkContourValues> ContourValues;
  int ArrayComponent = 0;
  int ProjectionSteps = 0;
  double EdgeScale = 1.0;
  double LowestValue = -1e38;
  double HighestValue = 1e38;
  double LeastGradientMagnitude = 0.0;
  double LargestCosine = 0.1;
  double SegmentLength = 1.0;
  bool Silhouettes = true;
  bool Faceted = false;
  bool Creases = false;
  double FeatureAngle = 30.0;
  double ShortestCrease = 0.0;
  double ShortestBorder = 0.0;
  bool Borders = true;
  bool NonManifoldEdges = false;
  bool ComputeNormals = false;
  bool ComputeRadialCurvature = false;
  bool ComputeArcLength = false;
  bool ComputeCellIds = false;
};

#endif
