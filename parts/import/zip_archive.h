#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "machine/base/result.h"

namespace g31::parts {

/// A file in a zip archive, as the directory at the archive's end says.
struct ZipEntry {
  std::string_view name;
  std::uint16_t method = 0;    ///< 0 stored, 8 deflated
  std::uint32_t checksum = 0;  ///< CRC-32 of the unpacked bytes
  std::string_view packed;
  std::uint64_t unpacked_size = 0;  ///< bytes
};

/// The directory of an archive; nothing is unpacked.
/// Error: without the path: no directory at the end (cut off), entries that lie outside the file,
/// more than 4 GiB.
Result<std::vector<ZipEntry>, std::string> zip_directory(std::string_view archive);

struct Unpacked {
  std::string bytes;
};

/// Unpacks an entry; never asks for more memory than the directory says.
/// Error: without the path: damaged, or not as long as the directory says.
Result<Unpacked, std::string> unpacked(const ZipEntry& entry);

}  // namespace g31::parts
