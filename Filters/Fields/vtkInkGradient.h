// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkGradient
 * @brief gradients, smoothed values and Laplacians at the points of an image
 *
 * For every point of a vtkImageData the filter estimates the gradient of a scalar array: by central
 * differences, or by 4D linear regression (Neumann et al. 2000), which Lu et al. (2003, section 4.1) use
 * against noise: a hyperplane is fitted to the values of a point and its 26 neighbors by least squares; its
 * slope is the gradient and its height a smoothed value. The Laplacian is that of the image smoothed by a
 * Gaussian (LoG).
 *
 * The input array is set with SetInputArrayToProcess(0, ...); by default it is the active point scalars. An
 * array that is not contiguous in memory is copied first.
 *
 * Output: the input image with all its arrays and, as requested, the point arrays `Gradient` (three
 * components: value per world unit, spacing and direction matrix accounted for), `GradientMagnitude`,
 * `Laplacian` (value per world unit squared) and `Value` (smoothed). Input arrays of these names are
 * replaced. Arrays that are not requested are neither computed nor allocated. Results too large for the
 * output's type are clamped to its largest value.
 *
 * At the image's border, and next to points that are NaN, infinite or hidden, differences are one-sided and
 * regressions use the neighbors that exist; along an axis with a single point, derivatives are 0. At points
 * that are themselves NaN, infinite or hidden every result is 0, so outputs never hold NaN.
 *
 * The filter streams: it accepts any UPDATE_EXTENT and requests that extent plus the neighbors that the
 * results depend on. Results are bitwise identical for any partition of the image and any number of threads
 * (set by VTK_SMP_MAX_THREADS).
 *
 * Errors, each with an empty output: no such point array, ArrayComponent beyond its components, a spacing of
 * zero or a singular direction matrix.
 *
 * @sa vtkInkIsoSurfaceSampler vtkImageGradient vtkGradientFilter
 */
#ifndef vtkInkGradient_h
#define vtkInkGradient_h

#include "InkSetters.h"
#include "vtkImageAlgorithm.h"
#include "vtkInkFiltersFieldsModule.h" // for the export macro
#include "vtkSmartPointer.h"           // for arrays that are used again

class vtkDataArray;
class vtkImageData;

