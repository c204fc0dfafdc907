#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/source/file_system.h"
#include "tools/disk/part_file.h"

namespace g31::disk {

/// The real disk.  Any number of threads may read at a time.  "-" is standard input; it, a pipe and
/// a device are read whole once and kept, and waited for as waiting.h says.  A name that begins as
/// shipped_name() does is a file that comes with g31.
class Disk final : public source::FileSystem {
 public:
  /// What a pipe or a device may bring, bytes; one that brings more cannot be read.
  static constexpr std::size_t kMostOfAPipe = 256'000'000;

  std::optional<std::string> read(const std::string& named) override;
  std::optional<std::uint64_t> size(const std::string& named) override;
  std::optional<std::string> read_part(const std::string& path, std::uint64_t offset,
                                       std::size_t length) override;
  std::vector<std::string> list(const std::string& folder) override;
  std::optional<std::string> why_no_list(const std::string& folder) override;
  std::vector<std::string> folders(const std::string& folder) override;
  bool has_folder(const std::string& folder) override;
};

/// Looks at the entries of a folder one by one, in no order.
/// @returns why not at all of them, in the system's words
std::optional<std::string> look_into(
    const std::string& folder,
    const std::function<void(const std::filesystem::directory_entry&)>& look);

/// Why read() has not read a file, for people.
std::string why_unreadable(const std::string& path);

/// Writes a file under a temporary name beside it and renames it, so that nobody ever sees half of
/// it; a link to a file stays one.  A device or a pipe gets the text as it is.  @returns why it
/// could not be written; nullopt: it was
std::optional<std::string> write_whole_file(const std::string& path, std::string_view text);
/// The same of a text that is made piece by piece.
std::optional<std::string> write_whole_file(const std::string& path,
                                            const std::function<void(PartFile&)>& write);

}  // namespace g31::disk
