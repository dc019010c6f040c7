#include "ReadFile.h"

#include "FinishVolume.h"
#include "Orientation.h"

#include "vtkDICOMImageReader.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"

namespace ink::cli
{

Input readDicomFolder(const std::filesystem::path& folder, Progress& progress)
{
  vtkNew<vtkDICOMImageReader> reader;
  reader->SetDirectoryName(folder.c_str());
  runReader(reader, folder, progress);
  return makeVolumeInput(reader->GetOutput(), folder, "DICOM series");
}

} // namespace ink::cli
