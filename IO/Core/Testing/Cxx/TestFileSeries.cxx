// SPDX-License-Identifier: BSD-3-Clause
#include "FileSeries.h"
#include "ReadError.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <unistd.h>

namespace
{

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

/// A folder with files, which goes with this object.
class Folder
{
public:
  explicit Folder(const Names& names)
  {
    fs::create_directories(this->Path);
    for (const std::string& name : names)
    {
      std::ofstream(this->Path / name) << "x";
    }
  }
  ~Folder() { fs::remove_all(this->Path); }

  /// The names of a series' files; none where it is refused.
  Names filesOf(const std::string& pattern) const
  {
    Names names;
    try
    {
      for (const fs::path& file : ink::io::filesOfSeries(this->Path / pattern))
      {
        EXPECT_EQ(file.parent_path(), this->Path);
        names.push_back(file.filename().string());
      }
    }
    catch (const ink::io::ReadError& error)
    {
      EXPECT_NE(std::string(error.what()).find("no file has a name of this pattern"), std::string::npos);
    }
    return names;
  }

  const fs::path Path = fs::temp_directory_path() / ("ink-series-" + std::to_string(getpid()));
};

} // namespace

TEST(FileSeries, ANumberStandsForDigits)
{
  const Folder folder({ "s_1.ply", "s_10.ply", "s_002.ply", "s_.ply", "s_x.ply", "s_3.ply.gz", "s_4.vtp",
    "as_5.ply", "s_-6.ply", ".s_7.ply" });
  const Names expected{ "s_1.ply", "s_002.ply", "s_10.ply" };
  EXPECT_EQ(folder.filesOf("s_%d.ply"), expected);
  EXPECT_EQ(folder.filesOf("s_%03d.ply"), expected);
  EXPECT_EQ(folder.filesOf("%d.ply"), Names());
  EXPECT_EQ(folder.filesOf("s_%d.ply.gz"), Names{ "s_3.ply.gz" });
}

TEST(FileSeries, BesideANumberCharactersStandForThemselves)
{
  const Folder folder({ "scan[1]_1.ply", "scan[1]_2.ply", "scan1_3.ply", "run*_4.ply", "run_5.ply",
    "runaway_6.ply", "what?_7.ply", "whats_8.ply", "x", "1_1" });
  EXPECT_EQ(folder.filesOf("scan[1]_%d.ply"), (Names{ "scan[1]_1.ply", "scan[1]_2.ply" }));
  EXPECT_EQ(folder.filesOf("run*_%d.ply"), Names{ "run*_4.ply" });
  EXPECT_EQ(folder.filesOf("what?_%d.ply"), Names{ "what?_7.ply" });
  // What the number stands for is in neither part, and a name may be shorter than both.
  EXPECT_EQ(folder.filesOf("*%d"), Names());
  EXPECT_EQ(folder.filesOf("****_%d"), Names());
  EXPECT_EQ(folder.filesOf("1_%d1_1"), Names());
}

TEST(FileSeries, WithoutANumberAPatternIsAsInTheShell)
{
  const Folder folder({ "s_2.ply", "s_10.ply", "s_a.ply", ".s_3.ply", "s_4.vtp" });
  EXPECT_EQ(folder.filesOf("s_*.ply"), (Names{ "s_2.ply", "s_10.ply", "s_a.ply" }));
  EXPECT_EQ(folder.filesOf("*_?.ply"), (Names{ "s_2.ply", "s_a.ply" }));
  EXPECT_EQ(folder.filesOf("t*"), Names());
}

TEST(FileSeries, AFileOfTheVeryNameIsNone)
{
  const Folder folder({ "s_%d.ply", "s*.ply" });
  EXPECT_FALSE(ink::io::isSeries(folder.Path / "s_%d.ply"));
  EXPECT_FALSE(ink::io::isSeries(folder.Path / "s*.ply"));
  EXPECT_TRUE(ink::io::isSeries(folder.Path / "t_%04d.ply"));
  EXPECT_TRUE(ink::io::isSeries(folder.Path / "t*.ply"));
  EXPECT_TRUE(ink::io::isSeries("a.pvd"));
  EXPECT_FALSE(ink::io::isSeries("a%.ply"));
}
