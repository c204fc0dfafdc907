#include <algorithm>
#include <charconv>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>

#include "interpreter/analysis/fanuc_comments.h"
#include "interpreter/analysis/fanuc_doubts.h"
#include "interpreter/analysis/fanuc_flow.h"
#include "interpreter/analysis/program_set.h"
#include "interpreter/dialects/fanuc/code/lathe.h"
#include "interpreter/dialects/fanuc/code/library.h"
#include "interpreter/dialects/fanuc/code/word_limits.h"
#include "machine/base/contract.h"

namespace g31::analysis {
namespace {

/// Which program a call means.  @pre !call.target.empty()
/// @param factor  above it digits of a number count calls; 0: there is none
fanuc::ProgramKey key_of(const Call& call, int factor) {
  const std::string& target = call.target;
  fanuc::ProgramKey key;
  if (target.starts_with('<')) {
    key.name = target.substr(1, target.size() - 2);
  } else {
    std::from_chars(target.data() + 1, target.data() + target.size(), key.number);
    key.number = factor > 0 ? key.number % factor : key.number;
  }
  return key;
}

/// Whether a program goes back behind its call, whatever it does: it has a plain M99, and no M2 or
/// M30, no call, and no M99 with a block to go on at.
bool returns_for_certain(const fanuc::CompiledProgram& program) {
  bool returns = false;
  for (const fanuc::Step& step : program.steps) {
    const syntax::Block& block = program.tree->blocks[step.block];
    const std::span words =
        std::span(program.tree->words).subspan(block.first_word, block.word_count);
    const bool has_p = std::ranges::find(words, 'P', &syntax::Word::letter) != words.end();
    for (const syntax::Word& word : words) {
      const bool is_code = word.letter == 'M' || word.letter == 'G' || word.letter == 'T';
      const bool is_open = is_code && word.form == syntax::ValueForm::Computed;
      const bool ends = word.letter == 'M' && (word.number == 2.0 || word.number == 30.0);
      if (is_open || ends || fanuc::calls_program(word) || (fanuc::is_return(word) && has_p)) {
        return false;
      }
      returns = returns || fanuc::is_return(word);
    }
  }
  return returns;
}

class FanucPrograms final : public ProgramSet {
 public:
  FanucPrograms(const fanuc::Profile& profile, source::SourceMap& sources, WordReading reading)
      : profile_(profile), sources_(sources), library_(sources), reading_(std::move(reading)) {
    library_.compile_for(profile);
  }

  void start_over() override {
    library_.start_over();
    reading_.every_block_calls = false;
  }
  bool add_file(const std::string& path) override {
    if (library_.add_file(path) != fanuc::ProgramLibrary::Added::Yes) {
      return false;
    }
    const auto [lets_call, is_new] = lets_every_block_call_.try_emplace(path, false);
    if (is_new) {
      const auto programs = library_.programs_of(path);
      lets_call->second = !programs.empty() && lets_every_block_call(*programs.front()->tree);
    }
    reading_.every_block_calls |= lets_call->second;
    return true;
  }
  void add_folder(const std::string& folder) override { library_.add_folder(folder); }
  void add_shipped_folder(const std::string& folder) override {
    library_.add_shipped_folder(folder);
  }

  const source::SourceFile& text(const std::string& path) override {
    const source::SourceFile* const text = library_.text_of(path);
    G31_EXPECTS(text != nullptr);
    return *text;
  }

  std::optional<Finding> refusal(const std::string& path) override {
    for (const fanuc::CompiledProgram* const program : library_.programs_of(path)) {
      if (const auto signs = fanuc::lathe_signs(*program)) {
        source::Diagnostic told = make_diagnostic(source::DiagnosticId::LatheProgram,
                                                  location_in(*program, signs->where), signs->what);
        return Finding{RuleId::OtherMachine, 0, told.where, std::move(told.message),
                       std::move(told.remedy)};
      }
    }
    return std::nullopt;
  }

  std::vector<Flow> flows(const std::string& path) override {
    std::vector<Flow> all;
    const auto programs = library_.programs_of(path);
    WordReading reading = reading_;
    if (!programs.empty()) {
      reading.in_increments = is_in_increments(*programs.front()->tree, reading.points);
    }
    for (const fanuc::CompiledProgram* const program : programs) {
      // An O number without blocks beside real programs is what some editors leave behind.
      if (program->steps.size() > 1 || programs.size() == 1) {
        all.push_back(flow_of(*program, profile_, reading));
      }
    }
    return all;
  }

  std::vector<Finding> hidden_programs(const std::string& path) override {
    std::vector<Finding> hidden;
    std::map<fanuc::ProgramKey, source::Location> known;
    const auto programs = library_.programs_of(path);
    for (std::size_t i = 0; i < programs.size(); ++i) {
      const fanuc::CompiledProgram& program = *programs[i];
      if (program.steps.size() <= 1) {
        continue;  // an O number that an editor left behind
      }
      const source::Location name = location_in(program, program.tree->programs[i].name);
      const auto [first, is_new] = known.try_emplace(program.key, name);
      if (!is_new && !program.key.is_empty()) {
        const int line = sources_.show(first->second).line;
        hidden.push_back({RuleId::ProgramTwice, 0, name,
                          fmt::format("{} appears twice: calls find that of line {}",
                                      to_text(program.key), line),
                          std::string(source::info(source::DiagnosticId::ProgramTwice).remedy)});
      }
    }
    return hidden;
  }

