// SPDX-License-Identifier: BSD-3-Clause
#include "InkTestBaseline.h"

#include "vtkImageDifference.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"

#include <filesystem>
#include <iostream>

bool InkTestMatchesBaseline(const InkTestImage& image, const std::string& name, double tolerance)
{
  const auto write = [&name](vtkImageData* data, const std::string& what)
  {
    const std::filesystem::path folder = INK_TEST_OUTPUT_DIR;
    std::filesystem::create_directories(folder);
    const std::string path = (folder / (name + what + ".png")).string();
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(data);
    writer->SetFileName(path.c_str());
    writer->Write();
    return path;
  };

  const std::string baseline = std::string(INK_BASELINE_DIR) + '/' + name + ".png";
  if (!std::filesystem::exists(baseline))
  {
    std::cerr << "No baseline " << baseline << "; the picture is in " << write(image.GetData(), "")
              << std::endl;
    return false;
  }
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(baseline.c_str());
  reader->Update();
  const int* size = reader->GetOutput()->GetDimensions();
  if (size[0] != image.GetWidth() || size[1] != image.GetHeight())
  {
    std::cerr << "The baseline " << baseline << " has " << size[0] << " x " << size[1]
              << " pixels, the picture " << write(image.GetData(), "") << " has " << image.GetWidth() << " x "
              << image.GetHeight() << std::endl;
    return false;
  }

  vtkNew<vtkImageDifference> difference;
  difference->SetInputData(image.GetData());
  difference->SetImageConnection(reader->GetOutputPort());
  difference->Update();
  const double error = difference->GetThresholdedError();
  if (error <= tolerance)
  {
    return true;
  }
  std::cerr << "The error of " << error << " exceeds " << tolerance << ".\n  baseline   " << baseline
            << "\n  picture    " << write(image.GetData(), "") << "\n  difference "
            << write(difference->GetOutput(), ".difference") << std::endl;
  return false;
}
