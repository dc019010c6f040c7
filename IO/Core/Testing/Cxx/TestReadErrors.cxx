// SPDX-License-Identifier: BSD-3-Clause
#include "ReadError.h"
#include "VtkMessages.h"

#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkOutputWindow.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace fs = std::filesystem;
namespace io = ink::io;

namespace
{

std::string reasonOf(const auto& reading)
{
  try
  {
    reading();
  }
  catch (const io::ReadError& error)
  {
    return error.what();
  }
  return "";
}

} // namespace

TEST(VtkMessages, LoseWhereInVTKTheyCameFrom)
{
  EXPECT_EQ(ink::plainMessage("ERROR: In vtkX.cxx, line 7\nvtkX (0x55d0): cannot  open 'a  b'\n  twice.\n\n"),
    "cannot  open 'a  b' twice");
  EXPECT_EQ(ink::plainMessage("Warning: In /a b/vtkX.cxx, line 12\n"), "");
}

TEST(VtkMessages, KeepsTheFirstErrorAndGivesTheWindowBack)
{
  vtkOutputWindow* before = vtkOutputWindow::GetInstance();
  {
    const ink::VtkMessages messages;
    vtkNew<vtkObject> object;
    vtkWarningWithObjectMacro(object, "be careful");
    EXPECT_EQ(messages.error(), "");
    vtkErrorWithObjectMacro(object, "first");
    vtkErrorWithObjectMacro(object, "second");
    EXPECT_EQ(messages.error(), "first");
  }
  EXPECT_EQ(vtkOutputWindow::GetInstance(), before);
}

TEST(ReadError, NamesTheFileAndWhatIsThere)
{
  const fs::path folder = fs::temp_directory_path() / "InkReadErrors";
  fs::create_directories(folder);
  const fs::path empty = folder / "Empty.NII.GZ";
  std::ofstream(empty).flush();
  EXPECT_EQ(reasonOf([&] { io::checkExists(folder / "none"); }),
    "cannot read '" + (folder / "none").string() + "': no such file");
  EXPECT_EQ(
    reasonOf([&] { io::checkExists(empty); }), "cannot read '" + empty.string() + "': the file is empty");
  EXPECT_EQ(reasonOf([&] { io::checkExists("/dev/null"); }),
    "cannot read '/dev/null': it is neither a regular file nor a directory");
  EXPECT_EQ(reasonOf([&] { io::checkExists(folder); }), "");
  EXPECT_EQ(io::suffixOf(empty), ".nii.gz");
  EXPECT_EQ(io::suffixOf("a.b/c"), "");
  fs::remove_all(folder);
}

TEST(ReadError, ProgressMayEndReading)
{
  EXPECT_NO_THROW(io::advance({}, 0.5));
  EXPECT_NO_THROW(io::advance([](double) { return true; }, 0.5));
  EXPECT_THROW(io::advance([](double) { return false; }, 0.5), io::ReadAborted);
}