  std::vector<Finding> doubts_of_text(const std::string& path) override {
    const auto programs = library_.programs_of(path);
    if (programs.empty()) {
      return {};
    }
    const syntax::Tree& tree = *programs.front()->tree;
    std::vector<Finding> doubts = open_comments(text(path), tree);
    for (const std::vector<Finding>& more :
         {lost_heads(text(path), tree), constant_comparisons(text(path), tree),
          doubled_words(text(path), tree, profile_, reading_)}) {
      std::ranges::copy(more, std::back_inserter(doubts));
    }
    return doubts;
  }

  std::optional<Fault> missing_program(const Flow& caller, const Call& call) override {
    if (call.target.empty() || call.target == caller.program) {
      return std::nullopt;
    }
    if (const fanuc::CompiledProgram* const called = called_by(call)) {
      return call.start ? missing_start(*called, *call.start) : std::nullopt;
    }
    const fanuc::ProgramKey key = key_of(call, count_factor(call));
    return fault_of(
        key.name.empty() ? fanuc::AlarmId::CalledNotFound : fanuc::AlarmId::CalledNameNotFound,
        Fault::Kind::Block, call.where, fanuc::missing_program(key));
  }

  bool returns_for_certain(const Call& call) override {
    const fanuc::CompiledProgram* const called =
        call.target.empty() || call.kind == Call::Kind::Modal ? nullptr : called_by(call);
    return called != nullptr && analysis::returns_for_certain(*called);
  }

 private:
  [[nodiscard]] int count_factor(const Call& call) const {
    return call.kind == Call::Kind::Subprogram ? profile_.count_factor : 0;
  }

  /// nullptr: there is none.  M98 P51000 calls O1000 five times where no program is O51000.
  [[nodiscard]] const fanuc::CompiledProgram* called_by(const Call& call) {
    const fanuc::CompiledProgram* const called = library_.find(key_of(call, 0));
    return called != nullptr ? called : library_.find(key_of(call, count_factor(call)));
  }

  /// M98 P Q: the program has no such block.
  [[nodiscard]] std::optional<Fault> missing_start(const fanuc::CompiledProgram& called,
                                                   const Call::Start& start) const {
    if (called.find_label(start.sequence, 0)) {
      return std::nullopt;
    }
    return fault_of(fanuc::AlarmId::SequenceNotFound, Fault::Kind::Target, start.where,
                    fmt::format("{} has no N{}", to_text(called.key), start.sequence));
  }

  [[nodiscard]] Fault fault_of(fanuc::AlarmId id, Fault::Kind kind, syntax::ShortSpan where,
                               const std::string& detail) const {
    const fanuc::AlarmInfo& row = fanuc::info(id);
    return {kind, fanuc::number_of(row, profile_.alarm_numbers), where,
            fmt::format("{}: {}", row.text, detail), std::string(row.remedy)};
  }

  const fanuc::Profile& profile_;
  source::SourceMap& sources_;
  fanuc::ProgramLibrary library_;
  WordReading reading_;
  std::unordered_map<std::string, bool> lets_every_block_call_;  ///< by file, of those added so far
};

/// The G codes that a sheet makes macro calls: "G81" of [macro_calls], 6050 to 6059.
std::set<int> called_codes(const runtime::ControlSetup& setup) {
  std::set<int> codes;
  const auto number_in = [](std::string_view text) {
    int number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number;
  };
  for (const auto& [code, program] : setup.macro_calls) {
    if (code.starts_with('G')) {
      codes.insert(number_in(std::string_view(code).substr(1)));
    }
  }
  const auto& calls = fanuc::info(fanuc::ParameterId::MacroGCode);
  for (const auto& [name, value] : setup.parameters) {
    const int number = number_in(name);
    if (number >= calls.first && number <= calls.last) {
      codes.insert(fanuc::nearest_integer(value));
    }
  }
  return codes;
}

/// What a sheet says of numbers without a decimal point.
PointReading points_of(const runtime::ControlSetup& setup) {
  PointReading points;
  const auto is_on = [&](const char* name) {
    const auto given = setup.parameters.find(name);
    return given != setup.parameters.end() && given->second != 0.0;
  };
  points.counts_increments = !is_on("3401.0");
  points.has_fine_feed = is_on("1403.0");
  points.scale.set_increment_system(setup.increment);
  return points;
}

}  // namespace

std::unique_ptr<ProgramSet> fanuc_programs(const fanuc::Profile& profile,
                                           source::SourceMap& sources,
                                           const runtime::ControlSetup& setup) {
  return std::make_unique<FanucPrograms>(profile, sources,
                                         WordReading{called_codes(setup), false, points_of(setup)});
}

}  // namespace g31::analysis
