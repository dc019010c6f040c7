// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkPrincipalCurvature
 * @brief principal curvatures and directions at the points of a surface
 *
 * Curvature is positive where the surface bends away from its outward normal: a sphere of radius R with
 * normals out of it has k1 = k2 = 1 / R. k1 >= k2, in 1 / world unit. Directions have length 1, are tangent
 * and orthogonal, and stand for lines: their sign means nothing.
 *
 * Input: a vtkPolyData with polygons or strips, of any shape. Outside is where the point normals point to,
 * an array `Normals` without such, and if there are none where the polygons run counterclockwise. Border
 * points closer than a millionth of the mesh's extent count as one. Hidden cells are left out, ghost cells
 * are neighbors.
 *
 * With an image at the optional second input, curvature is that of the image's level sets through the input's
 * points, from gradient and Hessian, with normals out of the denser side; the input then needs no polygons.
 * The image's array is set with SetInputArrayToProcess(0, 1, ...), as SetFieldArray does; by default it is
 * the active point scalars. Its values are smoothed first, see FieldSmoothing.
 *
 * Output: the input with the point arrays `k1`, `k2`, `PrincipalDirection1` and `PrincipalDirection2` and, on
 * request, `MeanCurvature`, `GaussCurvature`, `UmbilicMeasure`, `CurvatureDerivative` and `CurvatureSource`.
 * Input arrays of these names are replaced. All values are finite, and the same for any number of threads.
 *
 * Errors, each with an empty output: a face with a point that does not exist, no face with area, an image
 * without such an array. An input without polygons gives a warning if there is no image; so does an image in
 * which no point lies.
 *
 * @sa vtkCurvatures vtkInkContours
 */
#ifndef vtkInkPrincipalCurvature_h
#define vtkInkPrincipalCurvature_h

