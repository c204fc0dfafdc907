#include "tools/cli/run_options.h"

#include <algorithm>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "interpreter/source/diagnostic.h"
#include "machine/base/letters.h"
#include "tools/cli/control_and_level_options.h"
#include "tools/cli/limit_options.h"
#include "tools/cli/output_places.h"
#include "tools/cli/report_options.h"

namespace g31::cli {
namespace {

/// Takes the code of a warning or note of g31, in small letters, too.
std::string take_allowed(std::string& code) {
  code = in_capitals(code);
  const auto row = std::ranges::find(source::diagnostics(), code, &source::DiagnosticInfo::code);
  if (row == source::diagnostics().end()) {
    return fmt::format("{} is not a message of g31 itself, like PRB301", code);
  }
  return row->severity == source::Severity::Error
             ? fmt::format("{} is an error, which ends the run", code)
             : "";
}

/// What an operator's panel has, and how much is said.
void add_desk_options(CLI::App& run, RunOptions& options) {
  run.add_flag("--optional-stop", options.optional_stop,
               "the switch for M01 is on: it stops; else it is passed");
  run.add_option("--block-skip", options.block_skip,
                 "the switch for /N is on, 1 to 9 (/ alone is 1); repeatable")
      ->type_name("N")
      ->allow_extra_args(false)
      ->transform(whole_number(1, 9));
  CLI::Option* const quiet = run.add_flag_callback(
      "-q,--quiet", [&options] { options.talk = Talk::Quiet; },
      "on standard error only what is wrong: no stops, no messages, no line at the end");
  run.add_flag_callback(
         "-v,--verbose", [&options] { options.talk = Talk::Verbose; },
         "on standard error each measuring move, too")
      ->excludes(quiet);
  run.add_flag("--no-color,--no-colour", options.no_colour,
               "no colours on a terminal; so does the environment variable NO_COLOR");
}

/// The report and what stands in it.
void add_page_options(CLI::App& run, RunOptions& options) {
  add_report_options(run, options.report, options.language);
  run.add_option("--compare", options.compare,
                 "beside the run of the report another one, as its document (--json --moves "
                 "--touches, with times by --blocks) tells it")
      ->type_name("OTHER.json")
      ->check([](const std::string& path) { return path.empty() ? "it names no file" : ""; })
      ->needs("--report");
}

}  // namespace

void add_program_options(CLI::App& command, RunOptions& options) {
  command
      .add_option("PROGRAM", options.programs,
                  "the program to run; further files are where subprograms are looked up first")
      ->type_name("FILE")
      ->required();
  command
      .add_option("-s,--setup", options.setups,
                  "set-up sheet (TOML); repeatable, later ones win key by key")
      ->type_name("FILE")
      ->allow_extra_args(false);
  add_control_option(command, options.control,
                     "control profile, for example fanuc-16i, sinumerik-828d");
  command
      .add_option("--lib", options.libraries,
                  "folder of subprograms, with those below it; repeatable")
      ->type_name("DIR")
      ->allow_extra_args(false);
  command
      .add_option(
          "--set", options.assignments,
          "variable before the start, #500=1.5 or R1=1.5; an empty value is null (#); repeatable")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  command.add_option("--seed", options.seed, "seed of every random model (default 0)")
      ->type_name("N")
      ->transform(whole_number(0, kLargestCount));
  command.add_option("--max-blocks", options.budget.blocks, "executed blocks (default 50000000)")
      ->type_name("N")
      ->transform(whole_number(0, kLargestCount));
  command
      .add_option(
          "--max-time", options.budget.wall_seconds,
          "wall seconds (default 600); then who reads a pipe of ours is waited for 1 s at most")
      ->type_name("S")
      ->check(why_no_time);
  add_max_output(command, options.max_output,
                 "all printouts, files, lists of the document and rows of tables together");
}

void add_expect_option(CLI::App& command, RunOptions& options) {
  command
      .add_option("--expect", options.expects,
                  "what a variable is to be at the end, #160=19.998+-0.001, #7=vacant or NAME=\"a "
                  "text\"; R1-R9=0 is each of a range, as --print takes it; else exit code 1; "
                  "repeatable, [expect] of a sheet says more")
      ->type_name("NAME=VALUE+-TOLERANCE")
      ->allow_extra_args(false);
}

void add_run_options(CLI::App& run, RunOptions& options) {
  add_program_options(run, options);
  run.add_option(
         "--print", options.prints,
         "variables to report at the end: #100-#149,#5061 or R1,_OVR[4]; all: every one that is "
         "set, locals of the main program included")
      ->type_name("NAMES")
      ->allow_extra_args(false);
  run.add_option("--json", options.json, "result document; - is standard output")
      ->type_name("FILE")
      ->check(why_no_place);
  add_page_options(run, options);
  add_expect_option(run, options);
  run.add_option("--printer", options.printer,
                 "where printouts go: a file, - for standard output (default), or a serial line "
                 "as DEVICE,BAUD,PARITY,DATA BITS,STOP BITS")
      ->type_name("PRINTER")
      ->check(why_no_printer);
  run.add_option(
         "--printer-wait", options.printer_wait_s,
         "seconds for which a printer on a line may stop the program at a time (default 30)")
      ->type_name("S")
      ->check(why_no_time);
  run.add_option("--jsonl", options.jsonl,
                 "every move, touch, stop, printout and message as it happens, one JSON object a "
                 "line; - is standard output")
      ->type_name("FILE")
      ->check(why_no_place);
  run.add_flag("--changes", options.changes,
               "every variable, offset and tool datum that the run has changed");
  add_desk_options(run, options);
  run.add_flag("--moves", options.moves, "every move in the document");
  run.add_flag("--touches", options.touches, "every touch in the document");
  run.add_flag("--blocks", options.blocks,
               "in the document how often each block ran, every call with its time, and what "
               "variables were given");
  run.add_option("--allow", options.allowed,
                 "a warning or note that is neither shown nor counted: PRB316; repeatable; in a "
                 "program (g31: allow PRB316 reason) or ; g31: allow PRB316 reason")
      ->type_name("CODE")
      ->allow_extra_args(false)
      ->transform(CLI::Validator(take_allowed, ""));
  add_fail_on_option(run, options.fail_on,
                     "the least message that makes a completed run exit with 1: error, warning "
                     "(default) or note");
  run.add_option("--trace", options.trace, "axis positions over time and at the end, a CSV table")
      ->type_name("FILE")
      ->check(why_no_place);
  run.add_option("--trace-period", options.trace_period,
                 "time between two rows: 182.32us, 4ms, 0.001s or plain seconds (default 1ms)")
      ->type_name("TIME")
      ->needs("--trace");
  run.add_option("--readings", options.readings,
                 "what the sensors of the sheet read at every stop (G04, M00, M01, STOPRE), as a "
                 "table (CSV)")
      ->type_name("FILE")
      ->check(why_no_place);
}

std::string run_examples() {
  return "Examples:\n"
         "  g31 run O6001.nc --setup ring.toml --print '#517,#518'\n"
         "  g31 run part.nc -s machine.toml -s fixture.toml --lib macros --json - --touches\n"
         "  g31 run O9010.nc --set '#1=1' --set '#18=5' --control fanuc-30i\n"
         "  g31 run part.mpf --control sinumerik-828d -s machine.toml --set R1=5 --print "
         "'_OVR[4],R2'\n"
         "  g31 run part.arc SUB.SPF -s machine.toml --lib cycles\n"
         "  g31 run step.nc -s bed.toml --readings bed.csv\n"
         "  g31 run part.nc -s machine.toml --expect '#160=19.998+-0.001' --json result.json\n"
         "  g31 run part.nc -s machine.toml --report part.html\n"
         "  g31 run part.nc -s machine.toml --printer printout.txt\n"
         "  g31 run part.nc -s machine.toml --printer /dev/ttyS0,4800,e,7,2\n\n"
         "A printer at a line, as a control feeds it (more in macros/README.md):\n"
         "  e,7    ISO code: even parity in bit 8; o,7 odd parity\n"
         "  n,8    plain characters; ISO code where parameter 0.1 is 1\n"
         "  POPEN sends DC2, PCLOS DC4; DC3 from the printer stops the output, DC1 lets it go on.\n"
         "  A printer that is not ready is alarm 86, exit code 3; no such line, exit code 2.\n\n";
}

}  // namespace g31::cli
