// SPDX-License-Identifier: BSD-3-Clause
#include "InfoCommand.h"

#include "FormatNumber.h"
#include "Progress.h"
#include "Volume.h"
#include "VolumeSlices.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <iomanip>
#include <iostream>

namespace ink::cli
{
namespace
{

void line(const char* name, const std::string& value)
{
  std::cout << std::left << std::setw(15) << name << value << '\n';
}

/// What only all values together tell.
struct Statistics
{
  FiniteRange values;
  std::optional<IsoSuggestion> suggestion;
};

Statistics examine(VolumeSlices& volume, Progress& progress)
{
  progress.step("looking at the values");
  const FiniteRange values = findFiniteRange(volume);
  return { values, suggestIsoValue(volume, progress) };
}

void describeVolume(const VolumeSlices& volume, const Input& input, const Statistics& statistics)
{
  const auto& [values, suggestion] = statistics;
  vtkImageData* image = volume.frame();
  line("dimensions", formatDimensions(image->GetDimensions()));
  line("spacing", formatTriple(image->GetSpacing()));
  line("origin", formatTriple(image->GetOrigin()));
  vtkMatrix3x3* direction = image->GetDirectionMatrix();
  if (!direction->IsIdentity())
  {
    const double* d = direction->GetData();
    line("direction", formatTriple(d) + ", " + formatTriple(d + 3) + ", " + formatTriple(d + 6));
  }
  line("type",
    vtkImageScalarTypeNameMacro(volume.type()) +
      (" (" + std::to_string(8 * vtkDataArray::GetDataTypeSize(volume.type()))) + " bits)");
  line("components", std::to_string(input.components));
  line("range",
    values.least > values.greatest ? "none"
                                   : formatNumber(values.least) + " to " + formatNumber(values.greatest));
  if (values.notFinite > 0)
  {
    line("not finite", std::to_string(values.notFinite) + " voxels");
  }
  if (input.surfaceValue)
  {
    line("suggested iso", formatNumber(*input.surfaceValue) + " (that of the file's surface)");
    return;
  }
  line("suggested iso",
    suggestion ? formatNumber(suggestion->value) + " (" + methodText(*suggestion) + ")"
               : "none: the volume has no two values");
}

void describeMesh(vtkPolyData* mesh)
{
  line("points", std::to_string(mesh->GetNumberOfPoints()));
  line("cells", std::to_string(mesh->GetNumberOfCells()));
  const double* b = mesh->GetBounds();
  line("bounds",
    formatNumber(b[0]) + " to " + formatNumber(b[1]) + ", " + formatNumber(b[2]) + " to " +
      formatNumber(b[3]) + ", " + formatNumber(b[4]) + " to " + formatNumber(b[5]));
  vtkPointData* pointData = mesh->GetPointData();
  for (int i = 0; i < pointData->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = pointData->GetAbstractArray(i);
    line(i == 0 ? "point arrays" : "",
      std::string(array->GetName() ? array->GetName() : "(no name)") + ": " + array->GetDataTypeAsString() +
        ", " + std::to_string(array->GetNumberOfComponents()) + " components");
  }
}

} // namespace

void info(const InputOptions& options, bool quiet)
{
  Progress progress(quiet);
  const Input input = readInput(options, progress);
  Statistics statistics;
  if (input.volume)
  {
    statistics = examine(*input.volume, progress);
  }
  progress.finish();
  line("file", options.file.string());
  line("format", input.format);
  if (input.volume)
  {
    describeVolume(*input.volume, input, statistics);
  }
  else
  {
    describeMesh(vtkPolyData::SafeDownCast(input.data));
  }
  for (const std::string& note : input.notes)
  {
    line("note", note);
  }
}

} // namespace ink::cli
