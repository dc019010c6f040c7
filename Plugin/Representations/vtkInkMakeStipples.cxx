// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkMakeStipples.h"

#include "vtkInkGatherMesh.h"
#include "vtkInkStippleGenerator.h"

#include "Sampling/StippledVoxels.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkFlyingEdges3D.h"
#include "vtkGeometryFilter.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace
{

/// Of a picture, whose room says how many stipples a mesh gets.
constexpr double PixelsPerStipple = 6.0;

bool AreStipples(vtkPolyData* data)
{
  return data->GetFieldData()->GetArray("StipplesPerElement") && data->GetNumberOfCells() > 0 &&
    data->GetNumberOfVerts() == data->GetNumberOfCells();
}

/// The input's leaves by what is done with them.
struct Leaves
{
  std::vector<vtkImageData*> Images;
  std::vector<vtkPolyData*> Stipples;
  std::vector<vtkDataSet*> Others;
  bool Composite = false;
  std::string Problem;

  explicit Leaves(vtkDataObject* input)
  {
    if (auto composite = vtkCompositeDataSet::SafeDownCast(input))
    {
      this->Composite = true;
      auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
      for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
      {
        this->Add(leaves->GetCurrentDataObject());
      }
    }
    else if (input)
    {
      this->Add(input);
    }
  }

  void Add(vtkDataObject* leaf)
  {
    auto data = vtkDataSet::SafeDownCast(leaf);
    if (!data)
    {
      this->Problem = std::string("a ") + leaf->GetClassName() + ". It needs images, meshes or stipples.";
      return;
    }
    if (data->GetNumberOfPoints() == 0)
    {
      return;
    }
    auto polyData = vtkPolyData::SafeDownCast(data);
    if (auto image = vtkImageData::SafeDownCast(data))
    {
      this->Images.push_back(image);
    }
    else if (polyData && AreStipples(polyData))
    {
      this->Stipples.push_back(polyData);
    }
    else
    {
      this->Others.push_back(data);
    }
  }
};

vtkSmartPointer<vtkPolyData> Append(const std::vector<vtkSmartPointer<vtkPolyData>>& parts)
{
  if (parts.size() < 2)
  {
    return parts.empty() ? vtkSmartPointer<vtkPolyData>::New() : parts.front();
  }
  vtkNew<vtkAppendPolyData> append;
  for (const auto& part : parts)
  {
    append->AddInputData(part);
  }
  append->Update();
  vtkSmartPointer<vtkPolyData> result = append->GetOutput();
  // Of all parts alike, but appending leaves it out.
  result->GetFieldData()->PassData(parts.front()->GetFieldData());
  return result;
}

/// Takes a generator's properties that this drawing changes back when it is done.
class ChangedGenerator
{
public:
  explicit ChangedGenerator(vtkInkStippleGenerator* generator)
    : Generator(generator)
    , Windowed(generator->GetUseScalarWindow())
    , Count(generator->GetNumberOfSurfaceStipples())
  {
    generator->GetScalarWindow(this->Window);
  }
  ~ChangedGenerator()
  {
    this->Generator->SetInputConnection(nullptr);
    this->Generator->SetStatistics(nullptr);
    this->Generator->SetPassScalars(false);
    this->Generator->SetUseScalarWindow(this->Windowed);
    this->Generator->SetScalarWindow(this->Window);
    this->Generator->SetNumberOfSurfaceStipples(this->Count);
  }
  ChangedGenerator(const ChangedGenerator&) = delete;
  void operator=(const ChangedGenerator&) = delete;

private:
  vtkInkStippleGenerator* const Generator;
  const bool Windowed;
  const vtkIdType Count;
  double Window[2];
};

/// Lets the generator pass on the array to color by, where the data has it.
void TakeColors(vtkDataSet* data, const vtkInkStippleRequest& request, bool cells, vtkInkMadeStipples& made)
{
  vtkDataArray* active = data->GetPointData()->GetScalars();
  const bool chosen = !request.ColorArray.empty();
  const std::string name = chosen ? request.ColorArray : active && active->GetName() ? active->GetName() : "";
  const int association = chosen ? request.ColorAssociation : vtkDataObject::FIELD_ASSOCIATION_POINTS;
  const bool ofCells = association == vtkDataObject::FIELD_ASSOCIATION_CELLS;
  vtkDataSetAttributes* attributes =
    ofCells ? static_cast<vtkDataSetAttributes*>(data->GetCellData()) : data->GetPointData();
  const bool has = !name.empty() && (!ofCells || cells) && attributes->GetArray(name.c_str());
  request.Generator->SetPassScalars(has);
  request.Generator->SetInputArrayToProcess(1, 0, 0, association, has ? name.c_str() : "");
  if (has)
  {
    made.ColorArray = name;
    made.ColorAssociation = association;
  }
}

/// What the first process says that has colors.
void AgreeOnColors(vtkInkMadeStipples& made, vtkMultiProcessController* controller)
{
  const int none = controller->GetNumberOfProcesses();
  const int own = made.ColorArray.empty() ? none : controller->GetLocalProcessId();
  int first = none;
  controller->AllReduce(&own, &first, 1, vtkCommunicator::MIN_OP);
  if (first < none)
  {
    vtkMultiProcessStream stream;
    stream << made.ColorArray << made.ColorAssociation;
    controller->Broadcast(stream, first);
    stream >> made.ColorArray >> made.ColorAssociation;
  }
}

/// All processes' statistics added up.
void AddUp(ink::VolumeStatistics& statistics, vtkMultiProcessController* controller)
{
  const auto bins = statistics.magnitudes.bins();
  const std::vector<std::uint64_t> own(bins.begin(), bins.end());
  std::vector<std::uint64_t> all(own.size());
  controller->AllReduce(own.data(), all.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::SUM_OP);
  statistics.magnitudes.setBins(all);
  const std::array ownLimits{ -statistics.lowest, statistics.highest };
  std::array<double, 2> limits;
  controller->AllReduce(ownLimits.data(), limits.data(), 2, vtkCommunicator::MAX_OP);
  statistics.lowest = -limits[0];
  statistics.highest = limits[1];
}

vtkSmartPointer<vtkPolyData> MakeIsoSurface(vtkImageData* image, const vtkInkStippleRequest& request)
{
  vtkNew<vtkFlyingEdges3D> surface;
  surface->SetInputData(image);
  if (!request.Scalars.empty())
  {
    surface->SetInputArrayToProcess(
      0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, request.Scalars.c_str());
  }
  surface->SetValue(0, *request.IsoValue);
  surface->ComputeNormalsOff();
  surface->ComputeScalarsOff();
  surface->Update();
  return surface->GetOutput();
}

void StippleImages(const Leaves& leaves, const vtkInkStippleRequest& request, vtkInkMadeStipples& made)
{
  vtkInkStippleGenerator* generator = request.Generator;
  const ChangedGenerator changed(generator);
  generator->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, request.Scalars.c_str());
  if (request.IsoValue && !generator->GetUseScalarWindow())
  {
    generator->UseScalarWindowOn();
    generator->SetScalarWindow(*request.IsoValue, std::numeric_limits<double>::max());
  }
  // The leaves of composite data are whole images.
  vtkNew<vtkInformation> whole;
  vtkInformation* update = leaves.Composite ? whole.Get() : request.Update;
  const auto connect = [&](vtkImageData* image)
  {
    if (leaves.Composite)
    {
      generator->SetInputData(image);
    }
    else
    {
      generator->SetInputConnection(request.Port);
    }
  };

  const auto statistics = std::make_shared<ink::VolumeStatistics>();
  std::vector<vtkImageData*> measured;
  // The same on all processes.
  const bool measures = generator->GetThresholdMode() == vtkInkStippleGenerator::PERCENTILE ||
    !generator->GetUseReferenceRanges();
  for (vtkImageData* image : leaves.Images)
  {
    connect(image);
    if (!measures || generator->Measure(update, *statistics))
    {
      measured.push_back(image);
    }
  }
  if (measures)
  {
    AddUp(*statistics, request.Controller);
    generator->SetStatistics(statistics);
  }
  std::vector<vtkSmartPointer<vtkPolyData>> stipples;
  std::vector<vtkSmartPointer<vtkPolyData>> surfaces;
  for (vtkImageData* image : measured)
  {
    connect(image);
    TakeColors(image, request, false, made);
    generator->Update(update);
    if (generator->GetOutput()->GetNumberOfPoints() > 0)
    {
      stipples.push_back(vtkSmartPointer<vtkPolyData>::New());
      stipples.back()->ShallowCopy(generator->GetOutput());
    }
    if (request.IsoValue)
    {
      surfaces.push_back(MakeIsoSurface(image, request));
    }
  }
  made.Stipples = Append(stipples);
  made.Surface = Append(surfaces);
  made.OfImage = true;
}

