// SPDX-License-Identifier: BSD-3-Clause
// .vdb files for the tests of what reads them.
#ifndef VDBTestFiles_h
#define VDBTestFiles_h

#include "OpenVDBTrees.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <openvdb/tools/LevelSetSphere.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

/// A file's name in the folder for temporary files, with the running test's, as ctest runs several at once.
inline std::string FileOfTest(const std::string& name)
{
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  std::string file = std::string(test.test_suite_name()) + test.name() + name;
  std::replace(file.begin(), file.end(), '/', '_');
  return testing::TempDir() + file;
}

inline std::string WriteVDB(const std::string& name, const openvdb::GridPtrVec& grids)
{
  openvdb::initialize();
  std::string file = FileOfTest(name);
  openvdb::io::File(file).write(grids);
  return file;
}

template <class Grid = openvdb::FloatGrid>
typename Grid::Ptr MakeSphere(const std::string& name = "sphere")
{
  const auto grid = openvdb::tools::createLevelSetSphere<Grid>(6.0f, { 1.0f, 2.0f, 3.0f }, 0.5f, 3.0f);
  grid->setName(name);
  return grid;
}

/// A point and its normal, which sort and compare exactly.
using VDBSample = std::array<double, 6>;

inline std::vector<VDBSample> SamplesOf(vtkPolyData* data)
{
  std::vector<VDBSample> samples(static_cast<std::size_t>(data->GetNumberOfPoints()));
  vtkDataArray* normals = data->GetPointData()->GetNormals();
  for (std::size_t n = 0; normals && n < samples.size(); ++n)
  {
    data->GetPoint(static_cast<vtkIdType>(n), samples[n].data());
    normals->GetTuple(static_cast<vtkIdType>(n), samples[n].data() + 3);
  }
  std::sort(samples.begin(), samples.end());
  return samples;
}

#endif
