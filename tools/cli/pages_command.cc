#include "tools/cli/pages_command.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "machine/base/nearest_name.h"
#include "tools/cli/completion.h"
#include "tools/cli/manual_page.h"
#include "tools/cli/messages.h"
#include "tools/cli/write_out.h"
#include "tools/session/control.h"

namespace g31::cli {
namespace {

ExitCode print(const std::string& text) {
  const auto wrong = write_out("-", text);
  return wrong ? refuse(*wrong) : ExitCode::Completed;
}

std::vector<std::string> command_names(const ProgramWords& words) {
  std::vector<std::string> names;
  for (const CommandWords& command : words.commands) {
    names.push_back(command.name);
  }
  return names;
}

}  // namespace

ExitCode completion_command(const ProgramWords& words, const PagesOptions& options) {
  return print(completion_script(words, options.shell));
}

ExitCode manual_command(const ProgramWords& words, const PagesOptions& options) {
  const std::vector<std::string> names = command_names(words);
  if (!options.command.empty() && std::ranges::find(names, options.command) == names.end()) {
    const std::vector<std::string_view> known(names.begin(), names.end());
    const auto nearest = nearest_name(options.command, known);
    return refuse(session::bad_input(fmt::format(
        "g31 has no command '{}'{}; it has {}", options.command,
        nearest ? fmt::format(", did you mean '{}'?", *nearest) : "", fmt::join(names, ", "))));
  }
  return print(manual_page(words, options.command));
}

ExitCode version_command(const ProgramWords& words, bool is_json) {
  if (!is_json) {
    return print(fmt::format("{} {}\n", words.program.name, words.version));
  }
  const nlohmann::ordered_json document = {{"schema", "g31.version/1"},
                                           {"version", words.version},
                                           {"commands", command_names(words)},
                                           {"controls", session::control_names()}};
  return print(document.dump(2) + "\n");
}

}  // namespace g31::cli
