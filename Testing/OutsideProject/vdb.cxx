// SPDX-License-Identifier: BSD-3-Clause
// Writes a small OpenVDB file and samples it with an installed vtkInk; fails if no points come out.
#include <Fields/Grid/GridField.h>
#include <Fields/Vdb/VdbWrite.h>
#include <vtkInkVDBIsoSurfaceSampler.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <span>
#include <vector>

int main()
{
  const ink::GridGeometry geometry({ 8, 8, 8 });
  std::vector<float> values(geometry.sampleCount(), 0.0f);
  values[geometry.offset({ 3, 4, 5 })] = 1.0f;
  const ink::GridField<float> volume(geometry, std::span<const float>(values));
  std::ofstream("outside.vdb", std::ios::binary) << ink::serializeVdb(ink::makeVdbGrid(volume, {}));

  vtkNew<vtkInkVDBIsoSurfaceSampler> sampler;
  sampler->SetFileName("outside.vdb");
  sampler->SetValue(0, 0.5);
  sampler->Update();
  const vtkIdType points = sampler->GetOutput()->GetNumberOfPoints();
  std::cout << points << " points" << std::endl;
  return points > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
