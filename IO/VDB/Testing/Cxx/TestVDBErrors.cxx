// SPDX-License-Identifier: BSD-3-Clause
// What cannot be read: one message that says what was found and what was expected, and an empty output.

#include "InkTestChecks.h"
#include "VDBTestFiles.h"

#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInkVDBIsoSurfaceSampler.h"
#include "vtkInkVDBReader.h"
#include "vtkNew.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>

namespace
{

template <class Reader>
void ExpectFrom(InkTestChecks& check, const std::string& name, const std::vector<std::string>& words,
  const std::function<void(Reader*)>& change)
{
  vtkNew<Reader> reader;
  vtkNew<InkTestMessages> messages;
  messages->Observe(reader);
  messages->Observe(reader->GetExecutive());
  change(reader);
  reader->Update();
  check(reader->GetOutput()->GetNumberOfPoints() == 0, name, ": no points");
  messages->Expect(check, name, words);
}

/// For both classes.
void Expect(InkTestChecks& check, const std::string& name, const std::vector<std::string>& words,
  const std::string& file, const char* grid = nullptr, int memory = 4096)
{
  const auto change = [&](auto* reader)
  {
    reader->SetFileName(file.empty() ? nullptr : file.c_str());
    reader->SetGridName(grid);
    reader->SetMaximumMemory(memory);
  };
  ExpectFrom<vtkInkVDBReader>(check, name, words, change);
  ExpectFrom<vtkInkVDBIsoSurfaceSampler>(check, name + ", samples", words, change);
}

} // namespace

int TestVDBErrors(int, char*[])
{
  InkTestChecks check;
  const auto mask = openvdb::BoolGrid::create();
  mask->setName("mask");
  const std::string file = WriteVDB("TestVDBErrors.vdb", { MakeSphere(), mask });

  Expect(check, "no name", { "FileName is empty" }, "");
  Expect(check, "no file", { "\"none.vdb\"", "there is no such file" }, "none.vdb");
  Expect(check, "a folder", { "not a regular file" }, ".");
  std::ofstream("TestVDBErrorsText.vdb") << "These are words, not voxels.";
  Expect(check, "no OpenVDB file", { "it is not an OpenVDB file" }, "TestVDBErrorsText.vdb");
  std::ofstream("TestVDBErrorsEmpty.vdb").flush();
  Expect(check, "an empty file", { "it is not an OpenVDB file" }, "TestVDBErrorsEmpty.vdb");
  Expect(check, "no such grid", { "no grid 'density'", "'sphere' (float), 'mask' (bool)" }, file, "density");
  Expect(check, "not numbers", { "'mask'", "'bool'; expected float, double or half" }, file, "mask");

  std::ifstream in(file, std::ios::binary);
  const std::string bytes{ std::istreambuf_iterator<char>(in), {} };
  std::ofstream("TestVDBErrorsShort.vdb", std::ios::binary) << bytes.substr(0, bytes.size() / 2);
  Expect(check, "cut short", { "it " }, "TestVDBErrorsShort.vdb");

  const auto frustum = openvdb::FloatGrid::create();
  frustum->setName("frustum");
  frustum->tree().setValue(openvdb::Coord(1, 2, 3), 1.0f);
  frustum->setTransform(openvdb::math::Transform::createFrustumTransform(
    openvdb::BBoxd({ 0, 0, 0 }, { 10, 10, 10 }), 0.5, 10.0, 1.0));
  Expect(check, "frustum", { "NonlinearFrustumMap", "expected a linear one" },
    WriteVDB("TestVDBErrorsFrustum.vdb", { frustum }));

  // Two voxels far apart: little as a tree, much as an image.
  const auto far = openvdb::FloatGrid::create(0.0f);
  far->setName("far");
  far->tree().setValue(openvdb::Coord(-100000, 0, 0), 1.0f);
  far->tree().setValue(openvdb::Coord(100000, 100000, 100000), 1.0f);
  const std::string farFile = WriteVDB("TestVDBErrorsFar.vdb", { far });
  ExpectFrom<vtkInkVDBReader>(check, "too large",
    { "200005 x 100005 x 100005", "MiB", "allowed are 4096 MiB" },
    [&](vtkInkVDBReader* reader) { reader->SetFileName(farFile.c_str()); });
  vtkNew<vtkInkVDBIsoSurfaceSampler> sampler;
  sampler->SetFileName(farFile.c_str());
  sampler->SetValue(0, 0.5);
  sampler->Update();
  check(sampler->GetOutput()->GetNumberOfPoints() == 16, "16 points around two far voxels, found ",
    sampler->GetOutput()->GetNumberOfPoints());
  Expect(
    check, "too large a tree", { "'sphere'", "MiB of memory; allowed are 1 MiB" },
    [&]
    {
      const auto large =
        openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(60.0f, { 0, 0, 0 }, 1.0f, 3.0f);
      large->setName("sphere");
      return WriteVDB("TestVDBErrorsLarge.vdb", { large });
    }(),
    nullptr, 1);

  // An empty grid is no error, but worth a word.
  const auto empty = openvdb::FloatGrid::create(1.0f);
  empty->setName("nothing");
  const std::string emptyFile = WriteVDB("TestVDBErrorsNothing.vdb", { empty });
  ExpectFrom<vtkInkVDBReader>(check, "empty grid", { "nothing", "no active voxels" },
    [&](vtkInkVDBReader* reader) { reader->SetFileName(emptyFile.c_str()); });
  return check.Result();
}