class VTKINKFILTERSFIELDS_EXPORT vtkInkGradient : public vtkImageAlgorithm
{
public:
  static vtkInkGradient* New();
  vtkTypeMacro(vtkInkGradient, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How gradients are estimated, see SetMethod.
  enum MethodType
  {
    CENTRAL_DIFFERENCE = 0,
    REGRESSION = 1
  };

  ///@{
  /**
   * CENTRAL_DIFFERENCE: half the difference of the two neighbors along each axis; sharp and fast, for
   * noise-free data. REGRESSION (default): the least-squares hyperplane through all neighbors, which leaves
   * about a third of the noise.
   */
  vtkSetClampMacro(Method, int, CENTRAL_DIFFERENCE, REGRESSION);
  vtkGetMacro(Method, int);
  void SetMethodToCentralDifference() { this->SetMethod(CENTRAL_DIFFERENCE); }
  void SetMethodToRegression() { this->SetMethod(REGRESSION); }
  const char* GetMethodAsString();
  ///@}

  /// The regression's neighborhood, see SetNeighborhood.
  enum NeighborhoodType
  {
    NEIGHBORHOOD_3 = 0,
    NEIGHBORHOOD_5 = 1
  };

  ///@{
  /**
   * The neighborhood of a regression: NEIGHBORHOOD_3 (default), 3 x 3 x 3 points, or NEIGHBORHOOD_5, 5 x 5 x
   * 5, which smooths more and is slower. Central differences do not use it.
   */
  vtkSetClampMacro(Neighborhood, int, NEIGHBORHOOD_3, NEIGHBORHOOD_5);
  vtkGetMacro(Neighborhood, int);
  void SetNeighborhoodTo3() { this->SetNeighborhood(NEIGHBORHOOD_3); }
  void SetNeighborhoodTo5() { this->SetNeighborhood(NEIGHBORHOOD_5); }
  const char* GetNeighborhoodAsString();
  ///@}

  /// The weights of neighbors, see SetWeighting.
  enum WeightingType
  {
    UNIFORM = 0,
    INVERSE_DISTANCE = 1
  };

  ///@{
  /**
   * The weights of neighbors in a regression. UNIFORM (default): equal weights, which leave the least noise.
   * INVERSE_DISTANCE: the reciprocal of its distance in world units, which blurs less, especially where the
   * spacing is anisotropic. Central differences do not use it.
   */
  vtkSetClampMacro(Weighting, int, UNIFORM, INVERSE_DISTANCE);
  vtkGetMacro(Weighting, int);
  void SetWeightingToUniform() { this->SetWeighting(UNIFORM); }
  void SetWeightingToInverseDistance() { this->SetWeighting(INVERSE_DISTANCE); }
  const char* GetWeightingAsString();
  ///@}

  ///@{
  /**
   * Compute the point array `Gradient`. Default: on.
   */
  vtkSetMacro(ComputeGradient, bool);
  vtkGetMacro(ComputeGradient, bool);
  vtkBooleanMacro(ComputeGradient, bool);
  ///@}

  ///@{
  /**
   * Compute the point array `GradientMagnitude`. Default: on.
   */
  vtkSetMacro(ComputeGradientMagnitude, bool);
  vtkGetMacro(ComputeGradientMagnitude, bool);
  vtkBooleanMacro(ComputeGradientMagnitude, bool);
  ///@}

  ///@{
  /**
   * Compute the point array `Value`, the regression's smoothed value; with central differences it equals the
   * input. Default: off.
   */
  vtkSetMacro(ComputeValue, bool);
  vtkGetMacro(ComputeValue, bool);
  vtkBooleanMacro(ComputeValue, bool);
  ///@}

  ///@{
  /**
   * Compute the point array `Laplacian`, of the image smoothed by a Gaussian. Default: off. Unlike for
   * gradients, 64-bit integers beyond 2^53 are rounded to double, a relative error of up to 2^-53.
   */
  vtkSetMacro(ComputeLaplacian, bool);
  vtkGetMacro(ComputeLaplacian, bool);
  vtkBooleanMacro(ComputeLaplacian, bool);
  ///@}

  ///@{
  /**
   * The standard deviation of the Gaussian that smooths before the Laplacian is taken, in LaplacianScaleUnit.
   * 0 does not smooth; larger values show broader features and are slower. Clamped to 16 points along each
   * axis. Range: 0 upwards. Default: 1.
   */
  InkSetClampMacro(LaplacianScale, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(LaplacianScale, double);
  ///@}

  /// The unit of the Gaussian's scale, see SetLaplacianScaleUnit.
  enum ScaleUnitType
  {
    SAMPLES = 0,
    WORLD_UNITS = 1
  };

  ///@{
  /**
   * The unit of LaplacianScale. SAMPLES (default): points, the same number along each axis whatever the
   * spacing. WORLD_UNITS: the same distance along each axis, whatever the spacing.
   */
  vtkSetClampMacro(LaplacianScaleUnit, int, SAMPLES, WORLD_UNITS);
  vtkGetMacro(LaplacianScaleUnit, int);
  void SetLaplacianScaleUnitToSamples() { this->SetLaplacianScaleUnit(SAMPLES); }
  void SetLaplacianScaleUnitToWorldUnits() { this->SetLaplacianScaleUnit(WORLD_UNITS); }
  const char* GetLaplacianScaleUnitAsString();
  ///@}

  ///@{
  /**
   * The component of the input array that is used. Default: 0.
   */
  vtkSetClampMacro(ArrayComponent, int, 0, VTK_INT_MAX);
  vtkGetMacro(ArrayComponent, int);
  ///@}

  ///@{
  /**
   * The type of the output arrays: vtkAlgorithm::SINGLE_PRECISION (default), float, or DOUBLE_PRECISION,
   * double, which also computes in double precision and is about half as fast.
   */
  vtkSetClampMacro(OutputArraysPrecision, int, SINGLE_PRECISION, DOUBLE_PRECISION);
  vtkGetMacro(OutputArraysPrecision, int);
  void SetOutputArraysPrecisionToSingle() { this->SetOutputArraysPrecision(SINGLE_PRECISION); }
  void SetOutputArraysPrecisionToDouble() { this->SetOutputArraysPrecision(DOUBLE_PRECISION); }
  const char* GetOutputArraysPrecisionAsString();
  ///@}

protected:
  vtkInkGradient();
  ~vtkInkGradient() override;

  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkInkGradient(const vtkInkGradient&) = delete;
  void operator=(const vtkInkGradient&) = delete;

  /// Keeps references to the output's arrays, so that the next run can reuse those that nobody else
  /// references by then: writing to memory that is already mapped is much faster.
  void KeepArrays(vtkImageData* output);
  /// An array for the output, reusing a kept one where possible.
  vtkSmartPointer<vtkDataArray> MakeArray(int which, vtkIdType tuples);

  vtkSmartPointer<vtkDataArray> Kept[4];
  int Method = REGRESSION;
  int Neighborhood = NEIGHBORHOOD_3;
  int Weighting = UNIFORM;
  bool ComputeGradient = true;
  bool ComputeGradientMagnitude = true;
  bool ComputeValue = false;
  bool ComputeLaplacian = false;
  double LaplacianScale = 1.0;
  int LaplacianScaleUnit = SAMPLES;
  int ArrayComponent = 0;
  int OutputArraysPrecision = SINGLE_PRECISION;
};

#endif
