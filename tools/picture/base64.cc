#include "tools/picture/base64.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace g31::picture {

std::string base64(std::string_view bytes) {
  constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t here = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto byte = k < here ? static_cast<unsigned char>(bytes[i + k]) : 0U;
      bits = bits << 8U | byte;
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= here ? kLetters[bits >> (18U - 6U * k) & 0x3FU] : '=';
    }
  }
  return text;
}

}  // namespace g31::picture
