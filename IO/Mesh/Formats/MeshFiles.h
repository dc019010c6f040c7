// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkSmartPointer.h"

#include "Core/Progress.h"

#include <filesystem>
#include <string>
#include <vector>

class vtkPolyData;

namespace ink::io
{

/// Readers of meshes and points. VTK has such, but those of its versions differ, and some fall over what they
/// do not expect: see Documentation/files.md.
///
/// All of them take a file whole or not at all, and believe a header only as far as there are bytes for what
/// it promises.
/// @param notes what was not used, or that a surface was made, each a sentence without its dot, is added
/// @throws ReadError if it is not such a file or not whole, ReadAborted
using MeshFileReader = vtkSmartPointer<vtkPolyData>(
  const std::filesystem::path& file, std::vector<std::string>& notes, const Progress& progress);
MeshFileReader readGifti;
MeshFileReader readLegacyMesh;
MeshFileReader readObj;
MeshFileReader readOff;
MeshFileReader readPcd;
MeshFileReader readPly;
MeshFileReader readStl;
MeshFileReader readVtp;
MeshFileReader readVtu;
MeshFileReader readXyz;

/// Whether a file is a legacy VTK file of poly data, by its first lines; others of the same suffix hold
/// images.
bool isLegacyMesh(const std::filesystem::path& file);

} // namespace ink::io
