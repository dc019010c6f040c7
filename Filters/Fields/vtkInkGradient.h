// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkInkGradient
 * @brief   image data to gradients, smoothed values and Laplacians at its points
 *
 * For every point of a vtkImageData the filter estimates the gradient of a scalar array: by central
 * differences, or by 4D linear regression (Neumann et al. 2000), which Lu et al. (2003, section 4.1) use
 * against noise: the plane that fits the values of a point and its 26 neighbors best, its slope the gradient
 * and its height a smoothed value. The Laplacian is that of the image smoothed by a Gaussian.
 *
 * The input array is the one that SetInputArrayToProcess(0, ...) names, the active point scalars by default.
 * An array that is not contiguous in memory is copied first.
 *
 * Output: the input image with all its arrays and, as asked for, the point arrays `Gradient` (three
 * components: value per world unit, spacing and direction matrix accounted for), `GradientMagnitude`,
 * `Laplacian` (value per world unit squared) and `Value` (smoothed). Arrays of these names in the input are
 * replaced. What is not asked for is neither computed nor allocated. Results that are too large for the
 * output's type become its largest value.
 *
 * At the image's border, and beside points that are NaN, infinite or hidden, differences are one-sided and
 * regressions fit the neighbors that there are; along an axis with one point derivatives are 0. At points
 * that are NaN, infinite or hidden themselves every result is 0: outputs hold no NaN.
 *
 * The filter streams: it takes any UPDATE_EXTENT and asks its input for that extent and the neighbors that
 * the results depend on. The results are the same bits for any split of the image and any number of threads
 * (VTK_SMP_MAX_THREADS sets it).
 *
 * Errors, each with an empty output: no such point array, ArrayComponent beyond its components, a spacing
 * of zero or a direction matrix without inverse.
 *
 * @sa vtkInkIsoSurfaceSampler vtkImageGradient vtkGradientFilter
 */
#ifndef vtkInkGradient_h
#define vtkInkGradient_h

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
   * CENTRAL_DIFFERENCE: half the difference of the two neighbors along each axis, sharp and fast, for data
   * without noise. REGRESSION (default): the plane that fits all neighbors best, which leaves about a third
   * of the noise.
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
   * The neighbors that a regression takes in: NEIGHBORHOOD_3 (default), 3 x 3 x 3 points, or NEIGHBORHOOD_5,
   * 5 x 5 x 5, which smooths more and is slower. Central differences do not use it.
   */
  vtkSetClampMacro(Neighborhood, int, NEIGHBORHOOD_3, NEIGHBORHOOD_5);
  vtkGetMacro(Neighborhood, int);
  void SetNeighborhoodTo3() { this->SetNeighborhood(NEIGHBORHOOD_3); }
  void SetNeighborhoodTo5() { this->SetNeighborhood(NEIGHBORHOOD_5); }
  const char* GetNeighborhoodAsString();
  ///@}

  /// How much a neighbor counts, see SetWeighting.
  enum WeightingType
  {
    UNIFORM = 0,
    INVERSE_DISTANCE = 1
  };

  ///@{
  /**
   * How much a neighbor counts in a regression. UNIFORM (default): all the same, which leaves the least
   * noise. INVERSE_DISTANCE: the reciprocal of its distance in world units, which blurs less, above all where
   * the spacing differs from axis to axis. Central differences do not use it.
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
   * Compute the point array `Value`, the regression's smoothed value; with central differences it is the
   * input's. Default: off.
   */
  vtkSetMacro(ComputeValue, bool);
  vtkGetMacro(ComputeValue, bool);
  vtkBooleanMacro(ComputeValue, bool);
  ///@}

  ///@{
  /**
   * Compute the point array `Laplacian`, of the image smoothed by a Gaussian. Default: off. Here, unlike in
   * gradients, 64-bit integers beyond 2^53 count as the nearest doubles, off by up to 2^-53 of themselves.
   */
  vtkSetMacro(ComputeLaplacian, bool);
  vtkGetMacro(ComputeLaplacian, bool);
  vtkBooleanMacro(ComputeLaplacian, bool);
  ///@}

  ///@{
  /**
   * The standard deviation of the Gaussian that smooths before the Laplacian is taken, in LaplacianScaleUnit.
   * 0 does not smooth; larger shows broader features and is slower. Beyond 16 points along an axis, it counts
   * as 16. Range: 0 upwards. Default: 1.
   */
  void SetLaplacianScale(double value);
  double GetLaplacianScaleMinValue() { return 0.0; }
  double GetLaplacianScaleMaxValue() { return VTK_DOUBLE_MAX; }
  vtkGetMacro(LaplacianScale, double);
  ///@}

  /// What the Gaussian's scale is measured in, see SetLaplacianScaleUnit.
  enum ScaleUnitType
  {
    SAMPLES = 0,
    WORLD_UNITS = 1
  };

  ///@{
  /**
   * The unit of LaplacianScale. SAMPLES (default): points, as many along each axis whatever the spacing.
   * WORLD_UNITS: as far along each axis, whatever the spacing.
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
   * double, which is also computed in double precision and is about half as fast.
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

  /// Remembers the output's arrays, so that the next run can write into those that no one else holds by then:
  /// memory that was used before is much faster than fresh memory.
  void KeepArrays(vtkImageData* output);
  /// An array of the output, one that was kept where possible.
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
