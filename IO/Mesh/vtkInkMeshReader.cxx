// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkMeshReader.h"

#include "FileFormats.h"
#include "GridCells.h"
#include "InkReportReadError.h"
#include "InkVTKCompat.h"
#include "MeshFiles.h"
#include "ReadError.h"

#include "vtkCellArray.h"
#include "vtkErrorCode.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <exception>

namespace fs = std::filesystem;
namespace io = ink::io;

vtkStandardNewMacro(vtkInkMeshReader);

namespace
{

struct Format
{
  const char* suffix;
  const char* name;
  io::MeshFileReader* read;
};
constexpr Format formats[] = { { ".ply", "PLY mesh", io::readPly }, { ".obj", "OBJ mesh", io::readObj },
  { ".off", "OFF mesh", io::readOff }, { ".stl", "STL mesh", io::readStl },
  { ".vtp", "VTK XML mesh (.vtp)", io::readVtp }, { ".vtu", "VTK XML unstructured grid (.vtu)", io::readVtu },
  { ".vtk", "legacy VTK mesh", io::readLegacyMesh }, { ".xyz", "XYZ points", io::readXyz },
  { ".pcd", "PCD points", io::readPcd }, { ".gii", "GIFTI surface (.gii)", io::readGifti } };

/// Null if it is none.
const Format* FormatOf(const char* fileName)
{
  return io::findFormat(formats, fileName ? fileName : "");
}

} // namespace

vtkInkMeshReader::vtkInkMeshReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkInkMeshReader::~vtkInkMeshReader()
{
  this->SetFileName(nullptr);
}

int vtkInkMeshReader::CanReadFile(const char* fileName)
{
  try
  {
    io::checkExists(fileName ? fileName : "");
    const Format* format = FormatOf(fileName);
    return format && !fs::is_directory(fileName) &&
        (format->read != io::readLegacyMesh || io::isLegacyMesh(fileName))
      ? 1
      : 0;
  }
  catch (const std::exception&)
  {
    return 0;
  }
}

const char* vtkInkMeshReader::GetFileExtensions()
{
  static const std::string all = io::listSuffixes(formats);
  return all.c_str();
}

const char* vtkInkMeshReader::GetFormat()
{
  const Format* format = FormatOf(this->FileName);
  return format ? format->name : "";
}

int vtkInkMeshReader::GetNumberOfNotes()
{
  return static_cast<int>(this->Notes.size());
}

const char* vtkInkMeshReader::GetNote(int index)
{
  return index >= 0 && index < this->GetNumberOfNotes() ? this->Notes[static_cast<std::size_t>(index)].c_str()
                                                        : nullptr;
}

int vtkInkMeshReader::RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* mesh = vtkPolyData::GetData(outputVector);
  this->Notes.clear();
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->FileName || !*this->FileName)
  {
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro("FileName is empty; expected a file.");
    return 1;
  }
  const fs::path file = this->FileName;
  try
  {
    io::checkExists(file);
    const Format* format = FormatOf(this->FileName);
    if (!format || fs::is_directory(file))
    {
      io::failToRead(file,
        "unknown type '" + io::suffixOf(file) + "'; expected one of " +
          vtkInkMeshReader::GetFileExtensions());
    }
    mesh->ShallowCopy(format->read(file, this->Notes,
      [this](double done)
      {
        this->UpdateProgress(done);
        return !InkCheckAbort(this);
      }));
    if (mesh->GetNumberOfPoints() == 0)
    {
      io::failToRead(file, "it holds no points");
    }
    for (vtkCellArray* cells : { mesh->GetVerts(), mesh->GetLines(), mesh->GetPolys(), mesh->GetStrips() })
    {
      io::checkCells(cells, mesh->GetNumberOfPoints(), file);
    }
    io::dropMismatched(mesh, this->Notes);
  }
  catch (...)
  {
    this->SetErrorCode(InkReportReadError(this, mesh, file));
  }
  return 1;
}

void vtkInkMeshReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "") << "\n"
     << indent << "Format: " << this->GetFormat() << "\n";
}
