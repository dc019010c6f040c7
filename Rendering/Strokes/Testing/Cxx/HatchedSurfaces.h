// SPDX-License-Identifier: BSD-3-Clause
#ifndef HatchedSurfaces_h
#define HatchedSurfaces_h

#include "StrokeScene.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <numbers>

/// Lines for hatching that are evenly spaced for every prefix: on a surface (u, v) in a period or a square of
/// which `Point` gives the positions and `Normal` the normals, with v constant along lines.
class HatchedSurfaces
{
public:
  /// @param bits there are 2^bits lines
  /// @param spacing between all of them
  template <class Point, class Normal>
  void Add(int bits, double spacing, int family, const Point& point, const Normal& normal, int segments = 64)
  {
    for (int line = 0; line < 1 << bits; ++line)
    {
      const double v = (line + 0.5) / (1 << bits);
      StrokePolyline polyline;
      for (int i = 0; i <= segments; ++i)
      {
        const double u = static_cast<double>(i) / segments;
        polyline.push_back(point(u, v));
        const std::array<double, 3> n = normal(u, v);
        this->Normals->InsertNextTuple(n.data());
      }
      this->Polylines.push_back(polyline);
      int reversed = 0;
      for (int bit = 0; bit < bits; ++bit)
      {
        reversed |= ((line >> bit) & 1) << (bits - 1 - bit);
      }
      this->Priorities->InsertNextValue(
        (static_cast<float>(reversed) + 0.5f) / static_cast<float>(1 << bits));
      this->Spacings->InsertNextValue(static_cast<float>(spacing));
      this->Families->InsertNextValue(static_cast<unsigned char>(family));
    }
  }

  /// A square of z = 0 from -1 to 1, with lines along x.
  void AddPlane(int bits, int family = 0)
  {
    const auto point = [family](double u, double v)
    {
      const std::array<double, 3> p{ 2.0 * u - 1.0, 2.0 * v - 1.0, 0.0 };
      return family == 0 ? p : std::array<double, 3>{ p[1], p[0], 0.0 };
    };
    this->Add(bits, 2.0 / (1 << bits), family, point,
      [](double, double) {
        return std::array<double, 3>{ 0, 0, 1 };
      });
  }

  /// The side of a cylinder around y with radius 1 from y = -2 to 2 that is seen along -z, without its rims:
  /// lines around it, or along it.
  void AddCylinder(int bits, bool around)
  {
    const auto angle = [around](double u, double v) { return std::numbers::pi * ((around ? u : v) - 0.5); };
    const auto point = [=](double u, double v)
    {
      const double a = angle(u, v);
      return std::array<double, 3>{ std::sin(a), 4.0 * (around ? v : u) - 2.0, std::cos(a) };
    };
    const auto normal = [=](double u, double v)
    {
      const double a = angle(u, v);
      return std::array<double, 3>{ std::sin(a), 0.0, std::cos(a) };
    };
    const double spacing = (around ? 4.0 : std::numbers::pi) / (1 << bits);
    this->Add(bits, spacing, 0, point, normal);
  }

  vtkSmartPointer<vtkPolyData> Make()
  {
    vtkSmartPointer<vtkPolyData> data = MakeStrokes(this->Polylines);
    data->GetPointData()->SetNormals(this->Normals);
    data->GetCellData()->AddArray(this->Priorities);
    data->GetCellData()->AddArray(this->Spacings);
    data->GetCellData()->AddArray(this->Families);
    return data;
  }

  HatchedSurfaces()
  {
    this->Normals->SetName("Normals");
    this->Normals->SetNumberOfComponents(3);
    this->Priorities->SetName("Priority");
    this->Spacings->SetName("Spacing");
    this->Families->SetName("LineFamily");
  }

private:
  std::vector<StrokePolyline> Polylines;
  vtkNew<vtkFloatArray> Normals;
  vtkNew<vtkFloatArray> Priorities;
  vtkNew<vtkFloatArray> Spacings;
  vtkNew<vtkUnsignedCharArray> Families;
};

/// Hatching of one tone in sight along -z, whatever light there is, with sizes in pixels.
class HatchingScene : public StrokeScene
{
public:
  explicit HatchingScene(vtkPolyData* data, int size = 300)
    : StrokeScene(data, size, size)
  {
    this->Mapper->HatchingOn();
    this->Mapper->SetHatchSpacing(6.0);
    this->Mapper->SetLineWidth(0.8);
    this->Mapper->SetCrosshatching(0.0);
    this->Mapper->SetSilhouetteWeight(0.0);
    this->Mapper->SetDiffuseTruncation(0.0);
    this->Mapper->SetCapToButt();
    // Without lights all is in the deepest shadow.
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->RemoveAllLights();
  }

  /// @param height of what is seen at z = 0, from near or, with parallel projection, from far
  void SetView(double height, bool parallel)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetParallelProjection(parallel);
    camera->SetParallelScale(0.5 * height);
    camera->SetViewAngle(30.0);
    camera->SetPosition(0.0, 0.0, 0.5 * height / std::tan(std::numbers::pi / 12.0) + 1.0);
    this->Renderer->ResetCameraClippingRange();
  }
};

#endif
