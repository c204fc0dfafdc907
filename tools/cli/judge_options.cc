#include "tools/cli/judge_options.h"

#include <CLI/CLI.hpp>

#include "tools/cli/limit_options.h"
#include "tools/cli/output_places.h"
#include "tools/cli/report_options.h"

namespace g31::cli {

void add_judge_options(CLI::App& command, JudgeOptions& options) {
  command
      .add_option("PLAN", options.plan,
                  "a document g31.plan/1; its measures say id, nominal and tolerance, and printed "
                  "where the program prints another name than the id in capitals with - for other "
                  "characters")
      ->type_name("FILE")
      ->required();
  command
      .add_option(
          "RESULTS", options.results,
          "lines of names and values, or a document g31.run/1 whose program printed them or "
          "wrote them into one file: a file, - for standard input, or a serial line as "
          "DEVICE,BAUD,PARITY,DATA BITS,STOP BITS")
      ->type_name("FILE")
      ->required();
  command.add_option("--json", options.json, "the judgement as a document; - is standard output")
      ->type_name("FILE")
      ->check(why_no_place);
  add_report_options(command, options.report, options.language);
  command.get_option("--report")
      ->description("one HTML file with the values beside their limits; needs no network");
  constexpr double kShortestWaitS = 0.1;
  constexpr double kLongestWaitS = 86'400.0;
  command
      .add_option("--wait", options.wait_s,
                  "how long a serial line may be silent, until what has not come is missing")
      ->type_name("S")
      ->check(number_range(kShortestWaitS, kLongestWaitS))
      ->capture_default_str();
}

std::string judge_examples() {
  return "The exit code is 1 with any measure that is not good.\n\n"
         "Examples:\n"
         "  g31 run inspect.nc -s setup.toml --printer results.txt\n"
         "  g31 judge plan.json results.txt\n"
         "  g31 judge plan.json results.txt --json judgement.json --report judgement.html\n"
         "  g31 run INSPECT.MPF -s setup.toml --json run.json; g31 judge plan.json run.json\n"
         "  g31 judge plan.json /dev/ttyS0,4800,e,7,2 --wait 300\n\n";
}

}  // namespace g31::cli
