// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkWholeMesh.h"

#include "vtkInkGatherMesh.h"

#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"

void vtkInkWholeMesh::LookAt(vtkInformation* request, vtkInformationVector** input)
{
  // The pipeline's own request; those for leaves are not handed upstream.
  if (request->Has(vtkExecutive::ALGORITHM_BEFORE_FORWARD()))
  {
    this->IsComposite = vtkCompositeDataSet::GetData(input[0]) != nullptr;
  }
}

vtkInformationVector** vtkInkWholeMesh::Gather(vtkInformationVector** input, int ports)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  vtkPolyData* part = vtkPolyData::GetData(input[0]);
  if (this->IsComposite || !part || !controller || controller->GetNumberOfProcesses() == 1)
  {
    return input;
  }
  const vtkIdType own = part->GetNumberOfPolys() + part->GetNumberOfStrips();
  vtkIdType most = 0;
  controller->AllReduce(&own, &most, 1, vtkCommunicator::MAX_OP);
  if (most == 0)
  {
    return input;
  }
  const vtkSmartPointer<vtkPolyData> whole =
    vtkInkGatherMesh({ part }, vtkInkCommonPoints::WithNormals, controller);
  for (int port = 0; port < ports; ++port)
  {
    const auto index = static_cast<std::size_t>(port);
    this->Gathered[index]->Copy(input[port], 1);
    this->Pointers[index] = this->Gathered[index];
  }
  this->Gathered[0]->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), whole);
  return this->Pointers.data();
}

int vtkInkWholeMesh::Take(
  vtkInformationVector** input, int ports, const std::function<int(vtkInformationVector**)>& use)
{
  const int result = use(this->Gather(input, ports));
  // Lets go of the mesh.
  for (auto& gathered : this->Gathered)
  {
    gathered->SetNumberOfInformationObjects(0);
  }
  return result;
}
