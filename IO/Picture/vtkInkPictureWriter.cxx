// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkPictureWriter.h"

#include "PictureEncoder.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

using ink::io::PictureEncoder;

vtkStandardNewMacro(vtkInkPictureWriter);

namespace
{

/// What keeps an image from being a picture in a file of that name; empty if nothing does.
std::string FindProblem(const char* fileName, vtkImageData* image, vtkUnsignedCharArray* pixels)
{
  if (!fileName || !PictureEncoder::isPicture(fileName))
  {
    return "expected a file name that ends in " + PictureEncoder::suffixes() + ", found '" +
      (fileName ? fileName : "") + "'";
  }
  const int* size = image->GetDimensions();
  if (!pixels || size[0] < 1 || size[1] < 1 || size[2] != 1)
  {
    return "expected an image of one slice whose scalars are bytes, found " + std::to_string(size[0]) +
      " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]) +
      (pixels ? "" : " without such scalars");
  }
  const int components = pixels->GetNumberOfComponents();
  if (components != 3 && !(components == 4 && PictureEncoder::hasAlpha(fileName)))
  {
    return std::string("expected red, green and blue") +
      (PictureEncoder::hasAlpha(fileName) ? ", or with alpha" : "") + ", found " +
      std::to_string(components) + " components";
  }
  const int longest = PictureEncoder::longestSide(fileName);
  return std::max(size[0], size[1]) > longest ? "expected at most " + std::to_string(longest) +
      " pixels a side, found " + std::to_string(size[0]) + " x " + std::to_string(size[1])
                                              : std::string();
}

} // namespace

vtkInkPictureWriter::vtkInkPictureWriter()
{
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(0);
}

vtkInkPictureWriter::~vtkInkPictureWriter()
{
  this->SetFileName(nullptr);
}

void vtkInkPictureWriter::SetDotsPerInch(double dots)
{
  // Not a number compares as false.
  const double kept = dots > 1.0 ? std::min(dots, 30000.0) : 1.0;
  if (this->DotsPerInch != kept)
  {
    this->DotsPerInch = kept;
    this->Modified();
  }
}

std::string vtkInkPictureWriter::GetFileExtensions()
{
  return PictureEncoder::suffixes();
}

bool vtkInkPictureWriter::CanWriteFile(const char* fileName)
{
  return fileName && PictureEncoder::isPicture(fileName);
}

bool vtkInkPictureWriter::CanWriteAlpha(const char* fileName)
{
  return fileName && PictureEncoder::hasAlpha(fileName);
}

int vtkInkPictureWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

void vtkInkPictureWriter::SetInputData(vtkDataObject* image)
{
  this->SetInputDataObject(image);
}

bool vtkInkPictureWriter::Fail(unsigned long code, const std::string& problem)
{
  vtkErrorMacro(<< "The picture cannot be written: " << problem << '.');
  this->SetErrorCode(code);
  return false;
}

bool vtkInkPictureWriter::Write()
{
  this->SetErrorCode(vtkErrorCode::NoError);
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    return this->Fail(vtkErrorCode::UserError, "there is none");
  }
  this->GetInputAlgorithm()->UpdateWholeExtent();
  auto* image = vtkImageData::SafeDownCast(this->GetInputDataObject(0, 0));
  auto* pixels = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
  if (const std::string problem = FindProblem(this->FileName, image, pixels); !problem.empty())
  {
    return this->Fail(vtkErrorCode::FileFormatError, problem);
  }
  const int* size = image->GetDimensions();
  const ink::io::PictureLayout layout{ size[0], size[1], pixels->GetNumberOfComponents(), this->DotsPerInch };
  std::ofstream file(this->FileName, std::ios::binary);
  try
  {
    const auto encoder = PictureEncoder::create(this->FileName, layout,
      [&](std::span<const unsigned char> bytes)
      {
        file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        if (!file)
        {
          throw ink::io::PictureError("'" + std::string(this->FileName) + "': " + std::strerror(errno));
        }
      });
    for (int row = size[1] - 1; row >= 0; --row)
    {
      encoder->add(
        { pixels->GetPointer(static_cast<vtkIdType>(row * layout.rowBytes())), layout.rowBytes() });
    }
    encoder->finish();
    file.close();
  }
  catch (const ink::io::PictureError& error)
  {
    return this->Fail(vtkErrorCode::CannotOpenFileError, error.what());
  }
  return file ? true : this->Fail(vtkErrorCode::OutOfDiskSpaceError, std::strerror(errno));
}

void vtkInkPictureWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n"
     << indent << "DotsPerInch: " << this->DotsPerInch << "\n";
}
