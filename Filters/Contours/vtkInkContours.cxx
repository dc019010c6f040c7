// SPDX-License-Identifier: BSD-3-Clause
#include "vtkInkContours.h"

#include "Curves/Contours/MeshContours.h"
#include "InkContourLines.h"
#include "InkHasPolygons.h"
#include "InkMeshTriangles.h"
#include "InkPointNormals.h"
#include "InkReportException.h"

#include "vtkCamera.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <vector>

/// What is kept between eyes: an index of the last mesh, and what it was made from.
class vtkInkContours::vtkInternals
{
public:
  std::optional<ink::MeshContours> Index;
  std::vector<vtkIdType> CellIds;
  vtkPolyData* Mesh = nullptr; ///< only compared
  vtkMTimeType MeshTime = 0;
  ink::MeshContourOptions Options;
  int Builds = 0;
  bool HasWarnedOfNormals = false;

  bool IsOf(vtkPolyData* mesh, const ink::MeshContourOptions& options) const
  {
    return this->Index && this->Mesh == mesh && this->MeshTime == mesh->GetMTime() &&
      this->Options == options;
  }
};

vtkStandardNewMacro(vtkInkContours);

vtkInkContours::vtkInkContours()
  : Internals(std::make_unique<vtkInternals>())
{
}

vtkInkContours::~vtkInkContours() = default;

const char* vtkInkContours::GetEyeAsString()
{
  switch (this->Eye)
  {
    case POSITION:
      return "Position";
    case DIRECTION:
      return "Direction";
    default:
      return "Camera";
  }
}

void vtkInkContours::SetCamera(vtkCamera* camera)
{
  if (this->Camera != camera)
  {
    this->Camera = camera;
    this->Modified();
  }
}

vtkCamera* vtkInkContours::GetCamera()
{
  return this->Camera;
}

int vtkInkContours::GetNumberOfIndexBuilds()
{
  return this->Internals->Builds;
}

vtkMTimeType vtkInkContours::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Eye == CAMERA && this->Camera ? std::max(own, this->Camera->GetMTime()) : own;
}

int vtkInkContours::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* mesh = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  try
  {
    this->FindContours(mesh, output);
  }
  catch (...)
  {
    InkReportException(this, output, "The contours of the mesh cannot be found");
  }
  return 1;
}

void vtkInkContours::FindContours(vtkPolyData* mesh, vtkPolyData* output)
{
  if (this->Eye == CAMERA && !this->Camera)
  {
    throw std::invalid_argument(
      "there is no camera; expected one by SetCamera, or EyePosition or EyeDirection by SetEye");
  }
  if (!InkHasPolygons(mesh))
  {
    if (mesh->GetNumberOfPoints() > 0)
    {
      vtkWarningMacro("The input has " << mesh->GetNumberOfPoints() << " points and no polygons or strips; "
                                       << "expected a surface. There are no contours.");
    }
    return;
  }
  ink::Eye eye;
  if (this->Eye == CAMERA)
  {
    double vector[3];
    const bool parallel = this->Camera->GetParallelProjection() != 0;
    parallel ? this->Camera->GetDirectionOfProjection(vector) : this->Camera->GetPosition(vector);
    const glm::dvec3 v(vector[0], vector[1], vector[2]);
    eye = parallel ? ink::Eye::along(v) : ink::Eye::at(v);
  }
  else
  {
    const double* v = this->Eye == POSITION ? this->EyePosition : this->EyeDirection;
    eye = this->Eye == POSITION ? ink::Eye::at({ v[0], v[1], v[2] }) : ink::Eye::along({ v[0], v[1], v[2] });
  }
  const ink::MeshContourOptions options{ this->Silhouettes, this->Faceted, this->Creases, this->FeatureAngle,
    this->Borders, this->NonManifoldEdges };
  vtkInternals& kept = *this->Internals;
  if (!kept.IsOf(mesh, options))
  {
    kept.Index.reset();
    // Those of a mesh without normals are made from its faces.
    InkMeshTriangles triangles(mesh, true, InkMeshTriangles::Order::OfMesh);
    if (options.silhouettes && !options.faceted && !InkPointNormals(mesh) && !kept.HasWarnedOfNormals)
    {
      kept.HasWarnedOfNormals = true;
      vtkWarningMacro("The input has no point normals; expected a point array \"Normals\" for smooth "
                      "silhouettes. The mean over the faces around each point is used.");
    }
    this->UpdateProgress(0.2);
    kept.Index.emplace(triangles.GetMesh(), triangles.Normals, options);
    kept.CellIds = std::move(triangles.FaceIds);
    kept.Mesh = mesh;
    kept.MeshTime = mesh->GetMTime();
    kept.Options = options;
    ++kept.Builds;
    this->UpdateProgress(0.9);
  }
  const ink::ContourArrays arrays{ this->ComputeNormals, this->ComputeRadialCurvature, this->ComputeArcLength,
    this->ComputeCellIds };
  InkMakeContourLines(kept.Index->find(eye, arrays), mesh->GetPoints()->GetDataType(), kept.CellIds, output);
}

void vtkInkContours::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Eye: " << this->GetEyeAsString() << "\n";
  os << indent << "Camera: " << this->Camera.Get() << "\n";
  os << indent << "EyePosition: " << this->EyePosition[0] << ", " << this->EyePosition[1] << ", "
     << this->EyePosition[2] << "\n";
  os << indent << "EyeDirection: " << this->EyeDirection[0] << ", " << this->EyeDirection[1] << ", "
     << this->EyeDirection[2] << "\n";
  os << indent << "Silhouettes: " << this->Silhouettes << "\n";
  os << indent << "Faceted: " << this->Faceted << "\n";
  os << indent << "Creases: " << this->Creases << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "Borders: " << this->Borders << "\n";
  os << indent << "NonManifoldEdges: " << this->NonManifoldEdges << "\n";
  os << indent << "ComputeNormals: " << this->ComputeNormals << "\n";
  os << indent << "ComputeRadialCurvature: " << this->ComputeRadialCurvature << "\n";
  os << indent << "ComputeArcLength: " << this->ComputeArcLength << "\n";
  os << indent << "ComputeCellIds: " << this->ComputeCellIds << "\n";
}
