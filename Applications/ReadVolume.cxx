#include "ReadFile.h"

#include "CheckXmlFile.h"
#include "FinishVolume.h"
#include "VolumeHeader.h"
#include "XmlReaders.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkXMLImageDataReader.h"

namespace fs = std::filesystem;

namespace ink::cli
{
namespace
{

Input readXmlImage(const fs::path& file, const Memory& memory, Progress& progress)
{
  constexpr const char* format = "VTK XML image (.vti)";
  const double mostValues = checkXml(file);
  vtkNew<PromptXmlReader<vtkXMLImageDataReader>> reader;
  reader->SetMostValues(mostValues);
  if (reader->CanReadFile(file.c_str()) == 0)
  {
    failToRead(file, std::string("it is not a ") + format);
  }
  reader->SetFileName(file.c_str());
  runVolumeReader(reader, file, memory, progress);
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
  if (suffix == ".vtk")
  {
    return readVoxels(file, readLegacyHeader(file), "legacy VTK file of structured points", memory, progress);
  }
  return readXmlImage(file, memory, progress);
}

} // namespace ink::cli
