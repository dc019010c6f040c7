// SPDX-License-Identifier: BSD-3-Clause
// GIFTI surfaces, https://www.nitrc.org/projects/gifti, format 1.0.
#include "MeshFiles.h"

#include "Core/FormatNumber.h"
#include "GiftiFile.h"
#include "NumberTypes.h"
#include "ReadError.h"
#include "Words.h"

#include "vtkBase64Utilities.h"
#include "vtkByteSwap.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtk_zlib.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

constexpr std::string_view pointIntent = "NIFTI_INTENT_POINTSET";
constexpr std::string_view triangleIntent = "NIFTI_INTENT_TRIANGLE";

/// The numbers of an array of a GIFTI file.
class GiftiNumbers
{
public:
  /// @throws ReadError if it does not say how many there are
  GiftiNumbers(const fs::path& file, GiftiArray& array)
    : File(file)
    , Array(array)
  {
    constexpr double mostAxes = 6;
    const double axes = this->whole("Dimensionality", mostAxes);
    for (int axis = 0; axis < static_cast<int>(axes); ++axis)
    {
      // More than any file has, and their product is no infinity.
      constexpr double most = 1e15;
      const double size = this->whole("Dim" + std::to_string(axis), most);
      (axis == 0 ? this->Rows : this->Columns) *= size;
    }
  }

  double rows() const { return this->Rows; }
  double columns() const { return this->Columns; }

  [[noreturn]] void fail(const std::string& problem) const
  {
    failToRead(this->File, "its array '" + shortened(this->Array.intent()) + "' " + problem);
  }

  [[noreturn]] void failAt(const std::string& attribute, const std::string& expected) const
  {
    this->fail(
      "says " + attribute + " '" + shortened(this->Array.attribute(attribute)) + "'; expected " + expected);
  }

  /// A tuple for each row. The text of the array is gone then. @throws ReadError if there are not just as
  /// many numbers as it says
  vtkSmartPointer<vtkDataArray> take()
  {
    this->Numbers = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(this->type()));
    this->Text = std::move(this->Array.text);
    const bool isCompressed = this->says("Encoding", "GZipBase64Binary", "GIFTI_ENCODING_B64GZ");
    if (this->says("Encoding", "ASCII", "GIFTI_ENCODING_ASCII"))
    {
      this->readText();
    }
    else if (isCompressed || this->says("Encoding", "Base64Binary", "GIFTI_ENCODING_B64BIN"))
    {
      this->readBytes(isCompressed);
    }
    else
    {
      const std::string other(this->Array.attribute("ExternalFileName"));
      this->failAt("Encoding",
        "ASCII, Base64Binary or GZipBase64Binary" +
          (other.empty() ? "" : ", not numbers in the file '" + shortened(other) + "'"));
    }
    this->order();
    return this->Numbers;
  }

