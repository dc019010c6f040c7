// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFiles.h"

#include "ReadError.h"
#include "Words.h"

#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cmath>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace fs = std::filesystem;

namespace ink::io
{
namespace
{

constexpr std::string_view separators = " \t\r,;";
constexpr std::size_t positionColumns = 3;
constexpr std::size_t normalColumns = 6;
// Normals are written with few digits.
constexpr double unitLength = 0.01;

/// The numbers of a line; false if there is anything else in it.
bool numbersOf(std::string_view line, std::vector<double>& numbers)
{
  numbers.clear();
  for (;;)
  {
    const std::size_t begin = line.find_first_not_of(separators);
    if (begin == std::string_view::npos)
    {
      return true;
    }
    line.remove_prefix(begin);
    const std::string_view word = line.substr(0, line.find_first_of(separators));
    const std::optional<double> number = numberIn(word);
    if (!number)
    {
      return false;
    }
    numbers.push_back(*number);
    line.remove_prefix(word.size());
  }
}

/// Other columns than normals' are colors or intensities, whose length is hardly ever 1.
bool canBeNormal(const double* vector)
{
  const double length = std::hypot(vector[0], vector[1], vector[2]);
  return length == 0.0 || std::abs(length - 1.0) <= unitLength;
}

} // namespace

vtkSmartPointer<vtkPolyData> readXyz(
  const fs::path& file, std::vector<std::string>& notes, const Progress& progress)
{
  const auto size = static_cast<double>(fs::file_size(file));
  std::ifstream stream(file);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  bool haveNormals = true;
  std::size_t columns = 0;
  std::vector<double> numbers;
  std::string line;
  for (long long number = 1; std::getline(stream, line); ++number)
  {
    constexpr long long linesOfAStep = 1 << 16;
    if (number % linesOfAStep == 0)
    {
      advance(progress, static_cast<double>(stream.tellg()) / size);
    }
    const std::size_t begin = line.find_first_not_of(separators);
    if (begin == std::string::npos || line[begin] == '#')
    {
      continue;
    }
    const bool valid = numbersOf(line, numbers);
    if (!valid || numbers.size() < positionColumns || (columns > 0 && numbers.size() != columns))
    {
      failToRead(file,
        "line " + std::to_string(number) + " is '" + shortened(line) + "'; expected " +
          (columns > 0 ? std::to_string(columns) + " numbers as in the lines before"
                       : std::string("x, y and z, and perhaps a normal")));
    }
    columns = numbers.size();
    points->InsertNextPoint(numbers.data());
    haveNormals = haveNormals && columns == normalColumns && canBeNormal(numbers.data() + positionColumns);
    if (haveNormals)
    {
      normals->InsertNextTuple(numbers.data() + positionColumns);
    }
  }
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  cloud->SetPoints(points);
  if (haveNormals)
  {
    cloud->GetPointData()->SetNormals(normals);
  }
  else if (columns > positionColumns)
  {
    notes.push_back("of the " + std::to_string(columns) +
      " columns only x, y and z are used; normals would be three more, of length 1");
  }
  return cloud;
}

} // namespace ink::io
