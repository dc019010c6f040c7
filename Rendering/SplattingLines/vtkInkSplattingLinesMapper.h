// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkSplattingLinesMapper
 * @brief   line drawings from points with normals, by splatting
 *
 * Draws the points of a vtkPolyData as a line drawing (Zhang et al. 2014, section 3): the points are
 * splatted as oriented discs into a depth image, then their head-light shading is splatted twice with
 * Gaussians of two widths (equations 1 and 2), I1 and I2; where the wider exceeds the narrower,
 *
 *     H = I1 - Tau I2,   E = tanh(Phi H),   ink = max(0, -E),
 *
 * lines appear. No connectivity is needed. Points are sent to the GPU once, whatever parameters, camera and
 * style do; a view that does not change costs next to nothing, and Tau, Phi, colors and styles only a last
 * pass.
 *
 * To the paper's method are added, unless AsPublished is on: splats that are a few pixels wide in all
 * directions (EWA splatting, Zwicker et al. 2001), so that what is far away or seen edge-on has no holes and
 * lines are at least that thick, also in pictures drawn in tiles; Gaussians that go down to zero at the
 * splats' rim, so that lines are smooth; black beyond contours, in I1 only, so that these are solid; the
 * same beyond the border of the visible surface, so that a line is along it wherever it ends; sheets near
 * each other told apart by a tolerance of each splat's own; and ink averaged over a pixel's area.
 *
 * Beyond the visible surface, those behind it can be drawn (HiddenLayers, section 5.2); lines can be hard,
 * wider, thinned, broken, rid of speckles, and colored by layer, scalars or tone. All lengths on the picture
 * are relative to its height, so that large and small pictures show the same drawing; SpeckleLength alone is
 * in the window's pixels.
 *
 * Input: points with normals of any length (the point array `Normals`, or else the active normals, or the
 * array chosen with SetInputArrayToProcess(NORMALS, ...)) and, if there is one, the point array `Radius` in
 * world units (SetInputArrayToProcess(RADIUS, ...)). Without a Radius array, Radius, or if that is 0 an
 * estimate from the points' spacing, holds for all points. Points that are not finite, whose normal is
 * zero or whose radius is not positive are not drawn, nor are those that `vtkGhostType` marks as hidden or
 * duplicate. Cells are ignored. Where there is the point array `EdgeOffsets` of vtkInkSurfaceSampler, discs
 * end at the sharp edges that it names (as splats with clip lines, Zwicker et al. 2004), unless AsPublished
 * is on.
 *
 * With PaperVisibility on, the surface is painted in PaperColor under the ink and hides what lies behind
 * it; with it off, only the ink is drawn, over whatever other actors have drawn, and a little (1.5 times
 * the largest radius) in front of the surface, so that it also shows on a surface that another actor draws.
 * Of the actor's property, the opacity applies, and back-face culling: without it, as by default, open
 * surfaces are seen from behind, too; with it, closed surfaces are drawn faster.
 *
 * Hardware selection finds the actor and the points, with or without paper. Up to 6 clipping planes.
 *
 * @sa vtkInkIsoSurfaceSampler vtkPointGaussianMapper
 */
#ifndef vtkInkSplattingLinesMapper_h
#define vtkInkSplattingLinesMapper_h

#include "InkSetters.h"
#include "vtkInkMapper.h"
#include "vtkInkRenderingSplattingLinesModule.h" // for the export macro

#include <memory> // for std::unique_ptr

struct InkViewUniforms;

