// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PictureEncoder.h"

#include <vector>

namespace ink::io
{

/// PNG, with the resolution in a chunk pHYs.
class PngEncoder : public PictureEncoder
{
public:
  PngEncoder(const PictureLayout& layout, const ByteSink& sink);
  ~PngEncoder() override;

  void add(std::span<const unsigned char> rows) override;
  void finish() override;

private:
  struct Library;

  /// Lets libpng do something; its bytes go on after it, so that nothing is thrown through C.
  template <class Work>
  void run(const Work& work);

  std::unique_ptr<Library> Png;
};

} // namespace ink::io
