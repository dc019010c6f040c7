// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFiles.h"

#include "ReadError.h"
#include "Words.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

using StlCorner = std::array<float, 3>;

struct StlCornerHash
{
  std::size_t operator()(const StlCorner& corner) const
  {
    std::uint64_t hash = 0;
    for (const float coordinate : corner)
    {
      // Minus zero is zero.
      hash = (hash ^ std::bit_cast<std::uint32_t>(coordinate + 0.0f)) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 29;
    }
    return hash;
  }
};

/// Triangles come with corners of their own in the file; equal ones become one point.
class Triangles
{
public:
  explicit Triangles(const fs::path& file)
    : File(file)
  {
    this->Coordinates->SetNumberOfComponents(3);
  }

  void add(const std::array<StlCorner, 3>& corners)
  {
    ++this->Count;
    std::array<vtkIdType, 3> ids;
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (const float coordinate : corners[i])
      {
        if (!std::isfinite(coordinate))
        {
          failToRead(this->File,
            "a coordinate of triangle " + std::to_string(this->Count) + " is " + std::to_string(coordinate) +
              "; expected finite numbers");
        }
      }
      const auto [known, isNew] = this->Ids.try_emplace(corners[i], this->Coordinates->GetNumberOfTuples());
      if (isNew)
      {
        this->Coordinates->InsertNextTypedTuple(corners[i].data());
      }
      ids[i] = known->second;
    }
    if (ids[0] != ids[1] && ids[1] != ids[2] && ids[2] != ids[0])
    {
      this->Polygons->InsertNextCell(3, ids.data());
    }
  }

  vtkSmartPointer<vtkPolyData> take()
  {
    vtkNew<vtkPoints> points;
    points->SetData(this->Coordinates);
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    mesh->SetPoints(points);
    mesh->SetPolys(this->Polygons);
    return mesh;
  }

private:
  const fs::path& File;
  std::uint64_t Count = 0;
  std::unordered_map<StlCorner, vtkIdType, StlCornerHash> Ids;
  vtkNew<vtkFloatArray> Coordinates;
  vtkNew<vtkCellArray> Polygons;
};

std::uint32_t integerAt(const char* bytes)
{
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i)
  {
    value = value << 8 | static_cast<unsigned char>(bytes[i]);
  }
  return value;
}

constexpr std::size_t headerSize = 84;
constexpr std::size_t triangleSize = 50;
constexpr std::uint64_t trianglesOfAStep = 1 << 16;

void readBinary(std::string_view bytes, const fs::path& file, Triangles& triangles, const Progress& progress)
{
  const std::uint64_t count = bytes.size() < headerSize ? 0 : integerAt(bytes.data() + headerSize - 4);
  if (count == 0)
  {
    failToRead(file, "it holds no triangles");
  }
  const std::uint64_t expected = headerSize + count * triangleSize;
  if (bytes.size() < expected)
  {
    failToRead(file,
      "it has " + std::to_string(bytes.size()) + " bytes, but " + std::to_string(count) +
        " triangles of a binary STL need " + std::to_string(expected));
  }
  for (std::uint64_t i = 0; i < count; ++i)
  {
    if (i % trianglesOfAStep == 0)
    {
      advance(progress, static_cast<double>(i) / static_cast<double>(count));
    }
    // A normal, which is not used, the corners, and two bytes for anything.
    const char* corner = bytes.data() + headerSize + i * triangleSize + sizeof(StlCorner);
    std::array<StlCorner, 3> corners;
    for (StlCorner& to : corners)
    {
      for (float& coordinate : to)
      {
        coordinate = std::bit_cast<float>(integerAt(corner));
        corner += sizeof(float);
      }
    }
    triangles.add(corners);
  }
}

bool isWord(std::string_view word, std::string_view expected)
{
  return std::equal(word.begin(), word.end(), expected.begin(), expected.end(),
    [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

/// The words of an STL text one after the other.
class StlWords
{
public:
  StlWords(std::string_view text, const fs::path& file)
    : Text(text)
    , File(file)
  {
  }

  std::size_t left() const { return this->Text.size(); }
  std::string_view next() { return nextWord(this->Text); }
  void skipLine()
  {
    std::string_view line;
    nextLine(this->Text, line);
  }
  void expect(std::string_view expected)
  {
    const std::string_view word = this->next();
    if (!isWord(word, expected))
    {
      this->fail(word, std::string(expected));
    }
  }
  float number()
  {
    const std::string_view word = this->next();
    const std::optional<double> number = numberIn(word);
    if (!number)
    {
      this->fail(word, "a number");
    }
    return static_cast<float>(*number);
  }
  [[noreturn]] void fail(std::string_view word, const std::string& expected)
  {
    failToRead(this->File,
      (word.empty() ? std::string("the file ends") : "it says '" + shortened(word) + "'") + " where '" +
        expected + "' was expected");
  }

private:
  std::string_view Text;
  const fs::path& File;
};

/// One or more solids.
void readText(std::string_view text, const fs::path& file, Triangles& triangles, const Progress& progress)
{
  StlWords words(text, file);
  std::uint64_t count = 0;
  for (std::string_view word = words.next(); !word.empty(); word = words.next())
  {
    if (!isWord(word, "solid"))
    {
      words.fail(word, "solid");
    }
    // Its name, which may be anything, and perhaps a color.
    words.skipLine();
    for (word = words.next(); !isWord(word, "endsolid"); word = words.next())
    {
      if (isWord(word, "color"))
      {
        words.skipLine();
        continue;
      }
      if (!isWord(word, "facet"))
      {
        words.fail(word, "facet or endsolid");
      }
      if (count++ % trianglesOfAStep == 0)
      {
        advance(progress, 1.0 - static_cast<double>(words.left()) / static_cast<double>(text.size()));
      }
      // Its normal, which is not used and which some programs leave out.
      words.skipLine();
      words.expect("outer");
      words.expect("loop");
      std::array<StlCorner, 3> corners;
      for (StlCorner& corner : corners)
      {
        words.expect("vertex");
        for (float& coordinate : corner)
        {
          coordinate = words.number();
        }
      }
      words.expect("endloop");
      words.expect("endfacet");
      triangles.add(corners);
    }
    words.skipLine();
  }
}

/// Binary files may start with "solid" as well, but not go on with printable text.
bool isText(std::string_view bytes)
{
  std::string_view rest = bytes.substr(0, headerSize);
  return std::none_of(rest.begin(), rest.end(),
           [](unsigned char c) { return c < ' ' && c != '\n' && c != '\r' && c != '\t'; }) &&
    isWord(nextWord(rest), "solid");
}

} // namespace

vtkSmartPointer<vtkPolyData> readStl(
  const fs::path& file, std::vector<std::string>&, const Progress& progress)
{
  const std::string bytes = contentsOf(file);
  Triangles triangles(file);
  if (isText(bytes))
  {
    readText(bytes, file, triangles, progress);
  }
  else
  {
    readBinary(bytes, file, triangles, progress);
  }
  return triangles.take();
}

} // namespace ink::io
