#include "interpreter/analysis/fanuc_words.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "interpreter/analysis/fanuc_known_words.h"
#include "interpreter/dialects/fanuc/code/data_setting.h"
#include "interpreter/dialects/fanuc/vocabulary/argument_letters.h"
#include "interpreter/dialects/fanuc/vocabulary/axis_words.h"
#include "machine/units/axis_positions.h"

namespace g31::analysis {
namespace {

using fanuc::EvaluatedWord;
using fanuc::GAction;
using fanuc::GCode;
using syntax::Word;
using Words = std::span<const Word>;

/// What the words of a block are for.
enum class Use { Block, MacroCall, Subprogram, Return, Unknown };

/// Codes that the rest of a block is read by; the last of each kind counts.
struct CodesOfBlock {
  const GCode* acting = nullptr;  ///< takes the words for itself
  const GCode* work_offset = nullptr;
  const GCode* tool_length = nullptr;
  const GCode* compensation = nullptr;
  bool drills = false;          ///< in a canned cycle
  bool has_mode = false;        ///< a code like G05.1 takes words of its own
  bool is_open = false;         ///< what they do says the sheet, or the state before
  bool calls_by_sheet = false;  ///< one is a macro call by it: all words are arguments
};

bool is_g(const EvaluatedWord& word, double code) {
  return word.letter == 'G' && word.number == code;
}

bool is_called_by_sheet(double code, const WordReading& reading) {
  return reading.calling_codes.contains(fanuc::nearest_integer(code));
}

bool is_macro_call(const EvaluatedWord& word) {
  return is_g(word, 65.0) || is_g(word, 66.0);
}

void take_code(CodesOfBlock& codes, const EvaluatedWord& word, const fanuc::Profile& profile) {
  const GCode* const code = fanuc::find_g_code(word.number, profile);
  if (code == nullptr) {
    return;
  }
  codes.is_open |= code->action == GAction::MacroCall;
  codes.has_mode |= fanuc::leaves_words(code->action) && code->action != GAction::ExactStop;
  const bool is_one_shot =
      code->group == fanuc::Group::OneShot && !fanuc::leaves_words(code->action);
  if (is_one_shot || fanuc::is_frame(code->action)) {
    codes.is_open |= codes.acting != nullptr || code->action == GAction::Refused;
    codes.acting = code;
  } else if (code->action == GAction::WorkOffset) {
    codes.work_offset = code;
  } else if (code->group == fanuc::Group::ToolLength) {
    codes.tool_length = code;
  } else if (code->group == fanuc::Group::CutterCompensation) {
    codes.compensation = code;
  } else if (code->group == fanuc::Group::CannedCycle || code->action == GAction::Motion) {
    codes.drills = code->action == GAction::CannedCycle;
  }
}

class JudgedBlock {
 public:
  JudgedBlock(Words words, syntax::ShortSpan whole, const fanuc::Profile& profile,
              const WordReading& reading)
      : profile_(profile), reading_(reading), whole_(whole), given_(words), words_(words, profile) {
    for (const EvaluatedWord& word : words_.words().all()) {
      if (word.letter != 'G') {
        continue;
      }
      codes_.is_open |= g_code_may_call(word.number, profile, reading);
      codes_.calls_by_sheet |= is_called_by_sheet(word.number, reading);
      if (!is_macro_call(word) && !is_g(word, 67.0)) {
        take_code(codes_, word, profile);
      }
    }
  }

  [[nodiscard]] WrongWord judge() const;
  [[nodiscard]] std::vector<LostPoint> lost_points() const;

 private:
  [[nodiscard]] Use use() const;
  [[nodiscard]] Use use_by_m(const EvaluatedWord& word) const;
  [[nodiscard]] std::vector<Word> without_return() const;
  [[nodiscard]] WrongWord call(Use use) const;
  [[nodiscard]] WrongWord argument_letters() const;
  [[nodiscard]] WrongWord plain_words(char left_out) const;
  [[nodiscard]] WrongWord offsets() const;
  [[nodiscard]] WrongWord corners() const;
  [[nodiscard]] WrongWord compensation() const;
  [[nodiscard]] WrongWord action() const;
  [[nodiscard]] bool sets_other_data() const;

