// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace ink::cli
{

class PointStore;

/// What the formats of points call a type of values.
struct TypeNames
{
  int type; ///< as VTK_FLOAT
  const char* xml;
  const char* legacy;
  const char* ply; ///< null if it has no such type
};

/// Null for what is no number, or is less than a byte.
const TypeNames* findTypeNames(int type);

/// @throws std::invalid_argument where there are none
const TypeNames& typeNamesOf(int type);

/// An array's name as the value of an attribute in VTK's XML.
std::string xmlName(const std::string& name);

/// An array's name as one word, the way VTK's readers and writers of legacy files have it.
std::string legacyName(const std::string& name);

/// What table-like formats call the components of all arrays: each is another name, x y z those of the
/// coordinates, and nx ny nz those of normals.
/// @param words whether names must be words, as in PLY: what is none gets _ for its spaces
std::vector<std::string> columnNames(const PointStore& points, bool words);

/// A name as a cell of a table with commas.
std::string csvName(const std::string& name);

} // namespace ink::cli
