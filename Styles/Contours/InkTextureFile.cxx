// SPDX-License-Identifier: BSD-3-Clause
#include "InkTextureFile.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkImageReader2Factory.h"
#include "vtkNew.h"

#include <filesystem>
#include <sstream>
#include <system_error>

vtkSmartPointer<vtkImageData> InkReadTexture(const std::string& file, std::string& problem)
{
  problem.clear();
  if (file.empty())
  {
    return nullptr;
  }
  std::ostringstream found;
  found << "expected an image file of 8 bits, gray or red, green, blue and alpha, found '" << file << "', ";
  // A folder can be opened, but not read.
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(file, unknown))
  {
    found << "which is no file";
    problem = found.str();
    return nullptr;
  }
  const auto reader =
    vtkSmartPointer<vtkImageReader2>::Take(vtkImageReader2Factory::CreateImageReader2(file.c_str()));
  if (!reader)
  {
    found << "which is no image";
    problem = found.str();
    return nullptr;
  }
  // Errors are not printed where they are observed.
  bool failed = false;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&failed);
  command->SetCallback(
    [](vtkObject*, unsigned long, void* client, void*) { *static_cast<bool*>(client) = true; });
  reader->AddObserver(vtkCommand::ErrorEvent, command);
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  int size[3];
  image->GetDimensions(size);
  const int components = image->GetNumberOfScalarComponents();
  if (failed || image->GetNumberOfPoints() == 0)
  {
    found << "which cannot be read";
  }
  else if (size[2] != 1 || image->GetScalarType() != VTK_UNSIGNED_CHAR ||
    (components != 1 && components != 4))
  {
    found << size[0] << " x " << size[1] << " x " << size[2] << " pixels of "
          << image->GetScalarTypeAsString() << " with " << components << " components";
  }
  else
  {
    return image;
  }
  problem = found.str();
  return nullptr;
}

std::string InkCheckTexture(const std::string& file)
{
  std::string problem;
  InkReadTexture(file, problem);
  return problem;
}