  const fanuc::Profile& profile_;
  const WordReading& reading_;
  syntax::ShortSpan whole_;
  Words given_;
  KnownWords words_;
  CodesOfBlock codes_;
};

/// Of an M code; Block: it calls nothing.
Use JudgedBlock::use_by_m(const EvaluatedWord& word) const {
  if (!fanuc::is_integer(word, profile_)) {
    return Use::Block;
  }
  if (fanuc::is_return(word)) {
    return Use::Return;
  }
  const int code = fanuc::nearest_integer(word.number);
  if (code == 98) {
    return Use::Subprogram;
  }
  const bool is_local = profile_.has_local_calls && (code == 96 || code == 97);
  const bool is_end = code == 2 || code == 30;
  const bool may_call = code > 1 && !is_end && &word == &words_.words().all().front();
  return is_local || may_call ? Use::Unknown : Use::Block;
}

/// By the first word that calls.
Use JudgedBlock::use() const {
  if (codes_.is_open || words_.is_open('G') || words_.is_open('M')) {
    return Use::Unknown;
  }
  for (const EvaluatedWord& word : words_.words().all()) {
    if (is_macro_call(word)) {
      return Use::MacroCall;
    }
    const Use use = word.letter == 'M' ? use_by_m(word) : Use::Block;
    if (use != Use::Block) {
      return use;
    }
  }
  return Use::Block;
}

/// The words beside M99, without its own.
std::vector<Word> JudgedBlock::without_return() const {
  std::vector<Word> others;
  std::ranges::remove_copy_if(given_, std::back_inserter(others), fanuc::is_of_return);
  return others;
}

WrongWord JudgedBlock::judge() const {
  const Use use = this->use();
  if (use == Use::Unknown) {
    return std::nullopt;
  }
  if (use != Use::Block) {
    const WrongWord found = call(use);
    return found || use != Use::Return
               ? found
               : JudgedBlock(without_return(), whole_, profile_, reading_).judge();
  }
  constexpr char kNothing = '/';
  for (const auto& part : {plain_words(kNothing), offsets(), corners(), compensation()}) {
    if (part) {
      return part;
    }
  }
  return action();
}

/// G10 with what is no length, as far as its L says.
bool JudgedBlock::sets_other_data() const {
  if (codes_.acting == nullptr || codes_.acting->action != GAction::SetData) {
    return false;
  }
  const int number = fanuc::data_of(words_.words(), profile_);
  return !fanuc::sets_work_offset(number) &&
         fanuc::find_offset_form(number, runtime::OffsetMemory::C) == nullptr;
}

std::vector<LostPoint> JudgedBlock::lost_points() const {
  if (codes_.calls_by_sheet) {
    return analysis::lost_points(words_.words(), {nullptr, false, true}, profile_, reading_.points);
  }
  const Use use = this->use();
  if (use == Use::Return) {
    return JudgedBlock(without_return(), whole_, profile_, reading_).lost_points();
  }
  const bool is_read = use == Use::Block || use == Use::MacroCall;
  return is_read && !codes_.has_mode && !sets_other_data()
             ? analysis::lost_points(words_.words(),
                                     {codes_.acting, codes_.drills, use == Use::MacroCall},
                                     profile_, reading_.points)
             : std::vector<LostPoint>();
}

/// G65, G66, M98, M99.
WrongWord JudgedBlock::call(Use use) const {
  WrongWord found;
  if (use == Use::MacroCall) {
    found = argument_letters();
  } else if (use == Use::Subprogram) {
    found = plain_words(profile_.start_letter);
  }
  found = found ? found : words_.integer('P', [](int) -> fanuc::MaybeWrong { return {}; });
  return found ? found : words_.integer('L', fanuc::wrong_repeats);
}

WrongWord JudgedBlock::argument_letters() const {
  const auto& all = words_.words().all();
  const auto code = std::ranges::find_if(all, is_macro_call);
  for (auto word = all.begin(); word != all.end(); ++word) {
    if (fanuc::is_argument(*word, *code, profile_) && fanuc::argument_variable(word->letter) == 0) {
      return KnownWords::at(fanuc::no_argument(word->letter), *word);
    }
  }
  return std::nullopt;
}

/// @param left_out  of the call
WrongWord JudgedBlock::plain_words(char left_out) const {
  for (const EvaluatedWord& word : words_.words().all()) {
    const bool is_distance = fanuc::is_measuring_distance(word.letter, codes_.acting, profile_);
    if (word.letter != left_out && !is_distance && !fanuc::fits_plain_word(word, profile_)) {
      return KnownWords::at(fanuc::wrong_plain_word(word, profile_), word);
    }
  }
  return std::nullopt;
}

/// P of G54.1, H.
WrongWord JudgedBlock::offsets() const {
  const auto number_of = [](const GCode* code) {
    return code != nullptr ? code->number : fanuc::GNumber{};
  };
  const fanuc::GNumber work = number_of(codes_.work_offset);
  if (fanuc::selects_by_number(work, words_.words().has('P'))) {
    if (WrongWord found = words_.integer(
            'P', [&](int p) { return fanuc::wrong_work_system(p, work, profile_); })) {
      return found;
    }
  }
  const fanuc::GNumber length = number_of(codes_.tool_length);
  return words_.integer('H', [length](int h) { return fanuc::wrong_length_offset(h, length); });
}

/// ,C and ,R.
WrongWord JudgedBlock::corners() const {
  bool is_second = false;
  for (const EvaluatedWord& word : words_.words().all()) {
    if (word.letter != syntax::kChamferWord && word.letter != syntax::kRoundingWord) {
      continue;
    }
    if (is_second && !profile_.last_corner_word_counts) {
      return KnownWords::at(fanuc::second_corner(), word);
    }
    is_second = true;
    if (WrongWord found = KnownWords::at(fanuc::wrong_corner(word.number), word)) {
      return found;
    }
  }
  return std::nullopt;
}

/// D of G41 and G42.
WrongWord JudgedBlock::compensation() const {
  const EvaluatedWord* const d = words_.find('D');
  const bool counts = codes_.compensation != nullptr && codes_.compensation->number.whole != 40;
  auto wrong = counts && d != nullptr
                   ? fanuc::wrong_radius_offset(fanuc::nearest_integer(d->number))
                   : std::nullopt;
  return wrong ? WrongWord(WrongConstant{*std::move(wrong), whole_}) : std::nullopt;
}

WrongWord JudgedBlock::action() const {
  if (codes_.acting != nullptr) {
    return wrong_for_code(*codes_.acting, words_, whole_, profile_);
  }
  constexpr std::uint32_t kHoleWords =
      fanuc::letters_of({kAxisLetters, kAxisCount}) | fanuc::letters_of("R");
  const EvaluatedWord* const p = words_.find('P');
  return codes_.drills && p != nullptr && words_.words().has_any(kHoleWords) &&
                 !fanuc::is_dwell_in_seconds(*p, profile_)
             ? words_.integer('P', [](int ms) { return fanuc::wrong_dwell(ms / 1000.0); })
             : std::nullopt;
}

Words words_of(const fanuc::CompiledProgram& program, const syntax::Block& block) {
  return Words(program.tree->words).subspan(block.first_word, block.word_count);
}

/// Whether a block begins data: G10 with L3, L50 or L52, or one that only a run knows.
bool begins_data(Words words) {
  bool begins = false;
  for (const Word& word : words) {
    if (word.letter == 'L') {
      const int l = fanuc::nearest_integer(word.number);
      begins = word.form == syntax::ValueForm::Computed || l == fanuc::kToolLifeData ||
               fanuc::sets_parameters(l);
    }
  }
  return begins && std::ranges::any_of(words, [](const Word& word) { return is_g(word, 10.0); });
}

}  // namespace

bool g_code_may_call(double code, const fanuc::Profile& profile, const WordReading& reading) {
  const GCode* const row = fanuc::find_g_code(code, profile);
  return row == nullptr || row->set != fanuc::CodeSet::Family || is_called_by_sheet(code, reading);
}

FanucWords::FanucWords(const fanuc::CompiledProgram& program, const fanuc::Profile& profile,
                       const WordReading& reading)
    : program_(program), profile_(profile), reading_(reading) {}

bool lets_every_block_call(const syntax::Tree& tree) {
  return std::ranges::any_of(tree.words, [](const Word& word) { return is_g(word, 66.1); });
}

WordFindings FanucWords::judge(const syntax::Block& block) {
  const Words words = words_of(program_, block);
  const bool was_data = takes_data_;
  const bool ends = std::ranges::any_of(words, [](const Word& word) { return is_g(word, 11.0); });
  takes_data_ = !ends && (takes_data_ || begins_data(words));
  // What stands behind a / may be skipped, and the last word of a letter counts.
  const bool may_be_cut = std::ranges::find(words, '/', &Word::letter) != words.end();
  if (was_data || may_be_cut || reading_.every_block_calls) {
    return {};
  }
  const JudgedBlock judged(words, block.span, profile_, reading_);
  return {judged.judge(), reading_.in_increments ? std::vector<LostPoint>() : judged.lost_points()};
}

}  // namespace g31::analysis
