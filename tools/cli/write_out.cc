#include "tools/cli/write_out.h"

#include "tools/disk/disk.h"

namespace g31::cli {

std::optional<session::Refusal> write_out(const std::string& path, std::string_view text) {
  const auto problem = disk::write_whole_file(path, text);
  return problem ? std::optional(session::bad_input(*problem)) : std::nullopt;
}

}  // namespace g31::cli
