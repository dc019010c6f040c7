// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkStrokeMapper
 * @brief   draws polylines as strokes of a pen
 *
 * Strokes have a width in pixels, in thousandths of the picture's height or in world units, which may taper
 * towards their ends, fall with the distance and follow an array; round or mitered corners without gaps or
 * spikes; round or flat ends; dashes; and edges that are smooth without multisampling: a pixel gets as much
 * ink as the stroke covers of it, once where segments meet, also of a translucent stroke.
 *
 * Input: lines; one that ends at the point that it begins with is closed. Optional arrays: of the points,
 * `Normals` (3) of the surface that the strokes lie on, `ArcLength` (1) for dashes that stay where they are
 * while strokes change, `RadialCurvature` (1) of silhouettes, negative where their own surface hides them,
 * and the width's factor (SetInputArrayToProcess(0, ...), by default `Width`); of the cells or the points,
 * `Priority` (1) in [0, 1), without which Density drops strokes by chance. With ScalarVisibility on (it is
 * off by default) scalars of the points or cells color the strokes through the lookup table.
 *
 * Strokes are tested against what is drawn already, lifted a little towards the eye, more where their surface
 * is slanted. Given a surface (SetSurfaceConnection, SetSurfaceData), what it hides is decided along each
 * stroke instead of pixel by pixel, so that nothing is dotted where a stroke grazes its own surface: see
 * HiddenParts. Strokes then lie on the surface, whether or not an actor shows it.
 *
 * Strokes are blended over what lies behind them, in the renderer's translucent pass. They write depth where
 * they cover half a pixel, unless render passes for translucent things keep a depth of their own. Hardware
 * selection finds the actor and the strokes' points. Up to 6 clipping planes. Numbers are kept within their
 * ranges; what is no number is refused with a warning.
 *
 * @sa vtkInkSplattingLinesMapper vtkInkStippleMapper
 */
#ifndef vtkInkStrokeMapper_h
#define vtkInkStrokeMapper_h

#include "InkSetters.h" // for the setters
#include "vtkInkMapper.h"
#include "vtkInkRenderingStrokesModule.h" // for the export macro
#include "vtkSmartPointer.h"              // for the texture

#include <array>      // for boxes
#include <functional> // for what subclasses draw
#include <memory>     // for std::shared_ptr

class InkStrokeMarks;
template <class Resources>
class InkWindowResources;
struct InkHatching;
struct InkOccluderDepth;
struct InkStrokeStyle;
struct InkStrokeSurface;
struct InkViewUniforms;
class vtkFloatArray;
class vtkImageData;
class vtkPolyData;

