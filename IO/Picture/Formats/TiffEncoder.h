// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PictureEncoder.h"

#include "FileHandle.h"

#include <cstdint>

namespace ink::io
{

/// TIFF, compressed without loss (Deflate), with the resolution in its tags. The library goes back in the
/// file to write where things are, so it is a temporary one first.
class TiffEncoder : public PictureEncoder
{
public:
  TiffEncoder(const PictureLayout& layout, const ByteSink& sink);
  ~TiffEncoder() override;

  void add(std::span<const unsigned char> rows) override;
  void finish() override;

private:
  struct Library;

  std::unique_ptr<Library> Tiff;
};

} // namespace ink::io