/// The outer surfaces of this process's data.
std::vector<vtkSmartPointer<vtkPolyData>> MakeMeshes(const std::vector<vtkDataSet*>& leaves)
{
  std::vector<vtkSmartPointer<vtkPolyData>> surfaces;
  for (vtkDataSet* data : leaves)
  {
    vtkSmartPointer<vtkPolyData> surface = vtkPolyData::SafeDownCast(data);
    if (!surface)
    {
      vtkNew<vtkGeometryFilter> outside;
      outside->SetInputData(data);
      outside->Update();
      surface = outside->GetOutput();
    }
    surfaces.push_back(surface);
  }
  return surfaces;
}

void StippleSurfaces(const Leaves& leaves, const vtkInkStippleRequest& request, vtkInkMadeStipples& made)
{
  const vtkSmartPointer<vtkPolyData> mesh =
    vtkInkGatherMesh(MakeMeshes(leaves.Others), vtkInkCommonPoints::All, request.Controller);
  if (mesh->GetNumberOfPoints() == 0)
  {
    return;
  }
  const vtkIdType polygons = mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips();
  if (polygons == 0)
  {
    made.Problem = "data of " + std::to_string(mesh->GetNumberOfPoints()) +
      " points without polygons. It needs an image, a mesh, or stipples of Ink Stipple Generator.";
    return;
  }
  vtkInkStippleGenerator* generator = request.Generator;
  const ChangedGenerator changed(generator);
  if (generator->GetNumberOfSurfaceStipples() == 0)
  {
    generator->SetNumberOfSurfaceStipples(
      vtkInkStippleGenerator::CountForPicture(mesh, request.PictureSize, PixelsPerStipple));
  }
  generator->SetInputData(mesh);
  TakeColors(mesh, request, true, made);
  generator->Update();
  made.Stipples->ShallowCopy(generator->GetOutput());
  if (request.SurfaceHides)
  {
    made.Surface->SetPoints(mesh->GetPoints());
    made.Surface->SetPolys(mesh->GetPolys());
    made.Surface->SetStrips(mesh->GetStrips());
  }
}

