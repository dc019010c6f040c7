// SPDX-License-Identifier: BSD-3-Clause
// What hides stipples on polygons that are as large as the object.
#include "StippleScene.h"

#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkInkStippleGenerator.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkTriangleFilter.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstddef>

/// Of a cube those of the three faces that face the eye, whatever its size in the picture; but for some
/// within some pixels of the outline.
TEST(StippleCoarseMesh, HidesWhatIsBehindIt)
{
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cube->GetOutputPort());
  vtkNew<vtkInkStippleGenerator> generator;
  generator->SetInputConnection(triangles->GetOutputPort());
  generator->SetNumberOfSurfaceStipples(6000);
  generator->Update();
  vtkPolyData* stipples = generator->GetOutput();
  vtkDataArray* normals = stipples->GetCellData()->GetNormals();
  StippleScene scene(stipples);
  scene.AllOff();
  scene.Mapper->SetSurfaceData(triangles->GetOutput());
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  for (const int precision : { vtkInkStippleMapper::FLOAT, vtkInkStippleMapper::QUANTIZED })
  {
    scene.Mapper->SetPositionPrecision(precision);
    for (const double distance : { 3.0, 6.0 })
    {
      const glm::dvec3 eye = distance * glm::normalize(glm::dvec3(3.0, 2.0, 1.5));
      camera->SetPosition(&eye.x);
      camera->SetFocalPoint(0.0, 0.0, 0.0);
      scene.Renderer->ResetCameraClippingRange();
      scene.Window->Render();
      vtkNew<vtkFloatArray> marks;
      scene.Mapper->EvaluateMarks(scene.Renderer, scene.Actor, marks);
      // Numbers of stipples, and of those that are seen, on faces that face away and on others.
      std::array<double, 2> all{};
      std::array<double, 2> seen{};
      for (vtkIdType element = 0; element < stipples->GetNumberOfCells(); ++element)
      {
        const glm::dvec3 normal(normals->GetComponent(element, 0), normals->GetComponent(element, 1),
          normals->GetComponent(element, 2));
        vtkIdType count = 0;
        const vtkIdType* points = nullptr;
        stipples->GetCellPoints(element, count, points);
        for (vtkIdType i = 0; i < count; ++i)
        {
          glm::dvec3 p;
          stipples->GetPoint(points[i], &p.x);
          const std::size_t faces = glm::dot(normal, eye - p) > 0.0;
          all[faces] += 1.0;
          seen[faces] += marks->GetComponent(points[i], 1) > 0.0;
        }
      }
      EXPECT_GE(seen[1], 0.995 * all[1]) << distance << ", precision " << precision;
      // A pixel is a larger part of a smaller cube.
      EXPECT_LE(seen[0], 0.014 * distance * all[0]) << distance << ", precision " << precision;
    }
  }
}
