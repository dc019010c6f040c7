// SPDX-License-Identifier: BSD-3-Clause
// Lines of curvature: how far they are from the known ones of an ellipsoid and a torus, for each integrator
// and step, against the time to trace them.

#include "Tradeoff.h"

#include "StreamlineDeviation.h"

#include <cstdint>
#include <cstdlib>
#include <string>

namespace
{

using namespace ink::test;

const EllipsoidShape Ellipsoid;
const Shape EllipsoidMesh = Ellipsoid.sample(130, 65);
const ink::TriangleMesh EllipsoidTriangles = EllipsoidMesh.mesh.view();
const ink::MeshNavigation Navigation(EllipsoidTriangles, 180.0);
const TorusShape Torus;
const Shape TorusMesh = Torus.sample(150, 50);

ink::TraceOptions OptionsOf(ink::StreamlineIntegrator integrator, double factor)
{
  ink::TraceOptions options;
  options.maximumLength = 4.0;
  options.integrator = integrator;
  options.stepFactor = factor;
  return options;
}

/// Lines from a tenth of the triangles.
void Trace(const ink::TraceOptions& options)
{
  const ink::LineField field = fieldOf(EllipsoidMesh);
  const ink::StreamlineTracer tracer(Navigation, field, options);
  for (std::uint32_t t = 0; t < EllipsoidTriangles.triangles.size(); t += 10)
  {
    if (Navigation.isUsable(t))
    {
      tracer.trace({ t, { 0.3, 0.45, 0.25 } }, field.directions[EllipsoidTriangles.triangles[t][0]], {});
    }
  }
}

void AddSetting(
  Tradeoff& knob, const std::string& name, const ink::TraceOptions& options, Tradeoff::Role role)
{
  knob.Add(
    name, [=] { Trace(options); },
    { { "ellipsoid, maximum", largestDeviation(Ellipsoid, EllipsoidMesh, true, options) },
      { "ellipsoid, minimum", largestDeviation(Ellipsoid, EllipsoidMesh, false, options) },
      { "torus, minimum", largestDeviation(Torus, TorusMesh, false, options) } },
    role);
}

} // namespace

int main()
{
  Tradeoff::PrintHeader();
  Tradeoff knob("Integrator and StepFactor (vtkInkLinesOfCurvature)",
    "Keep the default; its lines are almost as exact as the mesh allows. Euler with a factor of 1 is as "
    "published.",
    "largest deviation, half axes 3, 2, 1.2 and radii 2, 0.7",
    "tracing 1,677 lines of length 4 on 16,900 triangles");
  using Integrator = ink::StreamlineIntegrator;
  AddSetting(knob, "Euler, 1", OptionsOf(Integrator::Euler, 1.0), Tradeoff::Choice);
  AddSetting(knob, "Euler, 0.25", OptionsOf(Integrator::Euler, 0.25), Tradeoff::Choice);
  AddSetting(knob, "Euler, 0.0625", OptionsOf(Integrator::Euler, 0.0625), Tradeoff::Choice);
  AddSetting(knob, "Runge-Kutta, 1", OptionsOf(Integrator::RungeKutta4, 1.0), Tradeoff::Choice);
  AddSetting(knob, "Runge-Kutta, 0.5", OptionsOf(Integrator::RungeKutta4, 0.5), Tradeoff::Default);
  AddSetting(knob, "Runge-Kutta, 0.25", OptionsOf(Integrator::RungeKutta4, 0.25), Tradeoff::Choice);
  knob.Print();
  return EXIT_SUCCESS;
}
