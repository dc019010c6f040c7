// SPDX-License-Identifier: BSD-3-Clause
// Stipples in 16 bytes and in 8: how far from their positions they are and how much pictures differ, against
// the time of a frame.

#include "Tradeoff.h"

#include "vtkInkStippleControls.h"
#include "vtkInkStippleGenerator.h"
#include "vtkInkStippleMapper.h"

#include "Stippling/QuantizedPosition.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace
{

constexpr int Side = 128; // voxels
constexpr int WindowSize = 600;

/// A torus of value 1 with a border of some voxels.
void MakeTorus(vtkImageData* image)
{
  image->SetDimensions(Side, Side, Side);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* values = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  for (vtkIdType n = 0; n < values->GetNumberOfTuples(); ++n)
  {
    const glm::dvec3 p = glm::dvec3(n % Side, n / Side % Side, n / Side / Side) - 0.5 * (Side - 1);
    const double distance = std::hypot(std::hypot(p.x, p.y) - 40.0, p.z) - 18.0;
    values->SetValue(n, static_cast<float>(std::clamp(0.5 - 0.4 * distance, 0.0, 1.0)));
  }
}

class Scene
{
public:
  explicit Scene(int precision)
  {
    vtkNew<vtkImageData> torus;
    MakeTorus(torus);
    this->Generator->SetInputData(torus);
    this->Mapper->SetInputConnection(this->Generator->GetOutputPort());
    this->Mapper->SetPositionPrecision(precision);
    vtkNew<vtkInkStippleControls> controls;
    controls->Apply(this->Mapper);
    this->Mapper->SetSizeUnitToPixels();
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
    this->Renderer->SetBackground(1.0, 1.0, 1.0);
    this->Window->SetOffScreenRendering(true);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(WindowSize, WindowSize);
    this->Window->AddRenderer(this->Renderer);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    // At the torus' outer edge, in front: there it stays in the middle however large voxels are.
    const double middle = 0.5 * (Side - 1);
    camera->SetFocalPoint(middle, middle - 58.0, middle);
    camera->SetPosition(middle - 100.0, middle - 300.0, middle + 150.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->ParallelProjectionOn();
    this->Renderer->ResetCameraClippingRange();
  }

  vtkPolyData* GetStipples()
  {
    this->Generator->Update();
    return this->Generator->GetOutput();
  }

  void Draw(double pixelsPerVoxel)
  {
    this->Renderer->GetActiveCamera()->SetParallelScale(0.5 * WindowSize / pixelsPerVoxel);
    this->Window->Render();
    this->Window->WaitForCompletion();
  }

  std::vector<unsigned char> TakePicture(double pixelsPerVoxel)
  {
    this->Draw(pixelsPerVoxel);
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Window->GetPixelData(0, 0, WindowSize - 1, WindowSize - 1, 0, pixels);
    return { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() };
  }

private:
  vtkNew<vtkInkStippleGenerator> Generator;
  vtkNew<vtkInkStippleMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

using Rounding =
  std::function<glm::vec3(const glm::vec3& position, const glm::vec3& low, const glm::vec3& high)>;

/// How far, in voxels, the farthest stipple is from where the generator put it.
/// @param keep what is kept of a position relative to the data's center and size, as the mapper sees it, and
/// of
///   the box of its element's stipples
double FindPositionError(vtkPolyData* stipples, const Rounding& keep)
{
  const double half = 0.5 * (Side - 1);
  double farthest = 0.0;
  for (vtkIdType element = 0; element < stipples->GetNumberOfVerts(); ++element)
  {
    vtkIdType size;
    const vtkIdType* ids;
    stipples->GetVerts()->GetCellAtId(element, size, ids);
    const auto position = [&](vtkIdType i)
    {
      glm::dvec3 p;
      stipples->GetPoint(ids[i], &p.x);
      return (p - half) / static_cast<double>(Side);
    };
    glm::vec3 low(INFINITY);
    glm::vec3 high(-INFINITY);
    for (vtkIdType i = 0; i < size; ++i)
    {
      low = glm::min(low, glm::vec3(position(i)));
      high = glm::max(high, glm::vec3(position(i)));
    }
    for (vtkIdType i = 0; i < size; ++i)
    {
      farthest = std::max(
        farthest, glm::distance(glm::dvec3(keep(glm::vec3(position(i)), low, high)), position(i)) * Side);
    }
  }
  return farthest;
}

/// The darkness by which pictures differ, of all the darkness there is.
double Difference(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
  double difference = 0.0;
  double ink = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    difference += std::abs(a[i] - b[i]);
    ink += 255.0 - a[i];
  }
  return difference / ink;
}

} // namespace

int main()
{
  Tradeoff::PrintHeader();
  Scene quantized(vtkInkStippleMapper::QUANTIZED);
  Scene single(vtkInkStippleMapper::FLOAT);
  vtkPolyData* stipples = single.GetStipples();
  glm::vec3 edges(0.0f);
  FindPositionError(stipples,
    [&](const glm::vec3& position, const glm::vec3& low, const glm::vec3& high)
    {
      edges = glm::max(edges, high - low);
      return position;
    });
  const Rounding exact = [](const glm::vec3& position, const glm::vec3&, const glm::vec3&)
  { return position; };
  const Rounding packed = [&](const glm::vec3& position, const glm::vec3& low, const glm::vec3& high)
  {
    const ink::stipple::QuantizationBox box = ink::stipple::fitQuantizationBox(low, high, edges);
    return ink::stipple::dequantizePosition(ink::stipple::quantizePosition(position, box, edges), box, edges);
  };

  Tradeoff knob("Precision of positions (vtkInkStippleMapper)",
    "Keep single precision; where memory is short, take the quantized positions, which need 14 bytes a "
    "stipple "
    "instead of 20, its part of the voxel's data included, and which no eye tells from others before a voxel "
    "covers hundreds of pixels.",
    "positions: the farthest from the true one, in voxels; pictures: darkness that differs from single "
    "precision's, of all, where a voxel covers so many pixels",
    "a frame of " + std::to_string(stipples->GetNumberOfPoints() / 1000) +
      ",000 stipples, 8 a voxel, preset anatomy, 600x600");
  const struct
  {
    const char* Name;
    Scene& Drawn;
    const Rounding& Keep;
    Tradeoff::Role Role;
  } settings[] = { { "quantized, 8 bytes a stipple", quantized, packed, Tradeoff::Choice },
    { "single, 16 bytes a stipple", single, exact, Tradeoff::Default } };
  for (const auto& setting : settings)
  {
    Tradeoff::Errors errors{ { "positions", FindPositionError(stipples, setting.Keep) } };
    for (const double pixels : { 4.0, 40.0, 400.0 })
    {
      errors.emplace_back("pictures, " + std::to_string(static_cast<int>(pixels)) + " pixels",
        Difference(single.TakePicture(pixels), setting.Drawn.TakePicture(pixels)));
    }
    knob.Add(
      setting.Name, [&scene = setting.Drawn] { scene.Draw(4.0); }, errors, setting.Role);
  }
  knob.Print();
  return 0;
}
