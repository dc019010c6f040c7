// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkIsoSurfaceAlgorithm
 * @brief   what samplers of iso-surfaces have in common
 *
 * The properties of vtkInkIsoSurfaceSampler, which samples images, and vtkInkVDBIsoSurfaceSampler, which
 * samples OpenVDB grids: at which values, where in a cell, with what beside the points, and what is left out.
 */
#ifndef vtkInkIsoSurfaceAlgorithm_h
#define vtkInkIsoSurfaceAlgorithm_h

#include "InkSetters.h"
#include "vtkInkFiltersSamplingModule.h" // for the export macro
#include "vtkNew.h"                      // for the contour values
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for the frame

#include <functional> // for parts
#include <optional>   // for slices
#include <vector>     // for the iso-values

class vtkContourValues;
class vtkImageData;

// VTK's wrapper generator does not know what is in it.
#ifndef __VTK_WRAP__
namespace ink
{
struct FiniteRange;
struct SampleOptions;
struct SuggestedSmoothing;
struct ThickSlices;
}
#endif

class VTKINKFILTERSSAMPLING_EXPORT vtkInkIsoSurfaceAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkInkIsoSurfaceAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The iso-values, as in vtkContourFilter. Default: none, which yields no points, but of an OpenVDB file
   * those of the surface that it is about: level sets at 0, narrow bands of `ink convert` at their value.
   */
  void SetValue(int i, double value);
  double GetValue(int i);
  void SetNumberOfContours(int number);
  vtkIdType GetNumberOfContours();
  void GenerateValues(int numContours, double rangeStart, double rangeEnd);
  void SetValues(const std::vector<double>& values); ///< these and no others
  ///@}

  /// Which cell edges the surface intersects, see SetCrossingRule.
  enum CrossingRuleType
  {
    HALF_OPEN = 0,
    STRICT = 1
  };

  ///@{
  /**
   * Which cell edges the surface at f0 intersects. HALF_OPEN (default): those with one end below f0 and the
   * other at or above it, so that a surface through voxel centers has neither holes nor duplicates. STRICT:
   * the rule as printed in Zhang et al., (f1 - f0)(f2 - f0) < 0, and the edge's midpoint where f1 = f2 = f0;
   * where voxels have exactly the value f0, as in integer data, it leaves holes and finds flat regions twice.
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
   * The standard deviation of the Gaussian that values are smoothed with before the surface is sampled, in
   * multiples of the smallest spacing, the same in all world directions; 0 to 8. Default: 0, values as they
   * are. Where voxels are not cubes, cells then are divided until they are about cubes, as with
   * Subdivision. Removes what noise, few gray levels and the distance of slices do to normals, and with it
   * parts thinner than the Gaussian, see SmoothingTarget; Common/Statistics/NoiseEstimate.h suggests a value.
   * NaN is refused with a warning.
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
   * What is made of the smoothed values. SURFACE (default): the surface and its normals; surfaces shrink
   * where they are bent, and parts as thin as the Gaussian vanish. NORMALS: the normals (by central
   * differences, interpolated). The surface then is that of values smoothed by a kernel that keeps parabolas,
   * a Gaussian of fourth order of half the deviation: it stays where it is, and so do thin parts.
   */
  vtkSetClampMacro(SmoothingTarget, int, SURFACE, NORMALS);
  vtkGetMacro(SmoothingTarget, int);
  void SetSmoothingTargetToSurface() { this->SetSmoothingTarget(SURFACE); }
  void SetSmoothingTargetToNormals() { this->SetSmoothingTarget(NORMALS); }
  const char* GetSmoothingTargetAsString();
  ///@}

  ///@{
  /**
   * How many cells take the place of one along the axis of the smallest spacing, 1 to 8; along others more,
   * so that cells are about cubes, up to 8, or 64 where these would be more than three times as long as wide.
   * Default: 1. Values in between are interpolated by cubics (Catmull and Rom) or come from the Gaussian of
   * Smoothing; Radius is that of the smaller cells. Above 1, cells are divided also where Smoothing is 0.
   */
  vtkSetClampMacro(Subdivision, int, 1, 8);
  vtkGetMacro(Subdivision, int);
  ///@}

  ///@{
  /**
   * Values are labels, the ids of a segmentation's regions, or a mask: each is replaced by whether it is at
   * or above the iso-value, 1 or 0, before it is smoothed, and the surface is half way between both.
   * Otherwise how large ids are displaces the surface. The value .5 shows all regions of ids from 1 on
   * together. Steps of voxels vanish with a Smoothing of 2, see SuggestSmoothing. Default: off.
   */
  vtkSetMacro(LabelMap, bool);
  vtkGetMacro(LabelMap, bool);
  vtkBooleanMacro(LabelMap, bool);
  ///@}

  ///@{
  /**
   * Of a LabelMap: where several labels meet on the surface, normals are those of each one's own surface,
   * smoothed like it, so that lines show a groove between them. Points stay where they are. Default: off.
   */
  vtkSetMacro(LabelBorders, bool);
  vtkGetMacro(LabelBorders, bool);
  vtkBooleanMacro(LabelBorders, bool);
  ///@}

  ///@{
  /**
   * Of slices that are 1.8 times as far apart as samples within them, or more: interpolate between two slices
   * not their values but the distances from the contour that the iso-value has in each, see
   * ink::sliceDistances. Surfaces that move by more than their edges' width from one slice to the next are
   * terraces otherwise. Cells are divided across slices then, also without Smoothing and Subdivision. Of
   * other volumes nothing changes. Default: off.
   */
  vtkSetMacro(ShapeBasedInterpolation, bool);
  vtkGetMacro(ShapeBasedInterpolation, bool);
  vtkBooleanMacro(ShapeBasedInterpolation, bool);
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
   * How normals are estimated. CELL: the gradient of the trilinear interpolant of the cell's own eight
   * voxels; the fastest, but faceted. INTERPOLATED_GRADIENT: gradients by central differences at the corners
   * are interpolated, then normalized. INTERPOLATED_NORMAL (default): the same gradients are normalized
   * first, then interpolated, as Zhang et al. do; more accurate at sharp boundaries and for anisotropic
   * voxels. REGRESSION: the same with gradients by linear regression over each corner's 26 neighbors (Neumann
   * et al. 2000, equal weights); smoother for noisy data, but rounds off features smaller than two voxels.
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
   * Compute the point array `SurfaceIndex`: the index of the iso-value that a point belongs to. Default: on.
   * It is omitted when there is only one iso-value.
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

  /// What is added where a surface leaves the volume, see SetCut.
  enum CutType
  {
    OPEN = 0,
    RIM = 1,
    CAP = 2
  };

  ///@{
  /**
   * What is added where a surface leaves the image, or the volume that vtkInk made an OpenVDB grid of; other
   * grids end nowhere. OPEN (default): nothing; the surface ends somewhere in the last voxels, and lines
   * along its edge are broken. RIM: points along the cut, with normals that turn from
   * the surface's over that of the volume's side, so that from everywhere the edge is one clean line; those
   * that point back inwards have half the Radius. CAP: also points all over the part of the side that is
   * inside, as if all beyond the volume were below the iso-value, and along the edges between two such sides,
   * with normals from the one's to the other's. The points follow those of their surface. They are found in
   * the values as they are.
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
   * Leave out parts of a surface that have less than this share of its largest part's points: noise and
   * floaters. A part is a connected component of active cells, which are neighbors if they share a face. 0
   * (default): none; negative: automatic, parts with less than a thousandth, or up to two voxels large. Parts
   * of an image are those of the piece that is sampled: for those of the whole, sample pieces with
   * ComputeCellIds and put them together first. Parts of an OpenVDB grid are those of the whole.
   */
  InkSetClampMacro(SmallestPart, -1.0, 1.0);
  vtkGetMacro(SmallestPart, double);
  ///@}

  ///@{
  /**
   * Keep only that many of the largest parts of each surface; a skull without its headrest is 1. 0 (default):
   * all. See SmallestPart for what a part is.
   */
  vtkSetClampMacro(LargestParts, int, 0, 1000000);
  vtkGetMacro(LargestParts, int);
  ///@}

  ///@{
  /**
   * The type of the point coordinates: vtkAlgorithm::SINGLE_PRECISION, DOUBLE_PRECISION or DEFAULT_PRECISION
   * (default), which is single unless the image, or a grid's active voxels, lie so far from the origin that
   * single precision would move points by more than a thousandth of the smallest spacing.
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
   * How many steps at most move each point onto the iso-surface of the trilinear interpolation, 0 to 8.
   * Default: 0, the points of Zhang et al. 2014: the mean of a cell's intersections lies off the surface by
   * some hundredths of the spacing. Each step (Newton's, along the central-difference gradient) leaves about
   * a tenth of the distance, more where boundaries are sharp; a point within 1e-4 of the smallest spacing is
   * moved no further, one that would have to leave its cell by more than a cell's width not at all. Normals
   * stay those at the point's old position. Pieces of an image then take a second level of ghost cells.
   */
  vtkSetClampMacro(ProjectionSteps, int, 0, 8);
  vtkGetMacro(ProjectionSteps, int);
  ///@}

  ///@{
  /**
   * The precision in which points and normals are computed: vtkAlgorithm::SINGLE_PRECISION (default) or
   * DOUBLE_PRECISION. Single precision applies to voxels of 8 and 16 bits and float; its points and normals
   * differ from those in double by about 1e-6 of a voxel and 1e-5 radians. Other types, and points in double,
   * are always computed in double. Classifying voxels as inside or outside is exact in both.
   */
  vtkSetClampMacro(ArithmeticPrecision, int, SINGLE_PRECISION, DOUBLE_PRECISION);
  vtkGetMacro(ArithmeticPrecision, int);
  void SetArithmeticPrecisionToSingle() { this->SetArithmeticPrecision(SINGLE_PRECISION); }
  void SetArithmeticPrecisionToDouble() { this->SetArithmeticPrecision(DOUBLE_PRECISION); }
  const char* GetArithmeticPrecisionAsString();
  ///@}

  ///@{
  /**
   * The memory in MiB that may be taken; 0: no limit. 0 to 16777216 (16 TiB). Default: 0 for images, 4096 for
   * OpenVDB files. An image that takes more than about half of it, with the 96 MiB that a program has anyhow,
   * is asked for a few slices at a time, unless a piece of several is to be sampled: its points are the same.
   * The algorithm that makes it has to make parts of it (update extents), as vtkInkVolumeReader does. Of a
   * grid what exceeds the limit, with the points of its surfaces, is an error that names the memory needed,
   * and so is of an image where a few slices or all points do.
   */
  vtkSetClampMacro(MaximumMemory, int, 0, 16777216);
  vtkGetMacro(MaximumMemory, int);
  ///@}

  ///@{
  /**
   * What Smoothing and Subdivision are chosen by, before anything is sampled: the Smoothing that the noise,
   * the gray levels and the voxels' shape around the surface of an iso-value ask for, see
   * ink::suggestSmoothing, with LabelMap and ShapeBasedInterpolation as they are set, whether the values seem
   * to be labels, whether contours between slices are better than values, and the number of cells that it
   * goes through, at most and before these are divided. It reads the image, a few slices at
   * a time where it would for points (at least ink::NoiseEstimate::slices for the smoothing), or the grid,
   * which then stays for the next update. 0 and one error if that cannot be read.
   */
  double SuggestSmoothing(double isoValue);
  bool SuggestLabelMap(double isoValue);
  bool SuggestLabelBorders(double isoValue);
  bool SuggestShapeBasedInterpolation(double isoValue);
  virtual vtkIdType CountActiveCells(double isoValue) = 0;
  ///@}

  /// Takes another one's properties, but for iso-values and MaximumMemory.
  void CopyProperties(vtkInkIsoSurfaceAlgorithm* from);

