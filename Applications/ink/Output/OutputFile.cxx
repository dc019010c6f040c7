// SPDX-License-Identifier: BSD-3-Clause
#include "OutputFile.h"

#include "Errors.h"
#include "FileHandle.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace fs = std::filesystem;

namespace ink::cli
{
namespace
{

constexpr std::array<int, 3> caughtSignals{ SIGINT, SIGTERM, SIGHUP };

// For the signal handler, which may only touch such things.
const char* volatile temporaryName = nullptr;

extern "C" void removeTemporary(int signal)
{
  if (temporaryName)
  {
    unlink(temporaryName);
  }
  // The default action was restored when this handler was entered.
  raise(signal);
}

/// A new file that is gone when this object is, unless it was renamed.
class TemporaryFile
{
public:
  TemporaryFile(std::string name, mode_t mode)
    : Name(std::move(name))
  {
    for (std::size_t i = 0; i < caughtSignals.size(); ++i)
    {
      struct sigaction action = {};
      action.sa_handler = removeTemporary;
      action.sa_flags = static_cast<int>(SA_RESETHAND);
      sigaction(caughtSignals[i], nullptr, &this->Previous[i]);
      if (this->Previous[i].sa_handler != SIG_IGN)
      {
        sigaction(caughtSignals[i], &action, nullptr);
      }
    }
    this->File =
      io::FileHandle(open(this->Name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode));
    this->Created = this->File.get() >= 0;
    temporaryName = this->Created ? this->Name.c_str() : nullptr;
  }

  ~TemporaryFile()
  {
    if (this->Created && !this->Renamed)
    {
      unlink(this->Name.c_str());
    }
    for (std::size_t i = 0; i < caughtSignals.size(); ++i)
    {
      sigaction(caughtSignals[i], &this->Previous[i], nullptr);
    }
    temporaryName = nullptr;
  }

  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  int descriptor() const { return this->File.get(); }
  bool close() { return this->File.close(); }

  bool renameTo(const fs::path& target)
  {
    this->Renamed = rename(this->Name.c_str(), target.c_str()) == 0;
    return this->Renamed;
  }

private:
  std::string Name;
  io::FileHandle File;
  bool Created = false;
  bool Renamed = false;
  std::array<struct sigaction, caughtSignals.size()> Previous;
};

[[noreturn]] void fail(const fs::path& path, const std::string& reason)
{
  throw Failure("cannot write '" + path.string() + "': " + reason);
}

} // namespace

OutputFile::OutputFile(const fs::path& path)
  : Given(path)
{
  if (path == standardOutput)
  {
    if (isatty(STDOUT_FILENO) == 1)
    {
      fail(path, "the standard output stream is a terminal; expected a file or a pipe");
    }
    this->Replaces = false;
    return;
  }
  std::error_code error;
  // Absolute first: of a path that does not exist yet, the canonical one may stay relative.
  this->Target = fs::weakly_canonical(fs::absolute(path), error);
  if (error || this->Target.empty())
  {
    fail(path, error ? error.message() : "no file name");
  }
  const fs::file_status status = fs::status(this->Target, error);
  if (fs::is_directory(status))
  {
    fail(path, "it is a directory");
  }
  const fs::path folder = this->Target.parent_path();
  if (!fs::is_directory(folder, error))
  {
    fail(path, "there is no directory '" + folder.string() + "'");
  }
  if (fs::exists(status) && access(this->Target.c_str(), W_OK) != 0)
  {
    fail(path, std::strerror(errno));
  }
  this->Replaces = !fs::exists(status) || fs::is_regular_file(status);
  if (this->Replaces && access(folder.c_str(), W_OK | X_OK) != 0)
  {
    fail(path, "directory '" + folder.string() + "': " + std::strerror(errno));
  }
}

void OutputFile::write(std::span<const unsigned char> data) const
{
  this->write([data](const ByteSink& sink) { sink(data); });
}

void OutputFile::write(const std::function<void(const ByteSink&)>& produce) const
{
  const auto require = [this](bool done)
  {
    if (!done)
    {
      fail(this->Given, std::strerror(errno));
    }
  };
  if (!this->Replaces)
  {
    io::FileHandle device(this->Given == standardOutput ? fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0)
                                                        : open(this->Target.c_str(), O_WRONLY | O_CLOEXEC));
    require(device.get() >= 0);
    produce([&](std::span<const unsigned char> data) { require(io::writeAll(device.get(), data)); });
    require(device.close());
    return;
  }

  // A new file gets the usual permissions, a replaced one keeps its own.
  struct stat existing = {};
  const bool exists = stat(this->Target.c_str(), &existing) == 0;
  const std::string name = this->Target.string() + "." + std::to_string(getpid()) + ".tmp";
  TemporaryFile temporary(name, 0666);
  require(temporary.descriptor() >= 0 &&
    (!exists || fchmod(temporary.descriptor(), existing.st_mode & 07777) == 0));
  produce([&](std::span<const unsigned char> data) { require(io::writeAll(temporary.descriptor(), data)); });
  require(fsync(temporary.descriptor()) == 0 && temporary.close() && temporary.renameTo(this->Target));
}

fs::path OutputFile::temporaryFolder() const
{
  return this->Replaces ? this->Target.parent_path() : fs::temp_directory_path();
}

} // namespace ink::cli
