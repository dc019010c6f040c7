// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFiles.h"

#include "CheckedXmlReader.h"
#include "ReaderProgress.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"

namespace ink::io
{

vtkSmartPointer<vtkPolyData> readVtp(
  const std::filesystem::path& file, std::vector<std::string>&, const Progress& progress)
{
  vtkNew<CheckedXmlReader<vtkXMLPolyDataReader>> reader;
  reader->open(file, "VTK XML mesh (.vtp)");
  const ReaderProgress reporting(reader, progress);
  reader->run([&reader] { reader->Update(); });
  if (reporting.aborted())
  {
    throw ReadAborted();
  }
  return reader->GetOutput();
}

} // namespace ink::io
