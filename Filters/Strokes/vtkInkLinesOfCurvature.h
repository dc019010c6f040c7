// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkLinesOfCurvature
 * @brief   lines of curvature of a mesh or an iso-surface, as polylines
 *
 * Lines that follow a surface's principal directions show its form, and are what hatching is made of (Rössl,
 * Kobbelt and Seidel 2000, sections 2.2 and 3.1). They are traced from triangle to triangle, in both
 * directions from seeds, and end at borders, at feature edges, at umbilics, at their greatest length, and
 * where they are closed.
 *
 * EVENLY_SPACED lines (default) keep a distance from each other, measured on the surface, so that two sides
 * of a thin wall do not disturb one another (Jobard and Lefer 1997, here on surfaces). They are made from
 * coarse to fine: the lines with `Priority` < p are even for every p, so that density is a slider.
 * AREA_SCATTER is the paper's: independent seeds, uniform by area or denser where the surface is curved.
 *
 * Input: a vtkPolyData with polygons or strips. If it has the point arrays `k1`, `k2`,
 * `PrincipalDirection1` and `PrincipalDirection2` (three components), as vtkInkPrincipalCurvature makes
 * them, these are used; otherwise curvature is estimated by that class's default. Points of equal position
 * count as one. Faces with a point that is not finite, and ghost and hidden cells, are left out. Outside is
 * where point normals point to, an array `Normals` without such; if there are none, where the polygons run
 * counterclockwise, but on closed meshes that are wound inside out. It says which curvature is the larger
 * one.
 *
 * Or a vtkImageData: lines on its iso-surface at IsoValue, without a mesh, evenly spaced, by curvature from
 * the gradient and Hessian of the image (SetInputArrayToProcess) after FieldSmoothing; steps are projected
 * back onto the surface. Directions are not smoothed there. The first piece has the lines of the whole image.
 *
 * Output: lines, one polyline each; a closed one ends with the id of its first point. Families are made
 * independently of each other, and lines are in the order of family, then of priority.
 *
 * | array         | of     | type          | meaning |
 * |---------------|--------|---------------|---------|
 * | `Normals`     | points | float, 3      | the surface's unit normal |
 * | `ArcLength`   | points | double        | from the line's first point, in world units |
 * | `k1`, `k2`    | points | float         | on request: principal curvatures, k1 >= k2 |
 * | `Priority`    | lines  | float         | in [0, 1): the share of the family's total length before it |
 * | `LineFamily`  | lines  | unsigned char | 0 along maximum, 1 along minimum curvature |
 *
 * Lines can be dropped by `Priority` with vtkInkStrokeMapper's Density. The result is the same for any number
 * of threads; pieces of a mesh that is spread over processes have lines of their own. Errors, each with an
 * empty output: a face with a point that does not exist, faces without area only, curvature arrays of a wrong
 * size, a spacing that makes too many lines. An input without polygons, and a surface without lines, give a
 * warning.
 *
 * @sa vtkInkPrincipalCurvature vtkInkHatching vtkInkStrokeMapper
 */
#ifndef vtkInkLinesOfCurvature_h
#define vtkInkLinesOfCurvature_h

#include "InkSetters.h"
#include "vtkInkFiltersStrokesModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for the region

class vtkPlanes;

#include <functional> // for progress

class InkLineWriter;

// VTK's wrapper generator does not know what is in it.
#ifndef __VTK_WRAP__
namespace ink
{
struct EvenStreamlineOptions;
struct FieldSurface;
struct SurfaceSamples;
}
#endif

