#include "tools/cli/control_and_level_options.h"

#include <map>

#include <CLI/CLI.hpp>

#include "tools/cli/limit_options.h"

namespace g31::cli {

void add_control_option(CLI::App& command, std::string& control, const std::string& text) {
  command.add_option("--control", control, text)->type_name("CONTROL")->check(why_no_word);
}

void add_fail_on_option(CLI::App& command, source::Severity& fail_on, const std::string& text) {
  static const std::map<std::string, source::Severity> kByName = [] {
    std::map<std::string, source::Severity> names;
    for (const auto severity :
         {source::Severity::Note, source::Severity::Warning, source::Severity::Error}) {
      names.emplace(source::name_of(severity), severity);
    }
    return names;
  }();
  command
      .add_option_function<std::string>(
          "--fail-on", [&fail_on](const std::string& given) { fail_on = kByName.at(given); }, text)
      ->check(CLI::IsMember(&kByName))
      ->type_name("SEVERITY");
}

void add_quiet_option(CLI::App& command, bool& is_quiet) {
  if (command.get_option_no_throw("--quiet") == nullptr) {
    command.add_flag("-q,--quiet", is_quiet, "no progress on a terminal");
  }
}

}  // namespace g31::cli
