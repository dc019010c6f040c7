// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ByteSink.h"

#include <filesystem>
#include <functional>
#include <span>

namespace ink::cli
{

using io::ByteSink;

/// The name that stands for the standard output stream.
inline constexpr const char* standardOutput = "-";

/// A file that is either written whole or left as it was. The data goes to a temporary file beside it, which
/// then takes its place; no error and no signal that can be caught leaves the temporary file behind.
class OutputFile
{
public:
  /// @throws Failure if it is clear already that path cannot be written: before the work, not after it.
  explicit OutputFile(const std::filesystem::path& path);

  /// @throws Failure if the data cannot be written whole.
  void write(std::span<const unsigned char> data) const;
  /// The same for data that `produce` hands over part by part; what it throws is passed on.
  void write(const std::function<void(const ByteSink&)>& produce) const;

  /// Where other files have room for as much as this one: its folder, or the system's for temporary files if
  /// this one is a device.
  std::filesystem::path temporaryFolder() const;

private:
  std::filesystem::path Given;  ///< for messages
  std::filesystem::path Target; ///< links followed, so that they stay
  bool Replaces; ///< false for devices, pipes and the standard output stream, which cannot be renamed over
};

} // namespace ink::cli
