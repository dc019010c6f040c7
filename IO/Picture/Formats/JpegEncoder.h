// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PictureEncoder.h"

namespace ink::io
{

/// JPEG of high quality without subsampled colors, since lines are sharp, with the resolution in its JFIF
/// header.
class JpegEncoder : public PictureEncoder
{
public:
  JpegEncoder(const PictureLayout& layout, const ByteSink& sink);
  ~JpegEncoder() override;

  void add(std::span<const unsigned char> rows) override;
  void finish() override;

private:
  struct Library;

  /// Lets libjpeg do something; its bytes go on after it, so that nothing is thrown through C.
  template <class Work>
  void run(const Work& work);

  std::unique_ptr<Library> Jpeg;
};

} // namespace ink::io
