#include "interpreter/dialects/fanuc/code/program_windows.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "interpreter/dialects/fanuc/text/scanner.h"
#include "interpreter/source/line_starts.h"

namespace g31::fanuc {
namespace {

using syntax::BlockKind;

/// Where the line of a place begins, if only blanks stand before it there.
std::optional<std::size_t> line_of(std::string_view text, std::size_t place) {
  const std::size_t end = text.find_last_of('\n', place);
  const std::size_t begin = end == std::string_view::npos ? 0 : end + 1;
  const std::string_view before = text.substr(begin, place - begin);
  const bool is_first = before.find_first_not_of(" \t\r") == std::string_view::npos;
  return is_first ? std::optional(begin) : std::nullopt;
}

bool is_loop(const syntax::Block& block) {
  return block.kind == BlockKind::While || block.kind == BlockKind::Do ||
         block.kind == BlockKind::End || block.begins_loop;
}

}  // namespace

ProgramWindows::ProgramWindows(source::SourceMap& sources, std::string path, std::uint64_t bytes)
    : sources_(sources), path_(std::move(path)), bytes_(bytes) {}

/// Whole lines from the present offset.
std::optional<std::string> ProgramWindows::next_text() {
  for (std::size_t length = kWindowBytes;; length *= 2) {
    auto text = sources_.files().read_part(path_, offset_, length);
    if (!text || text->empty()) {
      return std::nullopt;
    }
    const bool is_last = offset_ + text->size() >= bytes_ || text->size() < length;
    const std::size_t line_end = text->rfind('\n');
    if (!is_last && line_end == std::string::npos) {
      continue;  // one line longer than the window
    }
    if (!is_last) {
      text->resize(line_end + 1);
    }
    return text;
  }
}

bool ProgramWindows::can_be_split(const Window& window) const {
  return window.tree.programs.size() == 1 && std::ranges::none_of(window.tree.blocks, is_loop);
}

std::unique_ptr<ProgramWindows::Window> ProgramWindows::window_of(std::string text,
                                                                  TextBegins begins) const {
  auto window = std::make_unique<Window>(
      Window{sources_.window(path_, offset_, next_line_, std::move(text)), {}, {}});
  window->tree = parse(window->source.text(), begins);
  return window;
}

const CompiledProgram* ProgramWindows::next(const Profile& profile) {
  const bool is_first = window_ == nullptr;
  if (has_ended_ || (!is_first && window_->tree.end < window_->source.text().size())) {
    return nullptr;  // there, or at a %
  }
  auto text = next_text();
  if (!text) {
    return nullptr;
  }
  auto window = window_of(*std::move(text), is_first ? TextBegins::AtFile : TextBegins::InProgram);
  if (!is_first && window->tree.programs.size() > 1) {
    const std::string_view lines = window->source.text();
    if (const auto cut = line_of(lines, window->tree.programs[1].name.begin)) {
      window = window_of(std::string(lines.substr(0, *cut)), TextBegins::InProgram);
      has_ended_ = true;
    }
  }
  const std::string_view lines = window->source.text();
  offset_ += lines.size();
  next_line_ += static_cast<int>(source::line_ends_in(lines));
  if (window->tree.programs.size() == 1) {
    window->program = compile(window->source, window->tree, 0, profile, Extent::Window);
  }
  if (!can_be_split(*window)) {
    must_be_whole_ = true;
    return nullptr;
  }
  if (!is_first) {
    window->program.key = window_->program.key;
    steps_before_ += static_cast<syntax::Index>(window_->program.steps.size());
  }
  window_ = std::move(window);
  return &window_->program;
}

namespace {

/// Reads where programs begin, piece by piece.
class BeginningsReader {
 public:
  void read(std::string_view text) {
    for (std::size_t at = 0; at < text.size();) {
      if (text[at] == '\n') {
        ++at;
        ++line_;
        line_begin_ = offset_ + at;
        is_at_begin_ = true;
        in_number_ = false;
        in_name_ = false;
      } else if (in_name_) {
        take_name(text[at]);
        ++at;
      } else if (is_at_begin_ || in_number_) {
        look_at(text[at]);
        ++at;
      } else {
        at = look_behind_begin(text, at);
      }
    }
    offset_ += text.size();
  }

  [[nodiscard]] std::vector<ProgramBeginning> take() { return std::move(programs_); }

 private:
  void look_at(char c) {
    constexpr std::int32_t kLargestBeforeDigit = 99'999'999;
    const bool begins_name = is_at_begin_ && c == '<';
    const bool begins_number = is_at_begin_ && (c == 'O' || c == 'o' || c == ':');
    if (begins_name || begins_number) {
      programs_.push_back({{}, line_, line_begin_, has_percent_sign_});
    }
    in_name_ = begins_name;
    has_percent_sign_ = has_percent_sign_ || (c == '%' && !programs_.empty());
    const bool is_nothing = counts_for_nothing(c);
    if (in_number_ && is_digit(c) && programs_.back().key.number <= kLargestBeforeDigit) {
      programs_.back().key.number = 10 * programs_.back().key.number + (c - '0');
    }
    in_number_ = begins_number || (in_number_ && (is_digit(c) || is_nothing));
    is_at_begin_ = is_at_begin_ && is_nothing;
  }

  void take_name(char c) {
    constexpr std::size_t kMostKept = 64;
    ProgramKey& key = programs_.back().key;
    if (c == '>') {
      key = key_of_name(key.name);
      in_name_ = false;
    } else if (key.name.size() < kMostKept) {
      key.name.push_back(c);
    }
  }

  /// Nothing but % counts there.
  /// @return where the line ends
  std::size_t look_behind_begin(std::string_view text, std::size_t at) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    has_percent_sign_ =
        has_percent_sign_ ||
        (!programs_.empty() && text.substr(at, end - at).find('%') != std::string_view::npos);
    return end;
  }

  std::vector<ProgramBeginning> programs_;
  bool is_at_begin_ = true;  ///< of a line, but for blanks
  bool in_number_ = false;
  bool in_name_ = false;
  bool has_percent_sign_ = false;
  int line_ = 1;
  std::uint64_t line_begin_ = 0;
  std::uint64_t offset_ = 0;  ///< of the piece
};

}  // namespace

std::vector<ProgramBeginning> program_beginnings(source::FileSystem& files, const std::string& path,
                                                 std::uint64_t bytes) {
  BeginningsReader reader;
  for (std::uint64_t offset = 0; offset < bytes;) {
    const auto text = files.read_part(path, offset, kPieceBytes);
    if (!text || text->empty()) {
      break;
    }
    reader.read(*text);
    offset += text->size();
  }
  return reader.take();
}

}  // namespace g31::fanuc
