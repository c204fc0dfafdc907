#include "tests/support/run_program.h"

#include <fstream>
#include <iterator>

#include "tests/support/captured.h"

template class nlohmann::basic_json<>;

namespace g31::testing {

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

RunOutput run_program(cli::RunOptions options) {
  TemporaryFolder folder;
  options.json = folder.path("result.json");
  options.talk = cli::Talk::Quiet;
  const CommandOutput said = captured([&] { return cli::run_command(options); });
  RunOutput output{said.exit_code, {}, said.errors};
  std::ifstream in(options.json, std::ios::binary);
  if (in) {
    output.document = nlohmann::json::parse(in);
  }
  return output;
}

}  // namespace g31::testing
