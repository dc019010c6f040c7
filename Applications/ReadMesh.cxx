#include "ReadFile.h"

#include "CheckXmlFile.h"
#include "MeshFiles.h"
#include "Progress.h"
#include "Text.h"
#include "XmlReaders.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"

namespace fs = std::filesystem;

namespace ink::cli
{
namespace
{

vtkSmartPointer<vtkPolyData> readVtp(const fs::path& file, Progress& progress)
{
  const double mostValues = checkXml(file);
  vtkNew<PromptXmlReader<vtkXMLPolyDataReader>> reader;
  reader->SetMostValues(mostValues);
  reader->SetFileName(file.c_str());
  runReader(reader, file, progress);
  return reader->GetOutput();
}

/// Cells of points that do not exist would crash whatever looks at them.
void checkCells(vtkPolyData* mesh, const fs::path& file)
{
  for (vtkCellArray* cells : { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
  {
    if (!cells || cells->GetNumberOfConnectivityIds() == 0)
    {
      continue;
    }
    double range[2];
    cells->GetConnectivityArray()->GetRange(range, 0);
    if (range[0] < 0 || range[1] >= static_cast<double>(mesh->GetNumberOfPoints()))
    {
      failToRead(file,
        "a cell has point " + text(range[0] < 0 ? range[0] : range[1]) + ", but there are " +
          std::to_string(mesh->GetNumberOfPoints()) + " points");
    }
  }
}

} // namespace

Input readMesh(const fs::path& file, const std::string& suffix, Progress& progress)
{
  progress.step("reading " + file.filename().string());
  Input input;
  if (suffix == ".ply")
  {
    input.data = readPly(file, input.notes, progress);
    input.format = "PLY mesh";
  }
  else if (suffix == ".stl")
  {
    input.data = readStl(file, input.notes, progress);
    input.format = "STL mesh";
  }
  else if (suffix == ".obj")
  {
    input.data = readObj(file, input.notes, progress);
    input.format = "OBJ mesh";
  }
  else
  {
    input.data = readVtp(file, progress);
    input.format = "VTK XML mesh (.vtp)";
  }
  auto* mesh = vtkPolyData::SafeDownCast(input.data);
  if (mesh->GetNumberOfPoints() == 0)
  {
    failToRead(file, "it holds no points");
  }
  checkCells(mesh, file);
  return input;
}

} // namespace ink::cli
