#include "interpreter/source/file_system.h"

#include "interpreter/source/line_starts.h"

namespace g31::source {

std::optional<std::uint64_t> FileSystem::size(const std::string& path) {
  const auto text = read(path);
  return text ? std::optional<std::uint64_t>(text->size()) : std::nullopt;
}

std::optional<std::string> FileSystem::read_part(const std::string& path, std::uint64_t offset,
                                                 std::size_t length) {
  const auto text = read(path);
  if (!text || offset > text->size()) {
    return std::nullopt;
  }
  return text->substr(static_cast<std::size_t>(offset), length);
}

std::optional<std::string> FileSystem::why_no_list(const std::string& /*folder*/) {
  return std::nullopt;
}

std::vector<std::string> FileSystem::folders(const std::string& /*folder*/) {
  return {};
}

std::optional<std::string> read_program(FileSystem& files, const std::string& path) {
  auto text = files.read(path);
  if (text) {
    use_line_feeds(*text);
  }
  return text;
}

}  // namespace g31::source
