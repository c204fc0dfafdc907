#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/runtime/outcome.h"
#include "interpreter/runtime/shown_value.h"
#include "interpreter/source/source_map.h"
#include "tools/report/run_recorder.h"

namespace g31::report {

/// Everything that the result document of one run tells.
struct RunResult {
  std::string program;  ///< file name of the main program, without folder
  std::string control;
  std::uint64_t seed = 0;
  runtime::Outcome outcome;
  std::vector<std::pair<std::string, runtime::ShownValue>> variables;  ///< in the order asked for
  std::map<std::string, std::string> files;  ///< what the program wrote, by name
  double machine_time_s = 0.0;
  std::string probe_state;  ///< what is the matter with the probe, "" for nothing
};

/// The JSON text of schema `g31.run/1` (docs: the command-line contract), ending in a line break.
/// Bytes that are no UTF-8 in program texts are replaced by U+FFFD.
/// @param sources  of the programs that ran
std::string run_document(const RunResult& result, const RunRecorder& recorder,
                         const source::SourceMap& sources);

}  // namespace g31::report
