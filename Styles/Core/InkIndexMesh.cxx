// SPDX-License-Identifier: BSD-3-Clause
#include "InkIndexMesh.h"

#include "Core/DisjointSets.h"
#include "InkImageGrid.h"

#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

void InkIndexMesh::Append(const InkIndexMesh& other)
{
  const auto first = static_cast<std::uint32_t>(this->Points.size());
  this->Points.insert(this->Points.end(), other.Points.begin(), other.Points.end());
  for (const auto& [a, b, c] : other.Triangles)
  {
    this->Triangles.push_back({ first + a, first + b, first + c });
  }
}

void InkIndexMesh::RemoveUnusedPoints()
{
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> ids(this->Points.size(), unused);
  for (const Triangle& triangle : this->Triangles)
  {
    for (const std::uint32_t point : triangle)
    {
      ids[point] = 0;
    }
  }
  std::uint32_t count = 0;
  for (std::size_t n = 0; n < ids.size(); ++n)
  {
    if (ids[n] != unused)
    {
      this->Points[count] = this->Points[n];
      ids[n] = count++;
    }
  }
  this->Points.resize(count);
  for (Triangle& triangle : this->Triangles)
  {
    for (std::uint32_t& point : triangle)
    {
      point = ids[point];
    }
  }
}

void InkIndexMesh::KeepParts(const ink::ComponentSelection& selection)
{
  ink::DisjointSets parts(this->Points.size());
  for (const auto& [a, b, c] : this->Triangles)
  {
    parts.join(a, b);
    parts.join(a, c);
  }
  std::vector<std::uint32_t> labels(this->Points.size());
  std::vector<std::size_t> counts;
  for (std::uint32_t point = 0; point < labels.size(); ++point)
  {
    const std::uint32_t first = parts.least(point);
    if (first == point)
    {
      labels[point] = static_cast<std::uint32_t>(counts.size());
      counts.push_back(0);
    }
    labels[point] = labels[first];
    ++counts[labels[point]];
  }
  const std::vector<char> selected = ink::selectComponents(counts, selection);
  std::erase_if(this->Triangles, [&](const Triangle& triangle) { return !selected[labels[triangle[0]]]; });
}

InkCellFilter::InkCellFilter(const glm::ivec3& samples, const glm::ivec3& subdivision, vtkImageData* image)
  : Cells(glm::max(samples - 1, glm::ivec3(1)))
  , Subdivision(subdivision)
  , Skipped(InkGetMarks(image->GetCellData(),
      vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL |
        vtkDataSetAttributes::REFINEDCELL))
{
}

bool InkCellFilter::IsKept(const InkIndexMesh& mesh, const InkIndexMesh::Triangle& triangle) const
{
  const glm::dvec3 middle =
    (mesh.Points[triangle[0]] + mesh.Points[triangle[1]] + mesh.Points[triangle[2]]) / 3.0;
  if (!std::isfinite(middle.x + middle.y + middle.z))
  {
    return false;
  }
  if (this->Skipped.empty())
  {
    return true;
  }
  const glm::ivec3 cell =
    glm::clamp(glm::ivec3(middle / glm::dvec3(this->Subdivision)), glm::ivec3(0), this->Cells - 1);
  return !this->Skipped[cell.x +
    static_cast<std::size_t>(this->Cells.x) * (cell.y + static_cast<std::size_t>(this->Cells.y) * cell.z)];
}