private:
  /// An attribute that is one. @throws ReadError if it is none
  double whole(const std::string& attribute, double most) const
  {
    const std::optional<double> number = numberIn(this->Array.attribute(attribute));
    if (!number || !(*number >= 0.0 && *number <= most) || *number != std::floor(*number))
    {
      this->failAt(attribute, "a whole number from 0 to " + formatNumber(most));
    }
    return *number;
  }

  /// Whether an attribute is a word of the format, or the one that old versions of nibabel write for it.
  bool says(std::string_view attribute, std::string_view word, std::string_view old) const
  {
    const std::string_view said = this->Array.attribute(attribute);
    return said == word || said == old;
  }

  int type() const
  {
    constexpr std::string_view prefix = "NIFTI_TYPE_";
    const std::string_view said = this->Array.attribute("DataType");
    const auto found = said.starts_with(prefix)
      ? numberTypes().find(vtksys::SystemTools::LowerCase(std::string(said.substr(prefix.size()))))
      : numberTypes().end();
    if (found == numberTypes().end())
    {
      this->failAt("DataType", "NIFTI_TYPE_ and one of " + vtksys::SystemTools::UpperCase(listNumberTypes()));
    }
    return found->second;
  }

  double count() const { return this->Rows * this->Columns; }

  /// Makes room. @param most numbers that what there is can be @param there is what there is
  void makeRoom(double most, const std::string& there)
  {
    if (this->count() > most)
    {
      this->fail("has " + there + ", too few for the " + formatNumber(this->Rows) + " x " +
        formatNumber(this->Columns) + " numbers that it promises");
    }
    this->Numbers->SetNumberOfTuples(static_cast<vtkIdType>(this->count()));
  }

  void readText()
  {
    // A digit and a space each.
    this->makeRoom(
      static_cast<double>(this->Text.size() / 2 + 1), std::to_string(this->Text.size()) + " characters");
    std::string_view rest = this->Text;
    const vtkIdType count = this->Numbers->GetNumberOfTuples();
    for (vtkIdType i = 0; i < count; ++i)
    {
      const std::string_view word = nextWord(rest);
      const std::optional<double> number = numberIn(word);
      if (!number)
      {
        this->fail((word.empty() ? "ends" : "says '" + shortened(word) + "'") + " where number " +
          std::to_string(i + 1) + " of " + std::to_string(count) + " was expected");
      }
      if (!isNumberOf(this->Numbers->GetDataType(), *number))
      {
        this->fail("says '" + shortened(word) + "'; expected a number of its DataType '" +
          std::string(this->Array.attribute("DataType")) + "'");
      }
      this->Numbers->SetComponent(i, 0, *number);
    }
    if (const std::string_view word = nextWord(rest); !word.empty())
    {
      this->fail(
        "says '" + shortened(word) + "' after the " + std::to_string(count) + " numbers that it promises");
    }
  }

  void readBytes(bool isCompressed)
  {
    std::erase_if(this->Text, [](unsigned char c) { return std::isspace(c) != 0; });
    const auto size = static_cast<double>(this->Numbers->GetDataTypeSize());
    // zlib makes at most that many bytes of one.
    constexpr double mostOfCompressed = 1032;
    const double decoded = static_cast<double>(this->Text.size() / 4 * 3);
    this->makeRoom((isCompressed ? mostOfCompressed : 1.0) * decoded / size,
      std::to_string(this->Text.size()) + " characters" + (isCompressed ? " of compressed numbers" : ""));
    if (this->count() == 0.0)
    {
      return;
    }
    auto* bytes = static_cast<unsigned char*>(this->Numbers->GetVoidPointer(0));
    const auto needed = static_cast<std::size_t>(this->count() * size);
    if (isCompressed)
    {
      this->inflate(bytes, needed);
    }
    else if (const std::size_t found = this->decode(bytes, needed);
             found < needed || this->Text.size() / 4 * 3 > needed + 2)
    {
      this->fail("has " + std::to_string(this->Text.size()) + " characters, of which " +
        std::to_string(found) + " bytes of Base64 can be used; expected " + std::to_string(needed));
    }
    const bool isBig = this->says("Endian", "BigEndian", "GIFTI_ENDIAN_BIG");
    if (!isBig && !this->says("Endian", "LittleEndian", "GIFTI_ENDIAN_LITTLE"))
    {
      this->failAt("Endian", "LittleEndian or BigEndian");
    }
    if (size > 1.0 && isBig != (std::endian::native == std::endian::big))
    {
      vtkByteSwap::SwapVoidRange(
        bytes, static_cast<std::size_t>(this->count()), static_cast<std::size_t>(size));
    }
  }

  /// @return how many bytes there were
  std::size_t decode(unsigned char* bytes, std::size_t most) const
  {
    return vtkBase64Utilities::DecodeSafely(
      reinterpret_cast<const unsigned char*>(this->Text.data()), this->Text.size(), bytes, most);
  }

  void inflate(unsigned char* bytes, std::size_t needed)
  {
    std::vector<unsigned char> compressed(this->Text.size() / 4 * 3);
    compressed.resize(this->decode(compressed.data(), compressed.size()));
    auto made = static_cast<uLongf>(needed);
    const int result = uncompress(bytes, &made, compressed.data(), static_cast<uLong>(compressed.size()));
    if (result != Z_OK || made != needed)
    {
      this->fail(result == Z_BUF_ERROR || result == Z_OK
          ? "has compressed numbers that are not the " + std::to_string(needed) + " bytes which it promises"
          : "has compressed numbers that are broken");
    }
  }

  /// Makes a tuple of each row.
  void order()
  {
    const std::string_view order = this->Array.attribute("ArrayIndexingOrder");
    if (order != "RowMajorOrder" && order != "ColumnMajorOrder")
    {
      this->failAt("ArrayIndexingOrder", "RowMajorOrder or ColumnMajorOrder");
    }
    const auto columns = static_cast<vtkIdType>(this->Columns);
    if (order == "ColumnMajorOrder")
    {
      const auto rows = static_cast<vtkIdType>(this->Rows);
      const vtkIdType size = this->Numbers->GetDataTypeSize();
      auto ordered = vtk::TakeSmartPointer(this->Numbers->NewInstance());
      ordered->SetNumberOfTuples(rows * columns);
      const auto* from = static_cast<const char*>(this->Numbers->GetVoidPointer(0));
      auto* to = static_cast<char*>(ordered->GetVoidPointer(0));
      for (vtkIdType i = 0; i < rows * columns; ++i)
      {
        std::copy_n(from + i * size, size, to + (i % rows * columns + i / rows) * size);
      }
      this->Numbers = ordered;
    }
    this->Numbers->SetNumberOfComponents(static_cast<int>(columns));
  }

  const fs::path& File;
  GiftiArray& Array;
  double Rows = 1.0;
  double Columns = 1.0;
  std::string Text;
  vtkSmartPointer<vtkDataArray> Numbers;
};

/// What arrays are for, each kind once.
std::string intentsOf(const std::vector<GiftiArray>& arrays)
{
  std::vector<std::string> intents;
  std::string list;
  for (const GiftiArray& array : arrays)
  {
    const std::string intent = shortened(array.intent());
    if (std::find(intents.begin(), intents.end(), intent) == intents.end())
    {
      intents.push_back(intent);
      list += (list.empty() ? "" : ", ") + intent;
    }
  }
  return list.empty() ? "none" : list;
}

