// SPDX-License-Identifier: BSD-3-Clause
#include "InkImageVoxels.h"

#include "InkImageGrid.h"
#include "InkOwnedSamples.h"
#include "InkWithGridField.h"

#include "Fields/Derivatives/LaplacianOfGaussian.h"
#include "Fields/Grid/PieceOwnership.h"

#include "vtkAlgorithm.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>

namespace
{

template <class Work>
ink::EdgeVoxels WithField(const InkVoxelInput& input, const Work& work)
{
  const ink::ElementMarks hidden =
    InkGetMarks(input.Image->GetPointData(), vtkDataSetAttributes::HIDDENPOINT);
  return InkWithGridField(InkMakeGrid(input.Image, InkExtent(input.Image->GetExtent())), input.Scalars,
    input.Component, hidden, work);
}

/// Leaves out voxels that other pieces own.
ink::EdgeVoxels SelectOwn(const InkVoxelInput& input, const ink::EdgeVoxels& voxels)
{
  const glm::ivec3 n = InkExtent(input.Image->GetExtent()).GetDimensions();
  const ink::PieceOwnership own(
    n, input.Own, InkGetMarks(input.Image->GetCellData(), vtkDataSetAttributes::DUPLICATECELL));
  const auto& [begin, end] = own.box();
  ink::EdgeVoxels selected;
  for (std::size_t i = 0; i < voxels.samples.size(); ++i)
  {
    const std::size_t row = voxels.samples[i] / n.x;
    const glm::ivec3 sample(voxels.samples[i] % n.x, row % n.y, row / n.y);
    if (glm::all(glm::greaterThanEqual(sample, begin)) && glm::all(glm::lessThan(sample, end)) &&
      own.has(sample))
    {
      selected.samples.push_back(voxels.samples[i]);
      selected.positions.push_back(voxels.positions[i]);
      selected.gradients.push_back(voxels.gradients[i]);
      selected.values.push_back(voxels.values[i]);
    }
  }
  return selected;
}

} // namespace

InkVoxelInput InkVoxelInput::Take(vtkAlgorithm* filter, vtkDataArray* found, int association,
  vtkInformationVector** input, vtkInformationVector* output, int component)
{
  InkVoxelInput taken;
  vtkInformation* info = input[0]->GetInformationObject(0);
  taken.Image = vtkImageData::GetData(info);
  taken.Component = component;
  // An empty piece is not an error.
  if (taken.Image->GetNumberOfPoints() == 0)
  {
    return taken;
  }
  if (vtkDataArray* scalars = InkChooseScalars(filter, taken.Image, found, association, component))
  {
    taken.Array = scalars;
    taken.Scalars = InkMakeContiguous(scalars, taken.Component);
    taken.Own = InkGetOwnedSamples(info, output->GetInformationObject(0), taken.Image);
  }
  return taken;
}

ink::EdgeVoxels InkFindEdgeVoxels(
  const InkVoxelInput& input, double scale, double leastMagnitude, const ink::Progress& progress)
{
  return WithField(input,
    [&](const auto& field)
    { return SelectOwn(input, ink::findEdgeVoxels(field, glm::dvec3(scale), leastMagnitude, progress)); });
}

ink::EdgeVoxels InkSearchSilhouetteVoxels(
  const InkVoxelInput& input, const ink::SilhouetteCriteria& criteria, const ink::Eye& eye)
{
  return WithField(input,
    [&](const auto& field) {
      return SelectOwn(input, ink::describeVoxels(field, ink::searchSilhouetteVoxels(field, criteria, eye)));
    });
}

int InkGetVoxelGhostLevels(double scale)
{
  // The Laplacian at a neighbor.
  return ink::laplacianReach(glm::dvec3(scale)).x + 1;
}

double InkGetVoxelRadius(vtkImageData* image)
{
  const double* spacing = image->GetSpacing();
  return 0.5 * glm::length(glm::dvec3(spacing[0], spacing[1], spacing[2]));
}
