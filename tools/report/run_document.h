#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "interpreter/runtime/inspection.h"
#include "interpreter/runtime/outcome.h"
#include "interpreter/runtime/shown_value.h"
#include "interpreter/source/source_map.h"
#include "tools/coverage/coverage.h"
#include "tools/expect/expectation.h"
#include "tools/report/object_writer.h"
#include "tools/report/run_chronicle.h"
#include "tools/report/run_recorder.h"
#include "tools/session/heard.h"

namespace g31::report {

/// A file that a run depends on.
struct InputFile {
  std::string file;    ///< as it was named
  std::string sha256;  ///< of its bytes, hexadecimal
};

/// A variable, offset or tool datum that a run has changed.
struct ValueChange {
  std::string name;
  runtime::ShownValue before;
  runtime::ShownValue after;
};

/// Everything that the result document of one run tells.
struct RunResult {
  std::string version;  ///< of g31; "": not said
  int exit_code = 0;    ///< that the process ends with
  std::vector<InputFile> inputs;
  std::string program;  ///< file name of the main program, without folder
  std::string control;
  std::uint64_t seed = 0;
  runtime::Outcome outcome;
  bool optional_stop = false;  ///< M01 stops
  std::vector<expect::Judged> expectations;
  std::vector<expect::MeasuredCharacteristic> characteristics;
  std::vector<session::AllowedMessage> allowed;  ///< messages that nobody wants to hear
  std::vector<std::pair<std::string, runtime::ShownValue>> variables;  ///< in the order asked for
  runtime::NamedValues locals;                      ///< of the program that an alarm stands in
  std::optional<std::vector<ValueChange>> changes;  ///< where they are asked for
  std::map<std::string, std::string_view> files;    ///< what the program wrote, by name
  double machine_time_s = 0.0;
  std::string probe_state;                  ///< what is the matter with the probe, "" for nothing
  const RunChronicle* chronicle = nullptr;  ///< where it is asked for; outlives the result
  std::vector<coverage::FileCoverage> coverage;  ///< of what the chronicle has counted
};

/// The lists of a document that only who asks for them gets.
struct DocumentLists {
  bool moves = false;    ///< where the recorder keeps them
  bool touches = false;  ///< the same
  bool blocks = false;   ///< calls, counts and histories, and the times of moves, of the chronicle
};

/// Writes the JSON text of schema `g31.run/1` (docs: the command-line contract), which ends in a
/// line break, piece by piece: no list of it is ever in memory as text.  Bytes that are no UTF-8 in
/// program texts are replaced by U+FFFD.
/// @param sources  of the programs that ran
void write_run_document(const RunResult& result, const RunRecorder& recorder,
                        const source::SourceMap& sources, const DocumentLists& lists,
                        const TextSink& sink);

}  // namespace g31::report