/// Takes the first array that is for something, three numbers in a row; null if there is none.
vtkSmartPointer<vtkDataArray> takeTriples(
  std::vector<GiftiArray>& arrays, std::string_view intent, const fs::path& file)
{
  const auto found = std::find_if(
    arrays.begin(), arrays.end(), [intent](const GiftiArray& array) { return array.intent() == intent; });
  if (found == arrays.end())
  {
    return nullptr;
  }
  GiftiNumbers numbers(file, *found);
  if (numbers.columns() != 3.0)
  {
    numbers.fail("has " + formatNumber(numbers.rows()) + " x " + formatNumber(numbers.columns()) +
      " numbers; expected three in a row");
  }
  vtkSmartPointer<vtkDataArray> triples = numbers.take();
  if (intent == pointIntent && triples->GetDataType() != VTK_FLOAT && triples->GetDataType() != VTK_DOUBLE)
  {
    numbers.failAt("DataType", "NIFTI_TYPE_FLOAT32");
  }
  arrays.erase(found);
  return triples;
}

vtkSmartPointer<vtkCellArray> makeTriangles(vtkDataArray* corners, vtkIdType points, const fs::path& file)
{
  auto triangles = vtkSmartPointer<vtkCellArray>::New();
  triangles->AllocateExact(corners->GetNumberOfTuples(), 3 * corners->GetNumberOfTuples());
  for (vtkIdType i = 0; i < corners->GetNumberOfTuples(); ++i)
  {
    std::array<double, 3> numbers;
    corners->GetTuple(i, numbers.data());
    std::array<vtkIdType, 3> ids;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const double number = numbers[corner];
      if (!(number >= 0.0 && number < static_cast<double>(points)) || number != std::floor(number))
      {
        failToRead(file,
          "triangle " + std::to_string(i) + " has point " + formatNumber(number) + ", but there are " +
            std::to_string(points) + " points, counted from 0");
      }
      ids[corner] = static_cast<vtkIdType>(number);
    }
    triangles->InsertNextCell(3, ids.data());
  }
  return triangles;
}

/// The name of a point array: that of its metadata, or as "shape" of what it is for.
std::string arrayNameOf(const GiftiArray& array)
{
  const std::string intent(array.intent());
  constexpr std::string_view prefix = "NIFTI_INTENT_";
  return !array.name.empty()
    ? array.name
    : vtksys::SystemTools::LowerCase(intent.starts_with(prefix) ? intent.substr(prefix.size()) : intent);
}

/// Takes the arrays of one number a point, or of three; leaves others.
void takePointArrays(std::vector<GiftiArray>& arrays, vtkPolyData* mesh, const fs::path& file)
{
  vtkPointData* pointData = mesh->GetPointData();
  const auto take = [&](GiftiArray& array)
  {
    const std::string name = arrayNameOf(array);
    GiftiNumbers numbers(file, array);
    if (array.intent() == pointIntent || array.intent() == triangleIntent ||
      array.intent() == "NIFTI_INTENT_NODE_INDEX" ||
      numbers.rows() != static_cast<double>(mesh->GetNumberOfPoints()) ||
      (numbers.columns() != 1.0 && numbers.columns() != 3.0) || name.empty() ||
      name == vtkDataSetAttributes::GhostArrayName() || pointData->HasArray(name.c_str()))
    {
      return false;
    }
    const vtkSmartPointer<vtkDataArray> values = numbers.take();
    values->SetName(name.c_str());
    pointData->AddArray(values);
    return true;
  };
  // Not std::erase_if, which may ask twice.
  std::vector<GiftiArray> left;
  for (GiftiArray& array : arrays)
  {
    if (!take(array))
    {
      left.push_back(std::move(array));
    }
  }
  arrays = std::move(left);
}

} // namespace

vtkSmartPointer<vtkPolyData> readGifti(
  const fs::path& file, std::vector<std::string>& notes, const Progress& progress)
{
  std::vector<GiftiArray> arrays = giftiArrays(file, progress);
  const vtkSmartPointer<vtkDataArray> coordinates = takeTriples(arrays, pointIntent, file);
  if (!coordinates)
  {
    failToRead(file,
      "it holds no points; its arrays: " + intentsOf(arrays) +
        "; expected NIFTI_INTENT_POINTSET, as surfaces (.surf.gii) have it");
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  if (const auto corners = takeTriples(arrays, triangleIntent, file))
  {
    mesh->SetPolys(makeTriangles(corners, mesh->GetNumberOfPoints(), file));
  }
  else
  {
    notes.emplace_back("it holds points without triangles (NIFTI_INTENT_TRIANGLE)");
  }
  takePointArrays(arrays, mesh, file);
  if (!arrays.empty())
  {
    notes.push_back(std::to_string(arrays.size()) + " of its arrays are not used: " + intentsOf(arrays));
  }
  return mesh;
}

} // namespace ink::io
