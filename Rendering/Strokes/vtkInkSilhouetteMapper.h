// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkSilhouetteMapper
 * @brief   draws the outlines of a surface, or of an image's iso-surfaces, as strokes of a pen
 *
 * Input: a surface of polygons and strips, with point normals or without (then they are computed, which a
 * warning says); or a vtkImageData, see below. Its contours are found again when the camera, the surface or
 * an option changed, at a cost that follows their length and not the size of the surface (Hertzmann and Zorin
 * 2000), and drawn as vtkInkStrokeMapper draws strokes, with all its parameters. The surface hides what lies
 * behind it, whether or not an actor shows it; SetSurfaceConnection and SetSurfaceData give another surface
 * to do that, unless it is empty.
 *
 * Of an image the silhouettes of the iso-surfaces at its iso-values are found straight from the samples
 * (Burns et al. 2005), and lines where these surfaces leave the image or samples are missing (Borders). They
 * are found again also when an iso-value changed, of which all others are kept. No surface is made: discs,
 * one in each cell that an iso-surface passes (Zhang et al. 2014, section 5.1), hide what lies behind them by
 * more than a cell's diagonal. The array is the active point scalars, or set by
 * SetInputArrayToProcess(1, ...). Faceted, Creases, NonManifoldEdges, ShortestCrease and ShortestBorder are
 * of no effect. The cell array `SurfaceIndex` tells several iso-values apart.
 *
 * That is the Method CHAINS. Others draw silhouettes as Lu et al. (2003, section 5.6) publish them, of which
 * the GPU finds what depends on the camera: VOXEL_SEGMENTS, of edge voxels, those that vtkInkEdgeVoxels finds
 * in an image, as input; IMAGE_SPACE and TOON, of a surface. They draw silhouettes only, and
 * nothing that is hidden, whatever HiddenParts says.
 *
 * With Density less than 1 the longest contours are drawn, which have that share of the length of all; of
 * segments through voxels, and of edges, any, always the same ones.
 *
 * An edge that is a crease and a silhouette is drawn once, as a crease.
 *
 * Hardware selection finds points of the surface, or of the image, beside a contour. With ScalarVisibility
 * on, the cell array `ContourKind` (0 silhouette, 1 crease, 2 border, 3 non-manifold edge) can color the
 * strokes.
 *
 * @sa vtkInkStrokeMapper
 */
#ifndef vtkInkSilhouetteMapper_h
#define vtkInkSilhouetteMapper_h

#include "vtkInkRenderingStrokesModule.h" // for the export macro
#include "vtkInkStrokeMapper.h"
#include "vtkNew.h" // for the contour values

#include <memory> // for std::unique_ptr

class vtkContourValues;
class vtkImageData;