#include "InkSetters.h"
#include "vtkInkFiltersCurvatureModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class VTKINKFILTERSCURVATURE_EXPORT vtkInkPrincipalCurvature : public vtkPolyDataAlgorithm
{
public:
  static vtkInkPrincipalCurvature* New();
  vtkTypeMacro(vtkInkPrincipalCurvature, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How the curvature of a mesh is estimated, see SetEstimator.
  enum EstimatorType
  {
    JET = 0,
    EXPONENTIAL_MAP = 1
  };

  /// Where the curvature of a point comes from: the values of the point array `CurvatureSource`.
  enum SourceType
  {
    SURFACE = 0,   ///< the surface on all sides, or the image
    BORDER = 1,    ///< a one-sided fit at a border, or one at a non-manifold point
    NEIGHBORS = 2, ///< nothing at the point itself: the mean of its neighbors
    NONE = 3       ///< nothing known: 0
  };

  ///@{
  /**
   * The optional image whose level sets have the curvature, instead of the mesh. Default: none.
   */
  void SetFieldConnection(vtkAlgorithmOutput* field) { this->SetInputConnection(1, field); }
  void SetFieldData(vtkDataObject* field) { this->SetInputData(1, field); }
  ///@}
  /// The point array of the image by its name; an empty one, the default: the active scalars.
  void SetFieldArray(const char* name);

  ///@{
  /**
   * Of an image: the standard deviation of the Gaussian that its values are smoothed with, in multiples of
   * the smallest spacing. More removes noise, and detail. 0: none, for fields without noise and steps, as
   * sampled distances. From 0 to 10; default: 2, which tells the curvature of scans best, see
   * Documentation/accuracy-and-speed.md.
   */
  InkSetClampMacro(FieldSmoothing, 0.0, 10.0);
  vtkGetMacro(FieldSmoothing, double);
  ///@}

  ///@{
  /**
   * JET (default): a polynomial over the tangent plane, fitted to the points around; see NumberOfRings,
   * Adaptive and Degree. EXPONENTIAL_MAP: that of Rössl et al. (2000), a quadratic polynomial of the adjacent
   * points, unfolded; exact on smooth and regular meshes only, and without a value of its own at borders.
   */
  vtkSetClampMacro(Estimator, int, JET, EXPONENTIAL_MAP);
  vtkGetMacro(Estimator, int);
  void SetEstimatorToJet() { this->SetEstimator(JET); }
  void SetEstimatorToExponentialMap() { this->SetEstimator(EXPONENTIAL_MAP); }
  const char* GetEstimatorAsString();
  ///@}

  ///@{
  /**
   * Of JET: how many rings of edges around a point are fitted; with Adaptive, the most, or averages that
   * smooth out as much noise. More smooth out noise and detail, and take longer. 1 to 10; default: 5.
   */
  vtkSetClampMacro(NumberOfRings, int, 1, 10);
  vtkGetMacro(NumberOfRings, int);
  ///@}

  ///@{
  /**
   * Of JET: fit two rings at each point, at borders three, and average as many neighbors' curvature as noise
   * takes, which is told from how far points are from the polynomial. Where the surface itself is uneven, and
   * with ComputeDerivative, as few rings are fitted as noise allows; more than two by degree 2, unless
   * ComputeDerivative is on. Default: on.
   */
  vtkSetMacro(Adaptive, bool);
  vtkGetMacro(Adaptive, bool);
  vtkBooleanMacro(Adaptive, bool);
  ///@}

  ///@{
  /**
   * Of JET: the degree of the polynomial. 3 is more accurate where points are irregular; 2 is faster. 2 or 3;
   * default: 3.
   */
  vtkSetClampMacro(Degree, int, 2, 3);
  vtkGetMacro(Degree, int);
  ///@}

  ///@{
  /**
   * Of a mesh: neighborhoods end at edges between polygons at more than this angle, unless the surface goes
   * straight on there as seen from 2 % of the diagonal of its bounds' distance, as it does where it is rough:
   * so the sides of a box are flat, and those of a cylinder bend in one direction up to its caps. A point on
   * such an edge has the curvature of the side that is largest around it, as at a border. What a mesh's
   * bounds are, and where it is rough, depends on the pieces that it is in. 0 to 180 degrees; default: 180,
   * none, as published. Lines of curvature and styles have 40.
   */
  InkSetClampMacro(FeatureAngle, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  ///@{
  /**
   * Make the point array `MeanCurvature`, (k1 + k2) / 2. Default: off.
   */
  vtkSetMacro(ComputeMeanCurvature, bool);
  vtkGetMacro(ComputeMeanCurvature, bool);
  vtkBooleanMacro(ComputeMeanCurvature, bool);
  ///@}

  ///@{
  /**
   * Make the point array `GaussCurvature`, k1 k2, in 1 / world unit squared. Default: off.
   */
  vtkSetMacro(ComputeGaussCurvature, bool);
  vtkGetMacro(ComputeGaussCurvature, bool);
  vtkBooleanMacro(ComputeGaussCurvature, bool);
  ///@}

  ///@{
  /**
   * Make the point array `UmbilicMeasure`, from 0 to 1: how little the directions are determined,
   * 1 - (k1 - k2) / (|k1| + |k2|). 1 on spheres and planes, 0 on cylinders and saddles. Curvature of radii
   * beyond a million times the size of the input counts as none. Default: off.
   */
  vtkSetMacro(ComputeUmbilicMeasure, bool);
  vtkGetMacro(ComputeUmbilicMeasure, bool);
  vtkBooleanMacro(ComputeUmbilicMeasure, bool);
  ///@}

  ///@{
  /**
   * Make the point array `CurvatureDerivative`: four components in 1 / world unit squared, the derivative of
   * the second fundamental form along the directions 111, 112, 122 and 222, the first of which is that of k1
   * along PrincipalDirection1. Of meshes JET of degree 3 finds it, of images differences of curvature.
   * Default: off.
   */
  vtkSetMacro(ComputeDerivative, bool);
  vtkGetMacro(ComputeDerivative, bool);
  vtkBooleanMacro(ComputeDerivative, bool);
  ///@}

  ///@{
  /**
   * Make the point array `CurvatureSource`, which says where a point's curvature comes from: SURFACE, BORDER,
   * NEIGHBORS or NONE. Default: off.
   */
  vtkSetMacro(ComputeSource, bool);
  vtkGetMacro(ComputeSource, bool);
  vtkBooleanMacro(ComputeSource, bool);
  ///@}

  ///@{
  /**
   * The type of the arrays: vtkAlgorithm::SINGLE_PRECISION (default) or DOUBLE_PRECISION. Everything is
   * computed in double.
   */
  vtkSetClampMacro(OutputArraysPrecision, int, SINGLE_PRECISION, DOUBLE_PRECISION);
  vtkGetMacro(OutputArraysPrecision, int);
  void SetOutputArraysPrecisionToSingle() { this->SetOutputArraysPrecision(SINGLE_PRECISION); }
  void SetOutputArraysPrecisionToDouble() { this->SetOutputArraysPrecision(DOUBLE_PRECISION); }
  const char* GetOutputArraysPrecisionAsString();
  ///@}

protected:
  vtkInkPrincipalCurvature();
  ~vtkInkPrincipalCurvature() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkInkPrincipalCurvature(const vtkInkPrincipalCurvature&) = delete;
  void operator=(const vtkInkPrincipalCurvature&) = delete;

  double FieldSmoothing = 2.0;
  int Estimator = JET;
  int NumberOfRings = 5;
  bool Adaptive = true;
  int Degree = 3;
  double FeatureAngle = 180.0;
  bool ComputeMeanCurvature = false;
  bool ComputeGaussCurvature = false;
  bool ComputeUmbilicMeasure = false;
  bool ComputeDerivative = false;
  bool ComputeSource = false;
  int OutputArraysPrecision = SINGLE_PRECISION;
};

#endif
