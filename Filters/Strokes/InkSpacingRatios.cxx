// SPDX-License-Identifier: BSD-3-Clause
#include "InkSpacingRatios.h"

#include "InkPointNormals.h"
#include "Tone/Hatching/LocalSpacing.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

namespace hatching = ink::hatching;

/// The edge of the surface's samples, in spacings.
constexpr float SampleEdge = 0.9f;

/// Strokes of more spacings in all, for which memory would not suffice, are not those of the surface.
constexpr double MostSpacings = 1e8;

/// The strokes of a family, and which points of the input theirs are.
struct Family
{
  hatching::FamilyStrokes Strokes;
  std::vector<vtkIdType> Ids;
  double Spacing = 0.0;

  Family(vtkPolyData* data, int family, const glm::dvec3& center)
  {
    vtkDataArray* families = data->GetCellData()->GetArray("LineFamily");
    vtkDataArray* spacings = data->GetCellData()->GetArray("Spacing");
    vtkDataArray* priorities = data->GetCellData()->GetArray("Priority");
    vtkDataArray* normals = InkPointNormals(data);
    if (normals && normals->GetNumberOfTuples() != data->GetNumberOfPoints())
    {
      throw std::invalid_argument("the lines' normals are " + std::to_string(normals->GetNumberOfTuples()) +
        "; expected " + std::to_string(data->GetNumberOfPoints()) + ", one per point");
    }
    for (vtkIdType line = 0; line < data->GetNumberOfLines(); ++line)
    {
      if (families->GetComponent(line, 0) != family)
      {
        continue;
      }
      this->Spacing = spacings->GetComponent(line, 0);
      if (!(this->Spacing > 0.0))
      {
        return;
      }
      vtkIdType size;
      const vtkIdType* ids;
      data->GetLines()->GetCellAtId(line, size, ids);
      this->Strokes.begins.push_back(static_cast<std::uint32_t>(this->Ids.size()));
      this->Strokes.priorities.push_back(static_cast<float>(priorities->GetComponent(line, 0)));
      for (vtkIdType i = 0; i < size; ++i)
      {
        glm::dvec3 point;
        glm::dvec3 normal(0.0);
        data->GetPoint(ids[i], &point.x);
        if (normals)
        {
          normals->GetTuple(ids[i], &normal.x);
        }
        this->Ids.push_back(ids[i]);
        this->Strokes.points.emplace_back((point - center) / this->Spacing);
        this->Strokes.normals.emplace_back(normal / std::max(glm::length(normal), 1e-300));
      }
    }
    this->Strokes.begins.push_back(static_cast<std::uint32_t>(this->Ids.size()));
  }

  double FindLength() const
  {
    double length = 0.0;
    for (std::size_t stroke = 0; stroke + 1 < this->Strokes.begins.size(); ++stroke)
    {
      for (std::uint32_t i = this->Strokes.begins[stroke] + 1; i < this->Strokes.begins[stroke + 1]; ++i)
      {
        length += static_cast<double>(glm::distance(this->Strokes.points[i - 1], this->Strokes.points[i]));
      }
    }
    return length;
  }
};

} // namespace

vtkSmartPointer<vtkFloatArray> InkSpacingRatios(
  vtkPolyData* strokes, const InkMeshTriangles& surface, const ink::Progress& progress)
{
  auto ratios = vtkSmartPointer<vtkFloatArray>::New();
  ratios->SetName("SpacingRatio");
  ratios->SetNumberOfComponents(static_cast<int>(hatching::evenSpacing.size()));
  ratios->SetNumberOfTuples(strokes->GetNumberOfPoints());
  ratios->Fill(1.0);
  glm::dvec3 center;
  strokes->GetCenter(&center.x);
  for (const int number : { 0, 1 })
  {
    const Family family(strokes, number, center);
    if (family.Ids.empty() || !(family.FindLength() < MostSpacings))
    {
      continue;
    }
    const auto half = [&](double done) { return !progress || progress(0.5 * (number + done)); };
    const std::vector<hatching::SpacingRatios> found = hatching::localSpacing(family.Strokes,
      ink::areaSamples(surface.GetMesh(), surface.Normals, center, family.Spacing, SampleEdge), half);
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      ratios->SetTypedTuple(family.Ids[i], found[i].data());
    }
  }
  return ratios;
}