class VTKINKRENDERINGSPLATTINGLINES_EXPORT vtkInkSplattingLinesMapper : public vtkInkMapper
{
public:
  static vtkInkSplattingLinesMapper* New();
  vtkTypeMacro(vtkInkSplattingLinesMapper, vtkInkMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// All parameters of another mapper, the arrays to process and the layers' styles among them, and its
  /// input.
  void ShallowCopy(vtkAbstractMapper* mapper) override;

  /// Indices for SetInputArrayToProcess.
  enum InputArrays
  {
    NORMALS = 0,
    RADIUS = 1
  };

  ///@{
  /**
   * lambda: the factor by which illumination splats are larger than the points' radii; it sets the level
   * of detail (a larger one gives fewer, broader lines). Below 1 splats no longer overlap everywhere, and
   * lines become fainter and break up; as published, there are none in the end. Depth splats are never
   * scaled. 0.1 to 20; default: 2.5.
   */
  InkSetClampMacro(Lambda, 0.1, 20.0);
  vtkGetMacro(Lambda, double);
  ///@}

  ///@{
  /**
   * tau: a threshold; more lines with a larger one. 0.8 to 1.2; default: 0.99, which keeps
   * noise on flat surfaces below the threshold.
   */
  InkSetClampMacro(Tau, 0.8, 1.2);
  vtkGetMacro(Tau, double);
  ///@}

  ///@{
  /**
   * phi: the strength of the lines; darker with a larger one. 0 to 500; default: 100.
   */
  InkSetClampMacro(Phi, 0.0, 500.0);
  vtkGetMacro(Phi, double);
  ///@}

  ///@{
  /**
   * sigma_min: the width of the narrower Gaussian as a fraction of the splat radius; the wider one is
   * 1.6 times as wide. 0.05 to 2; default: 0.4.
   */
  InkSetClampMacro(Sigma, 0.05, 2.0);
  vtkGetMacro(Sigma, double);
  ///@}

  ///@{
  /**
   * Splat exactly as the paper writes it, without the additions that the class description lists: each pixel
   * is equations 1 and 2 of the discs whose depth there is that of the depth image, and in hidden layers of
   * the discs whose center's is (section 5.2). What the paper leaves open: depths are the same within 1.5
   * radii, and surfaces seen from behind are lit there. Contours are then faint and broken where few points
   * lie on them, and lines less smooth. Default: off.
   */
  vtkSetMacro(AsPublished, bool);
  vtkGetMacro(AsPublished, bool);
  vtkBooleanMacro(AsPublished, bool);
  ///@}

  ///@{
  /**
   * The radius of all points in world units when the input has no radius array; 0 (default): estimated
   * from the points' spacing.
   */
  InkSetClampMacro(Radius, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * The least radius of illumination splats on the picture, in thousandths of the viewport's height (but 1.5
   * pixels at least): it sets how thin lines can be, so that pictures of all sizes show the same drawing. 0
   * to 50; default: 3. AsPublished has no such radius.
   */
  InkSetClampMacro(MinimumRadius, 0.0, 50.0);
  vtkGetMacro(MinimumRadius, double);
  ///@}

  ///@{
  /**
   * Draw also the lines of surfaces behind the first, by depth peeling (Zhang et al. 2014, section 5.2): each
   * layer has its own depth image and its own lines. They are drawn through the paper, faintly; without
   * paper, each at its own depth, so that other actors hide them and depth peeling sorts them. Layers take as
   * much time each. Default: off.
   */
  vtkSetMacro(HiddenLayers, bool);
  vtkGetMacro(HiddenLayers, bool);
  vtkBooleanMacro(HiddenLayers, bool);
  ///@}

  ///@{
  /**
   * The most layers that are drawn where HiddenLayers is on, the visible one included; fewer where there are
   * no more. 1 to 8; default: 2.
   */
  vtkSetClampMacro(NumberOfLayers, int, 1, 8);
  vtkGetMacro(NumberOfLayers, int);
  ///@}

  /// The layers that the drawing of an actor in a renderer had when it was drawn last; 0 if it never was.
  int GetNumberOfDrawnLayers(vtkRenderer* renderer, vtkActor* actor);

  ///@{
  /**
   * Whether a hidden layer may face away from the viewer. Off (default), hidden layers are further closed
   * surfaces, which face the viewer again; on, also the inner side of a surface's back is one, unless the
   * actor culls back faces.
   */
  vtkSetMacro(PeelBackFaces, bool);
  vtkGetMacro(PeelBackFaces, bool);
  vtkBooleanMacro(PeelBackFaces, bool);
  ///@}

  ///@{
  /**
   * Color of a hidden layer's lines, RGB in 0..1, whatever InkColorMode is: only TONE mixes ToneColor into
   * it. Until it is set, or after ResetLayerColor, a hidden layer is colored as the visible one: by
   * InkColor, or with SCALARS by its own points' scalars. Layer 0 is the visible one, and its color
   * InkColor. Layers are 0 to 7; others are refused with a warning.
   */
  void SetLayerColor(int layer, double red, double green, double blue);
  void SetLayerColor(int layer, const double color[3]);
  void GetLayerColor(int layer, double color[3]);
  void ResetLayerColor(int layer);
  ///@}

  ///@{
  /**
   * How much of its ink a layer gets, 0 to 1. Default: 1 for the visible layer, 0.35 for the next, and for
   * each further one two thirds of that before.
   */
  void SetLayerStrength(int layer, double strength);
  double GetLayerStrength(int layer);
  ///@}

  ///@{
  /**
   * By how much a layer's lines are wider than the splats make them, in thousandths of the viewport's height;
   * negative: thinner. -20 to 20; default: 0. Works on the drawing as an image, as SpeckleLength, Thinning
   * and LayerDashLength do: that takes time where the picture has to be fetched from a GPU.
   */
  void SetLayerLineWidth(int layer, double width);
  double GetLayerLineWidth(int layer);
  ///@}

  ///@{
  /**
   * Length of a layer's dashes and, from 4 on, gaps, in thousandths of the viewport's height; 0 (default):
   * solid lines, of which shorter gaps are the way to dashed ones. 0 to 100.
   */
  void SetLayerDashLength(int layer, double length);
  double GetLayerDashLength(int layer);
  ///@}

  ///@{
  /**
   * LayerLineWidth of all layers, in thousandths of the viewport's height; -20 to 20; default: 0. Get gives
   * that of the visible layer.
   */
  void SetLineWidth(double width);
  double GetLineWidth() { return this->GetLayerLineWidth(0); }
  ///@}

  ///@{
  /**
   * From soft to hard lines. 0 (default): E as published; 1: ink where it was more than one half, and none
   * elsewhere.
   */
  InkSetClampMacro(Hardness, 0.0, 1.0);
  vtkGetMacro(Hardness, double);
  ///@}

  ///@{
  /**
   * Spots of ink shorter than this are left out, in pixels of the window; 0 (default): none. 0 to 1000. In
   * pictures drawn in tiles, whose spots are this many times the tiles' number longer, at most half the
   * shorter side of a tile: each tile is drawn with so much around it, and takes at most four times a
   * window's memory for that.
   */
  InkSetClampMacro(SpeckleLength, 0.0, 1000.0);
  vtkGetMacro(SpeckleLength, double);
  ///@}

  ///@{
  /**
   * Thin lines to a thousandth of the height, or to one pixel in viewports lower than 1000 pixels; LineWidth
   * makes them wider again, all alike. Default: off.
   */
  vtkSetMacro(Thinning, bool);
  vtkGetMacro(Thinning, bool);
  vtkBooleanMacro(Thinning, bool);
  ///@}

  /// What colors the lines.
  enum InkColorModes
  {
    INK = 0,     ///< InkColor and LayerColor
    SCALARS = 1, ///< point scalars through the lookup table, as other mappers do it; needs ScalarVisibility
    TONE = 2     ///< from the layer's color where the surface is seen edge-on to ToneColor where it faces
  };

  ///@{
  /**
   * INK (default), SCALARS or TONE.
   */
  vtkSetClampMacro(InkColorMode, int, INK, TONE);
  vtkGetMacro(InkColorMode, int);
  void SetInkColorModeToInk() { this->SetInkColorMode(INK); }
  void SetInkColorModeToScalars() { this->SetInkColorMode(SCALARS); }
  void SetInkColorModeToTone() { this->SetInkColorMode(TONE); }
  const char* GetInkColorModeAsString();
  ///@}

  ///@{
  /**
   * Color of lines where the surface faces the viewer, with InkColorMode TONE; RGB in 0..1. Default: a dark
   * orange (0.8, 0.4, 0.1).
   */
  InkSetColorMacro(ToneColor);
  vtkGetVector3Macro(ToneColor, double);
  ///@}

  ///@{
  /**
   * Large splats may be summed up for squares of 2 x 2 or 4 x 4 pixels at once, each splat by its size, which
   * makes large Lambda as fast as small ones; this is the side of the largest such squares. 1: each pixel for
   * itself, exact; 2 (default); or 4. AsPublished and pictures drawn in tiles always have 1.
   */
  void SetMaximumDownsampling(int pixels);
  vtkGetMacro(MaximumDownsampling, int);
  ///@}

  ///@{
  /**
   * Sum up splats in 16-bit floats: faster on some GPUs, a tenth as exact. Default: off.
   */
  vtkSetMacro(HalfFloats, bool);
  vtkGetMacro(HalfFloats, bool);
  vtkBooleanMacro(HalfFloats, bool);
  ///@}

  ///@{
  /**
   * The part of the points that is drawn, for quicker pictures while something moves: those first in the
   * order of the point array `Priority`, of any values, or if there is none in an order by chance, with
   * larger radii, so that there are no holes. 0.01 to 1; default: 1.
   */
  InkSetClampMacro(PointFraction, 0.01, 1.0);
  vtkGetMacro(PointFraction, double);
  ///@}

  ///@{
  /**
   * Color of the lines, RGB in 0..1. Default: black.
   */
  InkSetColorMacro(InkColor);
  vtkGetVector3Macro(InkColor, double);
  ///@}

  ///@{
  /**
   * Color of the surface between the lines, RGB in 0..1. Default: white.
   */
  InkSetColorMacro(PaperColor);
  vtkGetVector3Macro(PaperColor, double);
  ///@}

  ///@{
  /**
   * Paint the surface in PaperColor under the lines (default), or draw the lines only.
   */
  vtkSetMacro(PaperVisibility, bool);
  vtkGetMacro(PaperVisibility, bool);
  vtkBooleanMacro(PaperVisibility, bool);
  ///@}

  /// Lines without paper are blended over what lies behind them.
  bool HasOpaqueGeometry() override;
  bool HasTranslucentPolygonalGeometry() override;

protected:
  vtkInkSplattingLinesMapper();
  ~vtkInkSplattingLinesMapper() override;

  std::unique_ptr<InkMarks> MakeMarks(vtkOpenGLRenderWindow* window) override;
  bool UpdateMarks(InkMarks& own) override;
  void DrawMarks(InkMarks& own, const InkFrame& frame) override;

  /// All finite points that `vtkGhostType` does not mark, whether or not cells use them, with their radii as
  /// far as those are given.
  void ComputeBounds() override;

private:
  vtkInkSplattingLinesMapper(const vtkInkSplattingLinesMapper&) = delete;
  void operator=(const vtkInkSplattingLinesMapper&) = delete;

  class vtkInternals;
  class vtkMarks;
  void UpdateOrder(vtkMarks& marks);
  void DrawLines(vtkMarks& marks, InkViewUniforms view, const InkFrame& frame);
  bool CheckLayer(const char* property, int layer);

  double Lambda = 2.5;
  double Tau = 0.99;
  double Phi = 100.0;
  double Sigma = 0.4;
  bool AsPublished = false;
  double Radius = 0.0;
  double MinimumRadius = 3.0;
  bool HiddenLayers = false;
  int NumberOfLayers = 2;
  bool PeelBackFaces = false;
  double Hardness = 0.0;
  double SpeckleLength = 0.0;
  bool Thinning = false;
  int InkColorMode = INK;
  double ToneColor[3] = { 0.8, 0.4, 0.1 };
  int MaximumDownsampling = 2;
  bool HalfFloats = false;
  double PointFraction = 1.0;
  double InkColor[3] = { 0.0, 0.0, 0.0 };
  double PaperColor[3] = { 1.0, 1.0, 1.0 };
  bool PaperVisibility = true;

  std::unique_ptr<vtkInternals> Internals;
};

#endif
