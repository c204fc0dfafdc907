#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "interpreter/source/file_system.h"
#include "interpreter/source/line_starts.h"
#include "interpreter/source/location.h"
#include "interpreter/source/source_file.h"

namespace g31::source {

/// A place as people and documents read it.
struct ShownPlace {
  std::string file;  ///< as it was opened; empty: no place
  int line = 0;      ///< from 1; 0: the text is no longer to be had
  int column = 0;    ///< from 1, in characters as people read them
  std::string text;  ///< of the line, without its end and a byte order mark
};

/// Of the line, in front of the place.
std::size_t bytes_before(const ShownPlace& place);

/// The files of a set of programs, with what their places need to be shown: name and text, or for
/// windows of long files the way to read them again.  Line and column are computed when a place is
/// shown.
///
/// A file is the same one whoever opens it, and however often; when its text has changed in
/// between, it is another file of the same name.  So no place is shown in a text that is not its
/// own.  Any number of threads may use the map at a time.
class SourceMap {
 public:
  /// @param files  outlives the map
  explicit SourceMap(FileSystem& files) : files_(files) {}
  SourceMap(const SourceMap&) = delete;
  SourceMap& operator=(const SourceMap&) = delete;

  [[nodiscard]] FileSystem& files() const { return files_; }

  /// A file whose text stays as long as the map.
  /// @param text  as a control reads it: of the same length as in the file
  const SourceFile& whole(const std::string& path, std::string text);

  /// Whole lines of a file that is too long to be kept.  They stay as long as the caller keeps
  /// them; to show a place in them, the map reads them again.
  /// @param begin  of the text in the file, bytes
  /// @param first_line  of the text, from 1
  SourceFile window(const std::string& path, std::uint64_t begin, int first_line, std::string text);

  /// A text that a run makes for itself, in no file.  Its places are shown as long as it lives,
  /// which is to end before the map does.
  std::shared_ptr<const SourceFile> passing(const std::string& name, std::string text);

  [[nodiscard]] ShownPlace show(const Location& where) const;

 private:
  struct Window {
    std::size_t length = 0;  ///< bytes
    int first_line = 1;
    std::size_t hash = 0;  ///< of its text
    friend bool operator==(const Window&, const Window&) = default;
  };
  struct File {
    std::string name;
    const SourceFile* text = nullptr;         ///< the whole of it; nullptr: only windows
    std::unique_ptr<const SourceFile> kept;   ///< what `text` points to, where the map keeps it
    std::optional<LineStarts> lines;          ///< of `text`, once a place was shown
    std::map<std::uint64_t, Window> windows;  ///< by their beginnings; none overlaps another
  };
  /// The window that was read again last.
  struct Reread {
    FileId file = FileId::None;
    std::uint64_t begin = 0;
    std::string text;
    LineStarts lines{{}};
  };

  static bool agrees(const File& file, std::string_view whole);
  static bool agrees(const File& file, std::uint64_t begin, const Window& window,
                     std::string_view text);
  FileId add(const std::string& name);
  void forget(FileId id);
  [[nodiscard]] ShownPlace show_in_window(const File& file, const Location& where) const;
  [[nodiscard]] bool read_again(const File& file, FileId id, std::uint64_t begin,
                                const Window& window) const;

  FileSystem& files_;
  mutable std::mutex mutex_;
  mutable std::unordered_map<FileId, File> known_;
  std::map<std::string, std::vector<FileId>> by_path_;
  std::uint32_t last_ = 0;  ///< id that was given
  mutable Reread reread_;
};

}  // namespace g31::source
