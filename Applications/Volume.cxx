#include "Volume.h"

#include "vtkAOSDataArrayTemplate.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSetGet.h"

namespace ink::cli
{
namespace
{

template <typename T>
std::optional<IsoSuggestion> suggest(vtkDataArray* scalars, const int dimensions[3])
{
  using Array = vtkAOSDataArrayTemplate<T>;
  vtkSmartPointer<Array> values = Array::FastDownCast(scalars);
  if (!values)
  {
    values = vtkSmartPointer<Array>::New();
    values->DeepCopy(scalars);
  }
  const std::span<const T> span(values->GetPointer(0), static_cast<std::size_t>(values->GetNumberOfValues()));
  return ink::suggestIsoValue<T>(span, { dimensions[0], dimensions[1], dimensions[2] });
}

} // namespace

std::optional<IsoSuggestion> suggestIsoValue(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const int* dimensions = image->GetDimensions();
  switch (scalars->GetDataType())
  {
    vtkTemplateMacro(return suggest<VTK_TT>(scalars, dimensions));
    default:
      return std::nullopt;
  }
}

void finiteRange(vtkImageData* image, double range[2])
{
  image->GetPointData()->GetScalars()->GetFiniteRange(range, 0);
}

std::string methodText(const IsoSuggestion& suggestion)
{
  return suggestion.method == IsoSuggestion::Method::Boundary
    ? "the lowest clear boundary between two materials"
    : "Otsu's threshold, as no boundary is clear";
}

} // namespace ink::cli
