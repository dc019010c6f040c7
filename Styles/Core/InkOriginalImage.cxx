// SPDX-License-Identifier: BSD-3-Clause
#include "InkOriginalImage.h"

#include "InkActiveScalars.h"
#include "InkOriginalSamples.h"
#include "InkStyleProcesses.h"

#include "Core/FormatNumber.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <new>
#include <vector>

namespace
{

struct Original
{
  vtkSmartPointer<vtkImageData> Image; ///< null: there is none
  bool WasRepeated = false;            ///< or else slices were interpolated
};

/// @param given which has no arrays of cells but marks of ghosts, where none is hidden
Original FindIn(vtkImageData* given, const InkOriginalImage::Search& search)
{
  vtkNew<vtkImageData> image;
  image->ShallowCopy(given);
  image->GetCellData()->Initialize();
  Original found{ InkWithoutRepeats(image, search.Array), true };
  if (found.Image == image.Get() && search.Slices)
  {
    found = { InkWithoutInterpolatedSlices(image, search.Array), false };
  }
  return found.Image == image.Get() || (found.WasRepeated && !search.Repeats) ? Original{} : found;
}

/// The same, but nothing is found where memory does not suffice: other processes wait for what this one says.
/// @param whole null: none
Original TryToFind(vtkImageData* whole, const InkOriginalImage::Search& search)
{
  try
  {
    return whole ? FindIn(whole, search) : Original{};
  }
  catch (const std::bad_alloc&)
  {
    return {};
  }
}

/// The image that all processes' parts make, with the one array: on the first process, if there is one.
/// @param part null: none here
vtkSmartPointer<vtkImageData> Gather(
  InkStyleProcesses& processes, vtkImageData* part, const std::string& array)
{
  vtkNew<vtkImageData> own;
  if (part)
  {
    own->CopyStructure(part);
    own->GetCellData()->AddArray(part->GetCellGhostArray());
    own->GetPointData()->SetScalars(part->GetPointData()->GetArray(array.c_str()));
  }
  vtkImageData* const images[] = { own };
  const InkWholeImages whole = processes.GatherImages(images);
  return whole.size() == 1 ? whole.front() : nullptr;
}

/// Whether points cannot be left out: where cells have values, other than marks of ghosts, and where some are
/// hidden.
bool KeepsAllPoints(vtkImageData* image)
{
  const int ghosts = image->GetCellGhostArray() ? 1 : 0;
  return image->GetCellData()->GetNumberOfArrays() > ghosts || image->HasAnyBlankCells() ||
    image->HasAnyBlankPoints();
}

Original FindInParts(InkStyleProcesses& processes, vtkImageData* part, const InkOriginalImage::Search& search)
{
  int points = 0;
  std::string array = search.Array;
  if (const auto active = part ? InkWithActiveScalars(part, array) : nullptr)
  {
    vtkDataArray* values = active->GetPointData()->GetScalars();
    array = values && values->GetName() ? values->GetName() : "";
  }
  processes.AgreeOnArray(array, points);
  InkOriginalImage::Search named = search;
  named.Array = array;
  const vtkSmartPointer<vtkImageData> whole = Gather(processes, part, array);
  const Original found = TryToFind(whole, named);
  std::vector<double> isFound{ found.Image ? 1.0 : 0.0 };
  processes.TakeOfFirst(isFound);
  if (isFound[0] == 0.0)
  {
    return {};
  }
  // Only now are the others wanted, which the picture may show as colors.
  const auto names = part ? InkNamesOfValues(part->GetPointData()) : std::vector<std::string>();
  for (std::size_t i = 0;; ++i)
  {
    std::string other = i < names.size() ? names[i] : "";
    processes.AgreeOnArray(other, points);
    if (other.empty())
    {
      break;
    }
    if (const auto more = other == array ? nullptr : Gather(processes, part, other))
    {
      whole->GetPointData()->AddArray(more->GetPointData()->GetScalars());
    }
  }
  return TryToFind(whole, named);
}

} // namespace

bool InkOriginalImage::IsKnown(vtkImageData* image, const Search& search) const
{
  return this->Image == image && this->Time == (image ? image->GetMTime() : 0) && this->Looked == search;
}

bool InkOriginalImage::Find(InkStyleProcesses& processes, vtkDataObject* data, const Search& search)
{
  auto* image = vtkImageData::SafeDownCast(data);
  // Processes have to agree on what they do; one without a part may have any empty data.
  const bool isOther = data && !image && data->GetNumberOfElements(vtkDataObject::POINT) > 0;
  std::array found{ image ? 1.0 : 0.0, isOther || (image && KeepsAllPoints(image)) ? 1.0 : 0.0,
    this->IsKnown(image, search) ? 0.0 : 1.0 };
  processes.TakeGreatest(found);
  const auto [images, unfit, unknown] = found;
  if (images == 0.0 || unfit > 0.0)
  {
    return false;
  }
  if (unknown == 0.0)
  {
    return this->Source != nullptr;
  }
  *this = {};
  const Original original =
    processes.GetNumber() > 1 ? FindInParts(processes, image, search) : FindIn(image, search);
  this->Image = image;
  this->Time = image ? image->GetMTime() : 0;
  this->Looked = search;
  std::vector<double> numbers;
  if (original.Image)
  {
    const int* voxels = original.Image->GetDimensions();
    numbers.assign(voxels, voxels + 3);
    numbers.push_back(original.WasRepeated ? 1.0 : 0.0);
  }
  processes.TakeOfFirst(numbers);
  if (numbers.empty())
  {
    return false;
  }
  int voxels[3];
  std::copy_n(numbers.begin(), 3, voxels);
  const bool wasRepeated = numbers[3] > 0.0;
  this->Note = std::string("the volume was enlarged by ") +
    (wasRepeated ? "repeating voxels" : "interpolating slices") + "; it is drawn as the " +
    ink::formatDimensions(voxels) + " that it was made of; " +
    (wasRepeated ? "LabelMap" : "ShapeBasedInterpolation") + " off draws it as it is";
  this->Source = vtkSmartPointer<vtkTrivialProducer>::New();
  this->Source->SetOutput(original.Image ? original.Image : vtkSmartPointer<vtkImageData>::New());
  return true;
}
