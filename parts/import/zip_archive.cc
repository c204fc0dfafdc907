#include "parts/import/zip_archive.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <zlib.h>

namespace g31::parts {
namespace {

constexpr std::size_t kDirectoryEnd = 22;    // bytes, without its comment
constexpr std::size_t kDirectoryEntry = 46;  // bytes, without its name
constexpr std::size_t kLocalHead = 30;       // bytes, without its name
constexpr std::uint16_t kStored = 0;
constexpr std::uint16_t kDeflated = 8;

template <typename Whole>
Whole number_at(std::string_view bytes, std::size_t at) {
  Whole value = 0;
  for (std::size_t i = 0; i < sizeof(Whole); ++i) {
    value = static_cast<Whole>(value | Whole{static_cast<unsigned char>(bytes[at + i])} << (8 * i));
  }
  return value;
}

/// What stands behind the head of the file at `at`; nullopt: it lies outside the archive.
std::optional<std::string_view> packed_bytes(std::string_view archive, std::size_t at,
                                             std::size_t size) {
  if (at > archive.size() || archive.size() - at < kLocalHead ||
      !archive.substr(at).starts_with("PK\x03\x04")) {
    return std::nullopt;
  }
  const std::size_t head = kLocalHead + number_at<std::uint16_t>(archive, at + 26) +
                           number_at<std::uint16_t>(archive, at + 28);
  if (archive.size() - at < head || archive.size() - at - head < size) {
    return std::nullopt;
  }
  return archive.substr(at + head, size);
}

/// Whether the head in front of a file says the same as its entry of the directory.
/// @param head, entry  where they begin; @pre both are in the archive
bool do_heads_agree(std::string_view archive, std::size_t head, std::size_t entry) {
  // Places in the head; in the entry they are two bytes further on.
  constexpr std::size_t kFlags = 6;
  constexpr std::size_t kMethod = 8;
  constexpr std::size_t kChecksum = 14;
  constexpr std::size_t kSizes[] = {18, 22};
  constexpr std::size_t kNameLength = 26;
  constexpr std::uint16_t kSaidBehind = 8;  // checksum and sizes stand behind the file
  constexpr std::uint32_t kSaidElsewhere = 0xFFFFFFFF;
  const auto words_agree = [&](std::size_t place) {
    return number_at<std::uint16_t>(archive, head + place) ==
           number_at<std::uint16_t>(archive, entry + 2 + place);
  };
  const auto longs_agree = [&](std::size_t place) {
    return number_at<std::uint32_t>(archive, head + place) ==
           number_at<std::uint32_t>(archive, entry + 2 + place);
  };
  const auto sizes_agree = [&](std::size_t place) {
    return number_at<std::uint32_t>(archive, head + place) == kSaidElsewhere || longs_agree(place);
  };
  const bool says_sizes = (number_at<std::uint16_t>(archive, head + kFlags) & kSaidBehind) == 0;
  return words_agree(kMethod) && words_agree(kNameLength) &&
         (!says_sizes || (longs_agree(kChecksum) && std::ranges::all_of(kSizes, sizes_agree)));
}

}  // namespace

Result<std::vector<ZipEntry>, std::string> zip_directory(std::string_view archive) {
  const std::size_t end = archive.rfind("PK\x05\x06");
  if (end == std::string_view::npos || archive.size() - end < kDirectoryEnd) {
    return std::string("it is a zip archive without its end: it was cut off");
  }
  const auto count = number_at<std::uint16_t>(archive, end + 10);
  std::size_t at = number_at<std::uint32_t>(archive, end + 16);
  std::vector<ZipEntry> entries;
  for (std::uint32_t i = 0; i < count; ++i) {
    const bool fits =
        at <= end && end - at >= kDirectoryEntry && archive.substr(at).starts_with("PK\x01\x02");
    const std::size_t name = fits ? number_at<std::uint16_t>(archive, at + 28) : 0;
    if (!fits || end - at - kDirectoryEntry < name) {
      return std::string("its zip directory is damaged, or of a kind for archives beyond 4 GiB");
    }
    const auto packed = packed_bytes(archive, number_at<std::uint32_t>(archive, at + 42),
                                     number_at<std::uint32_t>(archive, at + 20));
    ZipEntry entry{archive.substr(at + kDirectoryEntry, name),
                   number_at<std::uint16_t>(archive, at + 10),
                   number_at<std::uint32_t>(archive, at + 16), packed.value_or(""),
                   number_at<std::uint32_t>(archive, at + 24)};
    if (!packed) {
      return fmt::format("'{}' in it lies outside of it: it was cut off, or is damaged",
                         entry.name);
    }
    // assimp stops the process where it meets one whose heads contradict each other.
    if (!do_heads_agree(archive, number_at<std::uint32_t>(archive, at + 42), at)) {
      return fmt::format("'{}' in it is damaged: its head says other than the directory",
                         entry.name);
    }
    entries.push_back(entry);
    at += kDirectoryEntry + name + number_at<std::uint16_t>(archive, at + 30) +
          number_at<std::uint16_t>(archive, at + 32);
  }
  return entries;
}

Result<Unpacked, std::string> unpacked(const ZipEntry& entry) {
  const auto damaged = [&](std::string_view why) {
    return fmt::format("'{}' in it is damaged: {}", entry.name, why);
  };
  std::string bytes;
  if (entry.method == kStored) {
    bytes = entry.packed;
  } else if (entry.method == kDeflated) {
    bytes.resize(static_cast<std::size_t>(entry.unpacked_size));
    z_stream stream{};
    // zlib takes the bytes as its own, and leaves them as they are.
    // NOLINTNEXTLINE
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(entry.packed.data()));
    stream.avail_in = static_cast<uInt>(entry.packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data());  // NOLINT
    stream.avail_out = static_cast<uInt>(bytes.size());
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) {
      return damaged("no memory to unpack it");
    }
    const int ended = inflate(&stream, Z_FINISH);
    const auto left = stream.avail_out;
    inflateEnd(&stream);
    if (ended != Z_STREAM_END || left != 0) {
      return damaged("unpacked it is not as long as the directory says");
    }
  } else {
    return damaged("it is packed in a way that is not known");
  }
  const auto* const data = reinterpret_cast<const Bytef*>(bytes.data());  // NOLINT
  if (bytes.size() != entry.unpacked_size || ::crc32_z(0, data, bytes.size()) != entry.checksum) {
    return damaged("its checksum is wrong");
  }
  return Unpacked{std::move(bytes)};
}

}  // namespace g31::parts
