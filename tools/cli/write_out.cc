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
  const bool is_document = json == "-";
  auto wrong = write_out("-", is_document ? document() : for_people());
  return wrong || is_document || json.empty() ? wrong : write_out(json, document());
}

}  // namespace g31::cli
