// SPDX-License-Identifier: BSD-3-Clause
#include "Volume.h"

#include "Progress.h"
#include "VolumeSlices.h"

#include "IsoSurface/ActiveCellBound.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSetGet.h"

#include <algorithm>
#include <span>
#include <stdexcept>

namespace ink::cli
{
namespace
{

template <typename T>
std::span<const T> valuesOf(vtkImageData* slices)
{
  vtkDataArray* scalars = slices->GetPointData()->GetScalars();
  return { static_cast<const T*>(scalars->GetVoidPointer(0)),
    static_cast<std::size_t>(scalars->GetNumberOfValues()) };
}

/// Calls use(T()) with the type of a volume's values.
template <typename Use>
auto withType(int type, const Use& use) -> decltype(use(0.0))
{
  switch (type)
  {
    vtkTemplateMacro(return use(VTK_TT()));
  }
  throw std::invalid_argument("a volume of VTK's type " + std::to_string(type));
}

} // namespace

std::vector<IsoSuggestion> suggestIsoValues(VolumeSlices& volume, Progress& progress)
{
  return withType(volume.type(),
    [&](auto zero)
    {
      using T = decltype(zero);
      if (volume.inMemory())
      {
        return ink::suggestIsoValues(valuesOf<T>(volume.frame()), volume.dimensions());
      }
      // The slices are read twice, each time from the first on; and twice more if they have to be smoothed.
      constexpr double passes = 2.0;
      double pass = -1.0;
      const SliceReader<T> read = [&](int first, int end)
      {
        pass += first == 0 ? 1.0 : 0.0;
        const double done = (pass + static_cast<double>(first) / volume.dimensions()[2]) / passes;
        progress.part(std::min(done, 1.0), 1.0);
        // The slices themselves stay where they are when the image that shows them goes.
        return valuesOf<T>(volume.get(first, end));
      };
      return ink::suggestIsoValues(read, volume.dimensions(), std::max(volume.atOnce(), 3));
    });
}

FiniteRange findFiniteRange(VolumeSlices& volume)
{
  FiniteRange all;
  const int count = volume.dimensions()[2];
  for (int first = 0; first < count; first += volume.atOnce())
  {
    all.add(findFiniteRange(volume.get(first, std::min(first + volume.atOnce(), count))));
  }
  return all;
}

FiniteRange findFiniteRange(vtkImageData* slices)
{
  return withType(slices->GetScalarType(),
    [slices](auto zero) { return ink::findFiniteRange(valuesOf<decltype(zero)>(slices)); });
}

std::vector<std::size_t> boundActiveCells(vtkImageData* slices, double isoValue, CrossingRule rule)
{
  const int* d = slices->GetDimensions();
  return withType(slices->GetScalarType(),
    [&](auto zero) {
      return ink::boundActiveCells(valuesOf<decltype(zero)>(slices), { d[0], d[1], d[2] }, isoValue, rule);
    });
}

} // namespace ink::cli