#ifndef __VTK_WRAP__
  /// The slices between which distances are interpolated, if they are.
  /// @param frame where the voxels lie
  std::optional<ink::ThickSlices> FindThickSlices(vtkImageData* frame) const;

  /// All that is suggested at once, whatever LabelMap and ShapeBasedInterpolation are.
  virtual ink::SuggestedSmoothing SuggestSmoothings(double isoValue) = 0;

  /// The iso-values; without any, that of the surface that a file is about.
  virtual std::vector<double> FindIsoValues();

  /// Where the voxels lie: an image without values, which is empty after an error.
  virtual vtkSmartPointer<vtkImageData> MakeFrame() = 0;

  /// Takes a part of the points of a surface, which is the index of its iso-value. Those of a surface come in
  /// their order, without vertices and `SurfaceIndex`.
  using PartSink = std::function<void(int surface, vtkPolyData* part)>;

  /**
   * Samples in parts, of which none needs more of MaximumMemory than a quarter. SmallestPart and LargestParts
   * do not count for images, whose parts of surfaces are known at the end. What goes wrong is reported as by
   * Update; what the sink throws goes through.
   * @return false after an error
   */
  virtual bool SampleParts(const PartSink& sink) = 0;

  /// The finite values that were found by the last SampleParts, or the values of a grid.
  /// @throws std::exception if it cannot be read
  virtual ink::FiniteRange FindRange() = 0;
#endif

  /// Includes the iso-values.
  vtkMTimeType GetMTime() override;

protected:
  vtkInkIsoSurfaceAlgorithm();
  ~vtkInkIsoSurfaceAlgorithm() override;

  /// The iso-values, with one warning if any of them is not a number.
  std::vector<double> TakeIsoValues();
#ifndef __VTK_WRAP__
  /// CrossingRule and NormalMethod.
  ink::SampleOptions MakeSampleOptions() const;
#endif

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
  bool LabelMap = false;
  bool LabelBorders = false;
  bool ShapeBasedInterpolation = false;
  int Subdivision = 1;
  int Cut = OPEN;
  double SmallestPart = 0.0;
  int LargestParts = 0;
  int ArithmeticPrecision = SINGLE_PRECISION;
  int MaximumMemory = 0;

private:
  vtkInkIsoSurfaceAlgorithm(const vtkInkIsoSurfaceAlgorithm&) = delete;
  void operator=(const vtkInkIsoSurfaceAlgorithm&) = delete;

  vtkNew<vtkContourValues> ContourValues;
};

#endif
