// SPDX-License-Identifier: BSD-3-Clause
// The curvature of meshes: how many rings of points are fitted, and by which polynomial, against error and
// time. That of the iso-surfaces of volumes: by their meshes, or by the Hessian of values that are smoothed
// by Gaussians.

#include "Tradeoff.h"

#include "AnalyticFields.h"
#include "Curvature/MeshCurvature.h"
#include "Curvature/SmoothedCurvature.h"
#include "Fields/Resampling/ResampleGrid.h"
#include "MeshesWithCurvature.h"
#include "SampledVolume.h"
#include "Statistics/NoiseEstimate.h"

#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace ink::test;

ink::CurvatureOptions Rings(int rings, int degree)
{
  ink::CurvatureOptions options;
  options.rings = rings;
  options.degree = degree;
  options.adaptive = false;
  return options;
}

/// The iso-surface of what a scanner sees of a shape, within -1 to 1 along each axis: 1 inside, 0 outside,
/// blurred by a Gaussian of deviation .7 samples across the surface, with noise of a share of the step.
struct ScannedSurface
{
  ink::testing::Volume<float> scan;
  glm::dvec3 smoothing;           ///< that its noise asks for, in samples
  Mesh mesh;                      ///< as style line-art makes it
  std::vector<glm::vec3> normals; ///< out of it
  std::vector<ink::PrincipalCurvature> exact;

  template <class Shape>
  ScannedSurface(const Shape& shape, int samples, double noise)
    : scan(ink::GridGeometry(glm::ivec3(samples), glm::dvec3(-1.0), glm::dvec3(2.0 / (samples - 1))))
  {
    const double blur = 0.7 * this->scan.geometry.spacing().x;
    std::uint64_t index = 0;
    this->scan = ink::testing::Volume<float>::from(this->scan.geometry,
      [&](const glm::dvec3& p)
      {
        return 0.5 * std::erfc(shape.distance(p) / (std::sqrt(2.0) * blur)) +
          noise * ink::testing::hashNormal(1, index++);
      });
    this->smoothing = glm::dvec3(
      ink::suggestSmoothing(ink::estimateNoise(this->scan.field(), 0.5), this->scan.geometry.spacing()));
    this->findMesh();
    for (const glm::dvec3& p : this->mesh.points)
    {
      // The field is greater outside.
      const ink::PrincipalCurvature inward = ink::fieldCurvature(shape, p).value();
      this->exact.push_back({ -inward.k2, -inward.k1, inward.direction2, inward.direction1 });
      this->normals.emplace_back(shape.gradient(p));
    }
  }

  ink::MeshCurvature ofMesh() const { return ink::estimateCurvature(this->mesh.view(), this->normals); }
  /// @param least of the Gaussian, in samples
  ink::MeshCurvature ofField(double least) const
  {
    return ink::smoothedCurvatures(
      this->scan.field(), glm::max(this->smoothing, glm::dvec3(least)), this->mesh.points);
  }

private:
  void findMesh()
  {
    const ink::GridGeometry& grid = this->scan.geometry;
    const auto along = [&](int axis)
    { return ink::AxisResampling(this->smoothing[axis], 1, grid.dimensions()[axis]); };
    std::vector<float> smooth(grid.sampleCount());
    ink::resampleGrid(this->scan.field(), { along(0), along(1), along(2) }, std::span<float>(smooth));
    vtkNew<vtkFloatArray> values;
    values->SetArray(smooth.data(), static_cast<vtkIdType>(smooth.size()), 1);
    vtkNew<vtkImageData> image;
    image->SetDimensions(&grid.dimensions()[0]);
    image->SetOrigin(&grid.origin()[0]);
    image->SetSpacing(&grid.spacing()[0]);
    image->GetPointData()->SetScalars(values);
    vtkNew<vtkFlyingEdges3D> edges;
    edges->SetInputData(image);
    edges->SetValue(0, 0.5);
    edges->ComputeNormalsOff();
    edges->Update();
    vtkPolyData* found = edges->GetOutput();
    this->mesh.points.resize(static_cast<std::size_t>(found->GetNumberOfPoints()));
    for (std::size_t n = 0; n < this->mesh.points.size(); ++n)
    {
      found->GetPoint(static_cast<vtkIdType>(n), &this->mesh.points[n][0]);
    }
    for (vtkIdType n = 0; n < found->GetNumberOfPolys(); ++n)
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      found->GetPolys()->GetCellAtId(n, count, ids);
      const auto id = [&](int corner) { return static_cast<std::uint32_t>(ids[corner]); };
      this->mesh.triangles.push_back({ id(0), id(1), id(2) });
    }
  }
};

