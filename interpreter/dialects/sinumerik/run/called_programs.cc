#include "interpreter/dialects/sinumerik/run/called_programs.h"

#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/run/file_name.h"

namespace g31::sinumerik {
namespace {

constexpr std::size_t kMostExecTexts = 50'000;  // of EXECSTRING: what was compiled is kept
constexpr std::size_t kMostWritten = 10'000;  // programs that a run writes and calls: all are kept
constexpr std::size_t kMostWrittenBytes = 16 << 20;  // of their texts: the code is larger

}  // namespace

const CompiledProgram* CalledPrograms::find(std::string_view name) {
  return programs_.find(name, {stack_.level().program->folder, folder_name(channel_.call_path)});
}

bool CalledPrograms::is_written(std::string_view path) const {
  return channel_.files.contains(file_meant(channel_, path));
}

void CalledPrograms::set_call_path(std::string path) {
  channel_.call_path = std::move(path);
  found_calls_.clear();
}

Result<const CompiledProgram*, Failure> CalledPrograms::called(const CallSite& site,
                                                               const std::string& text) {
  if (files_seen_ != channel_.files.changes()) {
    files_seen_ = channel_.files.changes();
    found_calls_.clear();
  }
  if (const auto found = found_calls_.find(&site); found != found_calls_.end()) {
    return found->second;
  }
  const std::string& name = site.name.empty() ? text : site.name;
  if (const CompiledProgram* const program = find(name)) {
    // Files and given programs are kept apart, so neither can stand for the other.
    if (is_written(name)) {
      return failure(AlarmId::NotImplemented,
                     fmt::format("a call of {}, to which the run has written: what was there "
                                 "before would run",
                                 name));
    }
    if (!site.name.empty()) {
      found_calls_.emplace(&site, program);
    }
    return program;
  }
  const auto written = written_program(name);
  if (!written || written.value() != nullptr) {
    return written;
  }
  const bool is_l_number = name.size() > 1 && upper(name.front()) == 'L' && is_digit(name[1]);
  return failure(site.name.empty() || is_l_number ? AlarmId::ProgramNotFound : AlarmId::NotDefined,
                 name);
}

/// A program that WRITE has made, as it is now; nullptr: there is none.
Result<const CompiledProgram*, Failure> CalledPrograms::written_program(std::string_view name) {
  const ProgramName wanted = program_name(name);
  for (const auto& [file, content] : channel_.files.all()) {
    const ProgramName parts = program_name(file);
    const bool fits = parts.stem == wanted.stem && (wanted.suffix.empty() || parts.suffix.empty() ||
                                                    wanted.suffix == parts.suffix);
    if (!fits) {
      continue;
    }
    if (const auto known = written_.find({file, content}); known != written_.end()) {
      return known->second;
    }
    if (written_.size() >= kMostWritten || content.size() > kMostWrittenBytes - written_bytes_) {
      return failure(AlarmId::TooComplex, fmt::format("{}: too many programs are written", name));
    }
    const CompiledProgram* const made = programs_.written(file, content);
    written_.emplace(std::pair(file, content), made);
    written_bytes_ += content.size();
    return made;
  }
  return static_cast<const CompiledProgram*>(nullptr);
}

Result<const CompiledProgram*, Failure> CalledPrograms::text_of(const CompiledProgram& home,
                                                                const std::string& source) {
  if (texts_run_.size() >= kMostExecTexts) {
    return failure(AlarmId::TooComplex, "EXECSTRING: too many different texts");
  }
  const CompiledProgram*& made = texts_run_[{&home, source}];
  if (made == nullptr) {
    made = programs_.snippet(source, home, "EXECSTRING");
  }
  if (MaybeFailure missing = stack_.missing_of_main(*made)) {
    return *std::move(missing);
  }
  return made;
}

}  // namespace g31::sinumerik
