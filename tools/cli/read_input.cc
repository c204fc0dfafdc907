#include "tools/cli/read_input.h"

#include <utility>

#include <fmt/format.h>

namespace g31::cli {

Result<std::string, session::Refusal> read_input(disk::Disk& disk, const std::string& path,
                                                 const InputLimit& limit) {
  if (const auto size = disk.size(path); size && *size > limit.bytes) {
    return session::bad_input(fmt::format("{}: {} bytes are too many: at most {}; {}", path, *size,
                                          limit.bytes, limit.advice));
  }
  auto text = disk.read(path);
  return text ? Result<std::string, session::Refusal>(*std::move(text))
              : session::unreadable("", path);
}

}  // namespace g31::cli
