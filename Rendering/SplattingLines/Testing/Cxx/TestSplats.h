// SPDX-License-Identifier: BSD-3-Clause
#ifndef TestSplats_h
#define TestSplats_h

#include "InkTestPoints.h"
#include "vtkInkSplattingLinesMapper.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

/// Splats whose pictures tests work out on the CPU.
struct Splat
{
  std::array<double, 3> Position;
  std::array<double, 3> Normal;
  double Radius;
};

inline vtkSmartPointer<vtkPolyData> ToPolyData(const std::vector<Splat>& splats)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> radii;
  radii->SetName("Radius");
  for (const Splat& splat : splats)
  {
    points->InsertNextPoint(splat.Position.data());
    normals->InsertNextTuple(splat.Normal.data());
    radii->InsertNextValue(static_cast<float>(splat.Radius));
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->AddArray(normals);
  data->GetPointData()->AddArray(radii);
  return data;
}

struct Parameters
{
  double Lambda, Tau, Phi, Sigma;

  void Give(vtkInkSplattingLinesMapper* mapper) const
  {
    mapper->SetLambda(this->Lambda);
    mapper->SetTau(this->Tau);
    mapper->SetPhi(this->Phi);
    mapper->SetSigma(this->Sigma);
  }
};

/// Where a line of sight meets a splat's plane.
struct SplatHit
{
  double Distance2; ///< from the splat's center
  double Depth;     ///< from the eye, along -z
  double Radius;
  double Light; ///< f_i: the light is at the eye

  SplatHit(const Splat& splat, const glm::dvec3& eye, const glm::dvec3& direction)
    : Radius(splat.Radius)
  {
    const glm::dvec3 center(splat.Position[0], splat.Position[1], splat.Position[2]);
    const glm::dvec3 normal(splat.Normal[0], splat.Normal[1], splat.Normal[2]);
    const double along = glm::dot(normal, direction);
    const glm::dvec3 point = eye + glm::dot(normal, center - eye) / along * direction;
    const glm::dvec3 offset = point - center;
    this->Distance2 = glm::dot(offset, offset);
    this->Depth = eye.z - point.z;
    this->Light = glm::dot(normal, glm::normalize(eye - center));
  }
};

/// Equations 1 and 2 and E = tanh(phi (I1 - tau I2)) of Zhang et al. 2014.
/// @param side -1 where the surface is seen from behind
/// @param counts whether a splat takes part
template <class Counts>
double InkOfSplats(const std::vector<SplatHit>& hits, const Parameters& p, double side, const Counts& counts)
{
  const auto illumination = [&](double sigma)
  {
    double weighted = 0.0;
    double weights = 0.0;
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
      const SplatHit& hit = hits[i];
      if (hit.Distance2 <= p.Lambda * p.Lambda * hit.Radius * hit.Radius && counts(i))
      {
        const double variance = std::pow(p.Lambda * hit.Radius * sigma, 2);
        const double w = std::exp(-hit.Distance2 / (2.0 * variance)) / variance;
        weighted += w * side * hit.Light;
        weights += w;
      }
    }
    return weights > 0.0 ? weighted / weights : 0.0;
  };
  return std::max(0.0, -std::tanh(p.Phi * (illumination(p.Sigma) - p.Tau * illumination(1.6 * p.Sigma))));
}

inline void AddSphere(
  std::vector<Splat>& splats, double radius, double spacing, const InkTestPoints::Vector& center)
{
  auto sphere = InkTestPoints::Sphere(radius, spacing, center);
  vtkDataArray* normals = sphere->GetPointData()->GetArray("Normals");
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    Splat splat;
    sphere->GetPoint(i, splat.Position.data());
    normals->GetTuple(i, splat.Normal.data());
    splat.Radius = spacing * (1.2 + 0.1 * static_cast<double>(i % 3));
    splats.push_back(splat);
  }
}

#endif
