#include "tools/cli/report_options.h"

#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace g31::cli {

void add_report_options(CLI::App& command, std::string& report, page::Language& language) {
  command
      .add_option("--report", report,
                  "one HTML file with results, pictures, time line, listing; needs no network")
      ->type_name("FILE.html")
      ->check([](const std::string& path) {
        return path.ends_with(".html") || path.ends_with(".htm")
                   ? std::string()
                   : fmt::format("{} is no .html file", path);
      });
  add_language_option(command, language);
  command.get_option("--lang")->needs("--report");
}

void give_drawing_language(CLI::App& command) {
  CLI::Option* const language = command.get_option("--lang");
  language->remove_needs(command.get_option("--report"));
  language->description("language of the report and of the words in --svg: en (default) or ja");
  language->check([&command](const std::string&) {
    return command.count("--report") + command.count("--svg") > 0
               ? std::string()
               : std::string("--report or --svg has to be given, it is their language");
  });
}

void add_language_option(CLI::App& command, page::Language& language) {
  command
      .add_option_function<std::string>(
          "--lang",
          [&language](const std::string& name) {
            const auto known = page::language_named(name);
            if (!known) {
              throw CLI::ValidationError("--lang", fmt::format("{} is neither en nor ja", name));
            }
            language = *known;
          },
          "language of the report: en (default) or ja")
      ->type_name("LANGUAGE");
}

}  // namespace g31::cli