void TakeStipples(const Leaves& leaves, const vtkInkStippleRequest& request, vtkInkMadeStipples& made)
{
  std::vector<vtkSmartPointer<vtkPolyData>> parts;
  for (vtkPolyData* stipples : leaves.Stipples)
  {
    parts.push_back(vtkSmartPointer<vtkPolyData>::New());
    parts.back()->ShallowCopy(stipples);
    vtkCellData* cells = parts.back()->GetCellData();
    const bool colored = request.ColorAssociation == vtkDataObject::FIELD_ASSOCIATION_CELLS &&
      cells->HasArray(request.ColorArray.c_str());
    cells->SetActiveScalars(colored ? request.ColorArray.c_str() : nullptr);
    if (colored)
    {
      made.ColorArray = request.ColorArray;
      made.ColorAssociation = request.ColorAssociation;
    }
  }
  made.Stipples = Append(parts);
  made.IdsAreInputs = parts.size() == 1 && !leaves.Composite;
}

} // namespace

vtkInkMadeStipples vtkInkMakeStipples(vtkDataObject* input, const vtkInkStippleRequest& request)
{
  const Leaves leaves(input);
  vtkInkMadeStipples made{ vtkSmartPointer<vtkPolyData>::New(), vtkSmartPointer<vtkPolyData>::New(), false,
    false, {}, 0, leaves.Problem };
  const std::array own{ leaves.Images.empty() ? 0 : 1, leaves.Stipples.empty() ? 0 : 1 };
  std::array<int, 2> found;
  request.Controller->AllReduce(own.data(), found.data(), 2, vtkCommunicator::MAX_OP);
  const auto [images, stipples] = found;
  if (images)
  {
    StippleImages(leaves, request, made);
  }
  else if (stipples)
  {
    TakeStipples(leaves, request, made);
  }
  else
  {
    StippleSurfaces(leaves, request, made);
  }
  AgreeOnColors(made, request.Controller);
  const std::size_t left = leaves.Others.size() + (images ? leaves.Stipples.size() : 0);
  if ((images || stipples) && left > 0 && made.Problem.empty())
  {
    made.Problem = std::to_string(left) + " datasets beside " + (images ? "images" : "stipples") +
      ". It draws images, stipples and meshes one kind at a time.";
  }
  return made;
}
