#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/dialects/fanuc/code/compile.h"
#include "interpreter/dialects/fanuc/text/parse.h"
#include "interpreter/source/source_map.h"

namespace g31::fanuc {

/// Files beyond this size are run window by window; smaller ones are kept whole, which takes some
/// twenty times their size.
inline constexpr std::uint64_t kWholeFileBytes = 1U << 20;

/// How much text one window has, to the next line end: what is made of it stays in the caches.
inline constexpr std::size_t kWindowBytes = 1U << 16;

/// How much is read at once where only the beginnings of programs are looked for.
inline constexpr std::size_t kPieceBytes = 1U << 16;

/// A long program as a run of windows: only one of them is in memory at a time, so that a program
/// of any size runs in a few megabytes as long as it goes straight on.
class ProgramWindows {
 public:
  /// @param sources  must outlive the windows
  ProgramWindows(source::SourceMap& sources, std::string path, std::uint64_t bytes);

  /// The next window, compiled for a control, which ends the life of the one before; nullptr when
  /// there is none, or when the text cannot be split (see must_be_whole).
  const CompiledProgram* next(const Profile& profile);

  /// A loop was found, or a further program where windows cannot end: they do not show where it
  /// ends.
  [[nodiscard]] bool must_be_whole() const { return must_be_whole_; }

  /// Whether text is left behind the last window.
  [[nodiscard]] bool has_more() const { return offset_ < bytes_; }

  /// Steps of the program before the present window.
  [[nodiscard]] syntax::Index steps_before() const { return steps_before_; }

 private:
  struct Window {
    source::SourceFile source;
    syntax::Tree tree;
    CompiledProgram program;
  };

  std::optional<std::string> next_text();
  [[nodiscard]] std::unique_ptr<Window> window_of(std::string text, TextBegins begins) const;
  bool can_be_split(const Window& window) const;

  source::SourceMap& sources_;
  std::string path_;
  std::uint64_t bytes_;
  std::uint64_t offset_ = 0;
  int next_line_ = 1;
  syntax::Index steps_before_ = 0;
  bool must_be_whole_ = false;
  bool has_ended_ = false;  ///< where the next program of the file begins
  std::unique_ptr<Window> window_;
};

/// Where a program begins.
struct ProgramBeginning {
  ProgramKey key;
  int line = 0;              ///< from 1
  std::uint64_t offset = 0;  ///< of that line, bytes
  /// Behind one that stands in a program: there the tape ends, unless it is in a comment.
  bool is_behind_percent_sign = false;
};

/// The programs that begin at lines of a file, in their order.  Reads the file once, piece by
/// piece.
std::vector<ProgramBeginning> program_beginnings(source::FileSystem& files, const std::string& path,
                                                 std::uint64_t bytes);

}  // namespace g31::fanuc
