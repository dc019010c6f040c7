// SPDX-License-Identifier: BSD-3-Clause
#include "InkImageGrid.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <glm/common.hpp>

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>

InkExtent::InkExtent(const int extent[6])
  : First(extent[0], extent[2], extent[4])
  , Last(extent[1], extent[3], extent[5])
{
}

glm::ivec3 InkExtent::GetDimensions() const
{
  return glm::max(this->Last - this->First + 1, glm::ivec3(0));
}

InkExtent InkGetWholeExtent(vtkInformation* info, vtkImageData* image)
{
  const int* whole = info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT());
  return InkExtent(whole ? whole : image->GetExtent());
}

vtkSmartPointer<vtkImageData> InkMakeFrame(vtkInformation* info)
{
  auto frame = vtkSmartPointer<vtkImageData>::New();
  if (info->Has(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()))
  {
    frame->SetExtent(info->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()));
  }
  if (info->Has(vtkDataObject::ORIGIN()))
  {
    frame->SetOrigin(info->Get(vtkDataObject::ORIGIN()));
  }
  if (info->Has(vtkDataObject::SPACING()))
  {
    frame->SetSpacing(info->Get(vtkDataObject::SPACING()));
  }
  if (info->Has(vtkDataObject::DIRECTION()))
  {
    frame->SetDirectionMatrix(info->Get(vtkDataObject::DIRECTION()));
  }
  return frame;
}

namespace
{

using SDDP = vtkStreamingDemandDrivenPipeline;

/// Whether an image covers the whole extent, and none of its cells belongs to another piece.
bool IsWhole(vtkInformation* input, vtkImageData* image)
{
  if (InkExtent(image->GetExtent()) != InkGetWholeExtent(input, image))
  {
    return false;
  }
  const ink::ElementMarks others = InkGetMarks(image->GetCellData(), vtkDataSetAttributes::DUPLICATECELL);
  return std::none_of(
    others.bytes.begin(), others.bytes.end(), [&](auto bits) { return (bits & others.mask) != 0; });
}

bool IsFirstPiece(vtkInformation* output)
{
  return output->Get(SDDP::UPDATE_NUMBER_OF_PIECES()) <= 1 || output->Get(SDDP::UPDATE_PIECE_NUMBER()) == 0;
}

} // namespace

bool InkIsWholeImage(vtkInformation* input, vtkInformation* output, vtkImageData* image)
{
  return IsFirstPiece(output) && IsWhole(input, image);
}

bool InkIsOfFirstPiece(vtkInformation* input, vtkInformation* output, vtkImageData* image)
{
  return !IsFirstPiece(output) && IsWhole(input, image);
}

ink::GridGeometry InkMakeGrid(vtkImageData* image, const InkExtent& extent)
{
  glm::dvec3 origin;
  glm::dvec3 spacing;
  image->GetOrigin(&origin[0]);
  image->GetSpacing(&spacing[0]);
  glm::dmat3 direction;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      direction[column][row] = image->GetDirectionMatrix()->GetElement(row, column);
    }
  }
  return ink::GridGeometry(extent.GetDimensions(), origin, spacing, direction, extent.First);
}

bool InkNeedsDoublePrecision(const ink::GridGeometry& grid)
{
  glm::dvec3 farthest(0.0);
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::ivec3 last = grid.dimensions() - 1;
    farthest = glm::max(
      farthest, glm::abs(grid.toWorld(last * glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1))));
  }
  const double largest = std::max({ farthest.x, farthest.y, farthest.z });
  const glm::dvec3 spacing = glm::abs(grid.spacing());
  const double smallest = std::min({ spacing.x, spacing.y, spacing.z });
  const double rounding = std::max<double>(
    0.5 * std::numeric_limits<float>::epsilon() * largest, std::numeric_limits<float>::denorm_min());
  return rounding > 1e-3 * smallest || largest > std::numeric_limits<float>::max();
}

ink::ElementMarks InkGetMarks(vtkDataSetAttributes* attributes, unsigned char bits)
{
  auto* array =
    vtkUnsignedCharArray::SafeDownCast(attributes->GetAbstractArray(vtkDataSetAttributes::GhostArrayName()));
  if (!array)
  {
    return {};
  }
  return { { array->GetPointer(0), static_cast<std::size_t>(array->GetNumberOfValues()) }, bits };
}

namespace
{

std::string ListOfArrays(vtkDataSetAttributes* attributes)
{
  std::string list;
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    const char* name = attributes->GetArrayName(i);
    list += (list.empty() ? "\"" : ", \"") + std::string(name ? name : "") + "\"";
  }
  return list.empty() ? "none" : list;
}

