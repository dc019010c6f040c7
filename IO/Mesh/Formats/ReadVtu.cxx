// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFiles.h"

#include "CheckedXmlReader.h"
#include "GridCells.h"
#include "ReaderProgress.h"

#include "vtkCellType.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLUnstructuredGridReader.h"

namespace ink::io
{
namespace
{

/// Faults: VTK takes types modulo 256, renumbers the points of cells of higher order by a degree that the
/// file says, and walks from face to face of polyhedra wherever their counts lead.
class GridReader : public CheckedXmlReader<vtkXMLUnstructuredGridReader>
{
public:
  static GridReader* New() { VTK_STANDARD_NEW_BODY(GridReader); }

protected:
  GridReader() = default;

  int ReadArrayValues(vtkXMLDataElement* element, vtkIdType arrayIndex, vtkAbstractArray* array,
    vtkIdType start, vtkIdType count, vtkXMLReader::FieldType type) override
  {
    if (!this->CheckedXmlReader::ReadArrayValues(element, arrayIndex, array, start, count, type))
    {
      return 0;
    }
    auto* values = vtkDataArray::SafeDownCast(array);
    const std::string_view name = values ? nameOfCells(element) : "";
    if (name == "faceoffsets")
    {
      this->FaceEnds = values;
    }
    else if (name == "faces" && !this->areWhole(values))
    {
      vtkErrorMacro("the faces of its polyhedra do not end where their faceoffsets say");
      return 0;
    }
    else if (const std::string problem = name == "types" ? problemOfTypes(values) : ""; !problem.empty())
    {
      // VTK would lose the array where this failed.
      vtkErrorMacro(<< problem);
      values->Fill(VTK_EMPTY_CELL);
    }
    return 1;
  }

private:
  static std::string problemOfTypes(vtkDataArray* types)
  {
    std::string problem;
    for (vtkIdType i = 0; i < types->GetNumberOfTuples() && problem.empty(); ++i)
    {
      problem = problemOfCellType(types->GetComponent(i, 0));
    }
    return problem;
  }

  /// Of each polyhedron: the number of its faces, and of each face that of its points and these.
  bool areWhole(vtkDataArray* faces) const
  {
    const vtkIdType size = faces->GetNumberOfTuples();
    vtkIdType at = 0;
    const auto next = [&]
    {
      const double number = at < size ? faces->GetComponent(at++, 0) : -1.0;
      return number >= 0.0 && number <= static_cast<double>(size - at) ? static_cast<vtkIdType>(number) : -1;
    };
    for (vtkIdType cell = 0; cell < this->FaceEnds->GetNumberOfTuples(); ++cell)
    {
      const double end = this->FaceEnds->GetComponent(cell, 0);
      if (end < 0.0)
      {
        continue;
      }
      const vtkIdType count = next();
      for (vtkIdType face = 0; face < count; ++face)
      {
        const vtkIdType points = next();
        if (points < 0)
        {
          return false;
        }
        at += points;
      }
      if (count < 0 || static_cast<double>(at) != end)
      {
        return false;
      }
    }
    return at == size;
  }

  vtkSmartPointer<vtkDataArray> FaceEnds;
};

} // namespace

vtkSmartPointer<vtkPolyData> readVtu(
  const std::filesystem::path& file, std::vector<std::string>& notes, const Progress& progress)
{
  vtkNew<GridReader> reader;
  reader->open(file, "VTK XML unstructured grid (.vtu)");
  const Progress first = halfOf(progress, 0.0);
  const ReaderProgress reporting(reader, first);
  reader->run([&reader] { reader->Update(); });
  if (reporting.aborted())
  {
    throw ReadAborted();
  }
  return surfaceOf(reader->GetOutput(), file, notes, progress);
}

} // namespace ink::io
