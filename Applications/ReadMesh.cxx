#include "ReadFile.h"

#include "CheckMeshFile.h"
#include "CheckXmlFile.h"
#include "Text.h"
#include "XmlReaders.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"
#include "vtkXMLPolyDataReader.h"

namespace fs = std::filesystem;

namespace ink::cli
{
namespace
{

template <typename Reader>
vtkSmartPointer<vtkPolyData> read(const fs::path& file, Progress& progress)
{
  vtkNew<Reader> reader;
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
  Input input;
  if (suffix == ".ply")
  {
    checkPly(file);
    input.data = read<vtkPLYReader>(file, progress);
    input.format = "PLY mesh";
  }
  else if (suffix == ".stl")
  {
    checkStl(file);
    input.data = read<vtkSTLReader>(file, progress);
    input.format = "STL mesh";
  }
  else if (suffix == ".obj")
  {
    checkObj(file);
    input.data = read<vtkOBJReader>(file, progress);
    input.format = "OBJ mesh";
  }
  else
  {
    checkXml(file);
    input.data = read<PromptXmlReader<vtkXMLPolyDataReader>>(file, progress);
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
