#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "interpreter/analysis/program_set.h"
#include "interpreter/analysis/sinumerik_flow.h"
#include "interpreter/dialects/sinumerik/code/callable_programs.h"
#include "interpreter/dialects/sinumerik/code/program_name.h"
#include "interpreter/dialects/sinumerik/code/value_limits.h"
#include "interpreter/dialects/sinumerik/code/wrong_argument.h"
#include "interpreter/dialects/sinumerik/vocabulary/names.h"
#include "machine/base/contract.h"

namespace g31::analysis {
namespace {

/// Whether a program may be one that the caller has written.
bool may_write(const Flow& caller, std::string_view program) {
  return caller.written.has_unknown ||
         (!caller.written.names.empty() &&
          std::ranges::find(caller.written.names, sinumerik::program_name(program).stem) !=
              caller.written.names.end());
}

/// The line before a program: %_N_NAME_SPF.
source::Location header_of(const sinumerik::FiledProgram& program) {
  const sinumerik::ProgramSource& source = program.source();
  const std::string_view before = source.file->text().substr(0, source.text.begin);
  const std::string_view line = before.substr(0, before.find_last_not_of("\r\n") + 1);
  const auto begin = static_cast<std::uint32_t>(line.rfind('\n') + 1);
  return source.file->at({begin, static_cast<std::uint32_t>(line.size())});
}

class SinumerikPrograms final : public ProgramSet {
 public:
  SinumerikPrograms(source::SourceMap& sources, const runtime::ControlSetup& setup)
      : sources_(sources), data_(setup.data), axis_names_(setup.axis_names) {
    start_over();
  }

  /// What files define is in the code of all others: nothing is kept.
  void start_over() override {
    sites_.clear();
    memory_.emplace(sources_);
    memory_->library.expect_data(data_);
    memory_->library.expect_axes(axis_names_);
    memory_->library.expect_any_main();
  }

  bool add_file(const std::string& path) override {
    return memory_->library.add_file(path) == sinumerik::ProgramLibrary::Added::Yes;
  }
  void add_folder(const std::string& folder) override { memory_->library.add_folder(folder); }
  void add_shipped_folder(const std::string& folder) override {
    memory_->library.add_shipped_folder(folder);
  }
  void add_definitions(std::span<const std::string> files) override {
    memory_->library.add_definitions(files);
  }

  const source::SourceFile& text(const std::string& path) override {
    const sinumerik::ProgramFile* const file = memory_->library.file(path);
    G31_EXPECTS(file != nullptr);
    return file->text();
  }

  std::vector<Flow> flows(const std::string& path) override {
    (void)memory_->library.definitions();  // before anything else is compiled
    sinumerik::ProgramFile* const file = memory_->library.file(path);
    G31_EXPECTS(file != nullptr);
    std::vector<Flow> all;
    for (const auto& program : file->programs()) {
      const sinumerik::CompiledProgram& code = program->code(memory_->library.globals());
      note_calls(code);
      all.push_back(flow_of(code));
    }
    return all;
  }

  std::vector<Finding> hidden_programs(const std::string& path) override {
    const sinumerik::ProgramFile* const file = memory_->library.file(path);
    G31_EXPECTS(file != nullptr);
    std::vector<Finding> hidden;
    std::map<std::array<std::string, 3>, source::Location> known;
    for (const auto& program : file->programs()) {
      const sinumerik::ProgramName& name = program->name();
      const source::Location header = header_of(*program);
      const auto [first, is_new] = known.try_emplace({name.folder, name.stem, name.suffix}, header);
      if (!is_new) {
        hidden.push_back({RuleId::ProgramTwice, 0, header,
                          fmt::format("{} appears twice: calls find that of line {}", name.stem,
                                      sources_.show(first->second).line),
                          std::string(source::info(source::DiagnosticId::ProgramTwice).remedy)});
      }
    }
    return hidden;
  }

  std::vector<Flow> definitions() override {
    std::vector<Flow> all;
    for (const sinumerik::CompiledProgram* const code : memory_->library.definitions()) {
      all.push_back(flow_of(*code));
    }
    return all;
  }

  std::optional<Fault> missing_program(const Flow& caller, const Call& call) override;
  std::optional<Fault> wrong_arguments(const Flow& caller, const Call& call) override;

 private:
  using Program = sinumerik::CompiledProgram;
  struct Site {
    const Program* caller = nullptr;
    const sinumerik::CallSite* call = nullptr;
  };
  void note_calls(const Program& program);
  std::vector<const Program*> meant_by(const std::string& target, const Program& caller);

  struct Memory {
    explicit Memory(source::SourceMap& sources) : library(sources), callable(library) {}
    sinumerik::ProgramLibrary library;
    sinumerik::CallablePrograms callable;
  };

