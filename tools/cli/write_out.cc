#include "tools/cli/write_out.h"

#include "tools/disk/disk.h"

namespace g31::cli {

std::optional<session::Refusal> write_out(const std::string& path, std::string_view text) {
  return write_out(path, [&](disk::PartFile& file) { file.write(text); });
}

std::optional<session::Refusal> write_out(const std::string& path,
                                          const std::function<void(disk::PartFile&)>& write) {
  const auto problem = disk::write_whole_file(path, write);
  return problem ? std::optional(session::bad_input(*problem)) : std::nullopt;
}

std::optional<session::Refusal> write_result(const std::string& json,
                                             const std::function<std::string()>& for_people,
                                             const std::function<std::string()>& document) {
  if (json == "-") {
    return write_out("-", document());
  }
  // The file is there before its reader hears of the end, and where nobody can hear of it.
  auto unwritten = json.empty() ? std::nullopt : write_out(json, document());
  auto untold = write_out("-", for_people());
  return unwritten ? unwritten : untold;
}

}  // namespace g31::cli
