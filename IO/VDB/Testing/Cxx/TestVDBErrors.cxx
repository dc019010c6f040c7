// SPDX-License-Identifier: BSD-3-Clause
// What cannot be read: one message that says what was found and what was expected, and an empty output.

#include "InkTestMessages.h"
#include "VDBTestFiles.h"

#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkInkVDBIsoSurfaceSampler.h"
#include "vtkInkVDBReader.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>

namespace
{

template <class Reader>
void ExpectFrom(
  const std::string& name, const std::vector<std::string>& words, const std::function<void(Reader*)>& change)
{
  vtkNew<Reader> reader;
  vtkNew<InkTestMessages> messages;
  messages->Observe(reader);
  messages->Observe(reader->GetExecutive());
  change(reader);
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0) << name << ": no points";
  messages->Expect(name, words);
}

/// For both classes.
void Expect(const std::string& name, const std::vector<std::string>& words, const std::string& file,
  const char* grid = nullptr, int memory = 4096)
{
  const auto change = [&](auto* reader)
  {
    reader->SetFileName(file.empty() ? nullptr : file.c_str());
    reader->SetGridName(grid);
    reader->SetMaximumMemory(memory);
  };
  ExpectFrom<vtkInkVDBReader>(name, words, change);
  ExpectFrom<vtkInkVDBIsoSurfaceSampler>(name + ", samples", words, change);
}

} // namespace

TEST(VDBErrors, FilesOfOtherContents)
{
  Expect("no name", { "FileName is empty" }, "");
  Expect("no file", { "\"none.vdb\"", "there is no such file" }, "none.vdb");
  Expect("a folder", { "not a regular file" }, ".");
  std::ofstream(FileOfTest("Text.vdb")) << "These are words, not voxels.";
  Expect("no OpenVDB file", { "it is not an OpenVDB file" }, FileOfTest("Text.vdb"));
  std::ofstream(FileOfTest("Empty.vdb")).flush();
  Expect("an empty file", { "it is not an OpenVDB file" }, FileOfTest("Empty.vdb"));
}

TEST(VDBErrors, AreToldByWhatAsksBeforeSampling)
{
  const auto expect = [](const std::string& name, auto ask)
  {
    vtkNew<vtkInkVDBIsoSurfaceSampler> sampler;
    vtkNew<InkTestMessages> messages;
    messages->Observe(sampler);
    sampler->SetFileName("none.vdb");
    EXPECT_EQ(ask(sampler.Get()), 0) << name;
    messages->Expect(name, { "\"none.vdb\"", "there is no such file" });
  };
  expect("smoothing", [](auto* sampler) { return sampler->SuggestSmoothing(0.5); });
  expect("cells", [](auto* sampler) { return sampler->CountActiveCells(0.5); });
}

TEST(VDBErrors, FilesThatEndTooSoon)
{
  std::ifstream in(WriteVDB("Whole.vdb", { MakeSphere() }), std::ios::binary);
  const std::string bytes{ std::istreambuf_iterator<char>(in), {} };
  std::ofstream(FileOfTest("Short.vdb"), std::ios::binary) << bytes.substr(0, bytes.size() / 2);
  Expect("cut short", { "it " }, FileOfTest("Short.vdb"));
}

TEST(VDBErrors, GridsThatCannotBeRead)
{
  const auto mask = ink::testing::emptyGrid<openvdb::BoolGrid>("mask");
  const std::string file = WriteVDB(".vdb", { MakeSphere(), mask });
  Expect("no such grid", { "no grid 'density'", "'sphere' (float), 'mask' (bool)" }, file, "density");
  Expect("not numbers", { "'mask'", "'bool'; expected float, double or half" }, file, "mask");

  const auto frustum = openvdb::FloatGrid::create();
  frustum->setName("frustum");
  frustum->tree().setValue(openvdb::Coord(1, 2, 3), 1.0f);
  frustum->setTransform(openvdb::math::Transform::createFrustumTransform(
    openvdb::BBoxd({ 0, 0, 0 }, { 10, 10, 10 }), 0.5, 10.0, 1.0));
  Expect("frustum", { "NonlinearFrustumMap", "expected a linear one" }, WriteVDB("Frustum.vdb", { frustum }));
}

/// Two voxels far apart: little as a tree, much as an image.
TEST(VDBErrors, ImagesLargerThanTheMemoryAllowed)
{
  const auto far = openvdb::FloatGrid::create(0.0f);
  far->setName("far");
  far->tree().setValue(openvdb::Coord(-100000, 0, 0), 1.0f);
  far->tree().setValue(openvdb::Coord(100000, 100000, 100000), 1.0f);
  const std::string file = WriteVDB(".vdb", { far });
  ExpectFrom<vtkInkVDBReader>("too large", { "200005 x 100005 x 100005", "MiB", "allowed are 4096 MiB" },
    [&](vtkInkVDBReader* reader) { reader->SetFileName(file.c_str()); });
  vtkNew<vtkInkVDBIsoSurfaceSampler> sampler;
  sampler->SetFileName(file.c_str());
  sampler->SetValue(0, 0.5);
  sampler->Update();
  EXPECT_EQ(sampler->GetOutput()->GetNumberOfPoints(), 16) << "points around two far voxels";
}

TEST(VDBErrors, TreesLargerThanTheMemoryAllowed)
{
  const auto large = openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(60.0f, { 0, 0, 0 }, 1.0f, 3.0f);
  large->setName("sphere");
  Expect("too large a tree", { "'sphere'", "MiB of memory; allowed are 1 MiB" }, WriteVDB(".vdb", { large }),
    nullptr, 1);
}

/// An empty grid is no error, but worth a word.
TEST(VDBErrors, EmptyGridsAreMentioned)
{
  const auto empty = openvdb::FloatGrid::create(1.0f);
  empty->setName("nothing");
  const std::string file = WriteVDB(".vdb", { empty });
  ExpectFrom<vtkInkVDBReader>("empty grid", { "nothing", "no active voxels" },
    [&](vtkInkVDBReader* reader) { reader->SetFileName(file.c_str()); });
}