  source::SourceMap& sources_;
  sinumerik::SheetData data_;
  std::map<std::string, char> axis_names_;
  std::optional<Memory> memory_;  ///< there is always one
  std::map<std::pair<const source::SourceFile*, std::uint32_t>, Site> sites_;  ///< by their places
};

/// An alarm that a call will raise.
Fault fault_of(sinumerik::AlarmId id, syntax::ShortSpan where, const std::string& detail) {
  const sinumerik::AlarmInfo& row = sinumerik::info(id);
  return {Fault::Kind::Block, row.number, where, fmt::format("{}: {}", row.text, detail),
          std::string(row.remedy)};
}

/// A text that is given as it stands and has more characters than its parameter.
std::optional<sinumerik::WrongArgument> text_too_long(const sinumerik::Variable& parameter,
                                                      const sinumerik::Argument& argument,
                                                      const sinumerik::CompiledProgram& caller) {
  const bool is_known = argument.form == sinumerik::Argument::Form::Value &&
                        argument.type == sinumerik::Type::String &&
                        argument.value.bank == sinumerik::Bank::Constants &&
                        parameter.type == sinumerik::Type::String;
  if (!is_known) {
    return std::nullopt;
  }
  const auto wrong = sinumerik::too_long(
      caller.text_constants[static_cast<std::size_t>(argument.value.place)], parameter.longest);
  return wrong ? std::optional(sinumerik::WrongArgument{
                     wrong->id, fmt::format("{}: {}", parameter.name, wrong->detail)})
               : std::nullopt;
}

/// What the program called says to the arguments, as a run does when it takes them.
std::optional<Fault> fault_between(const sinumerik::CompiledProgram& caller,
                                   const sinumerik::CallSite& call, syntax::ShortSpan where,
                                   const sinumerik::CompiledProgram& called) {
  const std::span given =
      std::span(caller.arguments).subspan(call.first_argument, call.argument_count);
  if (!called.has_proc && !given.empty()) {
    return fault_of(sinumerik::AlarmId::ProcMissing, where, called.name);
  }
  if (called.has_wrong_proc) {
    return std::nullopt;
  }
  if (given.size() > called.parameters.size()) {
    return fault_of(sinumerik::AlarmId::TooManyArguments, where,
                    fmt::format("{} takes {} arguments, {} are given", called.name,
                                called.parameters.size(), given.size()));
  }
  static const sinumerik::Argument kOmitted;
  for (std::size_t i = 0; i < called.parameters.size(); ++i) {
    const sinumerik::Parameter& parameter = called.parameters[i];
    const sinumerik::Argument& argument = i < given.size() ? given[i] : kOmitted;
    const sinumerik::Variable& variable =
        called.variables[static_cast<std::size_t>(parameter.variable)];
    auto wrong = wrong_argument(parameter, variable, given_by(argument, caller));
    if (!wrong) {
      wrong = text_too_long(variable, argument, caller);
    }
    if (wrong) {
      const bool is_omitted = argument.form == sinumerik::Argument::Form::Omitted;
      return fault_of(wrong->id, is_omitted ? where : argument.where,
                      fmt::format("{}, {}", called.name, wrong->detail));
    }
  }
  return std::nullopt;
}

void SinumerikPrograms::note_calls(const Program& program) {
  for (std::size_t step = 0; step < program.ops.size(); ++step) {
    const sinumerik::Op& op = program.ops[step];
    if (op.code == sinumerik::OpCode::Call) {
      sites_[{program.file, program.spans[step].begin}] = {
          &program, &program.calls[static_cast<std::size_t>(op.a.place)]};
    }
  }
}

/// Every program that a name may mean.  Which one it does depends on the files that are given to a
/// run and on CALLPATH.
std::vector<const sinumerik::CompiledProgram*> SinumerikPrograms::meant_by(
    const std::string& target, const Program& caller) {
  const Program* const found = memory_->callable.find(target, {caller.folder, ""});
  if (found == nullptr) {
    return {};
  }
  std::vector all = {found};
  for (sinumerik::FiledProgram* const other : memory_->library.opened(found->name)) {
    if (is_callable(other->name())) {
      all.push_back(&other->code(memory_->library.globals()));
    }
  }
  return all;
}

/// The first fault, when none of the programs that may be meant takes the arguments.
std::optional<Fault> SinumerikPrograms::wrong_arguments(const Flow& caller, const Call& call) {
  const auto place = sites_.find({caller.file, call.where.begin});
  if (call.target.empty() || place == sites_.end()) {
    return std::nullopt;
  }
  const auto& [program, site] = place->second;
  const bool never_runs = site->passes.bank == sinumerik::Bank::Constants &&
                          program->constants[static_cast<std::size_t>(site->passes.place)] == 0.0;
  if (never_runs) {
    return std::nullopt;
  }
  std::optional<Fault> first;
  for (const Program* const called : meant_by(call.target, *program)) {
    auto fault = fault_between(*program, *site, call.where, *called);
    if (!fault) {
      return std::nullopt;
    }
    if (!first) {
      first = std::move(fault);
    }
  }
  return first;
}

std::optional<Fault> SinumerikPrograms::missing_program(const Flow& caller, const Call& call) {
  using sinumerik::AlarmId;
  // Where the caller and CALLPATH point decides between programs, not whether there is one.
  if (call.target.empty() || may_write(caller, call.target) ||
      memory_->callable.find(call.target, {}) != nullptr) {
    return std::nullopt;
  }
  if (const auto* const cycle = sinumerik::find_unsimulated_cycle(call.target);
      cycle != nullptr && !call.by_text) {
    return Fault{Fault::Kind::NotSimulated, 0, call.where,
                 fmt::format("{}, {}: a run reports it and skips it", cycle->name, cycle->text),
                 "a program of this name, in the file or in a folder with --lib"};
  }
  const bool is_l_number = call.target.size() > 1 && sinumerik::upper(call.target.front()) == 'L' &&
                           sinumerik::is_digit(call.target[1]);
  return fault_of(call.by_text || is_l_number ? AlarmId::ProgramNotFound : AlarmId::NotDefined,
                  call.where, call.target);
}

}  // namespace

std::unique_ptr<ProgramSet> sinumerik_programs(source::SourceMap& sources,
                                               const runtime::ControlSetup& setup) {
  return std::make_unique<SinumerikPrograms>(sources, setup);
}

}  // namespace g31::analysis
