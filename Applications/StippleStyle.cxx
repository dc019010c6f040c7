#include "StippleStyle.h"

#include "Errors.h"
#include "Progress.h"
#include "SampleVolume.h"
#include "Text.h"
#include "Volume.h"
#include "VolumeSlices.h"
#include "VtkMessages.h"

#include "Tone/StippleSliders.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace ink::cli
{
namespace
{

/// The surfaces that hide what lies behind them, and stipples only of what they enclose.
void takeIsoValues(
  const Input& input, const StippleStyle& style, const std::vector<double>& isoValues, Progress& progress)
{
  checkIsoValues(isoValues, summarizeValues(*input.volume));
  vtkNew<vtkFlyingEdges3D> surface;
  surface->SetInputData(input.data);
  surface->ComputeNormalsOff();
  surface->ComputeScalarsOff();
  for (std::size_t i = 0; i < isoValues.size(); ++i)
  {
    surface->SetValue(static_cast<int>(i), isoValues[i]);
  }
  progress.step("finding the surface", surface);
  surface->Update();
  style.mapper->SetSurfaceData(surface->GetOutput());
  if (!style.roomGiven)
  {
    style.mapper->SetPixelsPerStipple(ink::roomAtHidingSurface * style.mapper->GetPixelsPerStipple());
  }
  if (!style.generator->GetUseScalarWindow())
  {
    style.generator->UseScalarWindowOn();
    style.generator->SetScalarWindow(
      *std::min_element(isoValues.begin(), isoValues.end()), std::numeric_limits<double>::max());
  }
}

void prepareVolume(const Input& input, const StippleStyle& style, std::vector<double> isoValues,
  std::vector<std::string>& notes, Progress& progress)
{
  if (!input.data)
  {
    const VolumeSlices& volume = *input.volume;
    std::uint64_t bytes = static_cast<std::uint64_t>(vtkDataArray::GetDataTypeSize(volume.type()));
    for (const int n : volume.dimensions())
    {
      bytes *= static_cast<std::uint64_t>(n);
    }
    throw Failure("stipples need the whole volume at once, " + memoryText(bytes) + ": expected --memory of " +
      memoryText(Memory::limitFor(bytes, 2)) + " or more, or --style splatting-lines");
  }
  takeSurfaceValue(input, isoValues, notes);
  if (!isoValues.empty())
  {
    takeIsoValues(input, style, isoValues, progress);
  }
}

void prepareMesh(vtkPolyData* mesh, const StippleStyle& style, const std::vector<double>& isoValues,
  std::optional<long long> samples, double pixels)
{
  if (!isoValues.empty())
  {
    throw UsageError("--iso: a mesh has no iso-values, only volumes have");
  }
  if (style.volumeOption)
  {
    throw UsageError(
      *style.volumeOption + ": expected a volume, found a mesh, which has stipples everywhere");
  }
  if (!samples && !style.listLengthGiven)
  {
    samples = vtkInkStippleGenerator::CountForPicture(mesh, pixels, style.mapper->GetPixelsPerStipple());
  }
  style.generator->SetNumberOfSurfaceStipples(samples.value_or(0));
  style.mapper->SetSurfaceData(mesh);
}

void takeColors(vtkPolyData* stipples, const StippleStyle& style)
{
  const ScalarColors& wanted = *style.scalarColors;
  vtkDataArray* scalars = stipples->GetCellData()->GetScalars();
  double found[2];
  scalars->GetFiniteRange(found, 0);
  const auto [least, greatest] = wanted.range.value_or(std::array{ found[0], found[1] });
  vtkNew<vtkColorTransferFunction> colors;
  colors->SetColorSpaceToLab();
  const auto last = static_cast<double>(wanted.colors.size() - 1);
  for (std::size_t i = 0; i < wanted.colors.size(); ++i)
  {
    const Color& c = wanted.colors[i];
    colors->AddRGBPoint(least + (greatest - least) * static_cast<double>(i) / last, c[0], c[1], c[2]);
  }
  style.mapper->SetLookupTable(colors);
  style.mapper->UseLookupTableScalarRangeOn();
  style.mapper->ScalarVisibilityOn();
  // Bytes, too: VTK takes them for colors otherwise.
  style.mapper->SetColorModeToMapScalars();
}

} // namespace

vtkSmartPointer<vtkPolyData> makeStipples(const Input& input, const StippleStyle& style,
  std::vector<double> isoValues, std::optional<long long> samples, double pixels,
  std::vector<std::string>& notes, Progress& progress)
{
  vtkInkStippleGenerator* generator = style.generator;
  if (input.volume)
  {
    if (samples)
    {
      throw UsageError("--samples: expected a mesh, found a volume, which has --max-stipples in a voxel");
    }
    prepareVolume(input, style, std::move(isoValues), notes, progress);
  }
  else
  {
    prepareMesh(vtkPolyData::SafeDownCast(input.data), style, isoValues, samples, pixels);
  }
  if (style.scalarColors)
  {
    generator->PassScalarsOn();
    if (!style.scalarColors->array.empty())
    {
      generator->SetInputArrayToProcess(
        1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS, style.scalarColors->array.c_str());
    }
  }
  generator->SetInputData(input.data);
  progress.step("placing stipples", generator);
  const VtkMessages messages;
  generator->Update();
  if (const std::string problem = messages.error(); !problem.empty())
  {
    throw Failure(problem);
  }
  vtkSmartPointer<vtkPolyData> stipples = generator->GetOutput();
  if (stipples->GetNumberOfPoints() == 0)
  {
    throw Failure(input.volume ? "nothing to draw: no voxel has a gradient that is steep enough" +
          std::string(generator->GetUseScalarWindow() ? " and a value in the window" : "")
                               : "nothing to draw: no stipple was placed on the mesh");
  }
  if (style.scalarColors)
  {
    takeColors(stipples, style);
  }
  style.mapper->SetInputData(stipples);
  return stipples;
}

} // namespace ink::cli
