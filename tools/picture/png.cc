#include "tools/picture/png.h"

#include <cstdint>

#include <zlib.h>

#include "machine/base/contract.h"

namespace g31::picture {
namespace {

void append_big_endian(std::string& bytes, std::uint32_t word) {
  for (int shift = 24; shift >= 0; shift -= 8) {
    bytes.push_back(static_cast<char>(word >> shift & 0xFFU));
  }
}

void append_chunk(std::string& file, const std::string& kind_and_data) {
  append_big_endian(file, static_cast<std::uint32_t>(kind_and_data.size() - 4));
  file += kind_and_data;
  // zlib speaks of bytes as unsigned.
  const auto* const bytes = reinterpret_cast<const Bytef*>(kind_and_data.data());
  append_big_endian(
      file, static_cast<std::uint32_t>(crc32(0, bytes, static_cast<uInt>(kind_and_data.size()))));
}

/// Each row as what it differs from the pixel before it.
std::string filtered(int width, int height, std::string_view pixels) {
  constexpr char kSub = 1;
  const auto row_bytes = 3 * static_cast<std::size_t>(width);
  std::string rows;
  for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
    const std::string_view row = pixels.substr(y * row_bytes, row_bytes);
    rows.push_back(kSub);
    for (std::size_t i = 0; i < row.size(); ++i) {
      rows.push_back(static_cast<char>(row[i] - (i < 3 ? 0 : row[i - 3])));
    }
  }
  return rows;
}

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  const int outcome =
      compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_COMPRESSION);
  G31_EXPECTS(outcome == Z_OK);
  packed.resize(size);
  return packed;
}

}  // namespace

std::string png_of(int width, int height, std::string_view pixels) {
  G31_EXPECTS(width > 0 && height > 0);
  G31_EXPECTS(pixels.size() ==
              3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  std::string header = "IHDR";
  append_big_endian(header, static_cast<std::uint32_t>(width));
  append_big_endian(header, static_cast<std::uint32_t>(height));
  // Eight bits a channel, true colour, deflate, filters by row, not interlaced.
  header += std::string("\x08\x02\x00\x00\x00", 5);
  std::string file = "\x89PNG\r\n\x1a\n";
  append_chunk(file, header);
  append_chunk(file, "IDAT" + deflated(filtered(width, height, pixels)));
  append_chunk(file, "IEND");
  return file;
}

}  // namespace g31::picture
