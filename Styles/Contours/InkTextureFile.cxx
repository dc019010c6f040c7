// SPDX-License-Identifier: BSD-3-Clause
#include "InkTextureFile.h"

#include "vtkBMPReader.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkImageReader2.h"
#include "vtkJPEGReader.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkTIFFReader.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>
#include <system_error>

namespace
{

/// Of formats of pictures with 8 bits. That of VTK's factory may be one that takes text for an image, and
/// crashes: vtkHDRReader of VTK 9.2.
vtkSmartPointer<vtkImageReader2> FindReader(const std::string& file)
{
  const std::array<vtkSmartPointer<vtkImageReader2>, 4> readers{ vtkSmartPointer<vtkPNGReader>::New(),
    vtkSmartPointer<vtkTIFFReader>::New(), vtkSmartPointer<vtkJPEGReader>::New(),
    vtkSmartPointer<vtkBMPReader>::New() };
  const auto found = std::find_if(readers.begin(), readers.end(),
    [&](const auto& reader) { return reader->CanReadFile(file.c_str()) > 0; });
  return found == readers.end() ? nullptr : *found;
}

} // namespace

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
  const vtkSmartPointer<vtkImageReader2> reader = FindReader(file);
  if (!reader)
  {
    found << "which is no PNG, TIFF, JPEG or BMP";
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
