// SPDX-License-Identifier: BSD-3-Clause
// The curvature of meshes: how many rings of points are fitted, and by which polynomial, against error and
// time.

#include "Tradeoff.h"

#include "Curvature/MeshCurvature.h"
#include "CurvedMeshes.h"

#include <string>

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

} // namespace

int main()
{
  const CurvedMesh clean = ellipsoid({ 1.0, 0.7, 0.5 }, 4);
  const CurvedMesh noisy = ellipsoid({ 1.0, 0.7, 0.5 }, 4, 0.002);
  const CurvedMesh irregular = closedTorus(1.0, 0.4, 90, 45, 0.45);
  const CurvedMesh timed = closedTorus(1.0, 0.4, 256, 128);
  Tradeoff knob("Curvature of meshes",
    "Keep adaptive rings; take a fixed number where neighboring points should be treated alike, and the "
    "exponential map only to compare with the paper.",
    "root mean square error of k1 and k2, 1 / world unit, of surfaces about 2 wide with |k| up to 4",
    "torus of 33k points");
  const auto add = [&](const std::string& name, const ink::CurvatureOptions& options, Tradeoff::Role role)
  {
    const auto error = [&](const CurvedMesh& mesh)
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
  return 0;
}
