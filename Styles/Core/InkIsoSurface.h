// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkIsoSurface_h
#define InkIsoSurface_h

#include "vtkInkStyle.h"
#include "vtkInkStylesModule.h" // for the export macro

#include "vtkNew.h"
#include "vtkTimeStamp.h"

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
  ///@}

  vtkInkIsoSurfaceSampler* GetSampler() { return this->Sampler; }

  /// When something changed last that the points depend on.
  vtkMTimeType GetMTime();

  /**
   * The points of an image's surfaces, with Normals and Radius.
   * @param style that follows the sampler and notes a value that is chosen
   * @param image to sample; of one that is input.Data, and comes from a port, the piece that is asked for
   * @param array the point array to sample; empty: the active scalars
   * @param points becomes them
   * @return what is wrong; empty if nothing is
   */
  std::string Sample(vtkInkStyle* style, const vtkInkStyle::Input& input, vtkImageData* image,
    const std::string& array, vtkPolyData* points);

private:
  vtkNew<vtkInkIsoSurfaceSampler> Sampler;
  std::vector<double> IsoValues;
  vtkTimeStamp Changed;
};

#endif
