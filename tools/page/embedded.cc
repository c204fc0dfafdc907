#include "tools/page/embedded.h"

#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <zlib.h>

#include "machine/base/contract.h"
#include "tools/page/html.h"
#include "tools/picture/base64.h"

namespace g31::page {
namespace {

constexpr std::size_t kMostPlain = std::size_t{1} << 20U;

struct EndDeflate {
  void operator()(z_stream* stream) const { deflateEnd(stream); }
};

std::string compressed(std::string_view text, const plot::Growth& growth) {
  constexpr int kGzip = 15 + 16;  // the largest window, with gzip's head
  constexpr int kMemory = 8;
  z_stream stream = {};
  const int started =
      deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kGzip, kMemory, Z_DEFAULT_STRATEGY);
  G31_EXPECTS(started == Z_OK);
  const std::unique_ptr<z_stream, EndDeflate> ends(&stream);
  std::string bytes(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<unsigned char*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<unsigned int>(text.size());
  stream.next_out = reinterpret_cast<unsigned char*>(bytes.data());
  // Piece by piece of what comes out, a few milliseconds each.
  constexpr std::size_t kPiece = std::size_t{1} << 14U;
  int state = Z_OK;
  while (state == Z_OK) {
    const std::size_t before = stream.total_out;
    stream.avail_out = static_cast<unsigned int>(std::min(kPiece, bytes.size() - before));
    state = deflate(&stream, Z_FINISH);
    if (growth) {
      growth(stream.total_out - before);
    }
  }
  bytes.resize(stream.total_out);
  G31_EXPECTS(state == Z_STREAM_END);
  return bytes;
}

}  // namespace

std::string embedded(std::string_view id, std::string_view json, const plot::Growth& growth) {
  if (json.size() <= kMostPlain) {
    return fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n", id,
                       json_for_script(json));
  }
  return fmt::format("<script type=\"text/plain\" id=\"{}\" data-encoding=\"gzip\">{}</script>\n",
                     id, picture::base64(compressed(json, growth)));
}

}  // namespace g31::page