class VTKINKFILTERSSTROKES_EXPORT vtkInkLinesOfCurvature : public vtkPolyDataAlgorithm
{
public:
  static vtkInkLinesOfCurvature* New();
  vtkTypeMacro(vtkInkLinesOfCurvature, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The iso-value of an image's surface; outside, values are smaller. Default: 0.
   */
  InkSetClampMacro(IsoValue, -VTK_DOUBLE_MAX, VTK_DOUBLE_MAX);
  vtkGetMacro(IsoValue, double);
  ///@}

  ///@{
  /**
   * Of an image: the standard deviation of the Gaussian that smooths what curvature is taken of, not the
   * surface, in multiples of the smallest spacing; see vtkInkPrincipalCurvature. From 0 to 10; default: 2.
   */
  InkSetClampMacro(FieldSmoothing, 0.0, 10.0);
  vtkGetMacro(FieldSmoothing, double);
  ///@}

  /// Which lines are made.
  enum FamilyChoice
  {
    MAXIMUM = 0,
    MINIMUM = 1,
    BOTH = 2
  };

  ///@{
  /**
   * Lines along the directions of MAXIMUM curvature (default), of MINIMUM curvature, or BOTH.
   */
  vtkSetClampMacro(Families, int, MAXIMUM, BOTH);
  vtkGetMacro(Families, int);
  void SetFamiliesToMaximum() { this->SetFamilies(MAXIMUM); }
  void SetFamiliesToMinimum() { this->SetFamilies(MINIMUM); }
  void SetFamiliesToBoth() { this->SetFamilies(BOTH); }
  const char* GetFamiliesAsString();
  ///@}

  /// Where lines start.
  enum SeedingChoice
  {
    EVENLY_SPACED = 0,
    AREA_SCATTER = 1
  };

  ///@{
  /**
   * EVENLY_SPACED (default): a distance from each other; or AREA_SCATTER: at random, as published.
   */
  vtkSetClampMacro(Seeding, int, EVENLY_SPACED, AREA_SCATTER);
  vtkGetMacro(Seeding, int);
  void SetSeedingToEvenlySpaced() { this->SetSeeding(EVENLY_SPACED); }
  void SetSeedingToAreaScatter() { this->SetSeeding(AREA_SCATTER); }
  const char* GetSeedingAsString();
  ///@}

  ///@{
  /**
   * The distance between evenly spaced lines of a family, in world units. Less makes more lines. 0 (default)
   * to 1e300; 0: a hundredth of the diagonal of the bounds.
   */
  InkSetClampMacro(Spacing, 0.0, 1e300);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * How close an evenly spaced line comes to others before it ends, as a share of their spacing. Less makes
   * longer, less even lines. 0.1 to 0.9; default: 0.5.
   */
  InkSetClampMacro(StopDistance, 0.1, 0.9);
  vtkGetMacro(StopDistance, double);
  ///@}

  ///@{
  /**
   * About how many seeds AREA_SCATTER makes for each family (n in the paper). 1 to 1e8; default: 5000.
   */
  vtkSetClampMacro(NumberOfSeeds, int, 1, 100000000);
  vtkGetMacro(NumberOfSeeds, int);
  ///@}

  ///@{
  /**
   * How many seeds AREA_SCATTER makes at most in one triangle (m in the paper). 1 to 1000; default: 10.
   */
  vtkSetClampMacro(SeedsPerTriangle, int, 1, 1000);
  vtkGetMacro(SeedsPerTriangle, int);
  ///@}

  ///@{
  /**
   * From which absolute curvature on, in 1 / world unit, AREA_SCATTER makes more seeds. 0 to 1e300;
   * default: 0.
   */
  InkSetClampMacro(CurvatureThreshold, 0.0, 1e300);
  vtkGetMacro(CurvatureThreshold, double);
  ///@}

  ///@{
  /**
   * How many times as many seeds AREA_SCATTER makes beyond the CurvatureThreshold. 1 (default: no more) to
   * 1000.
   */
  InkSetClampMacro(CurvatureFactor, 1.0, 1000.0);
  vtkGetMacro(CurvatureFactor, double);
  ///@}

  ///@{
  /**
   * The greatest length of a line, in world units. 0 (default) to 1e300; 0: no limit for EVENLY_SPACED, and
   * a quarter of the square root of the surface's area for AREA_SCATTER.
   */
  InkSetClampMacro(MaximumLength, 0.0, 1e300);
  vtkGetMacro(MaximumLength, double);
  ///@}

  ///@{
  /**
   * The least length of an evenly spaced line, in spacings: what is shorter is left out. 0 to 1000;
   * default: 2.
   */
  InkSetClampMacro(MinimumLength, 0.0, 1000.0);
  vtkGetMacro(MinimumLength, double);
  ///@}

  /// How lines are integrated.
  enum IntegratorChoice
  {
    EULER = 0,
    RUNGE_KUTTA_4 = 1
  };

  ///@{
  /**
   * RUNGE_KUTTA_4 (default), of fourth order within each triangle; or EULER, as published: faster, and less
   * exact.
   */
  vtkSetClampMacro(Integrator, int, EULER, RUNGE_KUTTA_4);
  vtkGetMacro(Integrator, int);
  void SetIntegratorToEuler() { this->SetIntegrator(EULER); }
  void SetIntegratorToRungeKutta4() { this->SetIntegrator(RUNGE_KUTTA_4); }
  const char* GetIntegratorAsString();
  ///@}

  ///@{
  /**
   * The step's length as a share of the paper's, which adapts to a triangle's size and the turn of the
   * directions in it (equation 15); no step of an evenly spaced line is longer than a quarter of the spacing.
   * 0.01 to 10; default: 0.5; 1 as published.
   */
  InkSetClampMacro(StepFactor, 0.01, 10.0);
  vtkGetMacro(StepFactor, double);
  ///@}

  ///@{
  /**
   * Lines end at edges whose faces' normals enclose more than this, in degrees, if the surface is bent as
   * much there from two spacings' distance: noise makes no edges. A surface full of such edges has none. 0 to
   * 180 (never); default: 40.
   */
  InkSetClampMacro(FeatureAngle, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Lines end where the umbilic measure, 0 on a cylinder or saddle and 1 on a sphere or plane, is more than
   * this. 0 to 1; default: 1, never.
   */
  InkSetClampMacro(UmbilicLimit, 0.0, 1.0);
  vtkGetMacro(UmbilicLimit, double);
  ///@}

  ///@{
  /**
   * Whether directions are smoothed where the umbilic measure is high and they are hardly defined, as a cross
   * field, so that lines go straight on where maximum and minimum change places. There they follow the form
   * at large first, if the curvature of some spacings around has directions. Default: on; off as published.
   */
  vtkSetMacro(SmoothDirections, bool);
  vtkGetMacro(SmoothDirections, bool);
  vtkBooleanMacro(SmoothDirections, bool);
  ///@}

  ///@{
  /**
   * Whether, with SmoothDirections, the first family is one smooth field all over the surface, and the second
   * one at right angles to it, instead of families by the sign of curvatures: the first one has the direction
   * that bends more, as published, where one clearly does over some 25 spacings; it follows either principal
   * direction, in the mean of four spacings, and leads from one to the other where there is none between.
   * Without it there are blocks of lines at right angles to each other where a surface hardly bends, or bends
   * up here and down there. Default: off.
   */
  vtkSetMacro(CombDirections, bool);
  vtkGetMacro(CombDirections, bool);
  vtkBooleanMacro(CombDirections, bool);
  ///@}

  ///@{
  /**
   * A curvature that counts as none, in 1 / world unit: where maximum and minimum differ by less, directions
   * are hardly defined, and are smoothed. More makes longer, more even lines that follow the form at large
   * only. 0 (default) to 1e300; 0: a tenth of one over the diagonal of the bounds.
   */
  InkSetClampMacro(NegligibleCurvature, 0.0, 1e300);
  vtkGetMacro(NegligibleCurvature, double);
  ///@}

  ///@{
  /**
   * How many times directions are averaged with those of neighbors, with SmoothDirections and without
   * CombDirections. More reach farther into spheres and planes. 1 to 1000; default: 30.
   */
  vtkSetClampMacro(SmoothingIterations, int, 1, 1000);
  vtkGetMacro(SmoothingIterations, int);
  ///@}

  ///@{
  /**
   * Where lines are wanted, behind planes whose normals point out of it, as the sides of what a camera sees
   * (vtkPlanes::SetFrustumPlanes): they end a triangle beyond it. Their directions are those that they would
   * have everywhere. Default: none, everywhere.
   */
  void SetRegion(vtkPlanes* region);
  vtkPlanes* GetRegion();
  ///@}

  ///@{
  /**
   * Make the point arrays `k1` and `k2`. Default: off.
   */
  vtkSetMacro(ComputeCurvatures, bool);
  vtkGetMacro(ComputeCurvatures, bool);
  vtkBooleanMacro(ComputeCurvatures, bool);
  ///@}

  ///@{
  /**
   * Other seeds make other lines. Default: 0.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  vtkMTimeType GetMTime() override;

protected:
  vtkInkLinesOfCurvature();
  ~vtkInkLinesOfCurvature() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkInkLinesOfCurvature(const vtkInkLinesOfCurvature&) = delete;
  void operator=(const vtkInkLinesOfCurvature&) = delete;

  struct Surface;
  struct Part;
  struct Traced;
  void MakeLines(vtkPolyData* mesh, vtkPolyData* output);
  /// Smooth directions of both families.
  void FindDirections(Surface& cut, const std::function<bool(double)>& progress);
  Traced TraceFamily(
    const Surface& cut, const Part& part, int family, const std::function<bool(double)>& progress);
  void MakeLinesOfImage(vtkInformationVector** input, vtkPolyData* output);
#ifndef __VTK_WRAP__
  /// Of an image's surface.
  void AddLines(const ink::FieldSurface& surface, ink::SurfaceSamples samples,
    ink::EvenStreamlineOptions options, InkLineWriter& writer, const std::function<bool(double)>& progress);
#endif

  /// Of the diagonal of the bounds.
  static constexpr double DefaultSpacing = 0.01;
  /// Over the diagonal: a curvature that is less counts as none.
  static constexpr double DefaultNegligible = 0.1;

  bool OwnsImage = true; ///< this piece has the lines of an image
  double IsoValue = 0.0;
  double FieldSmoothing = 2.0;
  int Families = MAXIMUM;
  int Seeding = EVENLY_SPACED;
  double Spacing = 0.0;
  double StopDistance = 0.5;
  int NumberOfSeeds = 5000;
  int SeedsPerTriangle = 10;
  double CurvatureThreshold = 0.0;
  double CurvatureFactor = 1.0;
  double MaximumLength = 0.0;
  double MinimumLength = 2.0;
  int Integrator = RUNGE_KUTTA_4;
  double StepFactor = 0.5;
  double FeatureAngle = 40.0;
  double UmbilicLimit = 1.0;
  bool SmoothDirections = true;
  bool CombDirections = false;
  double NegligibleCurvature = 0.0;
  int SmoothingIterations = 30;
  bool ComputeCurvatures = false;
  int Seed = 0;
  vtkSmartPointer<vtkPlanes> Region;
};

#endif
