// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFiles.h"

#include "ReadError.h"
#include "ReaderProgress.h"
#include "VtkMessages.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataReader.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <new>
#include <sstream>

namespace ink::io
{

namespace
{

std::string lowered(std::string text)
{
  for (char& c : text)
  {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return text;
}

/// A file's first lines, as far as they are text: version, title, encoding, dataset and the first section.
/// Lower case.
std::string startOf(const std::filesystem::path& file)
{
  std::ifstream in(file, std::ios::binary);
  std::string start(4096, '\0');
  in.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(in.gcount()));
  for (int line = 0; line < 2; ++line)
  {
    // A title may be anything.
    const std::size_t end = start.find('\n');
    start.erase(0, end == std::string::npos ? end : end + 1);
  }
  return lowered(start);
}

/// The sections of a file before its arrays, as far as VTK believes them.
///
/// Faults: VTK makes room for as many points as a file says, whatever its length; and of cells in the format
/// before version 5, a list of "count, ids" each, it reads as many ids as a count says.
class LegacySections
{
public:
  explicit LegacySections(const std::filesystem::path& file)
    : File(file)
    , Stream(file, std::ios::binary)
    , Bytes(static_cast<double>(std::filesystem::file_size(file)))
  {
  }

  void check()
  {
    std::string line;
    std::getline(this->Stream, line);
    const bool hasCounts = line.find("Version 5") == std::string::npos;
    std::getline(this->Stream, line); // the title
    std::getline(this->Stream, line);
    this->IsText = lowered(line).starts_with("ascii");
    while (std::getline(this->Stream, line))
    {
      std::istringstream words(lowered(line));
      std::string keyword;
      words >> keyword;
      if (keyword == "points")
      {
        this->passPoints(words);
      }
      else if (keyword == "point_data" || keyword == "cell_data")
      {
        return;
      }
      else if (hasCounts &&
        (keyword == "vertices" || keyword == "lines" || keyword == "polygons" ||
          keyword == "triangle_strips"))
      {
        this->checkCells(words);
      }
    }
  }

private:
  /// A number of values that there are bytes for. @param least bytes of each
  double readCount(std::istream& words, double least) const
  {
    double count = -1.0;
    words >> count;
    if (!(count >= 0.0 && least * count <= this->Bytes))
    {
      failToRead(this->File, "it says that it has more points or cells than there are bytes for");
    }
    return count;
  }

  void passPoints(std::istream& words)
  {
    const double count = this->readCount(words, 3.0);
    std::string type;
    words >> type;
    if (this->IsText)
    {
      double number = 0.0;
      for (double i = 0; i < 3.0 * count && this->Stream >> number; ++i)
      {
      }
      return;
    }
    const bool isShort = type.ends_with("short");
    const double size = type == "double" || type.ends_with("long") ? 8.0
      : isShort                                                    ? 2.0
      : type.ends_with("char")                                     ? 1.0
                                                                   : 4.0;
    this->Stream.seekg(static_cast<std::streamoff>(3.0 * count * size), std::ios::cur);
  }

  std::int64_t readInteger()
  {
    std::int64_t number = -1;
    if (this->IsText)
    {
      this->Stream >> number;
    }
    else if (std::array<unsigned char, 4> bytes{};
             this->Stream.read(reinterpret_cast<char*>(bytes.data()), 4))
    {
      number = static_cast<std::int32_t>(static_cast<std::uint32_t>(bytes[0]) << 24 |
        static_cast<std::uint32_t>(bytes[1]) << 16 | static_cast<std::uint32_t>(bytes[2]) << 8 | bytes[3]);
    }
    return this->Stream ? number : -1;
  }

  void checkCells(std::istream& words)
  {
    const double cells = this->readCount(words, 1.0);
    double left = this->readCount(words, 1.0);
    for (double cell = 0; cell < cells; ++cell)
    {
      const std::int64_t points = this->readInteger();
      left -= 1.0 + static_cast<double>(points);
      if (points < 0 || left < 0.0)
      {
        failToRead(this->File, "its cells say that they have more points than they have");
      }
      for (std::int64_t i = 0; i < points; ++i)
      {
        this->readInteger();
      }
    }
    if (left > 0.0)
    {
      failToRead(this->File, "its cells say that they have fewer points than they have");
    }
  }

  const std::filesystem::path& File;
  std::ifstream Stream;
  double Bytes;
  bool IsText = false;
};

} // namespace

bool isLegacyMesh(const std::filesystem::path& file)
{
  std::istringstream words(startOf(file));
  std::string encoding;
  std::string keyword;
  std::string kind;
  words >> encoding >> keyword >> kind;
  return keyword == "dataset" && kind == "polydata";
}

vtkSmartPointer<vtkPolyData> readLegacyMesh(
  const std::filesystem::path& file, std::vector<std::string>&, const Progress& progress)
{
  if (!isLegacyMesh(file))
  {
    failToRead(file, "it is not a legacy VTK file of a mesh; expected DATASET POLYDATA");
  }
  LegacySections(file).check();
  vtkNew<vtkPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllNormalsOn();
  const ReaderProgress reporting(reader, progress);
  const VtkMessages messages;
  vtkNew<vtkPolyData> mesh;
  bool whole = false;
  try
  {
    whole = reader->ReadMeshSimple(file.string(), mesh) != 0;
  }
  catch (const std::bad_alloc&)
  {
    failToRead(file, "there is not enough memory for what it says that it has");
  }
  if (reporting.aborted())
  {
    throw ReadAborted();
  }
  if (const std::string problem = messages.error(); !problem.empty() || !whole)
  {
    failToRead(file, problem.empty() ? "it is damaged" : problem);
  }
  return mesh;
}

} // namespace ink::io
