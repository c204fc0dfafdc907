#include "tools/setup/toml_reader.h"

#include "tools/setup/sheet_stack.h"

namespace g31::setup {

Result<Job, SetupErrors> read_job(std::span<const std::string> sheet_paths,
                                  const std::string& machines_folder) {
  const auto stack = SheetStack::read(sheet_paths, machines_folder);
  return stack ? stack.value().job({}) : stack.error();
}

}  // namespace g31::setup
