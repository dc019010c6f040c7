// SPDX-License-Identifier: BSD-3-Clause
// Samples a small synthetic volume with an installed vtkInk, makes the marks of each style of it, and asks
// which files can be read; fails if no points come out or a file is mistaken.
#include <vtkImageData.h>
#include <vtkInkIsoSurfaceSampler.h>
#include <vtkInkSplattingLinesMapper.h>
#include <vtkInkStyle.h>
#include <vtkInkVolumeReader.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRTAnalyticSource.h>
#include <vtkSmartPointer.h>

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
  bool drawn = points > 0;
  for (int n = 0; n < vtkInkStyle::GetNumberOfStyles(); ++n)
  {
    const auto style =
      vtkSmartPointer<vtkInkStyle>::Take(vtkInkStyle::CreateStyle(vtkInkStyle::GetStyleName(n)));
    drawn = style->Draw(wavelet->GetOutput()) && style->GetPiece(0)->GetNumberOfPoints() > 0 && drawn;
  }
  vtkNew<vtkInkVolumeReader> reader;
  const bool mistaken = reader->CanReadFile("main.cxx") != 0;
  return drawn && !mistaken ? EXIT_SUCCESS : EXIT_FAILURE;
}
