// SPDX-License-Identifier: BSD-3-Clause
// The stipples of a ball: which voxels have them, what their arrays say, and what each property changes.

#include "InkTestChecks.h"
#include "SamplerTestImages.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInkStippleGenerator.h"
#include "vtkMath.h"
#include "vtkNew.h"

#include <cstdlib>
#include <functional>
#include <string>

namespace
{

const double Radius = 10.0;

/// 100 in a ball around the origin, 0 outside, a step of one voxel in between.
vtkSmartPointer<vtkImageData> MakeBall(int type = VTK_FLOAT)
{
  return MakeImage(type, { -15, 16, -14, 15, -16, 14 },
    [](double x, double y, double z)
    { return 100.0 * std::clamp(Radius + 0.5 - std::sqrt(x * x + y * y + z * z), 0.0, 1.0); });
}

vtkSmartPointer<vtkPolyData> Stipple(
  vtkImageData* image,
  const std::function<void(vtkInkStippleGenerator*)>& change = [](vtkInkStippleGenerator*) {})
{
  vtkNew<vtkInkStippleGenerator> generator;
  generator->SetInputData(image);
  change(generator);
  generator->Update();
  return generator->GetOutput();
}

double Field(vtkPolyData* data, const char* name, int component = 0)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() == 1 ? array->GetComponent(0, component) : -1.0;
}

double Distance(vtkPolyData* data, vtkIdType point)
{
  double p[3];
  data->GetPoint(point, p);
  return vtkMath::Norm(p);
}

std::vector<std::array<double, 3>> PointsOf(vtkPolyData* data)
{
  std::vector<std::array<double, 3>> points(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t n = 0; n < points.size(); ++n)
  {
    data->GetPoint(static_cast<vtkIdType>(n), points[n].data());
  }
  return points;
}

/// One poly-vertex for each element, which hold all points in their order, and one tuple for each in each
/// array.
void CheckContract(InkTestChecks& check, vtkPolyData* data, int perVoxel)
{
  const vtkIdType elements = data->GetNumberOfCells();
  check(elements > 1000 && data->GetNumberOfVerts() == elements, "many elements, found ", elements);
  check(data->GetNumberOfPoints() == elements * perVoxel, perVoxel, " stipples an element, found ",
    data->GetNumberOfPoints(), " of ", elements);
  vtkIdType next = 0;
  for (vtkIdType e = 0; e < elements; ++e)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    data->GetVerts()->GetCellAtId(e, size, ids);
    bool ordered = size == perVoxel && data->GetCellType(e) == VTK_POLY_VERTEX;
    for (vtkIdType i = 0; i < size; ++i)
    {
      ordered = ordered && ids[i] == next++;
    }
    if (!check(ordered, "element ", e, " to hold the next ", perVoxel, " points"))
    {
      return;
    }
  }
  vtkCellData* cells = data->GetCellData();
  check(cells->GetNormals() && cells->GetNormals()->GetName() == std::string("Normals"), "normals");
  for (const char* name : { "Normals", "GradientMagnitude", "Value" })
  {
    check(cells->GetArray(name) && cells->GetArray(name)->GetNumberOfTuples() == elements, "a ", name,
      " for each element");
  }
  check(Field(data, "ElementKind") == 0.0, "volume elements");
  check(Field(data, "ElementSize") == 1.0, "elements of size 1, found ", Field(data, "ElementSize"));
  check(Field(data, "StipplesPerElement") == perVoxel, "StipplesPerElement of ", perVoxel);
  check(Field(data, "ScalarRange", 0) == 0.0 && Field(data, "ScalarRange", 1) == 100.0, "the scalar range");
  const double steepest = Field(data, "GradientMagnitudeRange", 1);
  check(Field(data, "GradientMagnitudeRange", 0) == 0.0 && steepest > 30.0 && steepest <= 60.0,
    "the steepest gradient to be about 50, found ", steepest);
}

void CheckBall(InkTestChecks& check, vtkPolyData* data)
{
  double outmost = 0.0;
  double inmost = 1e9;
  for (vtkIdType n = 0; n < data->GetNumberOfPoints(); ++n)
  {
    outmost = std::max(outmost, Distance(data, n));
    inmost = std::min(inmost, Distance(data, n));
  }
  check(inmost > Radius - 3.5 && outmost < Radius + 3.5, "stipples at the ball's surface, found distances ",
    inmost, " to ", outmost);
  double leastCosine = 1.0;
  double magnitudes[2];
  double values[2];
  data->GetCellData()->GetArray("GradientMagnitude")->GetRange(magnitudes);
  data->GetCellData()->GetArray("Value")->GetRange(values);
  for (vtkIdType e = 0; e < data->GetNumberOfCells(); ++e)
  {
    double normal[3];
    double point[3];
    data->GetCellData()->GetNormals()->GetTuple(e, normal);
    data->GetPoint(e * 8, point);
    leastCosine = std::min(leastCosine, vtkMath::Dot(normal, point) / vtkMath::Norm(point));
    check(std::abs(vtkMath::Norm(normal) - 1.0) < 1e-5, "a unit normal");
  }
  check(leastCosine > 0.95, "normals out of the ball, found a cosine of ", leastCosine);
  check(magnitudes[0] > 0.0 && magnitudes[1] == 1.0, "magnitudes up to 1");
  check(values[0] >= 0.0 && values[0] < 0.3 && values[1] <= 1.0 && values[1] > 0.7,
    "values from 0 to 1, found ", values[0], " to ", values[1]);
}

} // namespace

