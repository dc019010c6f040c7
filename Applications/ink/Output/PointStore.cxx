// SPDX-License-Identifier: BSD-3-Clause
#include "PointStore.h"

#include "Errors.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace ink::cli
{
namespace
{

vtkDataArray* arrayOf(vtkPolyData* points, std::size_t index)
{
  return index == 0 ? points->GetPoints()->GetData()
                    : points->GetPointData()->GetArray(static_cast<int>(index - 1));
}

/// Array `index` of the points, which lies in one piece in memory.
std::span<const unsigned char> bytesOf(vtkPolyData* points, std::size_t index, const PointStore::Array& array)
{
  return { static_cast<const unsigned char*>(arrayOf(points, index)->GetVoidPointer(0)),
    static_cast<std::size_t>(points->GetNumberOfPoints()) * array.tupleSize() };
}

[[noreturn]] void fail(const std::filesystem::path& folder, int error)
{
  throw Failure("cannot keep points in a temporary file in '" + folder.string() +
    "': " + (error ? std::strerror(error) : "it was cut short"));
}

} // namespace

std::size_t PointStore::Array::tupleSize() const
{
  return static_cast<std::size_t>(this->components) * vtkAbstractArray::GetDataTypeSize(this->type);
}

PointStore::PointStore(std::uint64_t memory, std::filesystem::path folder)
  : Memory(memory)
  , Folder(std::move(folder))
{
}

void PointStore::add(int surface, vtkPolyData* points)
{
  const auto count = static_cast<std::uint64_t>(points->GetNumberOfPoints());
  if (count == 0)
  {
    return;
  }
  std::vector<Array> arrays;
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(points->GetPointData()->GetNumberOfArrays()); ++i)
  {
    vtkDataArray* array = arrayOf(points, i);
    arrays.push_back(
      { i == 0 ? "Points" : array->GetName(), array->GetDataType(), array->GetNumberOfComponents() });
    bytes += count * arrays.back().tupleSize();
  }
  if (!this->Arrays.empty() && arrays != this->Arrays)
  {
    throw std::invalid_argument("PointStore: parts with different arrays");
  }
  this->Arrays = std::move(arrays);
  this->Field = points->GetFieldData();

  Part part{ surface, count, nullptr, this->FileSize };
  if (this->Kept + bytes <= this->Memory)
  {
    part.points = vtkSmartPointer<vtkPolyData>::New();
    part.points->ShallowCopy(points);
    this->Kept += bytes;
  }
  else
  {
    this->writePart(points);
  }
  this->Parts.push_back(std::move(part));
  this->Size += count;
}

void PointStore::writePart(vtkPolyData* points)
{
  if (this->File.get() < 0)
  {
    this->File = io::openUnnamed(this->Folder);
  }
  for (std::size_t i = 0; i < this->Arrays.size(); ++i)
  {
    const auto bytes = bytesOf(points, i, this->Arrays[i]);
    if (this->File.get() < 0 || !io::writeAll(this->File.get(), bytes))
    {
      fail(this->Folder, errno);
    }
    this->FileSize += bytes.size();
  }
}

void PointStore::forEachBlock(
  std::span<const std::size_t> wanted, const std::function<void(const Block&)>& use) const
{
  int surfaces = 0;
  for (const Part& part : this->Parts)
  {
    surfaces = std::max(surfaces, part.surface + 1);
  }
  for (int surface = 0; surface < surfaces; ++surface)
  {
    for (const Part& part : this->Parts)
    {
      if (part.surface == surface)
      {
        this->useBlocks(part, wanted, use);
      }
    }
  }
}

vtkSmartPointer<vtkPolyData> PointStore::take() const
{
  if (this->Parts.size() == 1 && this->Parts[0].points)
  {
    return this->Parts[0].points;
  }
  auto all = vtkSmartPointer<vtkPolyData>::New();
  for (std::size_t i = 0; i < this->Arrays.size(); ++i)
  {
    vtkSmartPointer<vtkDataArray> array =
      vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(this->Arrays[i].type));
    array->SetName(this->Arrays[i].name.c_str());
    array->SetNumberOfComponents(this->Arrays[i].components);
    array->SetNumberOfTuples(static_cast<vtkIdType>(this->Size));
    auto* value = static_cast<unsigned char*>(array->GetVoidPointer(0));
    this->forEachBlock(std::span(&i, 1),
      [&](const Block& block)
      { value = std::copy_n(block.values[0], block.count * this->Arrays[i].tupleSize(), value); });
    if (i == 0)
    {
      vtkNew<vtkPoints> points;
      points->SetData(array);
      all->SetPoints(points);
    }
    else if (this->Arrays[i].isNormals())
    {
      all->GetPointData()->SetNormals(array);
    }
    else
    {
      all->GetPointData()->AddArray(array);
    }
  }
  if (this->Field)
  {
    all->SetFieldData(this->Field);
  }
  return all;
}

void PointStore::useBlocks(
  const Part& part, std::span<const std::size_t> wanted, const std::function<void(const Block&)>& use) const
{
  std::vector<std::vector<unsigned char>> buffers(wanted.size());
  for (std::uint64_t first = 0; first < part.count; first += blockSize)
  {
    Block block;
    block.count = static_cast<std::size_t>(std::min<std::uint64_t>(blockSize, part.count - first));
    for (std::size_t n = 0; n < wanted.size(); ++n)
    {
      const std::size_t tuple = this->Arrays[wanted[n]].tupleSize();
      if (part.points)
      {
        block.values.push_back(
          bytesOf(part.points, wanted[n], this->Arrays[wanted[n]]).subspan(first * tuple).data());
        continue;
      }
      std::uint64_t position = part.position + first * tuple;
      for (std::size_t before = 0; before < wanted[n]; ++before)
      {
        position += part.count * this->Arrays[before].tupleSize();
      }
      buffers[n].resize(block.count * tuple);
      if (io::readAt(this->File.get(), position, buffers[n]) != buffers[n].size())
      {
        fail(this->Folder, errno);
      }
      block.values.push_back(buffers[n].data());
    }
    use(block);
  }
}

} // namespace ink::cli