/// The curvature of iso-surfaces by their meshes, and by Hessians of more or less smoothed values.
void compareSources()
{
  const ink::testing::Torus torus{ 0.62, 0.3 };
  const ink::testing::Torus thin{ 0.72, 0.12 };
  const ink::testing::Sphere sphere{ glm::dvec3(0.013, 0.007, 0.011), 0.8 };
  const std::vector<std::pair<std::string, ScannedSurface>> scans = {
    { "torus 48", { torus, 48, 0.0 } },
    { "torus 48, 5 % noise", { torus, 48, 0.05 } },
    { "torus 96", { torus, 96, 0.0 } },
    { "torus 96, 5 % noise", { torus, 96, 0.05 } },
    { "sphere 48", { sphere, 48, 0.0 } },
    { "sphere 48, 5 % noise", { sphere, 48, 0.05 } },
    { "thin torus 48, 5 % noise", { thin, 48, 0.05 } },
  };
  Tradeoff knob("Curvature of iso-surfaces (style line-art)",
    "Keep the Hessian of values smoothed by two voxels; less shows noise and voxels, more rounds the form. "
    "Take "
    "the mesh's only where a mesh is all there is.",
    "root mean square error of k1 and k2, 1 / half of the volume's side, with |k| up to 3.3, of the thin "
    "torus up "
    "to 8.3",
    "surface of 23,700 points in 96x96x96 floats");
  const auto add = [&](const std::string& name, const auto& find, Tradeoff::Role role)
  {
    Tradeoff::Errors errors;
    for (const auto& [scene, scan] : scans)
    {
      errors.emplace_back(scene, curvatureErrors(scan.exact, find(scan).points).curvature);
    }
    knob.Add(
      name, [&timed = scans[3].second, find] { find(timed); }, std::move(errors), role);
  };
  add(
    "mesh", [](const ScannedSurface& scan) { return scan.ofMesh(); }, Tradeoff::Choice);
  for (const double least : { 0.0, 1.0, 1.5, 2.0, 3.0 })
  {
    std::ostringstream name;
    name << "Hessian, " << (least > 0.0 ? "smoothed by " : "smoothed as the surface");
    if (least > 0.0)
    {
      name << least << (least == 1.0 ? " voxel or more" : " voxels or more");
    }
    add(
      name.str(), [least](const ScannedSurface& scan) { return scan.ofField(least); },
      least == 2.0 ? Tradeoff::Default : Tradeoff::Choice);
  }
  knob.Print();
}

} // namespace

int main()
{
  const MeshWithCurvature clean = ellipsoid({ 1.0, 0.7, 0.5 }, 4);
  const MeshWithCurvature noisy = ellipsoid({ 1.0, 0.7, 0.5 }, 4, 0.002);
  const MeshWithCurvature irregular = closedTorus(1.0, 0.4, 90, 45, 0.45);
  const MeshWithCurvature timed = closedTorus(1.0, 0.4, 256, 128);
  Tradeoff knob("Curvature of meshes",
    "Keep adaptive rings; take a fixed number where neighboring points should be treated alike, and the "
    "exponential map only to compare with the paper.",
    "root mean square error of k1 and k2, 1 / world unit, of surfaces about 2 wide with |k| up to 4",
    "torus of 33k points");
  const auto add = [&](const std::string& name, const ink::CurvatureOptions& options, Tradeoff::Role role)
  {
    const auto error = [&](const MeshWithCurvature& mesh)
    {
      return curvatureErrors(mesh.exact, ink::estimateCurvature(mesh.mesh.view(), {}, options).points)
        .curvature;
    };
    knob.Add(
      name, [&timed, options] { ink::estimateCurvature(timed.mesh.view(), {}, options); },
      { { "regular", error(clean) }, { "0.2 % noise", error(noisy) }, { "irregular", error(irregular) } },
      role);
  };
  ink::CurvatureOptions paper;
  paper.estimator = ink::CurvatureEstimator::ExponentialMap;
  add("exponential map", paper, Tradeoff::Choice);
  for (const int degree : { 2, 3 })
  {
    for (const int rings : { 2, 3, 5 })
    {
      add(std::to_string(rings) + " rings, degree " + std::to_string(degree), Rings(rings, degree),
        Tradeoff::Choice);
    }
  }
  ink::CurvatureOptions quadratic;
  quadratic.degree = 2;
  add("adaptive rings, degree 2", quadratic, Tradeoff::Choice);
  add("adaptive rings, degree 3", {}, Tradeoff::Default);
  Tradeoff::PrintHeader();
  knob.Print();
  compareSources();
  return 0;
}
