#include "ReadFile.h"

#include "FinishVolume.h"
#include "Orientation.h"

#include "vtkDICOMImageReader.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace fs = std::filesystem;

namespace ink::cli
{
namespace
{

/// Files with DICOM's mark, which stands after 128 bytes of anything.
std::vector<fs::path> dicomFiles(const fs::path& folder)
{
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
  {
    std::array<char, 132> start{};
    if (entry.is_regular_file() &&
      std::ifstream(entry.path(), std::ios::binary).read(start.data(), start.size()) &&
      std::string_view(start.data() + 128, 4) == "DICM")
    {
      files.push_back(entry.path());
    }
  }
  return files;
}

/// VTK does not notice if a file ends within its pixels. They are the last element as a rule, with the tag
/// (7FE0,0010), and their length stands before them.
void checkPixels(const fs::path& file, std::size_t pixelBytes)
{
  std::ifstream stream(file, std::ios::binary);
  const std::string bytes{ std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>() };
  constexpr std::string_view tag("\xE0\x7F\x10\x00", 4);
  const std::size_t position = bytes.rfind(tag, bytes.size() - std::min(bytes.size(), pixelBytes));
  // After the tag come 4 or 8 bytes: the length, in newer files after the type of the values.
  if (position == std::string::npos || bytes.size() - position < tag.size() + 4 + pixelBytes)
  {
    failToRead(file, "the file ends before its " + std::to_string(pixelBytes) + " bytes of pixels do");
  }
}

/// VTK turns the rows of DICOM's images upside down, and its slices come from the end of the series, the
/// position of which it knows.
void orient(vtkDICOMImageReader* reader, vtkImageData* image)
{
  const float* cosines = reader->GetImageOrientationPatient();
  const float* last = reader->GetImagePositionPatient();
  const double row[3] = { cosines[0], cosines[1], cosines[2] };
  const double column[3] = { cosines[3], cosines[4], cosines[5] };
  double normal[3];
  vtkMath::Cross(row, column, normal);
  const int* dimensions = image->GetDimensions();
  const double* spacing = image->GetSpacing();
  double steps[9];
  double origin[3];
  for (int i = 0; i < 3; ++i)
  {
    steps[i] = row[i];
    steps[3 + i] = -column[i];
    steps[6 + i] = -normal[i];
    origin[i] =
      last[i] + (dimensions[1] - 1) * spacing[1] * column[i] + (dimensions[2] - 1) * spacing[2] * normal[i];
  }
  constexpr double sign[3] = { 1, 1, 1 };
  Orientation(steps, origin, sign).apply(image);
}

} // namespace

Input readDicomFolder(const fs::path& folder, const Memory& memory, Progress& progress)
{
  const std::vector<fs::path> files = dicomFiles(folder);
  if (files.empty())
  {
    failToRead(folder, "it is a directory without DICOM files");
  }

  vtkNew<vtkDICOMImageReader> reader;
  reader->SetDirectoryName(folder.c_str());
  runVolumeReader(reader, folder, memory, progress);
  // The reader takes compressed pixels for plain ones.
  const char* syntax = reader->GetTransferSyntaxUID();
  const std::string syntaxName = syntax ? syntax : "";
  if (syntaxName.starts_with("1.2.840.10008.1.2.4") || syntaxName.starts_with("1.2.840.10008.1.2.5"))
  {
    failToRead(folder, "its pixels are compressed (transfer syntax " + syntaxName + "); expected plain ones");
  }
  const auto pixelBytes = static_cast<std::size_t>(reader->GetWidth()) * reader->GetHeight() *
    reader->GetNumberOfComponents() * reader->GetBitsAllocated() / 8;
  for (const fs::path& file : files)
  {
    checkPixels(file, pixelBytes);
  }
  Input input = makeVolumeInput(reader->GetOutput(), folder, "DICOM series");
  orient(reader, vtkImageData::SafeDownCast(input.data));
  return input;
}

} // namespace ink::cli
