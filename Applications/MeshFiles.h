#pragma once

#include "vtkSmartPointer.h"

#include <filesystem>
#include <string>
#include <vector>

class vtkPolyData;

namespace ink::cli
{

class Progress;

/// Readers of meshes and points. VTK has such, but those of its versions differ, and some fall over what they
/// do not expect: see Documentation/files.md.
///
/// All of them take a file whole or not at all, and believe a header only as far as there are bytes for what
/// it promises. \param notes what was not used, each a sentence without its dot, is added \throw Failure if
/// it is not such a file or not whole.
vtkSmartPointer<vtkPolyData> readPly(
  const std::filesystem::path& file, std::vector<std::string>& notes, Progress& progress);
vtkSmartPointer<vtkPolyData> readStl(
  const std::filesystem::path& file, std::vector<std::string>& notes, Progress& progress);
vtkSmartPointer<vtkPolyData> readObj(
  const std::filesystem::path& file, std::vector<std::string>& notes, Progress& progress);

} // namespace ink::cli
