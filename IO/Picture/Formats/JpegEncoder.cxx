// SPDX-License-Identifier: BSD-3-Clause
#include "JpegEncoder.h"

#include "vtk_jpeg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <csetjmp>
#include <vector>

namespace ink::io
{
namespace
{

constexpr int quality = 95;
constexpr double mostDotsPerInch = 65535;

} // namespace

struct JpegEncoder::Library
{
  jpeg_compress_struct compress = {};
  jpeg_error_mgr errors = {};
  jpeg_destination_mgr destination = {};
  std::jmp_buf failed = {};
  std::array<unsigned char, 1 << 16> buffer = {};
  std::vector<unsigned char> bytes;

  static Library& of(j_common_ptr any) { return *static_cast<Library*>(any->client_data); }
  static Library& of(j_compress_ptr any) { return *static_cast<Library*>(any->client_data); }

  void empty(std::size_t used)
  {
    this->bytes.insert(
      this->bytes.end(), this->buffer.begin(), this->buffer.begin() + static_cast<long>(used));
    this->destination.next_output_byte = this->buffer.data();
    this->destination.free_in_buffer = this->buffer.size();
  }

  Library()
  {
    this->compress.err = jpeg_std_error(&this->errors);
    this->errors.error_exit = [](j_common_ptr any) { std::longjmp(of(any).failed, 1); };
    this->errors.output_message = [](j_common_ptr) {};
    this->compress.client_data = this;
    this->destination.init_destination = [](j_compress_ptr any) { of(any).empty(0); };
    this->destination.empty_output_buffer = [](j_compress_ptr any) -> boolean
    {
      of(any).empty(of(any).buffer.size());
      return TRUE;
    };
    this->destination.term_destination = [](j_compress_ptr any)
    { of(any).empty(of(any).buffer.size() - of(any).destination.free_in_buffer); };
  }
  ~Library() { jpeg_destroy_compress(&this->compress); }
};

template <class Work>
void JpegEncoder::run(const Work& work)
{
  Library& library = *this->Jpeg;
  if (setjmp(library.failed))
  {
    throw PictureError("the picture cannot be encoded as JPEG");
  }
  work(&library.compress);
  this->Sink(library.bytes);
  library.bytes.clear();
}

JpegEncoder::JpegEncoder(const PictureLayout& layout, const ByteSink& sink)
  : PictureEncoder(layout, sink)
  , Jpeg(std::make_unique<Library>())
{
  this->run(
    [&](j_compress_ptr compress)
    {
      jpeg_create_compress(compress);
      compress->client_data = this->Jpeg.get();
      compress->dest = &this->Jpeg->destination;
      compress->image_width = static_cast<JDIMENSION>(layout.width);
      compress->image_height = static_cast<JDIMENSION>(layout.height);
      compress->input_components = 3;
      compress->in_color_space = JCS_RGB;
      jpeg_set_defaults(compress);
      jpeg_set_quality(compress, quality, TRUE);
      compress->comp_info[0].h_samp_factor = 1;
      compress->comp_info[0].v_samp_factor = 1;
      compress->density_unit = 1; // dots per inch
      compress->X_density = static_cast<UINT16>(std::lround(std::min(layout.dotsPerInch, mostDotsPerInch)));
      compress->Y_density = compress->X_density;
      jpeg_start_compress(compress, TRUE);
    });
}

JpegEncoder::~JpegEncoder() = default;

void JpegEncoder::add(std::span<const unsigned char> rows)
{
  const std::size_t length = this->Layout.rowBytes();
  for (; !rows.empty(); rows = rows.subspan(length))
  {
    // libjpeg does not change what it is given.
    auto* row = const_cast<unsigned char*>(rows.data());
    this->run([&row](j_compress_ptr compress) { jpeg_write_scanlines(compress, &row, 1); });
  }
}

void JpegEncoder::finish()
{
  this->run([](j_compress_ptr compress) { jpeg_finish_compress(compress); });
}

} // namespace ink::io
