#pragma once

#include <string>

#include "tools/page/language.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// --report and --lang of every command that shows what it found as a page.
void add_report_options(CLI::App& command, std::string& report, page::Language& language);

/// Lets --lang be for the words of --svg as well, of a command that has both.
void give_drawing_language(CLI::App& command);

/// --lang alone.
void add_language_option(CLI::App& command, page::Language& language);

}  // namespace g31::cli
