#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "interpreter/runtime/outcome.h"
#include "tools/cli/exit_code.h"
#include "tools/page/language.h"
#include "tools/session/prepare.h"
#include "tools/session/world.h"

namespace g31::page {
struct Report;
}  // namespace g31::page

namespace g31::cli {

/// How much a run says on standard error.
enum class Talk : std::uint8_t {
  Quiet,   ///< what is wrong
  Usual,   ///< stops and messages as they come, too, and a line at the end
  Verbose  ///< each measuring move, too
};

/// A run that is watched: its page goes to who watches, and it leaves nothing else behind.
struct Watch {
  std::uint64_t edition = 0;                            ///< of the page
  std::function<void(std::string html)> take;           ///< gets the page, once
  std::function<void(const std::string& path)> looked;  ///< hears of files and folders it looks for
  std::function<void()> touched = [] {};                ///< called at each measuring move
};

/// What the command line of `g31 run` says.
struct RunOptions : session::Request {
  std::vector<std::string> prints;
  std::string version;               ///< of g31
  std::vector<std::string> expects;  ///< "NAME=VALUE+-TOLERANCE"
  std::string json;                  ///< file, "-" for standard output, "" for none
  /// Where printouts go: "-" standard output, a file, or a line as parse_line_spec takes it; "" as
  /// "-", unless the document goes there.
  std::string printer;
  double printer_wait_s = 30.0;  ///< how long the printer may keep the program waiting at a time
  std::string trace;             ///< file of sampled positions, "" for none
  std::string readings;          ///< file of what sensors read at stops, "" for none
  std::string trace_period = "1ms";                   ///< as parse_duration takes it
  std::string report;                                 ///< HTML file, "" for none
  page::Language language = page::Language::English;  ///< of the report
  const Watch* watch = nullptr;                       ///< nullptr: nobody watches
  std::function<void(page::Report&)>
      amend_page;       ///< what a command changes of the report; may be empty
  std::string compare;  ///< document of another run for the report, "" for none
  std::string jsonl;    ///< file of events, "-" for standard output, "" for none
  Talk talk = Talk::Usual;
  bool tells_findings = true;  ///< on standard error; else whoever asked for the run does
  bool no_colour = false;
  bool changes = false;        ///< what the run has changed is told
  bool optional_stop = false;  ///< M01 stops
  std::set<int> block_skip;    ///< switches that are on beside those of the sheets
  bool moves = false;
  bool touches = false;
  bool blocks = false;               ///< calls, counts of blocks and values of variables are kept
  std::vector<std::string> allowed;  ///< codes of warnings and notes that nobody wants to hear
  source::Severity fail_on = source::Severity::Warning;  ///< least severe that counts as a finding
  /// The parts of the sheets where they are made already; outlive the run.
  const session::BuiltParts* parts = nullptr;
  runtime::Budget budget;
  std::uint64_t max_output = runtime::OutputBudget::kUsualBytes;
};

/// Runs a program and reports: to standard output or the printer what it prints, standard error
/// what is wrong.
/// A report shows all that the document can have, and so all of it is kept.
ExitCode run_command(const RunOptions& given);

}  // namespace g31::cli
