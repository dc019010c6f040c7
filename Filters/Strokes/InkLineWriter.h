// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkLineWriter_h
#define InkLineWriter_h

#include "Curves/Streamlines/Streamlines.h"
#include "InkAllocate.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cstddef>

/// The arrays of lines of curvature, of both families.
class InkLineWriter
{
public:
  InkLineWriter(int pointType, bool hasCurvatures)
    : HasCurvatures(hasCurvatures)
  {
    this->Points->SetDataType(pointType);
    this->Normals->SetName("Normals");
    this->Normals->SetNumberOfComponents(3);
    this->ArcLength->SetName("ArcLength");
    this->Priority->SetName("Priority");
    this->Family->SetName("LineFamily");
    for (std::size_t k = 0; k < 2; ++k)
    {
      this->Values[k]->SetName(CurvatureNames[k]);
    }
  }

  /// The point arrays of the principal curvatures and directions of a surface.
  static constexpr const char* CurvatureNames[] = { "k1", "k2", "PrincipalDirection1",
    "PrincipalDirection2" };

  /// @param normal(i), curvature(i): of a point of the lines; the latter k1 and k2, if they are written
  template <class Point, class Normal, class Curvature>
  void Add(
    const ink::StreamlinesOn<Point>& lines, int family, const Normal& normal, const Curvature& curvature)
  {
    const vtkIdType first = this->Points->GetNumberOfPoints();
    const auto count = static_cast<vtkIdType>(lines.positions.size());
    InkReserve(this->Points->GetData(), first + count);
    this->Points->SetNumberOfPoints(first + count);
    for (vtkIdType i = 0; i < count; ++i)
    {
      const auto n = static_cast<std::size_t>(i);
      this->Points->SetPoint(first + i, &lines.positions[n].x);
      const glm::vec3 own = normal(n);
      this->Normals->InsertNextTypedTuple(&own.x);
      this->ArcLength->InsertNextValue(lines.arcLength[n]);
      if (this->HasCurvatures)
      {
        const std::array<float, 2> values = curvature(n);
        this->Values[0]->InsertNextValue(values[0]);
        this->Values[1]->InsertNextValue(values[1]);
      }
    }
    for (std::size_t line = 0; line < lines.lines.size(); ++line)
    {
      const auto begin = first + static_cast<vtkIdType>(lines.lines.offsets[line]);
      const auto end = first + static_cast<vtkIdType>(lines.lines.offsets[line + 1]);
      const bool closed = lines.lines.closed[line] != 0;
      this->Lines->InsertNextCell(static_cast<int>(end - begin + (closed ? 1 : 0)));
      for (vtkIdType point = begin; point < end; ++point)
      {
        this->Lines->InsertCellPoint(point);
      }
      if (closed)
      {
        this->Lines->InsertCellPoint(begin);
      }
      this->Priority->InsertNextValue(lines.priorities[line]);
      this->Family->InsertNextValue(static_cast<unsigned char>(family));
    }
  }

  void Write(vtkPolyData* output)
  {
    output->SetPoints(this->Points);
    output->SetLines(this->Lines);
    output->GetPointData()->SetNormals(this->Normals);
    output->GetPointData()->AddArray(this->ArcLength);
    for (std::size_t k = 0; this->HasCurvatures && k < 2; ++k)
    {
      output->GetPointData()->AddArray(this->Values[k]);
    }
    output->GetCellData()->AddArray(this->Priority);
    output->GetCellData()->AddArray(this->Family);
  }

private:
  bool HasCurvatures;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkFloatArray> Normals;
  vtkNew<vtkDoubleArray> ArcLength;
  vtkNew<vtkFloatArray> Values[2];
  vtkNew<vtkFloatArray> Priority;
  vtkNew<vtkUnsignedCharArray> Family;
};

#endif
