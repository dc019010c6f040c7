#include "InfoCommand.h"

#include "Progress.h"
#include "Text.h"
#include "Volume.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
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

vtkIdType countNotFinite(vtkDataArray* scalars)
{
  vtkIdType count = 0;
  if (scalars->GetDataType() == VTK_FLOAT || scalars->GetDataType() == VTK_DOUBLE)
  {
    for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
    {
      count += std::isfinite(scalars->GetComponent(i, 0)) ? 0 : 1;
    }
  }
  return count;
}

void describeVolume(vtkImageData* image, int components)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  line("dimensions", dimensionsText(image->GetDimensions()));
  line("spacing", tripleText(image->GetSpacing()));
  line("origin", tripleText(image->GetOrigin()));
  vtkMatrix3x3* direction = image->GetDirectionMatrix();
  if (!direction->IsIdentity())
  {
    const double* d = direction->GetData();
    line("direction", tripleText(d) + ", " + tripleText(d + 3) + ", " + tripleText(d + 6));
  }
  line("type",
    scalars->GetDataTypeAsString() + (" (" + std::to_string(8 * scalars->GetDataTypeSize())) + " bits)");
  line("components", std::to_string(components));

  double range[2];
  finiteRange(image, range);
  const vtkIdType notFinite = countNotFinite(scalars);
  line("range", range[0] > range[1] ? "none" : text(range[0]) + " to " + text(range[1]));
  if (notFinite > 0)
  {
    line("not finite", std::to_string(notFinite) + " voxels");
  }
  const std::optional<IsoSuggestion> suggestion = suggestIsoValue(image);
  line("suggested iso",
    suggestion ? text(suggestion->value) + " (" + methodText(*suggestion) + ")"
               : "none: the volume has no two values");
}

void describeMesh(vtkPolyData* mesh)
{
  line("points", std::to_string(mesh->GetNumberOfPoints()));
  line("cells", std::to_string(mesh->GetNumberOfCells()));
  const double* b = mesh->GetBounds();
  line("bounds",
    text(b[0]) + " to " + text(b[1]) + ", " + text(b[2]) + " to " + text(b[3]) + ", " + text(b[4]) + " to " +
      text(b[5]));
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
  progress.finish();
  line("file", options.file.string());
  line("format", input.format);
  if (auto* image = vtkImageData::SafeDownCast(input.data))
  {
    describeVolume(image, input.components);
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
