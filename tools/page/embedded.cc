#include "tools/page/embedded.h"

#include <fmt/format.h>
#include <zlib.h>

#include "machine/base/contract.h"
#include "tools/page/html.h"
#include "tools/picture/base64.h"

namespace g31::page {
namespace {

constexpr std::size_t kMostPlain = std::size_t{1} << 20U;

std::string compressed(std::string_view text) {
  constexpr int kGzip = 15 + 16;  // the largest window, with gzip's head
  constexpr int kMemory = 8;
  z_stream stream = {};
  const int started =
      deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kGzip, kMemory, Z_DEFAULT_STRATEGY);
  G31_EXPECTS(started == Z_OK);
  std::string bytes(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<unsigned char*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<unsigned int>(text.size());
  stream.next_out = reinterpret_cast<unsigned char*>(bytes.data());
  stream.avail_out = static_cast<unsigned int>(bytes.size());
  const int state = deflate(&stream, Z_FINISH);
  bytes.resize(stream.total_out);
  deflateEnd(&stream);
  G31_EXPECTS(state == Z_STREAM_END);
  return bytes;
}

}  // namespace

std::string embedded(std::string_view id, std::string_view json) {
  if (json.size() <= kMostPlain) {
    return fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n", id,
                       json_for_script(json));
  }
  return fmt::format("<script type=\"text/plain\" id=\"{}\" data-encoding=\"gzip\">{}</script>\n",
                     id, picture::base64(compressed(json)));
}

}  // namespace g31::page
