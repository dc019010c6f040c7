#include "ReadFile.h"

#include "CheckVolumeFile.h"
#include "CheckXmlFile.h"
#include "FinishVolume.h"
#include "Orientation.h"
#include "PlainVoxels.h"
#include "XmlReaders.h"

#include "vtkImageData.h"
#include "vtkMetaImageReader.h"
#include "vtkNIFTIImageReader.h"
#include "vtkNew.h"
#include "vtkNrrdReader.h"
#include "vtkStructuredPoints.h"
#include "vtkStructuredPointsReader.h"
#include "vtkXMLImageDataReader.h"

namespace fs = std::filesystem;

namespace ink::cli
{
namespace
{

constexpr const char* notAtRightAngles = "its axes are not at right angles; they are taken as the world's";

void requireFormat(bool isOne, const fs::path& file, const char* format)
{
  if (!isOne)
  {
    failToRead(file, std::string("it is not a ") + format);
  }
}

Input readNifti(const fs::path& file, const Memory& memory, Progress& progress)
{
  constexpr const char* format = "NIfTI volume";
  vtkNew<vtkNIFTIImageReader> reader;
  requireFormat(reader->CanReadFile(file.c_str()) != 0, file, format);
  reader->SetFileName(file.c_str());
  runVolumeReader(reader, file, memory, progress);

  Input input = makeVolumeInput(reader->GetOutput(), file, format);
  auto* image = vtkImageData::SafeDownCast(input.data);
  const bool stored = reader->GetSFormMatrix() || reader->GetQFormMatrix();
  if (stored && !applyNiftiOrientation(reader, image))
  {
    input.notes.emplace_back(notAtRightAngles);
  }
  if (reader->GetTimeDimension() > 1)
  {
    input.notes.push_back(
      "it has " + std::to_string(reader->GetTimeDimension()) + " time steps; the first is used");
  }
  rescale(input, reader->GetRescaleSlope(), reader->GetRescaleIntercept());
  return input;
}

/// A volume from a reader that leaves the orientation in the file's header to `orient`. If it is large, and
/// `find` knows where its voxels lie, they stay in the file.
template <class Reader, class Find, class Orient>
Input readWithHeader(const fs::path& file, const char* format, const Find& find, const Orient& orient,
  const Memory& memory, Progress& progress)
{
  vtkNew<Reader> reader;
  requireFormat(reader->CanReadFile(file.c_str()) != 0, file, format);
  reader->SetFileName(file.c_str());
  Input input;
  vtkSmartPointer<vtkImageData> image;
  std::optional<PlainVoxels> voxels;
  if (readHeader(reader, file, progress) > memory.forWholeVolume())
  {
    voxels = find(file, reader);
  }
  if (voxels)
  {
    image = vtkSmartPointer<vtkImageData>::New();
    image->SetExtent(reader->GetDataExtent());
    image->SetSpacing(reader->GetDataSpacing());
    image->SetOrigin(reader->GetDataOrigin());
    input = makeVolumeInput(image, *voxels, format, memory);
  }
  else
  {
    runVolumeReader(reader, file, memory, progress);
    input = makeVolumeInput(reader->GetOutput(), file, format);
    image = vtkImageData::SafeDownCast(input.data);
  }
  if (!orient(file, image))
  {
    input.notes.emplace_back(notAtRightAngles);
  }
  return input;
}

Input readNrrd(const fs::path& file, const Memory& memory, Progress& progress)
{
  // First, because VTK waits forever for the end of a header that has none.
  checkNrrd(file);
  return readWithHeader<vtkNrrdReader>(
    file, "NRRD volume", findNrrdVoxels, applyNrrdOrientation, memory, progress);
}

Input readMetaImage(const fs::path& file, const Memory& memory, Progress& progress)
{
  return readWithHeader<vtkMetaImageReader>(
    file, "MetaImage volume", findMetaImageVoxels, applyMetaImageOrientation, memory, progress);
}

Input readXmlImage(const fs::path& file, const Memory& memory, Progress& progress)
{
  constexpr const char* format = "VTK XML image (.vti)";
  vtkNew<PromptXmlReader<vtkXMLImageDataReader>> reader;
  requireFormat(reader->CanReadFile(file.c_str()) != 0, file, format);
  checkXml(file);
  reader->SetFileName(file.c_str());
  runVolumeReader(reader, file, memory, progress);
  return makeVolumeInput(reader->GetOutput(), file, format);
}

Input readLegacyImage(const fs::path& file, const Memory& memory, Progress& progress)
{
  constexpr const char* format = "legacy VTK file of structured points";
  vtkNew<vtkStructuredPointsReader> reader;
  reader->SetFileName(file.c_str());
  requireFormat(reader->IsFileStructuredPoints() != 0, file, format);
  checkLegacyImage(file);
  runVolumeReader(reader, file, memory, progress, true);
  return makeVolumeInput(reader->GetOutput(), file, format);
}

} // namespace

Input readVolume(const fs::path& file, const std::string& suffix, const Memory& memory, Progress& progress)
{
  if (suffix == ".nii" || suffix == ".nii.gz")
  {
    return readNifti(file, memory, progress);
  }
  if (suffix == ".nrrd" || suffix == ".nhdr")
  {
    return readNrrd(file, memory, progress);
  }
  if (suffix == ".mha" || suffix == ".mhd")
  {
    return readMetaImage(file, memory, progress);
  }
  return suffix == ".vti" ? readXmlImage(file, memory, progress) : readLegacyImage(file, memory, progress);
}

} // namespace ink::cli
