#include <fmt/format.h>

#include "interpreter/analysis/program_set.h"
#include "interpreter/analysis/sinumerik_flow.h"
#include "interpreter/dialects/sinumerik/code/callable_programs.h"
#include "interpreter/dialects/sinumerik/vocabulary/names.h"
#include "machine/base/contract.h"

namespace g31::analysis {
namespace {

class SinumerikPrograms final : public ProgramSet {
 public:
  SinumerikPrograms(source::SourceMap& sources, const runtime::ControlSetup& setup)
      : library_(sources), callable_(library_) {
    library_.expect_data(setup.data);
    library_.expect_axes(setup.axis_names);
  }

  bool add_file(const std::string& path) override {
    return library_.add_file(path) == sinumerik::ProgramLibrary::Added::Yes;
  }
  void add_folder(const std::string& folder) override { library_.add_folder(folder); }

  const source::SourceFile& text(const std::string& path) override {
    const sinumerik::ProgramFile* const file = library_.file(path);
    G31_EXPECTS(file != nullptr);
    return file->text();
  }

  std::vector<Flow> flows(const std::string& path) override {
    (void)library_.definitions();  // before anything else is compiled
    sinumerik::ProgramFile* const file = library_.file(path);
    G31_EXPECTS(file != nullptr);
    std::vector<Flow> all;
    for (const auto& program : file->programs()) {
      all.push_back(flow_of(program->code(library_.globals())));
    }
    return all;
  }

  std::optional<Fault> missing_program(const Flow& caller, const Call& call) override;

 private:
  sinumerik::ProgramLibrary library_;
  sinumerik::CallablePrograms callable_;
};

std::optional<Fault> SinumerikPrograms::missing_program(const Flow& caller, const Call& call) {
  using sinumerik::AlarmId;
  // Where the caller and CALLPATH point decides between programs, not whether there is one.
  if (call.target.empty() || caller.writes_files || callable_.find(call.target, {}) != nullptr) {
    return std::nullopt;
  }
  if (const auto* const cycle = sinumerik::find_unsimulated_cycle(call.target);
      cycle != nullptr && !call.by_text) {
    return Fault{Fault::Kind::NotSimulated, 0, call.where,
                 fmt::format("{}, {}: a run tells it and passes over it", cycle->name, cycle->text),
                 "a program of this name, in the file or in a folder with --lib"};
  }
  const bool is_l_number = call.target.size() > 1 && sinumerik::upper(call.target.front()) == 'L' &&
                           sinumerik::is_digit(call.target[1]);
  const sinumerik::AlarmInfo& row =
      sinumerik::info(call.by_text || is_l_number ? AlarmId::ProgramNotFound : AlarmId::NotDefined);
  return Fault{Fault::Kind::Block, row.number, call.where,
               fmt::format("{}: {}", row.text, call.target), std::string(row.remedy)};
}

}  // namespace

std::unique_ptr<ProgramSet> sinumerik_programs(source::SourceMap& sources,
                                               const runtime::ControlSetup& setup) {
  return std::make_unique<SinumerikPrograms>(sources, setup);
}

}  // namespace g31::analysis
