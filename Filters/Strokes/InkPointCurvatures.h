// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkPointCurvatures_h
#define InkPointCurvatures_h

#include "Core/Progress.h"
#include "Curvature/PrincipalCurvature.h"
#include "InkMeshTriangles.h"
#include "Mesh/MeshNavigation.h"
#include "Mesh/TriangleMesh.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

class vtkPolyData;

/// The principal curvatures of a mesh's points, and the directions of lines.
struct InkPointCurvatures
{
  std::vector<ink::PrincipalCurvature> Points;
  std::array<std::vector<glm::dvec3>, 2> Directions; ///< of maximum and minimum curvature
  std::vector<float> Umbilics;

  /// @param negligible a curvature that counts as none
  void Add(const ink::PrincipalCurvature& point, double negligible);

  /// The directions of the first family, smoothed, from those and from preferences.
  using Smooth =
    std::function<std::vector<glm::dvec3>(const std::vector<glm::dvec3>&, const std::vector<float>&)>;
  /// Makes directions those that lines follow where curvature says little, too: of the form at large, and of
  /// flat faces their own.
  void FollowForm(const ink::TriangleMesh& surface, std::span<const glm::vec3> normals, double negligible,
    double spacing, const Smooth& smooth);

  /// k1 and k2 between the corners of a triangle.
  std::array<float, 2> At(const ink::TriangleMesh& mesh, const ink::MeshPoint& point) const;
};

/// Those of the mesh's arrays, or else estimated.
/// @param triangles those of the mesh, cut open at feature edges
/// @param sources the mesh's points that theirs are
/// @throws std::invalid_argument for arrays of other sizes
InkPointCurvatures InkFindPointCurvatures(vtkPolyData* mesh, const InkMeshTriangles& triangles,
  std::span<const std::uint32_t> sources, double negligible, const ink::Progress& progress);

#endif
