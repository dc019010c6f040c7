// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkStippleMapper
 * @brief   stipple drawings of volumes and surfaces
 *
 * Draws the stipples of a vtkInkStippleGenerator (Lu et al. 2003): of each element, a voxel or a polygon, the
 * first
 *
 *     T = N_max T_b T_s T_r T_l T_d T_i
 *
 * of its list (section 5 and Table 1), where N_max is the room for stipples in the element's projection
 * (section 4.3) and the factors are the enhancements for boundaries, silhouettes, resolution, light, distance
 * and interior (vtkInkStippleEnhancements), each with its k's and each on or off. Surfaces have those for
 * resolution, light and distance. The graphics card finds T for each stipple in each picture; a change of a
 * parameter or of the view sends nothing but that to it. Blocks of elements that are out of sight or get no
 * stipples cost next to nothing.
 *
 * To the paper's method are added: stipples appear gradually, paler or smaller than whole ones; where an
 * element's list is too short close up, they grow; and stipples show light on dark paper (LightInk).
 *
 * Input: one VTK_POLY_VERTEX cell for each element, all points in their order; cell data `Normals` (3) and,
 * of volumes, `GradientMagnitude` and `Value` (0 to 1); field data `ElementSize` (world units), `ElementKind`
 * (0 volume, 1 surface), `StipplesPerElement`. Elements whose normal is zero and what is not finite are not
 * drawn. With ScalarVisibility on (it is off by default), cell scalars color the elements through the lookup
 * table, whose opacities make stipples paler.
 *
 * A surface (SetSurfaceConnection, SetSurfaceData; or the generator's own input, see SurfaceFromInput) hides
 * the stipples behind it: a mesh its own, or an iso-surface those of a volume, which are see-through
 * otherwise. Stipples of a mesh on its back are drawn where a surface hides those of closed surfaces, unless
 * the actor's property has back-face culling on.
 *
 * Stipples are blended over what lies behind them, in the renderer's translucent pass or with
 * vtkInkStippleActor, which is faster, after it, with the opacity of the actor's property. No stipple is
 * larger than the largest point of the OpenGL in use. Hardware selection finds the actor and the stipples. Up
 * to 6 clipping planes. Numbers are kept within their ranges, colors within 0..1; what is no number is
 * refused with a warning.
 *
 * @sa vtkInkStippleActor vtkInkStippleControls vtkInkSplattingLinesMapper
 */
#ifndef vtkInkStippleMapper_h
#define vtkInkStippleMapper_h

#include "InkSetters.h"                   // for the setters
#include "vtkInkRenderingStippleModule.h" // for the export macro
#include "vtkInkStippleEnhancements.h"    // for the base

#include <memory> // for std::unique_ptr

class InkStippleMarks;
struct InkStippleInput;
class vtkFloatArray;

class VTKINKRENDERINGSTIPPLE_EXPORT vtkInkStippleMapper : public vtkInkStippleEnhancements
{
public:
  static vtkInkStippleMapper* New();
  vtkTypeMacro(vtkInkStippleMapper, vtkInkStippleEnhancements);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// All parameters and both inputs of another mapper, as far as it has them.
  void ShallowCopy(vtkAbstractMapper* mapper) override;

  ///@{
  /**
   * The surface that hides stipples behind it: polygons and strips, or where it has none, discs around its
   * points, of the point arrays `Normals` and `Radius`. Default: none, nothing is hidden, but see
   * SurfaceFromInput.
   */
  void SetSurfaceData(vtkPolyData* surface);
  void SetSurfaceConnection(vtkAlgorithmOutput* surface);
  ///@}

  /// What StippleSize is in, and PixelsPerStipple in its square.
  enum SizeUnits
  {
    THOUSANDTHS = 0, ///< of the viewport's height: the same drawing in a picture of any size
    PIXELS = 1
  };

  ///@{
  /**
   * The unit of StippleSize and PixelsPerStipple. THOUSANDTHS (default), the pixels of a viewport that is
   * 1000 pixels high: a large picture made smaller is the small picture; or PIXELS.
   */
  vtkSetClampMacro(SizeUnit, int, THOUSANDTHS, PIXELS);
  vtkGetMacro(SizeUnit, int);
  void SetSizeUnitToThousandths() { this->SetSizeUnit(THOUSANDTHS); }
  void SetSizeUnitToPixels() { this->SetSizeUnit(PIXELS); }
  const char* GetSizeUnitAsString();
  ///@}

  ///@{
  /**
   * How many pixels, as SizeUnit has them, of an element's projection make room for one stipple (section 4.3;
   * the paper has 1); the drawing is darker with a smaller one. 1e-6 to 1000, the least for pictures in
   * hundreds of tiles, which enlarge pixels by their number; default: 4.
   */
  InkSetClampMacro(PixelsPerStipple, 1e-6, 1000.0);
  vtkGetMacro(PixelsPerStipple, double);
  ///@}

  ///@{
  /**
   * The stipples' diameter in pixels, as SizeUnit has them, before distance and interior change it. 1e-4, as
   * above, to 100; default: 2.
   */
  InkSetClampMacro(StippleSize, 1e-4, 100.0);
  vtkGetMacro(StippleSize, double);
  ///@}

  ///@{
  /**
   * Whether stipples grow where an element has fewer than it has room for, close up, so that the gray stays.
   * Default: on.
   */
  vtkSetMacro(GrowWithZoom, bool);
  vtkGetMacro(GrowWithZoom, bool);
  vtkBooleanMacro(GrowWithZoom, bool);
  ///@}

  /// What becomes of parts of stipples (section 5.2).
  enum SmallElementWays
  {
    INTENSITY = 0,  ///< a third of a stipple is a pale one
    PROBABILITY = 1 ///< it is one with probability 1/3
  };

  ///@{
  /**
   * How elements that are too small for a pattern keep their gray: INTENSITY (default), which is smooth in
   * motion, or PROBABILITY, which has black stipples only. An element's random value comes from the cell's
   * global id where the input has those, else from the position of its first stipple: the same on any number
   * of processes.
   */
  vtkSetClampMacro(SmallElements, int, INTENSITY, PROBABILITY);
  vtkGetMacro(SmallElements, int);
  void SetSmallElementsToIntensity() { this->SetSmallElements(INTENSITY); }
  void SetSmallElementsToProbability() { this->SetSmallElements(PROBABILITY); }
  const char* GetSmallElementsAsString();
  ///@}

  ///@{
  /**
   * The room for stipples, in stipples, below which elements count as small (section 5.2). With INTENSITY and
   * a Fade of 1, the defaults, parts of stipples are pale ones in elements of any size, and it changes
   * nothing; it matters with PROBABILITY, or where Fade is less than 1. 2 to 9; default: 9.
   */
  InkSetClampMacro(MinimumCoverage, 2.0, 9.0);
  vtkGetMacro(MinimumCoverage, double);
  ///@}

  ///@{
  /**
   * Over how large a part of a stipple stipples of larger elements appear and vanish: 0 suddenly, 1 evenly.
   * Default: 1.
   */
  InkSetClampMacro(Fade, 0.0, 1.0);
  vtkGetMacro(Fade, double);
  ///@}

  ///@{
  /**
   * Whether stipples that appear or vanish are small instead of pale. Default: off.
   */
  vtkSetMacro(FadeBySize, bool);
  vtkGetMacro(FadeBySize, bool);
  vtkBooleanMacro(FadeBySize, bool);
  ///@}

  ///@{
  /**
   * How far warm and cool colors replace the stipples' own (section 5.7): 0 not at all, 1 altogether.
   * Default: 0.
   */
  InkSetClampMacro(WarmCool, 0.0, 1.0);
  vtkGetMacro(WarmCool, double);
  ///@}

  ///@{
  /**
   * How much the orientation towards the light decides between warm and cool. 0 to 1; default: 1.
   */
  InkSetClampMacro(ToneWeight, 0.0, 1.0);
  vtkGetMacro(ToneWeight, double);
  ///@}

  ///@{
  /**
   * How much the distance decides between warm (near) and cool (far). 0 to 1; default: 0.
   */
  InkSetClampMacro(DistanceWeight, 0.0, 1.0);
  vtkGetMacro(DistanceWeight, double);
  ///@}

  ///@{
  /**
   * The warm color, RGB in 0..1, blended with the cool one by hue, lightness and saturation. Default: red.
   */
  InkSetColorMacro(WarmColor);
  vtkGetVector3Macro(WarmColor, double);
  ///@}

  ///@{
  /**
   * The cool color, RGB in 0..1. Default: blue.
   */
  InkSetColorMacro(CoolColor);
  vtkGetVector3Macro(CoolColor, double);
  ///@}

  ///@{
  /**
   * Color of the stipples where ScalarVisibility is off, as it is by default; RGB in 0..1. Default: black.
   */
  InkSetColorMacro(InkColor);
  vtkGetVector3Macro(InkColor, double);
  ///@}

  ///@{
  /**
   * How far in elements' sizes stipples may lie behind the hiding surface and still be seen; -1 (default):
   * a tenth on surfaces, but behind polygons no more than a pixel, one and a half for volumes, but behind
   * discs no less than half the largest radius.
   * -1 to 100.
   */
  InkSetClampMacro(OccluderOffset, -1.0, 100.0);
  vtkGetMacro(OccluderOffset, double);
  ///@}

  ///@{
  /**
   * Whether stipples of a surface are hidden by it when no surface is given: by the mesh that the filter
   * which made the stipples had as its input. Default: on.
   */
  vtkSetMacro(SurfaceFromInput, bool);
  vtkGetMacro(SurfaceFromInput, bool);
  vtkBooleanMacro(SurfaceFromInput, bool);
  ///@}

  /// How exactly stipples keep their positions.
  enum PositionPrecisions
  {
    FLOAT = 0,    ///< 16 bytes a stipple on the graphics card
    QUANTIZED = 1 ///< 8 bytes a stipple, and 16 more an element
  };

  ///@{
  /**
   * FLOAT (default): positions in single precision, off by at most 3e-8 of the data's size. QUANTIZED: of
   * 1024 a side of each element's box of stipples, off by at most half a thousandth of it: seen by none
   * before an element fills the window. For drawings of more stipples than the graphics card has memory for.
   */
  vtkSetClampMacro(PositionPrecision, int, FLOAT, QUANTIZED);
  vtkGetMacro(PositionPrecision, int);
  void SetPositionPrecisionToFloat() { this->SetPositionPrecision(FLOAT); }
  void SetPositionPrecisionToQuantized() { this->SetPositionPrecision(QUANTIZED); }
  const char* GetPositionPrecisionAsString();
  ///@}

  /**
   * GetUploadTime of the elements' colors by scalars. They are sent again when the scalars, the lookup table
   * or what VTK's mappers have for coloring by them change, or when the stipples are.
   */
  vtkMTimeType GetColorUploadTime();

  /**
   * How many stipples the last picture had to look at; those that were left out as blocks are not among them.
   */
  vtkIdType GetNumberOfProcessedStipples();

  /**
   * What each of the input's points comes to in the renderer's present view: T, opacity (0: not drawn),
   * diameter in pixels, red, green, blue; as the shader finds it, hidden stipples included among those not
   * drawn. False and empty where there is nothing to draw or this OpenGL cannot do it. The window must have
   * been rendered.
   */
  bool EvaluateMarks(vtkRenderer* renderer, vtkActor* actor, vtkFloatArray* marks);

  /// Soft dots are blended over what lies behind them.
  bool HasOpaqueGeometry() override { return false; }
  bool HasTranslucentPolygonalGeometry() override { return true; }

protected:
  vtkInkStippleMapper();
  ~vtkInkStippleMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  std::unique_ptr<InkMarks> MakeMarks(vtkOpenGLRenderWindow* window) override;
  bool UpdateMarks(InkMarks& own) override;
  void DrawMarks(InkMarks& own, const InkFrame& frame) override;

private:
  vtkInkStippleMapper(const vtkInkStippleMapper&) = delete;
  void operator=(const vtkInkStippleMapper&) = delete;

  bool UploadStipples(const InkStippleInput& input, InkStippleMarks& marks);
  vtkPolyData* FindSurface();
  class vtkPicture;

  int SizeUnit = THOUSANDTHS;
  double PixelsPerStipple = 4.0;
  double StippleSize = 2.0;
  bool GrowWithZoom = true;
  int SmallElements = INTENSITY;
  double MinimumCoverage = 9.0;
  double Fade = 1.0;
  bool FadeBySize = false;
  double WarmCool = 0.0;
  double ToneWeight = 1.0;
  double DistanceWeight = 0.0;
  double WarmColor[3] = { 0.76, 0.04, 0.04 };
  double CoolColor[3] = { 0.035, 0.035, 0.665 };
  double InkColor[3] = { 0.0, 0.0, 0.0 };
  double OccluderOffset = -1.0;
  bool SurfaceFromInput = true;
  int PositionPrecision = FLOAT;

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
