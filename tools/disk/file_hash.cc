#include "tools/disk/file_hash.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <nettle/sha2.h>

namespace g31::disk {

std::optional<std::string> sha256_of(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    return std::nullopt;
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return std::nullopt;
  }
  sha256_ctx context;
  sha256_init(&context);
  std::array<char, 65536> piece{};
  while (file.read(piece.data(), piece.size()) || file.gcount() > 0) {
    std::array<std::uint8_t, piece.size()> bytes{};
    std::copy_n(piece.begin(), file.gcount(), bytes.begin());
    sha256_update(&context, static_cast<std::size_t>(file.gcount()), bytes.data());
  }
  if (file.bad()) {
    return std::nullopt;
  }
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
  sha256_digest(&context, digest.size(), digest.data());
  std::string text;
  for (const std::uint8_t byte : digest) {
    text += fmt::format("{:02x}", byte);
  }
  return text;
}

}  // namespace g31::disk
