#include "Orientation.h"

#include "TextHeader.h"

#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNIFTIImageReader.h"

#include <cmath>

namespace ink::cli
{
namespace
{

// Directions that are rounded in a file are still at right angles.
constexpr double tolerance = 1e-3;

/// An orientation from the vectors between neighbouring voxels and the place of the first, both as in the
/// file. sign turns the file's axes to DICOM's.
Orientation makeOrientation(
  const double steps[9], const double origin[3], const double sign[3], double spacing[3])
{
  Orientation orientation;
  for (int i = 0; i < 3; ++i)
  {
    spacing[i] = vtkMath::Norm(steps + 3 * i);
    for (int j = 0; j < 3; ++j)
    {
      orientation.direction[i][j] = sign[j] * steps[3 * i + j] / spacing[i];
    }
    orientation.origin[i] = sign[i] * origin[i];
  }
  return orientation;
}

} // namespace

bool Orientation::apply(vtkImageData* image) const
{
  for (int i = 0; i < 3; ++i)
  {
    const double* a = this->direction[i];
    const double* b = this->direction[(i + 1) % 3];
    // Written so that NaN fails as well.
    if (!(std::abs(vtkMath::Norm(a) - 1.0) < tolerance && std::abs(vtkMath::Dot(a, b)) < tolerance))
    {
      return false;
    }
  }
  const auto& d = this->direction;
  image->SetDirectionMatrix(d[0][0], d[1][0], d[2][0], d[0][1], d[1][1], d[2][1], d[0][2], d[1][2], d[2][2]);
  image->SetOrigin(this->origin);
  return true;
}

bool applyNiftiOrientation(vtkNIFTIImageReader* reader, vtkImageData* image)
{
  // NIfTI: +x to the right, +y to the front.
  constexpr double sign[3] = { -1, -1, 1 };
  for (vtkMatrix4x4* matrix : { reader->GetSFormMatrix(), reader->GetQFormMatrix() })
  {
    if (!matrix)
    {
      continue;
    }
    double steps[9];
    double origin[3];
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        steps[3 * i + j] = matrix->GetElement(j, i);
      }
      origin[i] = matrix->GetElement(i, 3);
    }
    // VTK's matrices are free of the spacing.
    double norms[3];
    if (makeOrientation(steps, origin, sign, norms).apply(image))
    {
      return true;
    }
  }
  return false;
}

bool applyNrrdOrientation(const std::filesystem::path& file, vtkImageData* image)
{
  auto fields = readTextHeader(file, ':', "");
  // The directions of axes that are not spatial are given as "none", which ends the numbers.
  std::string directions = fields["space directions"];
  if (const auto none = directions.find("none"); none != std::string::npos)
  {
    directions.erase(none, 4);
  }
  const std::vector<double> steps = numbersIn(directions);
  std::vector<double> origin = numbersIn(fields["space origin"]);
  if (steps.size() != 9)
  {
    return true;
  }
  origin.resize(3);

  const std::string space = fields["space"];
  const bool towardsRight = space.starts_with("right") || space == "RAS";
  const bool towardsFront = space.find("anterior") != std::string::npos || space == "RAS" || space == "LAS";
  const double sign[3] = { towardsRight ? -1.0 : 1.0, towardsFront ? -1.0 : 1.0, 1.0 };
  double spacing[3];
  if (!makeOrientation(steps.data(), origin.data(), sign, spacing).apply(image))
  {
    return false;
  }
  image->SetSpacing(spacing);
  return true;
}

bool applyMetaImageOrientation(const std::filesystem::path& file, vtkImageData* image)
{
  const auto fields = readTextHeader(file, '=', "ElementDataFile");
  // The format has three names for each.
  std::vector<double> steps;
  std::vector<double> origin;
  for (const char* name : { "TransformMatrix", "Rotation", "Orientation" })
  {
    if (const auto field = fields.find(name); field != fields.end())
    {
      steps = numbersIn(field->second);
    }
  }
  for (const char* name : { "Offset", "Position", "Origin" })
  {
    if (const auto field = fields.find(name); field != fields.end())
    {
      origin = numbersIn(field->second);
    }
  }
  if (steps.size() != 9)
  {
    return true;
  }
  origin.resize(3);
  constexpr double sign[3] = { 1, 1, 1 };
  double norms[3];
  return makeOrientation(steps.data(), origin.data(), sign, norms).apply(image);
}

} // namespace ink::cli
