#include "ReadFile.h"

#include "CheckVolumeFile.h"
#include "CheckXmlFile.h"
#include "FinishVolume.h"
#include "VolumeHeader.h"
#include "XmlReaders.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkStructuredPoints.h"
#include "vtkStructuredPointsReader.h"
#include "vtkXMLImageDataReader.h"

namespace fs = std::filesystem;

namespace ink::cli
{
namespace
{

void requireFormat(bool isOne, const fs::path& file, const char* format)
{
  if (!isOne)
  {
    failToRead(file, std::string("it is not a ") + format);
  }
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
    return readVoxels(file, readNiftiHeader(file), "NIfTI volume", memory, progress);
  }
  if (suffix == ".nrrd" || suffix == ".nhdr")
  {
    return readVoxels(file, readNrrdHeader(file), "NRRD volume", memory, progress);
  }
  if (suffix == ".mha" || suffix == ".mhd")
  {
    return readVoxels(file, readMetaImageHeader(file), "MetaImage volume", memory, progress);
  }
  return suffix == ".vti" ? readXmlImage(file, memory, progress) : readLegacyImage(file, memory, progress);
}

} // namespace ink::cli