class VTKINKRENDERINGSTROKES_EXPORT vtkInkSilhouetteMapper : public vtkInkStrokeMapper
{
public:
  static vtkInkSilhouetteMapper* New();
  vtkTypeMacro(vtkInkSilhouetteMapper, vtkInkStrokeMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// All parameters and both inputs of another mapper, as far as it has them.
  void ShallowCopy(vtkAbstractMapper* mapper) override;

  ///@{
  /// The surface, or the image, when it is not the output of a connected algorithm. Default: none.
  void SetInputData(vtkPolyData* surface);
  void SetInputData(vtkImageData* image);
  ///@}

  /// Later where an iso-value was changed.
  vtkMTimeType GetMTime() override;

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
  vtkSetClampMacro(ImageComponent, int, 0, VTK_INT_MAX);
  vtkGetMacro(ImageComponent, int);
  ///@}

  /// How silhouettes are found, see SetMethod.
  enum Methods
  {
    CHAINS = 0,
    VOXEL_SEGMENTS = 1,
    IMAGE_SPACE = 2,
    TOON = 3
  };

  ///@{
  /**
   * CHAINS (default): exact curves. VOXEL_SEGMENTS: the input is points of edge voxels with the arrays
   * `Gradient`, `Value` and `Radius`; each that passes the test of LowestValue, HighestValue,
   * LeastGradientMagnitude and LargestCosine gets a segment through its center along gradient x eye. Voxels
   * are sent to the GPU once. Nothing hides segments but a surface that SetSurfaceConnection gives, pixel by
   * pixel. IMAGE_SPACE: the edges of polygons that face away from the eye, as broad lines behind those that
   * face it, past which half of a line reaches (Raskar and Cohen 1999); the outside of a closed surface is
   * the front, whichever way its polygons run. They have neither dashes nor a texture. TOON: the surface is
   * ink where the cosine of the angle between its normal and the direction to the eye is at most
   * LargestCosine.
   */
  vtkSetClampMacro(Method, int, CHAINS, TOON);
  vtkGetMacro(Method, int);
  void SetMethodToChains() { this->SetMethod(CHAINS); }
  void SetMethodToVoxelSegments() { this->SetMethod(VOXEL_SEGMENTS); }
  void SetMethodToImageSpace() { this->SetMethod(IMAGE_SPACE); }
  void SetMethodToToon() { this->SetMethod(TOON); }
  const char* GetMethodAsString();
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
   * Segments through voxels and toon shading: the largest cosine of the angle between a voxel's gradient, or
   * the surface's normal, and the direction to the eye, regardless of its sign; broader bands with a larger
   * one. 0 to 1; default: 0.1. NaN is refused with a warning.
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
   * Image space: whether lines become thinner as the surface becomes smaller in the picture. LineWidth is
   * then that of a surface whose bounding sphere is as high as the picture, or higher, and of others its
   * share of the height. Default: on.
   */
  vtkSetMacro(Thinning, bool);
  vtkGetMacro(Thinning, bool);
  vtkBooleanMacro(Thinning, bool);
  ///@}

  ///@{
  /**
   * Whether silhouettes are drawn: where the surface turns away from the eye. Default: on.
   */
  vtkSetMacro(Silhouettes, bool);
  vtkGetMacro(Silhouettes, bool);
  vtkBooleanMacro(Silhouettes, bool);
  ///@}

  ///@{
  /**
   * Whether silhouettes are edges between polygons that face the eye and those that do not, in place of
   * smooth curves by the normals at the points. Default: off.
   */
  vtkSetMacro(Faceted, bool);
  vtkGetMacro(Faceted, bool);
  vtkBooleanMacro(Faceted, bool);
  ///@}

  ///@{
  /**
   * Whether creases are drawn: edges between polygons at an angle of FeatureAngle or more. Default: off.
   */
  vtkSetMacro(Creases, bool);
  vtkGetMacro(Creases, bool);
  vtkBooleanMacro(Creases, bool);
  ///@}

  ///@{
  /**
   * The least angle between the normals of the polygons at a crease, in degrees; fewer creases with a larger
   * one. 0 to 180; default: 30.
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
   * Whether creases are only edges along which the normals of the two polygons differ, too, as of meshes
   * whose points are split at their sharp edges. So a smooth but noisy part has none. Default: off.
   */
  vtkSetMacro(SharpCreasesOnly, bool);
  vtkGetMacro(SharpCreasesOnly, bool);
  vtkBooleanMacro(SharpCreasesOnly, bool);
  ///@}

  ///@{
  /**
   * Whether borders are drawn: edges of one polygon only; of an image, where an iso-surface ends. Default:
   * on.
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
   * Whether edges of more than two polygons are drawn. Default: off.
   */
  vtkSetMacro(NonManifoldEdges, bool);
  vtkGetMacro(NonManifoldEdges, bool);
  vtkBooleanMacro(NonManifoldEdges, bool);
  ///@}

  ///@{
  /**
   * Whether dashes of silhouettes stay where they were in the picture before while the camera moves, as far
   * as lines that stretch and join let them; a picture with dashes then depends on those before it, by where
   * on their lines they are. Default: on. Off, they begin where the line does, which travels over the surface
   * with the eye.
   */
  vtkSetMacro(CoherentDashes, bool);
  vtkGetMacro(CoherentDashes, bool);
  vtkBooleanMacro(CoherentDashes, bool);
  ///@}

  /**
   * The contours that an actor in a renderer showed last: lines with the point arrays `Normals`, of closed
   * surfaces `RadialCurvature`, and `ArcLength`, and the cell array `ContourKind`; null before the first
   * picture. Its modification time tells when they were found. Only of the Method CHAINS.
   */
  vtkPolyData* GetContours(vtkRenderer* renderer, vtkActor* actor);

  /// False and empty: the strokes have none of the input's points.
  bool EvaluateWidths(vtkRenderer* renderer, vtkActor* actor, vtkFloatArray* widths) override;

protected:
  vtkInkSilhouetteMapper();
  ~vtkInkSilhouetteMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  bool UpdateMarks(InkMarks& own) override;
  void DrawMarks(InkMarks& own, const InkFrame& frame) override;
  vtkPolyData* FindSurface() override;
  double FindDepthTolerance() override;
  /// Of chains those of the input, so that dashes are as long while the camera turns around it.
  bool GetExtent(double bounds[6]) override;

private:
  vtkInkSilhouetteMapper(const vtkInkSilhouetteMapper&) = delete;
  void operator=(const vtkInkSilhouetteMapper&) = delete;

  /// The input where it is an image, otherwise null.
  vtkImageData* FindImage();
  /// Whether no other surface hides contours.
  bool HidesItself();
  /// What finds contours of the input, made ready; false if the input has none, which was reported.
  bool UpdateFinder();
  bool PrepareImage(vtkImageData* image);
  bool UpdateToon(InkStrokeMarks& marks);
  /// Finds and uploads the contours for a frame's eye; false where there is nothing to draw.
  bool UpdateChains(InkMarks& own, const InkFrame& frame);
  bool CheckPolygons();
  bool CheckVoxels();
  void WarnOfNormals();
  void ChooseByEye(
    const InkStrokeMarks& marks, const InkFrame& frame, const InkViewUniforms& view, InkStrokeStyle& style);
  void DrawToon(InkStrokeMarks& marks, const InkFrame& frame);

  int Method = CHAINS;
  vtkNew<vtkContourValues> ContourValues;
  int ImageComponent = 0;
  double LowestValue = -1e38;
  double HighestValue = 1e38;
  double LeastGradientMagnitude = 0.0;
  double LargestCosine = 0.1;
  double SegmentLength = 1.0;
  bool Thinning = true;
  bool Silhouettes = true;
  bool Faceted = false;
  bool Creases = false;
  double FeatureAngle = 30.0;
  double ShortestCrease = 0.0;
  bool SharpCreasesOnly = false;
  double ShortestBorder = 0.0;
  bool Borders = true;
  bool NonManifoldEdges = false;
  bool CoherentDashes = true;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
