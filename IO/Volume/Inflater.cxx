// SPDX-License-Identifier: BSD-3-Clause
#include "Inflater.h"

#include "ReadError.h"

#include "vtk_zlib.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

namespace ink::io
{

struct Inflater::Stream
{
  z_stream state{};
  std::array<unsigned char, 1 << 16> input;
  bool ended = false;
};

Inflater::Inflater(const std::filesystem::path& file, std::uint64_t offset)
  : Path(file)
  , File(openToRead(file))
  , Position(offset)
  , Zlib(std::make_unique<Stream>())
{
  // The largest window, and either of the two headers.
  constexpr int anyWindow = 15 + 32;
  if (inflateInit2(&this->Zlib->state, anyWindow) != Z_OK)
  {
    failToRead(file, "zlib cannot begin");
  }
}

Inflater::~Inflater()
{
  inflateEnd(&this->Zlib->state);
}

std::size_t Inflater::read(std::span<unsigned char> bytes)
{
  z_stream& state = this->Zlib->state;
  std::size_t done = 0;
  while (done < bytes.size())
  {
    if (state.avail_in == 0)
    {
      const std::size_t found = readAt(this->File.get(), this->Position, this->Zlib->input);
      if (found == 0)
      {
        break;
      }
      this->Position += found;
      state.next_in = this->Zlib->input.data();
      state.avail_in = static_cast<uInt>(found);
    }
    if (this->Zlib->ended)
    {
      inflateReset(&state);
      this->Zlib->ended = false;
    }
    const auto room =
      static_cast<uInt>(std::min<std::size_t>(bytes.size() - done, std::numeric_limits<uInt>::max()));
    state.next_out = bytes.data() + done;
    state.avail_out = room;
    const int result = inflate(&state, Z_NO_FLUSH);
    done += room - state.avail_out;
    if (result == Z_STREAM_END)
    {
      this->Zlib->ended = true;
    }
    else if (result != Z_OK && result != Z_BUF_ERROR)
    {
      failToRead(this->Path,
        std::string("its compressed data is broken (") + (state.msg ? state.msg : "zlib stops") + ")");
    }
  }
  return done;
}

} // namespace ink::io