/// Why an image's scalars cannot be used; empty if they can. `scalars` is the array found for the name
/// `chosen`, or null, and `association` its field association.
std::string ProblemOf(
  vtkImageData* image, const char* chosen, vtkDataArray* scalars, int association, int component)
{
  std::ostringstream problem;
  if (!scalars)
  {
    const bool named = chosen && *chosen;
    problem << "No " << (named ? "numeric point array \"" : "point scalars") << (named ? chosen : "")
            << (named ? "\"" : "") << " in the image. Its point arrays: ";
    problem << ListOfArrays(image->GetPointData()) << ".";
    if (image->GetCellData()->GetNumberOfArrays() > 0)
    {
      problem << " Its cell arrays: " << ListOfArrays(image->GetCellData())
              << "; vtkCellDataToPointData (in ParaView Cell Data to Point Data) makes point arrays of them.";
    }
    return problem.str();
  }
  const char* name = scalars->GetName() ? scalars->GetName() : "(unnamed)";
  if (association != vtkDataObject::FIELD_ASSOCIATION_POINTS ||
    scalars->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    problem << "The array " << name << " has " << scalars->GetNumberOfTuples()
            << " values and is not point data. Expected a point array with " << image->GetNumberOfPoints()
            << " values.";
  }
  else if (component >= scalars->GetNumberOfComponents())
  {
    problem << "Component " << component << " was asked for, but the array " << name << " has "
            << scalars->GetNumberOfComponents() << " components, counted from 0.";
  }
  return problem.str();
}

} // namespace

vtkDataArray* InkChooseScalars(
  vtkAlgorithm* filter, vtkImageData* image, vtkDataArray* found, int association, int component)
{
  std::string problem;
  vtkDataArray* scalars = InkChooseScalars(filter, 0, image, found, association, component, problem);
  if (!problem.empty())
  {
    vtkErrorWithObjectMacro(filter, << problem);
  }
  return scalars;
}

vtkDataArray* InkChooseScalars(vtkAlgorithm* filter, int index, vtkImageData* image, vtkDataArray* found,
  int association, int component, std::string& problem)
{
  const char* chosen = filter->GetInputArrayInformation(index)->Get(vtkDataObject::FIELD_NAME());
  vtkDataArray* scalars = found;
  vtkPointData* points = image->GetPointData();
  const bool isNamed = chosen && *chosen;
  // Of an image of cells' centers, see InkPointInput, what was chosen among cells are points now.
  const bool asksForCells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  if (isNamed ? asksForCells && points->HasArray(chosen) : chosen || (asksForCells && !found))
  {
    scalars = isNamed ? points->GetArray(chosen) : points->GetScalars();
    association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  }
  problem = ProblemOf(image, chosen, scalars, association, component);
  return problem.empty() ? scalars : nullptr;
}

vtkSmartPointer<vtkDataArray> InkMakeContiguous(vtkDataArray* array, int& component)
{
  const bool bits = array->GetDataType() == VTK_BIT;
  if (array->HasStandardMemoryLayout() && !bits)
  {
    return array;
  }
  vtkSmartPointer<vtkDataArray> copy =
    vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(bits ? VTK_UNSIGNED_CHAR : array->GetDataType()));
  copy->SetNumberOfTuples(array->GetNumberOfTuples());
  copy->CopyComponent(0, array, component);
  component = 0;
  return copy;
}

bool InkKnowsPieces(vtkAlgorithm* filter)
{
  vtkAlgorithm* producer = filter;
  int port = 0;
  while (producer->GetNumberOfInputPorts() > 0 && producer->GetNumberOfInputConnections(0) > 0)
  {
    vtkAlgorithmOutput* connection = producer->GetInputConnection(0, 0);
    producer = connection->GetProducer();
    port = connection->GetIndex();
  }
  vtkInformation* info = producer->GetOutputInformation(port);
  return info->Has(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST()) ||
    info->Has(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT());
}

ink::ElementMarks InkGetLeftOutCells(vtkImageData* image)
{
  return InkGetMarks(image->GetCellData(),
    vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL |
      vtkDataSetAttributes::REFINEDCELL);
}

ink::CellSelection InkSelectCells(vtkInformation* input, vtkInformation* output, vtkImageData* image)
{
  ink::CellSelection cells;
  cells.skipped = InkGetLeftOutCells(image);
  if (InkIsOfFirstPiece(input, output, image))
  {
    cells.end = cells.begin;
  }
  return cells;
}
