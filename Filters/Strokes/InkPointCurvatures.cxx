// SPDX-License-Identifier: BSD-3-Clause
#include "InkPointCurvatures.h"

#include "Core/UnitOrZero.h"
#include "Curvature/MeshCurvature.h"
#include "Curves/Streamlines/FlatDirections.h"
#include "Curves/Streamlines/FormDirections.h"
#include "InkLineWriter.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace
{

constexpr auto& CurvatureNames = InkLineWriter::CurvatureNames;

/// Those of arrays of the mesh.
/// @param sources the points whose values are wanted
void ReadCurvatures(
  vtkPolyData* mesh, std::span<const std::uint32_t> sources, double negligible, InkPointCurvatures& result)
{
  vtkDataArray* arrays[4];
  for (int i = 0; i < 4; ++i)
  {
    arrays[i] = mesh->GetPointData()->GetArray(CurvatureNames[i]);
    const int components = i < 2 ? 1 : 3;
    if (arrays[i]->GetNumberOfComponents() != components ||
      arrays[i]->GetNumberOfTuples() != mesh->GetNumberOfPoints())
    {
      throw std::invalid_argument(std::string("the point array \"") + CurvatureNames[i] + "\" has " +
        std::to_string(arrays[i]->GetNumberOfTuples()) + " tuples of " +
        std::to_string(arrays[i]->GetNumberOfComponents()) + " components; expected " +
        std::to_string(mesh->GetNumberOfPoints()) + " of " + std::to_string(components));
    }
  }
  for (const std::uint32_t source : sources)
  {
    ink::PrincipalCurvature point;
    point.k1 = arrays[0]->GetComponent(source, 0);
    point.k2 = arrays[1]->GetComponent(source, 0);
    arrays[2]->GetTuple(source, &point.direction1.x);
    arrays[3]->GetTuple(source, &point.direction2.x);
    result.Add(point, negligible);
  }
}

} // namespace

void InkPointCurvatures::Add(const ink::PrincipalCurvature& point, double negligible)
{
  const bool isFinite = std::isfinite(point.k1) && std::isfinite(point.k2);
  this->Points.push_back({ isFinite ? point.k1 : 0.0, isFinite ? point.k2 : 0.0,
    ink::unitOrZero(point.direction1), ink::unitOrZero(point.direction2) });
  this->Umbilics.push_back(isFinite ? static_cast<float>(point.umbilicMeasure(negligible)) : 1.0f);
  this->Directions[0].push_back(this->Points.back().direction1);
  this->Directions[1].push_back(this->Points.back().direction2);
}

void InkPointCurvatures::FollowForm(const ink::TriangleMesh& surface, std::span<const glm::vec3> normals,
  double negligible, double spacing, const Smooth& smooth)
{
  ink::FormDirections form = ink::formDirections(surface, normals, this->Points, negligible, spacing);
  this->Directions = std::move(form.directions);
  this->Umbilics = std::move(form.umbilics);
  auto& [first, second] = this->Directions;
  const std::vector<glm::dvec3> flat = ink::flatDirections(surface);
  for (std::size_t i = 0; i < flat.size(); ++i)
  {
    if (flat[i] != glm::dvec3(0.0))
    {
      first[i] = flat[i];
      this->Umbilics[i] = 1.0f;
      form.preferences[i] = 1.0f;
    }
  }
  first = smooth(first, form.preferences);
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    second[i] = ink::unitOrZero(glm::cross(glm::dvec3(normals[i]), first[i]));
  }
}

std::array<float, 2> InkPointCurvatures::At(const ink::TriangleMesh& mesh, const ink::MeshPoint& point) const
{
  std::array<double, 2> mean{};
  for (int corner = 0; corner < 3; ++corner)
  {
    const ink::PrincipalCurvature& at =
      this->Points[mesh.triangles[point.triangle][static_cast<std::size_t>(corner)]];
    mean[0] += point.weights[corner] * at.k1;
    mean[1] += point.weights[corner] * at.k2;
  }
  return { static_cast<float>(mean[0]), static_cast<float>(mean[1]) };
}

InkPointCurvatures InkFindPointCurvatures(vtkPolyData* mesh, const InkMeshTriangles& triangles,
  std::span<const std::uint32_t> sources, double negligible, const ink::Progress& progress)
{
  InkPointCurvatures result;
  if (std::all_of(std::begin(CurvatureNames), std::end(CurvatureNames),
        [&](const char* name) { return mesh->GetPointData()->GetArray(name) != nullptr; }))
  {
    ReadCurvatures(mesh, sources, negligible, result);
    return result;
  }
  ink::CurvatureOptions options;
  options.seams = ink::Seams::Apart;
  for (const ink::PrincipalCurvature& point :
    ink::estimateCurvature(triangles.GetMesh(), triangles.Normals, options, progress).points)
  {
    result.Add(point, negligible);
  }
  return result;
}
