#pragma once

#include <cstdint>

namespace g31::source {

/// One file of a SourceMap.  Threads may open files in any order: which number a file has says
/// nothing, and nothing that leaves the program is ordered by it.
enum class FileId : std::uint32_t { None = 0 };

/// A place in a text, as plain numbers: it holds for ever, and a SourceMap shows it.
struct Location {
  FileId file = FileId::None;  ///< None: no place
  std::uint32_t length = 0;    ///< bytes
  std::uint64_t begin = 0;     ///< bytes from the beginning of the file

  [[nodiscard]] bool is_known() const { return file != FileId::None; }
  friend bool operator==(const Location&, const Location&) = default;
};

}  // namespace g31::source
