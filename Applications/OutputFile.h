#pragma once

#include <filesystem>
#include <span>

namespace ink::cli
{

/// A file that is either written whole or left as it was. The data goes to a temporary file beside it, which
/// then takes its place; no error and no signal that can be caught leaves the temporary file behind.
class OutputFile
{
public:
  /// \throw Failure if it is clear already that path cannot be written: before the work, not after it.
  explicit OutputFile(const std::filesystem::path& path);

  /// \throw Failure if the data cannot be written whole.
  void write(std::span<const unsigned char> data) const;

private:
  std::filesystem::path Given;  ///< for messages
  std::filesystem::path Target; ///< links followed, so that they stay
  bool Replaces;                ///< false for devices and pipes, which cannot be renamed over
};

} // namespace ink::cli