int TestStippleGenerator(int, char*[])
{
  InkTestChecks check;
  const auto ball = MakeBall();
  const auto plain = Stipple(ball);
  CheckContract(check, plain, 8);
  CheckBall(check, plain);
  const double share =
    static_cast<double>(plain->GetNumberOfCells()) / static_cast<double>(ball->GetNumberOfPoints());
  check(share > 0.045 && share < 0.055, "a twentieth of the voxels, found ", share);
  CheckContract(check, Stipple(ball, [](auto* g) { g->SetMaximumStipples(3); }), 3);

  // The lists of fewer stipples are the beginnings of longer ones' in voxels that mind no neighbor;
  // elsewhere the longer lists leave room. Everywhere, another seed gives others.
  check(PointsOf(Stipple(ball)) == PointsOf(plain), "the same stipples once more");
  check(PointsOf(Stipple(ball, [](auto* g) { g->SetSeed(1); })) != PointsOf(plain), "others by another seed");
  setenv("VTK_SMP_MAX_THREADS", "1", 1);
  check(PointsOf(Stipple(ball)) == PointsOf(plain), "the same stipples on one thread");
  unsetenv("VTK_SMP_MAX_THREADS");
  check(PointsOf(Stipple(MakeBall(VTK_UNSIGNED_CHAR))) == PointsOf(Stipple(MakeBall(VTK_SHORT))),
    "the same stipples from the same values of another type");

  const auto atLeast = [&](double threshold)
  {
    return Stipple(ball,
      [=](auto* g)
      {
        g->SetThresholdModeToMagnitude();
        g->SetGradientThreshold(threshold);
      });
  };
  check(atLeast(0.0)->GetNumberOfCells() > atLeast(20.0)->GetNumberOfCells() &&
      atLeast(20.0)->GetNumberOfCells() > 500 && atLeast(101.0)->GetNumberOfCells() == 0,
    "fewer elements above higher thresholds");
  const auto all = Stipple(ball, [](auto* g) { g->SetGradientPercentile(0.0); });
  check(all->GetNumberOfCells() == atLeast(0.0)->GetNumberOfCells(), "no element without a gradient");

  const auto window = Stipple(ball,
    [](auto* g)
    {
      g->UseScalarWindowOn();
      g->SetScalarWindow(60.0, 80.0);
      g->PassScalarsOn();
    });
  double range[2];
  window->GetCellData()->GetArray("Value")->GetRange(range);
  // Its voxels reach it, but their middles may lie outside.
  check(window->GetNumberOfCells() > 100 && range[0] > 0.25 && range[0] < 0.6 &&
      window->GetNumberOfCells() < all->GetNumberOfCells() / 2,
    "values around the window, found ", range[0], " to ", range[1]);
  vtkDataArray* colors = window->GetCellData()->GetScalars();
  check(colors && colors->GetName() == std::string("Density") &&
      colors->GetNumberOfTuples() == window->GetNumberOfCells(),
    "the scalars passed on");
  check(!plain->GetCellData()->GetScalars(), "no scalars passed on unasked");

  const vtkSmartPointer<vtkImageData> named = vtkSmartPointer<vtkImageData>::New();
  named->DeepCopy(ball);
  named->GetPointData()->GetScalars()->SetName("Value");
  const auto kept = Stipple(named, [](auto* g) { g->PassScalarsOn(); });
  kept->GetCellData()->GetArray("Value")->GetRange(range);
  check(range[1] <= 1.0, "values from 0 to 1 beside scalars of that name, found up to ", range[1]);
  colors = kept->GetCellData()->GetScalars();
  check(colors && colors->GetName() == std::string("InputValue") && colors->GetRange()[1] > 1.0,
    "scalars passed on under another name");

  const auto inVoxel = [](vtkPolyData* data, vtkIdType n)
  {
    double p[3];
    data->GetPoint(n, p);
    return std::max({ std::abs(p[0] - std::round(p[0])), std::abs(p[1] - std::round(p[1])),
      std::abs(p[2] - std::round(p[2])) });
  };
  for (const double thickness : { 0.0, 2.0 })
  {
    const auto layer = Stipple(ball, [=](auto* g) { g->SetLayerThickness(thickness); });
    double most = 0.0;
    for (vtkIdType n = 0; n < layer->GetNumberOfPoints(); ++n)
    {
      const vtkIdType first = n - n % 8;
      double normal[3];
      double a[3];
      double b[3];
      layer->GetCellData()->GetNormals()->GetTuple(n / 8, normal);
      layer->GetPoint(n, a);
      layer->GetPoint(first, b);
      vtkMath::Subtract(a, b, a);
      most = std::max(most, std::abs(vtkMath::Dot(a, normal)));
      check(inVoxel(layer, n) <= 0.5, "stipples in voxels");
    }
    check(thickness == 0.0 ? most < 1e-4 : most > 1.0, "a layer of thickness ", thickness, ", found ", most);
  }

  vtkNew<vtkInkStippleGenerator> clamped;
  clamped->SetMaximumStipples(1000);
  clamped->SetGradientPercentile(-5.0);
  clamped->SetLayerThickness(9.0);
  check(clamped->GetMaximumStipples() == 64 && clamped->GetGradientPercentile() == 0.0 &&
      clamped->GetLayerThickness() == 2.0,
    "clamped properties");
  return check.Result();
}
