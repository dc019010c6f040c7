// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FileHandle.h"
#include "OutputFile.h"

#include <cstddef>
#include <filesystem>
#include <span>

#include <sys/types.h>

namespace ink::cli
{

/// A video that ffmpeg, a program that has to be on PATH, encodes from pictures: H.264 in .mp4, VP9 in .webm,
/// or an animated .gif. It is written to its place when it is whole.
class Video
{
public:
  /// Whether a name is a video's.
  static bool isVideo(const std::filesystem::path& file);

  /// @throws Failure if the file cannot be written or there is no ffmpeg
  Video(const std::filesystem::path& file, int width, int height, double framesPerSecond);
  ~Video();
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;

  /// @param rgb red, green and blue of all pixels, the uppermost row first. @throws Failure
  void add(std::span<const unsigned char> rgb);

  /// @throws Failure if ffmpeg fails
  void finish();

private:
  [[noreturn]] void fail();

  std::filesystem::path File;
  OutputFile Output;
  io::FileHandle Encoded; ///< a file without a name
  io::FileHandle Messages;
  io::FileHandle Pictures; ///< to ffmpeg
  pid_t Encoder = -1;
};

} // namespace ink::cli
