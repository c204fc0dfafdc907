#include "interpreter/analysis/static_findings.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "interpreter/analysis/look_alikes.h"
#include "interpreter/source/readable_text.h"

namespace g31::analysis {
namespace {

RuleId rule_of(Fault::Kind kind) {
  switch (kind) {
    case Fault::Kind::Block:
      return RuleId::WrongBlock;
    case Fault::Kind::Target:
      return RuleId::MissingTarget;
    case Fault::Kind::End:
      return RuleId::NoProgramEnd;
    case Fault::Kind::NotSimulated:
      return RuleId::NotSimulated;
    case Fault::Kind::Comparison:
      return RuleId::MixedComparison;
    case Fault::Kind::LostPoint:
      return RuleId::LostPoint;
    case Fault::Kind::SurplusEnd:
      return RuleId::SurplusEnd;
  }
  return RuleId::WrongBlock;
}

class Findings {
 public:
  explicit Findings(ProgramSet& programs) : programs_(programs) {}

  void add(const Flow& flow) {
    const std::vector<bool> reached = reached_blocks(flow);
    // A wrong block may be the end that is missing.
    const bool is_readable =
        std::ranges::find(flow.faults, Fault::Kind::Block, &Fault::kind) == flow.faults.end();
    for (BlockIndex i = 0; i < flow.blocks.size(); ++i) {
      const Block& block = flow.blocks[i];
      for (const Fault& fault : flow.faults_of(block)) {
        const bool runs_out = reached[i] && is_readable && !may_end_run(flow, block);
        if (fault.kind != Fault::Kind::End || runs_out) {
          add(flow, fault, rule_of(fault.kind), reached[i]);
        }
      }
      for (const Call& call : flow.calls_of(block)) {
        add_call(flow, call, reached[i]);
      }
    }
  }

  void add(Finding finding) { found_.push_back(std::move(finding)); }

  std::vector<Finding> take() {
    std::ranges::stable_sort(found_, {}, [](const Finding& f) { return f.where.begin; });
    return std::move(found_);
  }

 private:
  /// Whether a program that the block calls may do so.
  [[nodiscard]] bool may_end_run(const Flow& flow, const Block& block) {
    return std::ranges::any_of(flow.calls_of(block), [this](const Call& call) {
      return !programs_.returns_for_certain(call);
    });
  }
  void add_call(const Flow& flow, const Call& call, bool is_reached) {
    if (const auto fault = programs_.missing_program(flow, call)) {
      const bool is_there = fault->kind != Fault::Kind::Block;
      add(flow, *fault, is_there ? rule_of(fault->kind) : RuleId::MissingProgram, is_reached);
    } else if (const auto wrong = programs_.wrong_arguments(flow, call)) {
      add(flow, *wrong, RuleId::WrongArguments, is_reached);
    }
  }

  void add(const Flow& flow, const Fault& fault, RuleId rule, bool is_reached) {
    // What g31 lacks is no mistake of the program, wherever it stands; no control refuses a doubt.
    const bool is_doubt =
        rule == RuleId::MixedComparison || rule == RuleId::LostPoint || rule == RuleId::SurplusEnd;
    const bool is_refused = rule != RuleId::NotSimulated && !is_doubt;
    if (!is_reached && is_refused) {
      rule = RuleId::UnreachedFault;
    }
    std::optional<Fix> fix;
    const auto repair = fault.repair ? fault.repair : plain_character(*flow.file, fault.where);
    if (repair) {
      fix = Fix{repair->title, {{flow.file->at(repair->where.widened()), repair->text}}};
    }
    found_.push_back({rule, fault.alarm, flow.file->at(fault.where.widened()), fault.message,
                      fault.remedy, std::move(fix)});
  }

  ProgramSet& programs_;
  std::vector<Finding> found_;
};

Finding no_program(const source::SourceFile& file, const std::string& why) {
  Finding finding;
  finding.rule = RuleId::NotAProgram;
  finding.where = file.at({});
  finding.message = why;
  return finding;
}

}  // namespace

std::vector<Finding> static_findings(ProgramSet& programs, const std::string& path) {
  const source::SourceFile& file = programs.text(path);
  if (source::is_no_text(file.text())) {
    return {no_program(file, "this file is not text")};
  }
  if (auto refused = programs.refusal(path)) {
    return {*std::move(refused)};
  }
  const std::vector<Flow> flows = programs.flows(path);
  if (flows.empty()) {
    return {no_program(file, "no program in this file")};
  }
  Findings findings(programs);
  for (const Flow& flow : flows) {
    findings.add(flow);
  }
  for (Finding& finding : programs.hidden_programs(path)) {
    findings.add(std::move(finding));
  }
  for (Finding& finding : programs.doubts_of_text(path)) {
    findings.add(std::move(finding));
  }
  return findings.take();
}

std::map<std::string, std::vector<Finding>> definition_findings(ProgramSet& programs) {
  std::map<std::string, std::vector<Finding>> by_file;
  for (const Flow& flow : programs.definitions()) {
    Findings findings(programs);
    findings.add(flow);
    std::ranges::move(findings.take(), std::back_inserter(by_file[flow.file->name()]));
  }
  std::erase_if(by_file, [](const auto& file) { return file.second.empty(); });
  return by_file;
}

}  // namespace g31::analysis
