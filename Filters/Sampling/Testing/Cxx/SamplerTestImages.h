// SPDX-License-Identifier: BSD-3-Clause
// Images for the tests of vtkInkIsoSurfaceSampler.
#ifndef SamplerTestImages_h
#define SamplerTestImages_h

#include "InkTestVolume.h"

#include "vtkDataArray.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

/// An image of the given type and extent whose one scalar is function(x, y, z) of the world point.
template <class Function>
vtkSmartPointer<vtkImageData> MakeImage(int type, const std::array<int, 6>& extent, Function function,
  const std::array<double, 3>& spacing = { 1.0, 1.0, 1.0 })
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(const_cast<int*>(extent.data()));
  image->SetSpacing(spacing.data());
  InkTestFill(image, type, function);
  return image;
}

/// 100 minus ten times the distance from the sphere of the given radius around the origin.
inline double BallDensity(double x, double y, double z, double radius)
{
  return 100.0 - 10.0 * (std::sqrt(x * x + y * y + z * z) - radius);
}

/// Says that it can make parts of an image of the given extent.
class PartsSource : public vtkImageAlgorithm
{
protected:
  explicit PartsSource(const std::array<int, 6>& whole)
    : WholeExtent(whole)
  {
    this->SetNumberOfInputPorts(0);
  }

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector* output) override
  {
    vtkInformation* info = output->GetInformationObject(0);
    info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), this->WholeExtent.data(), 6);
    info->Set(CAN_PRODUCE_SUB_EXTENT(), 1);
    vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 1);
    return 1;
  }

private:
  const std::array<int, 6> WholeExtent;
};

/// A sample as its point and normal, which sort and compare exactly.
using Sample = std::array<double, 6>;

inline std::vector<Sample> SamplesOf(vtkPolyData* data)
{
  std::vector<Sample> samples(static_cast<std::size_t>(data->GetNumberOfPoints()));
  vtkDataArray* normals = data->GetPointData()->GetNormals();
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    data->GetPoint(static_cast<vtkIdType>(n), samples[n].data());
    normals->GetTuple(static_cast<vtkIdType>(n), samples[n].data() + 3);
  }
  return samples;
}

inline std::vector<Sample> SortedSamplesOf(vtkPolyData* data)
{
  auto samples = SamplesOf(data);
  std::sort(samples.begin(), samples.end());
  return samples;
}

/// Those of all pieces of a filter's output, sorted.
inline std::vector<Sample> SamplesOfPieces(vtkPolyDataAlgorithm* filter, int pieces)
{
  std::vector<Sample> all;
  for (int piece = 0; piece < pieces; ++piece)
  {
    filter->UpdatePiece(piece, pieces, 0);
    const auto samples = SamplesOf(filter->GetOutput());
    all.insert(all.end(), samples.begin(), samples.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

#endif
