// SPDX-License-Identifier: BSD-3-Clause
// Samples a small synthetic volume with an installed vtkInk; fails if no points come out.
#include <vtkInkIsoSurfaceSampler.h>
#include <vtkInkSplattingLinesMapper.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRTAnalyticSource.h>

#include <cstdlib>
#include <iostream>

int main()
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  vtkNew<vtkInkIsoSurfaceSampler> sampler;
  sampler->SetInputConnection(wavelet->GetOutputPort());
  sampler->SetValue(0, 150.0);
  sampler->Update();

  vtkNew<vtkInkSplattingLinesMapper> mapper;
  mapper->SetInputConnection(sampler->GetOutputPort());

  const vtkIdType points = sampler->GetOutput()->GetNumberOfPoints();
  std::cout << points << " points" << std::endl;
  return points > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