class VTKINKRENDERINGSTROKES_EXPORT vtkInkStrokeMapper : public vtkInkMapper
{
public:
  static vtkInkStrokeMapper* New();
  vtkTypeMacro(vtkInkStrokeMapper, vtkInkMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// All parameters and both inputs of another mapper, as far as it has them.
  void ShallowCopy(vtkAbstractMapper* mapper) override;

  ///@{
  /**
   * The surface that hides strokes behind it: polygons and strips, or where it has none, discs around its
   * points, of the point arrays `Normals` and `Radius`. Default: none.
   */
  void SetSurfaceData(vtkPolyData* surface);
  void SetSurfaceConnection(vtkAlgorithmOutput* surface);
  ///@}

  /// What LineWidth, DashLength and GapLength are in.
  enum SizeUnits
  {
    THOUSANDTHS = 0, ///< of the viewport's height: the same drawing in a picture of any size
    PIXELS = 1,
    WORLD = 2 ///< the world's unit: strokes grow as the camera comes closer
  };

  ///@{
  /**
   * The unit of LineWidth, DashLength and GapLength. THOUSANDTHS (default), the pixels of a viewport that is
   * 1000 pixels high: a large picture made smaller is the small picture; PIXELS; or WORLD.
   */
  vtkSetClampMacro(SizeUnit, int, THOUSANDTHS, WORLD);
  vtkGetMacro(SizeUnit, int);
  void SetSizeUnitToThousandths() { this->SetSizeUnit(THOUSANDTHS); }
  void SetSizeUnitToPixels() { this->SetSizeUnit(PIXELS); }
  void SetSizeUnitToWorld() { this->SetSizeUnit(WORLD); }
  const char* GetSizeUnitAsString();
  ///@}

  ///@{
  /**
   * The strokes' width, as SizeUnit has it. 0 (nothing) to 1e12; default: 2.
   */
  InkSetClampMacro(LineWidth, 0.0, 1e12);
  vtkGetMacro(LineWidth, double);
  ///@}

  ///@{
  /**
   * How much of an open stroke's length is needed to grow from a point to the full width and to shrink to a
   * point again. 0 (default: the same width everywhere) to 1 (full in the middle only).
   */
  InkSetClampMacro(Taper, 0.0, 1.0);
  vtkGetMacro(Taper, double);
  ///@}

  ///@{
  /**
   * How much narrower the farthest strokes are than the nearest. 0 (default: not at all) to 1 (altogether).
   */
  InkSetClampMacro(DepthWidth, 0.0, 1.0);
  vtkGetMacro(DepthWidth, double);
  ///@}

  /// The shape of corners.
  enum Joins
  {
    ROUND_JOIN = 0,
    MITER_JOIN = 1
  };

  ///@{
  /**
   * ROUND_JOIN (default), or MITER_JOIN: pointed corners, but round ones beyond MiterLimit.
   */
  vtkSetClampMacro(Join, int, ROUND_JOIN, MITER_JOIN);
  vtkGetMacro(Join, int);
  void SetJoinToRound() { this->SetJoin(ROUND_JOIN); }
  void SetJoinToMiter() { this->SetJoin(MITER_JOIN); }
  const char* GetJoinAsString();
  ///@}

  ///@{
  /**
   * How far a pointed corner reaches at most, in widths, as in SVG. 1 to 20; default: 4.
   */
  InkSetClampMacro(MiterLimit, 1.0, 20.0);
  vtkGetMacro(MiterLimit, double);
  ///@}

  /// The shape of ends.
  enum Caps
  {
    ROUND_CAP = 0,
    BUTT_CAP = 1
  };

  ///@{
  /**
   * ROUND_CAP (default): ends are half discs around a stroke's first and last point; or BUTT_CAP: they are
   * flat. Where a surface hides the rest of a stroke, its end is flat always.
   */
  vtkSetClampMacro(Cap, int, ROUND_CAP, BUTT_CAP);
  vtkGetMacro(Cap, int);
  void SetCapToRound() { this->SetCap(ROUND_CAP); }
  void SetCapToButt() { this->SetCap(BUTT_CAP); }
  const char* GetCapAsString();
  ///@}

  ///@{
  /**
   * Whether strokes are dashed, by their arc length: dashes stay where they are on strokes that do not change
   * with the camera; those of silhouettes follow those of the picture before (CoherentDashes of
   * vtkInkSilhouetteMapper). A closed stroke has a whole number of them. Default: off.
   */
  vtkSetMacro(Dashed, bool);
  vtkGetMacro(Dashed, bool);
  vtkBooleanMacro(Dashed, bool);
  ///@}

  ///@{
  /**
   * The length of a dash, as SizeUnit has it, in the middle of the strokes. 0 to 1e12; default: 8.
   */
  InkSetClampMacro(DashLength, 0.0, 1e12);
  vtkGetMacro(DashLength, double);
  ///@}

  ///@{
  /**
   * The length of a gap between dashes, the same way. 0 to 1e12; default: 5.
   */
  InkSetClampMacro(GapLength, 0.0, 1e12);
  vtkGetMacro(GapLength, double);
  ///@}

  ///@{
  /**
   * An image that strokes are drawn with in place of plain ink: along their arc length, repeated, from their
   * begin, and its height across their width. 2D, of unsigned char; 1 component: how much ink there is, 255
   * being all; or 4: its color, too, in place of InkColor and scalars. Like dashes it stays where it is on
   * strokes that do not change with the camera, and a closed stroke has a whole number of repetitions.
   * Default: none.
   */
  void SetTexture(vtkImageData* texture);
  vtkImageData* GetTexture();
  ///@}

  ///@{
  /**
   * How many widths of a stroke (LineWidth, in the middle of the strokes) the texture's width takes. 1e-3 to
   * 1e12; default: 4.
   */
  InkSetClampMacro(TextureLength, 1e-3, 1e12);
  vtkGetMacro(TextureLength, double);
  ///@}

  ///@{
  /**
   * The share of the strokes that are drawn: those whose priority is less. Strokes are only dropped, never
   * changed, as it falls. 0 to 1; default: 1.
   */
  InkSetClampMacro(Density, 0.0, 1.0);
  vtkGetMacro(Density, double);
  ///@}

  ///@{
  /**
   * Color of the strokes where ScalarVisibility is off, as it is by default; RGB in 0..1. Default: black.
   */
  InkSetColorMacro(InkColor);
  vtkGetVector3Macro(InkColor, double);
  ///@}

  ///@{
  /**
   * How far strokes are lifted towards the eye, in pixels, so that the surface that they lie on does not hide
   * them; up to four times as far where it is slanted. 0 to 100; default: 2.
   */
  InkSetClampMacro(Lift, 0.0, 100.0);
  vtkGetMacro(Lift, double);
  ///@}

  ///@{
  /**
   * How far behind the surface strokes may lie and still count as visible, in the strokes' own unit: for
   * silhouettes by normals that are smoother than the surface, which lie a little behind its ridges. What is
   * farther behind is hidden. 0 (default) to 1e38. NaN is refused with a warning.
   */
  InkSetClampMacro(DepthTolerance, 0.0, 1e38);
  vtkGetMacro(DepthTolerance, double);
  ///@}

  /// How the parts are drawn that the surface hides.
  enum HiddenPartStyles
  {
    OMITTED = 0,
    FAINT = 1,
    DASHED = 2
  };

  ///@{
  /**
   * What becomes of the parts that the surface hides: OMITTED (default), FAINT (with HiddenOpacity) or DASHED
   * (with DashLength and GapLength).
   */
  vtkSetClampMacro(HiddenParts, int, OMITTED, DASHED);
  vtkGetMacro(HiddenParts, int);
  void SetHiddenPartsToOmitted() { this->SetHiddenParts(OMITTED); }
  void SetHiddenPartsToFaint() { this->SetHiddenParts(FAINT); }
  void SetHiddenPartsToDashed() { this->SetHiddenParts(DASHED); }
  const char* GetHiddenPartsAsString();
  ///@}

  ///@{
  /**
   * The opacity of hidden parts with HiddenParts FAINT. 0 to 1; default: 0.3.
   */
  InkSetClampMacro(HiddenOpacity, 0.0, 1.0);
  vtkGetMacro(HiddenOpacity, double);
  ///@}

  ///@{
  /**
   * Visible and hidden parts of a stroke that are shorter join their neighbors; pixels, enlarged with a
   * picture in tiles. 0 to 100; default: 4.
   */
  InkSetClampMacro(ShortestPart, 0.0, 100.0);
  vtkGetMacro(ShortestPart, double);
  ///@}

  ///@{
  /**
   * Whether strokes are hatching, which shows by its density and width how much light of the renderer falls
   * on their surface (Rössl et al. 2000, section 3.2). Their input is vtkInkHatching's: `Normals`, `Priority`
   * and the cell arrays `Spacing`, the distance between all strokes of a family, and `LineFamily`; where it
   * has the point array `SpacingRatio`, strokes are wider where they are farther from each other. As many
   * are drawn as HatchSpacing asks for, wider in the dark, and no narrower than LineWidth: lighter tones have
   * fewer strokes. The gray is the same at any distance. Given a surface, what it hides is left out pixel by
   * pixel, whatever HiddenParts says. Default: off.
   */
  vtkSetMacro(Hatching, bool);
  vtkGetMacro(Hatching, bool);
  vtkBooleanMacro(Hatching, bool);
  ///@}

  ///@{
  /**
   * The distance between strokes of hatching in the picture, as SizeUnit has it: fewer and wider ones, with
   * the same gray, with a larger one. 1e-3 to 1e12; default: 6.
   */
  InkSetClampMacro(HatchSpacing, 1e-3, 1e12);
  vtkGetMacro(HatchSpacing, double);
  ///@}

  ///@{
  /**
   * How dark middle tones are. 0 (all but the darkest are white) to 1 (all but the lightest are dark);
   * default: 0.5, as the light falls.
   */
  InkSetClampMacro(Tone, 0.0, 1.0);
  vtkGetMacro(Tone, double);
  ///@}

  ///@{
  /**
   * The share of the paper that is covered in the deepest shadow. 0 to 1; default: 0.85.
   */
  InkSetClampMacro(DarkestTone, 0.0, 1.0);
  vtkGetMacro(DarkestTone, double);
  ///@}

  ///@{
  /**
   * How much hatching is dark where the surface turns away from the eye in place of where there is no light.
   * 0 to 1 (only there); default: 0.3.
   */
  InkSetClampMacro(SilhouetteWeight, 0.0, 1.0);
  vtkGetMacro(SilhouetteWeight, double);
  ///@}

  ///@{
  /**
   * How much of the light may be missing without any strokes: larger highlights with a larger one. 0 to 1;
   * default: 0.1.
   */
  InkSetClampMacro(DiffuseTruncation, 0.0, 1.0);
  vtkGetMacro(DiffuseTruncation, double);
  ///@}

  ///@{
  /**
   * How far the surface may be turned away from the eye before that makes it dark: 1 minus the cosine. 0 to
   * 1; default: 0.5.
   */
  InkSetClampMacro(SilhouetteTruncation, 0.0, 1.0);
  vtkGetMacro(SilhouetteTruncation, double);
  ///@}

  ///@{
  /**
   * From which tones on the second family of lines crosses the first one. 0: never; 1: in all tones, both
   * alike; between: in tones above 1 - Crosshatching. Default: 0.5.
   */
  InkSetClampMacro(Crosshatching, 0.0, 1.0);
  vtkGetMacro(Crosshatching, double);
  ///@}

  ///@{
  /**
   * Hatching is left out where the surface faces away from the eye by more than this cosine. 0 to 1; default:
   * 0.2, as published. 1: nowhere; surfaces are seen, and lit, from both sides, whatever their normals'
   * orientation.
   */
  InkSetClampMacro(CullingCosine, 0.0, 1.0);
  vtkGetMacro(CullingCosine, double);
  ///@}

  /**
   * How wide strokes are at each of the input's points in the renderer's present view, in pixels, as the
   * shader finds it: 0 where they are not drawn, and the widest's at a point of several strokes. Whether a
   * surface hides them, dashes, clipping planes and tapering do not count. False and empty where there is
   * nothing to draw or this OpenGL cannot do it. The window must have been rendered.
   */
  virtual bool EvaluateWidths(vtkRenderer* renderer, vtkActor* actor, vtkFloatArray* widths);

  /**
   * Shares with another mapper what the GPU has of the surface that hides strokes, so that its depth is drawn
   * once where both draw for one actor: for mappers that have the same surface and the same clipping planes.
   * Pictures are the same as without.
   */
  void ShareSurface(vtkInkStrokeMapper* other);

  void ReleaseGraphicsResources(vtkWindow* window) override;

  /// Smooth edges are blended over what lies behind them.
  bool HasOpaqueGeometry() override { return false; }
  bool HasTranslucentPolygonalGeometry() override { return true; }

protected:
  vtkInkStrokeMapper();
  ~vtkInkStrokeMapper() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  std::unique_ptr<InkMarks> MakeMarks(vtkOpenGLRenderWindow* window) override;
  bool UpdateMarks(InkMarks& own) override;
  void DrawMarks(InkMarks& own, const InkFrame& frame) override;

  /// Brings marks up to date with strokes, as UpdateMarks does with those of the input.
  bool UpdateStrokes(InkMarks& own, vtkPolyData* strokes);
  ///@{
  /// The same with edge voxels, or with the edges of a surface, of which the shader makes strokes for an eye.
  bool UpdateVoxels(InkMarks& own, vtkPolyData* voxels);
  bool UpdateEdges(InkMarks& own, vtkPolyData* surface);
  ///@}
  /// @param choose sets in the style which strokes the shader makes; null: marks are strokes
  void DrawStrokes(InkStrokeMarks& marks, const InkFrame& frame,
    const std::function<void(InkStrokeStyle&, const InkViewUniforms&)>& choose);
  /// The depth of the surface in a view; null without one.
  InkOccluderDepth* UpdateDepth(const InkStrokeMarks& marks, const InkFrame& frame);
  /// The length of a dash with its gap in a frame, in the unit of the strokes' points; 0 where no dashes are
  /// drawn.
  /// @param bounds as GetExtent has them
  double FindDashPeriod(const InkFrame& frame, const double bounds[6]);
  /// Bounds, in the middle of which dashes and textures have the lengths that they should have in the
  /// picture; false (here) for those of the strokes.
  virtual bool GetExtent(double bounds[6]);
  /// The surface that hides strokes, or null.
  virtual vtkPolyData* FindSurface();
  /// DepthTolerance, or more where that surface is not exact.
  virtual double FindDepthTolerance() { return this->DepthTolerance; }

private:
  vtkInkStrokeMapper(const vtkInkStrokeMapper&) = delete;
  void operator=(const vtkInkStrokeMapper&) = delete;

  InkStrokeStyle MakeStyle(const InkStrokeMarks& marks, const InkViewUniforms& view);
  /// How long one of SizeUnit is in the middle of a box of the view's local frame, in that frame's unit.
  double FindSizeUnit(const InkViewUniforms& view, const std::array<double, 6>& box) const;
  InkHatching MakeHatching(const InkViewUniforms& view, vtkRenderer* renderer) const;
  /// Up to which point strokes may be drawn.
  int CountPoints(
    const InkStrokeMarks& marks, const InkViewUniforms& view, const InkStrokeStyle& style, int all) const;
  /// Uploads strokes or voxels, if they are others than before, and reports what is wrong with them.
  template <class Arrays>
  bool UploadStrokes(InkStrokeMarks& marks, const Arrays& arrays);
  /// @param strokesAreOfCells whether each stroke has a cell of the data, which may color it
  void UpdateColors(InkStrokeMarks& marks, vtkPolyData* data, bool strokesAreOfCells);
  /// The runs of the strokes in a view.
  /// @param depth of the surface that hides them, or null
  /// @param byPixel what the surface hides is found by each pixel, not along strokes
  void UpdateRuns(InkStrokeMarks& marks, const InkViewUniforms& view, const InkFrame& frame,
    const InkOccluderDepth* depth, bool byPixel);

  std::shared_ptr<InkWindowResources<InkStrokeSurface>> Surfaces;
  int SizeUnit = THOUSANDTHS;
  double LineWidth = 2.0;
  double Taper = 0.0;
  double DepthWidth = 0.0;
  int Join = ROUND_JOIN;
  double MiterLimit = 4.0;
  int Cap = ROUND_CAP;
  bool Dashed = false;
  double DashLength = 8.0;
  double GapLength = 5.0;
  vtkSmartPointer<vtkImageData> Texture;
  double TextureLength = 4.0;
  double Density = 1.0;
  double InkColor[3] = { 0.0, 0.0, 0.0 };
  double Lift = 2.0;
  double DepthTolerance = 0.0;
  int HiddenParts = OMITTED;
  double HiddenOpacity = 0.3;
  double ShortestPart = 4.0;
  bool Hatching = false;
  double HatchSpacing = 6.0;
  double Tone = 0.5;
  double DarkestTone = 0.85;
  double SilhouetteWeight = 0.3;
  double DiffuseTruncation = 0.1;
  double SilhouetteTruncation = 0.5;
  double Crosshatching = 0.5;
  double CullingCosine = 0.2;
};

#endif
