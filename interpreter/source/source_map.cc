#include "interpreter/source/source_map.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <functional>
#include <iterator>
#include <utility>

#include "interpreter/source/readable_text.h"
#include "machine/base/contract.h"
#include "machine/base/utf_8.h"

namespace g31::source {
namespace {

/// Four sums side by side, so that none waits for the product of another; each step can be undone,
/// so none loses what the step before told apart.
std::size_t hash_of(std::string_view text) {
  constexpr std::uint64_t kOdd = 0x9E3779B97F4A7C15;
  std::array<std::uint64_t, 4> sums = {1, 2, 3, 4};
  std::array<std::uint64_t, 4> next = {};
  for (; text.size() >= sizeof next; text.remove_prefix(sizeof next)) {
    std::memcpy(next.data(), text.data(), sizeof next);
    for (std::size_t i = 0; i < sums.size(); ++i) {
      sums[i] = std::rotl(sums[i] ^ next[i], 32) * kOdd;
    }
  }
  std::string rest(sizeof sums, '\0');
  std::memcpy(rest.data(), sums.data(), sizeof sums);
  return std::hash<std::string_view>()(rest.append(text));
}

/// @param first_line  of the text in its file
ShownPlace shown(const std::string& name, std::string_view text, const LineStarts& lines,
                 std::size_t offset, int first_line) {
  const LineColumn place = lines.at(offset);
  std::size_t before = static_cast<std::size_t>(place.column) - 1;
  std::string_view rest = text.substr(offset - before);
  if (place.line + first_line == 2 && rest.starts_with(kByteOrderMark)) {
    rest.remove_prefix(kByteOrderMark.size());
    before -= std::min(before, kByteOrderMark.size());
  }
  // A tape's line ends with LF CR CR: what stands of it before a block is no part of its text.
  for (; before > 0 && rest.starts_with('\r'); --before) {
    rest.remove_prefix(1);
  }
  const std::string_view line = rest.substr(0, rest.find_first_of("\r\n"));
  int column = column_in(line, before);
  if (before > line.size()) {  // at the line's end, or behind a CR that ends none
    column += static_cast<int>(character_count(rest.substr(line.size(), before - line.size())));
  }
  return {name, place.line + first_line - 1, column, std::string(line)};
}

}  // namespace

std::size_t bytes_before(const ShownPlace& place) {
  return bytes_in_front(place.text, place.column);
}

FileId SourceMap::add(const std::string& name) {
  G31_EXPECTS(last_ != ~std::uint32_t{0});
  const auto id = static_cast<FileId>(++last_);
  known_[id].name = name;
  return id;
}

/// Whether a whole text may be that of the file.
bool SourceMap::agrees(const File& file, std::string_view whole) {
  if (file.text != nullptr) {
    return file.text->text() == whole;
  }
  return std::ranges::all_of(file.windows, [&](const auto& known) {
    const auto& [begin, window] = known;
    return begin + window.length <= whole.size() &&
           hash_of(whole.substr(begin, window.length)) == window.hash;
  });
}

/// Whether a window may be one of the file.
bool SourceMap::agrees(const File& file, std::uint64_t begin, const Window& window,
                       std::string_view text) {
  if (file.text != nullptr) {
    const std::string_view whole = file.text->text();
    return begin <= whole.size() && whole.substr(begin, window.length) == text;
  }
  const auto next = file.windows.lower_bound(begin);
  if (next != file.windows.end() && next->first == begin) {
    return next->second == window;
  }
  const bool ends_before = next == file.windows.end() || begin + window.length <= next->first;
  const auto before = next == file.windows.begin() ? file.windows.end() : std::prev(next);
  return ends_before &&
         (before == file.windows.end() || before->first + before->second.length <= begin);
}

const SourceFile& SourceMap::whole(const std::string& path, std::string text) {
  const std::lock_guard lock(mutex_);
  std::vector<FileId>& versions = by_path_[path];
  const auto found =
      std::ranges::find_if(versions, [&](FileId id) { return agrees(known_[id], text); });
  const FileId id = found != versions.end() ? *found : versions.emplace_back(add(path));
  File& file = known_[id];
  if (file.text == nullptr) {
    file.kept = std::make_unique<SourceFile>(id, 0, path, std::move(text));
    file.text = file.kept.get();
  }
  return *file.text;
}

SourceFile SourceMap::window(const std::string& path, std::uint64_t begin, int first_line,
                             std::string text) {
  const Window window{text.size(), first_line, hash_of(text)};
  const std::lock_guard lock(mutex_);
  std::vector<FileId>& versions = by_path_[path];
  const auto found = std::ranges::find_if(
      versions, [&](FileId id) { return agrees(known_[id], begin, window, text); });
  const FileId id = found != versions.end() ? *found : versions.emplace_back(add(path));
  known_[id].windows.emplace(begin, window);
  return {id, begin, path, std::move(text)};
}

std::shared_ptr<const SourceFile> SourceMap::passing(const std::string& name, std::string text) {
  FileId id = FileId::None;
  {
    const std::lock_guard lock(mutex_);
    id = add(name);
  }
  std::shared_ptr<const SourceFile> made(new SourceFile(id, 0, name, std::move(text)),
                                         [this, id](const SourceFile* file) {
                                           forget(id);
                                           delete file;
                                         });
  const std::lock_guard lock(mutex_);
  known_[id].text = made.get();
  return made;
}

void SourceMap::forget(FileId id) {
  const std::lock_guard lock(mutex_);
  known_.erase(id);
}

ShownPlace SourceMap::show(const Location& where) const {
  const std::lock_guard lock(mutex_);
  const auto found = known_.find(where.file);
  if (found == known_.end()) {
    return {};
  }
  File& file = found->second;
  if (file.text == nullptr) {
    return show_in_window(file, where);
  }
  if (!file.lines) {
    file.lines.emplace(file.text->text());
  }
  return shown(file.name, file.text->text(), *file.lines, where.begin, 1);
}

ShownPlace SourceMap::show_in_window(const File& file, const Location& where) const {
  const auto behind = file.windows.upper_bound(where.begin);
  G31_EXPECTS(behind != file.windows.begin());
  const auto& [begin, window] = *std::prev(behind);
  if (!read_again(file, where.file, begin, window)) {
    return {file.name, 0, 0, {}};
  }
  return shown(file.name, reread_.text, reread_.lines, where.begin - begin, window.first_line);
}

/// @returns whether reread_ is the window as it was
bool SourceMap::read_again(const File& file, FileId id, std::uint64_t begin,
                           const Window& window) const {
  if (reread_.file == id && reread_.begin == begin) {
    return true;
  }
  auto text = files_.read_part(file.name, begin, window.length);
  if (!text || text->size() != window.length || hash_of(*text) != window.hash) {
    return false;
  }
  LineStarts lines(*text);
  reread_ = {id, begin, *std::move(text), std::move(lines)};
  return true;
}

}  // namespace g31::source
