// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkIsoSurface_h
#define InkIsoSurface_h

#include "vtkInkStyle.h"
#include "vtkInkStylesModule.h" // for the export macro

#include "vtkNew.h"
#include "vtkTimeStamp.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

class vtkImageData;
class vtkInkIsoSurfaceSampler;
class vtkPolyData;

/// What styles that draw the iso-surfaces of images have in common: the points of these surfaces, at values
/// that are given or chosen.
class VTKINKSTYLES_EXPORT InkIsoSurface
{
public:
  InkIsoSurface();
  ~InkIsoSurface();
  InkIsoSurface(const InkIsoSurface&) = delete;
  void operator=(const InkIsoSurface&) = delete;

  ///@{
  /// Parameters; see their table.
  void SetIsoValues(const std::vector<double>& values);
  const std::vector<double>& GetIsoValues() const { return this->IsoValues; }
  void SetSmallestPart(double share);
  double GetSmallestPart() const;
  void SetLargestParts(int count);
  int GetLargestParts() const;
  void SetCut(int cut);
  int GetCut() const;
  void SetSmoothing(double smoothing);
  double GetSmoothing() const { return this->Smoothing; }
  void SetSmoothingTarget(int target);
  int GetSmoothingTarget() const;
  void SetSubdivision(int subdivision);
  int GetSubdivision() const { return this->Subdivision; }
  ///@}

  vtkInkIsoSurfaceSampler* GetSampler() { return this->Sampler; }

  /// When something changed last that the points depend on.
  vtkMTimeType GetMTime();

  /**
   * Finds what the images of all processes are sampled with; all processes call it at once, also without
   * images.
   * @param style that notes a value that is chosen
   * @param array the point array to sample; empty: the active scalars
   * @return what is wrong; empty if nothing is
   */
  std::string Prepare(vtkInkStyle* style, std::span<vtkImageData* const> images, const std::string& array);

  /**
   * The points of an image's surfaces, with Normals and Radius; after Prepare.
   * @param style that follows the sampler
   * @param image to sample; of one that is input.Data, and comes from a port, the piece that is asked for
   * @param points becomes them
   * @return what is wrong; empty if nothing is
   */
  std::string Sample(
    vtkInkStyle* style, const vtkInkStyle::Input& input, vtkImageData* image, vtkPolyData* points);

private:
  /// That of the process with the largest image, where they hold parts.
  static std::optional<double> ChooseValue(
    vtkInkStyle* style, std::span<vtkImageData* const> images, const std::string& array);
  double FindSmoothing(vtkInkStyle* style, std::span<vtkImageData* const> images, const std::string& array,
    const std::vector<double>& values) const;
  int FindSubdivision(vtkInkStyle* style, std::span<vtkImageData* const> images) const;

  vtkNew<vtkInkIsoSurfaceSampler> Sampler;
  std::vector<double> IsoValues;
  double Smoothing = -1.0; ///< negative: as the image's noise asks for
  int Subdivision = 0;     ///< 0: as the picture's size asks for
  vtkTimeStamp Changed;
};

#endif
