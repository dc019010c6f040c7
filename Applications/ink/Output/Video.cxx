// SPDX-License-Identifier: BSD-3-Clause
#include "Video.h"

#include "Errors.h"
#include "ReadError.h"

#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace ink::cli
{
namespace
{

// These codecs want sides of even length.
constexpr const char* evenSides = "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white";

/// ffmpeg's arguments for what it writes.
const std::map<std::string, std::vector<std::string>>& encodings()
{
  static const std::map<std::string, std::vector<std::string>> all{
    { ".mp4", { "-vf", evenSides, "-c:v", "libx264", "-crf", "18", "-pix_fmt", "yuv420p", "-f", "mp4" } },
    { ".webm",
      { "-vf", evenSides, "-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-pix_fmt", "yuv420p", "-f",
        "webm" } },
    { ".gif", { "-vf", "split[a][b];[a]palettegen[p];[b][p]paletteuse", "-f", "gif" } },
  };
  return all;
}

/// An executable file of a name in the folders that PATH lists; empty if there is none. VTK's FindProgram
/// would take one in the working directory first.
std::string findProgram(const std::string& name)
{
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
  {
    const std::string file = (folder.empty() ? "." : folder) + "/" + name;
    if (access(file.c_str(), X_OK) == 0 && fs::is_regular_file(file))
    {
      return file;
    }
  }
  return {};
}

/// The shortest text that reads back as the same number.
std::string exactText(double number)
{
  std::array<char, 32> text;
  return { text.data(), std::to_chars(text.data(), text.data() + text.size(), number).ptr };
}

} // namespace

bool Video::isVideo(const fs::path& file)
{
  return encodings().contains(io::suffixOf(file));
}

Video::Video(const fs::path& file, int width, int height, double framesPerSecond)
  : File(file)
  , Output(file)
  , Encoded(io::openUnnamed(this->Output.temporaryFolder()))
  , Messages(io::openUnnamed(fs::temp_directory_path()))
{
  const std::string program = findProgram("ffmpeg");
  if (program.empty())
  {
    throw Failure("cannot write '" + file.string() +
      "': expected the program ffmpeg on PATH, found none; out_%04d.png writes pictures");
  }
  int ends[2] = { -1, -1 };
  if (this->Encoded.get() < 0 || this->Messages.get() < 0 || pipe2(ends, O_CLOEXEC) != 0)
  {
    throw Failure("cannot write '" + file.string() + "': " + std::strerror(errno));
  }
  const io::FileHandle reading(ends[0]);
  this->Pictures = io::FileHandle(ends[1]);

  std::vector<std::string> words{ program, "-v", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s",
    std::to_string(width) + "x" + std::to_string(height), "-r", exactText(framesPerSecond), "-i", "pipe:0",
    "-an" };
  const std::vector<std::string>& encoding = encodings().at(io::suffixOf(file));
  words.insert(words.end(), encoding.begin(), encoding.end());
  words.push_back("/proc/self/fd/" + std::to_string(this->Encoded.get()));
  std::vector<char*> arguments;
  for (std::string& word : words)
  {
    arguments.push_back(word.data());
  }
  arguments.push_back(nullptr);

  // A broken pipe is an error to report, not the end of this program.
  std::signal(SIGPIPE, SIG_IGN);
  this->Encoder = fork();
  if (this->Encoder == 0)
  {
    std::signal(SIGPIPE, SIG_DFL);
    fcntl(this->Encoded.get(), F_SETFD, 0);
    dup2(reading.get(), STDIN_FILENO);
    dup2(this->Messages.get(), STDOUT_FILENO);
    dup2(this->Messages.get(), STDERR_FILENO);
    execv(program.c_str(), arguments.data());
    _exit(127);
  }
  if (this->Encoder < 0)
  {
    throw Failure("cannot start '" + program + "': " + std::strerror(errno));
  }
}

Video::~Video()
{
  if (this->Encoder > 0)
  {
    // Not finished: there is nothing to wait for.
    kill(this->Encoder, SIGKILL);
    waitpid(this->Encoder, nullptr, 0);
  }
}

void Video::add(std::span<const unsigned char> rgb)
{
  if (!io::writeAll(this->Pictures.get(), rgb))
  {
    this->fail();
  }
}

void Video::finish()
{
  this->Pictures.close();
  int status = -1;
  while (waitpid(this->Encoder, &status, 0) < 0 && errno == EINTR)
  {
  }
  this->Encoder = -1;
  const bool isEmpty = lseek(this->Encoded.get(), 0, SEEK_END) <= 0;
  if (!WIFEXITED(status) || WEXITSTATUS(status) != EXIT_SUCCESS || isEmpty)
  {
    this->fail();
  }
  this->Output.write(
    [&](const ByteSink& sink)
    {
      if (!io::readAll(this->Encoded.get(), sink))
      {
        throw Failure("cannot write '" + this->File.string() + "': " + std::strerror(errno));
      }
    });
}

void Video::fail()
{
  std::array<unsigned char, 4096> bytes;
  std::string said(reinterpret_cast<const char*>(bytes.data()), io::readAt(this->Messages.get(), 0, bytes));
  said = said.substr(0, said.find('\n'));
  throw Failure(
    "cannot write '" + this->File.string() + "': ffmpeg failed" + (said.empty() ? "" : ": " + said));
}

} // namespace ink::cli
