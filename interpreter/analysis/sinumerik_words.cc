#include "interpreter/analysis/sinumerik_words.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "interpreter/analysis/sinumerik_constants.h"
#include "interpreter/dialects/sinumerik/code/word_limits.h"
#include "interpreter/dialects/sinumerik/vocabulary/g_codes.h"

namespace g31::analysis {
namespace {

using sinumerik::Address;
using sinumerik::Group;
using sinumerik::Modification;
using sinumerik::number_in_group;
using sinumerik::Op;
using sinumerik::OpCode;

/// The words of one NC block, as far as constants make them.
class JudgedWords {
 public:
  explicit JudgedWords(const sinumerik::CompiledProgram& program) : program_(program) {}

  /// @returns what is wrong with a word, or with the block that a step carries out
  WrongStep look_at(const Op& step, const SinumerikConstants& constants);

 private:
  struct Word {
    bool stands = false;
    std::optional<double> value;
    Modification modification = Modification::None;
  };
  /// Of the one MEASA or MEAWA of a block.
  struct Measuring {
    int count = 0;
    std::optional<double> mode;
    std::optional<double> trigger;
    bool has_second = false;
    std::optional<double> second_trigger;
    bool is_beside_positioning = false;  ///< POS stands in the block, and may be what measures
  };

  void forget();
  WrongStep take(std::size_t address, std::optional<double> value, Modification modification);
  WrongStep take_axis_word(const Op& step, const SinumerikConstants& constants);
  void take_measuring(const Op& step, const SinumerikConstants& constants);
  WrongStep take_block(const sinumerik::NcBlock& block);
  [[nodiscard]] WrongStep plain_words() const;
  [[nodiscard]] WrongStep corners() const;
  [[nodiscard]] WrongStep special(sinumerik::GAction action) const;
  [[nodiscard]] WrongStep polar() const;
  [[nodiscard]] WrongStep triggers() const;
  [[nodiscard]] WrongStep measuring() const;
  [[nodiscard]] WrongStep circle() const;
  [[nodiscard]] WrongStep feed() const;

  [[nodiscard]] const Word& word(Address address) const { return words_.at(index_of(address)); }
  [[nodiscard]] bool stands(Address address) const { return word(address).stands; }
  [[nodiscard]] std::optional<double> value(Address address) const { return word(address).value; }
  template <typename Limit>
  [[nodiscard]] WrongStep judged(Address address, Limit limit) const {
    const auto given = value(address);
    return given ? limit(*given) : std::nullopt;
  }
  [[nodiscard]] bool has_axis() const {
    return std::ranges::any_of(words_.begin(), words_.begin() + kAxisCount, &Word::stands);
  }
  [[nodiscard]] const sinumerik::GCode* code_of(Group group) const;
  /// The code that takes the axis words; nullptr: none.
  [[nodiscard]] const sinumerik::GCode* special_code() const;
  [[nodiscard]] std::optional<int> motion() const;

  const sinumerik::CompiledProgram& program_;
  std::array<Word, sinumerik::index_of(Address::Count)> words_;
  Measuring measuring_;
  std::span<const std::uint16_t> codes_;
  bool has_open_code_ = false;  ///< G[group]=number
};

WrongStep JudgedWords::take(std::size_t address, std::optional<double> value,
                            Modification modification) {
  words_.at(address) = {true, value, modification};
  const auto which = static_cast<Address>(address);
  const sinumerik::ValueRange range = range_of(which);
  return value && !range.holds(*value)
             ? WrongStep(sinumerik::out_of_range(name_of(which), *value, range))
             : std::nullopt;
}

WrongStep JudgedWords::take_axis_word(const Op& step, const SinumerikConstants& constants) {
  const auto& row = sinumerik::info(static_cast<sinumerik::AxisWordId>(step.detail));
  measuring_.is_beside_positioning =
      measuring_.is_beside_positioning || row.role == sinumerik::AxisRole::Positioning;
  const auto axis = constants.number(step.a);
  const auto value = constants.number(step.b);
  return is_setting(row.role) && axis && value && *axis >= 0.0
             ? sinumerik::wrong_axis_setting(row, static_cast<int>(*axis), *value)
             : std::nullopt;
}

void JudgedWords::take_measuring(const Op& step, const SinumerikConstants& constants) {
  if (step.detail == sinumerik::kSecondTrigger) {
    measuring_.has_second = true;
    measuring_.second_trigger = constants.number(step.b);
    return;
  }
  ++measuring_.count;
  measuring_.mode = constants.number(step.result);
  measuring_.trigger = constants.number(step.b);
}

WrongStep JudgedWords::look_at(const Op& step, const SinumerikConstants& constants) {
  if (step.code == OpCode::Block || step.code == OpCode::NcBlock) {
    forget();
  }
  if (step.code == OpCode::Word) {
    return take(step.detail, constants.number(step.a), static_cast<Modification>(step.count));
  }
  if (step.code == OpCode::AxisWord) {
    return take_axis_word(step, constants);
  }
  if (step.code == OpCode::AxisMeasuring) {
    take_measuring(step, constants);
  }
  has_open_code_ = has_open_code_ || step.code == OpCode::GroupCode;
  if (step.code != OpCode::Execute && step.code != OpCode::NcBlock) {
    return std::nullopt;
  }
  WrongStep wrong = take_block(program_.nc_blocks[static_cast<std::size_t>(step.b.place)]);
  forget();  // what stands behind a jump are other words
  return wrong;
}

void JudgedWords::forget() {
  words_ = {};
  measuring_ = {};
  has_open_code_ = false;
}

const sinumerik::GCode* JudgedWords::code_of(Group group) const {
  for (const std::uint16_t bits : codes_) {
    const sinumerik::GCode& row = sinumerik::g_codes()[sinumerik::unpacked(bits).row];
    if (row.group == group) {
      return &row;
    }
  }
  return nullptr;
}

const sinumerik::GCode* JudgedWords::special_code() const {
  for (const Group group : {Group::OneBlock, Group::ProgrammableFrame}) {
    const sinumerik::GCode* const code = code_of(group);
    if (code != nullptr && sinumerik::takes_words(code->action)) {
      return code;
    }
  }
  return nullptr;
}

/// By a code of the block itself.
std::optional<int> JudgedWords::motion() const {
  const sinumerik::GCode* const code = code_of(Group::Motion);
  return code != nullptr ? std::optional(code->number) : std::nullopt;
}

WrongStep JudgedWords::take_block(const sinumerik::NcBlock& block) {
  codes_ = block.codes_of(program_);
  for (const sinumerik::ConstantWord& constant : block.words_of(program_)) {
    if (WrongStep wrong = take(index_of(constant.address), constant.value, Modification::None)) {
      return wrong;
    }
  }
  WrongStep wrong = plain_words();
  wrong = wrong ? wrong : corners();
  if (wrong || has_open_code_) {
    return wrong;
  }
  if (const sinumerik::GCode* const code = special_code()) {
    return special(code->action);
  }
  for (const auto& part : {polar(), circle(), measuring(), feed()}) {
    if (part) {
      return part;
    }
  }
  return std::nullopt;
}

/// Words that are judged whatever else stands in the block.
WrongStep JudgedWords::plain_words() const {
  for (const Address address : sinumerik::kOnlyZero) {
    const auto given = value(address);
    if (given && *given != 0.0) {
      return sinumerik::only_zero(address, *given);
    }
  }
  for (const auto& part :
       {judged(Address::ThreadAngle, sinumerik::wrong_thread_angle),
        judged(Address::Tool, sinumerik::wrong_tool), judged(Address::Edge, sinumerik::wrong_edge),
        judged(Address::Additive, sinumerik::wrong_additive)}) {
    if (part) {
      return part;
    }
  }
  return std::nullopt;
}

WrongStep JudgedWords::corners() const {
  bool is_second = false;
  for (const Address address : sinumerik::kCornerWords) {
    if (stands(address) && is_second) {
      return sinumerik::second_corner();
    }
    is_second = is_second || stands(address);
    if (WrongStep wrong = judged(address, sinumerik::wrong_corner)) {
      return wrong;
    }
  }
  return std::nullopt;
}

/// G4, G75, G110 to G112; of others a run judges.
WrongStep JudgedWords::special(sinumerik::GAction action) const {
  if (action == sinumerik::GAction::Dwell) {
    if (has_axis() || stands(Address::PolarAngle) || stands(Address::PolarRadius) ||
        measuring_.is_beside_positioning) {
      return sinumerik::axis_beside_dwell();
    }
    return stands(Address::Speed) ? std::nullopt : judged(Address::Feed, sinumerik::wrong_dwell);
  }
  return action == sinumerik::GAction::FixedPoint
             ? judged(Address::FixedPoint, sinumerik::wrong_fixed_point)
         : action == sinumerik::GAction::Pole ? polar()
                                              : std::nullopt;
}

WrongStep JudgedWords::polar() const {
  if (WrongStep wrong = judged(Address::PolarAngle, sinumerik::wrong_polar_angle)) {
    return wrong;
  }
  return word(Address::PolarRadius).modification != Modification::Incremental
             ? judged(Address::PolarRadius, sinumerik::wrong_polar_radius)
             : std::nullopt;
}

/// What MEASA says, if it measures.
WrongStep JudgedWords::triggers() const {
  if (WrongStep wrong = sinumerik::wrong_measuring_mode(*measuring_.mode)) {
    return wrong;
  }
  if (!measuring_.trigger) {
    return std::nullopt;
  }
  if (WrongStep wrong = sinumerik::wrong_trigger("MEASA", *measuring_.trigger)) {
    return wrong;
  }
  const auto second = measuring_.second_trigger;
  return measuring_.has_second && second && *second != 0.0
             ? sinumerik::wrong_second_trigger(*measuring_.trigger, *second)
             : std::nullopt;
}

/// MEAS, MEAW, and MEASA or MEAWA of one axis.
WrongStep JudgedWords::measuring() const {
  const bool is_one =
      measuring_.count == 1 && measuring_.mode && sinumerik::measures(*measuring_.mode);
  WrongStep wrong = is_one ? triggers() : std::nullopt;
  const auto by_word = [](double trigger) { return sinumerik::wrong_trigger("MEAS", trigger); };
  const int words =
      (is_one ? 1 : 0) + (stands(Address::Measure) ? 1 : 0) + (stands(Address::MeasureOn) ? 1 : 0);
  wrong = wrong ? wrong : judged(Address::Measure, by_word);
  if (!wrong && words > 1) {
    return sinumerik::measured_twice();
  }
  wrong = wrong ? wrong : judged(Address::MeasureOn, by_word);
  const auto by_code = motion();
  const bool is_line = by_code == number_in_group("G0") || by_code == number_in_group("G1");
  return wrong || words == 0 || !by_code || is_line || measuring_.is_beside_positioning
             ? wrong
             : sinumerik::measured_circle();
}

/// TURN and AR of a block with its own code of a circle.
WrongStep JudgedWords::circle() const {
  const auto by_code = motion();
  const bool is_arc = by_code && sinumerik::is_arc(*by_code);
  const bool goes = has_axis() || stands(Address::PolarAngle) || stands(Address::PolarRadius);
  const bool is_other = stands(Address::Measure) || stands(Address::MeasureOn) ||
                        measuring_.count > 0 || stands(Address::Angle);
  if (!by_code || !sinumerik::is_circle(*by_code) || !goes || is_other) {
    return std::nullopt;
  }
  if (WrongStep wrong = judged(Address::Turns, sinumerik::wrong_turns)) {
    return wrong;
  }
  const auto angle =
      is_arc && !stands(Address::Radius) ? value(Address::OpeningAngle) : std::optional<double>();
  return angle && !sinumerik::is_opening_angle(*angle)
             ? WrongStep(sinumerik::wrong_opening_angle(*angle))
             : std::nullopt;
}

/// F of a line that the block itself commands.
WrongStep JudgedWords::feed() const {
  constexpr Address kOthers[] = {Address::ToothFeed, Address::Angle};
  const auto given = value(stands(Address::BlockFeed) ? Address::BlockFeed : Address::Feed);
  const bool is_other =
      std::ranges::any_of(kOthers, [this](Address address) { return stands(address); });
  return given && !is_other && has_axis() && motion() == number_in_group("G1") &&
                 !sinumerik::is_feed(*given)
             ? WrongStep(sinumerik::no_feed())
             : std::nullopt;
}

}  // namespace

WrongSteps wrong_steps(const sinumerik::CompiledProgram& program) {
  WrongSteps wrong;
  SinumerikConstants constants(program);
  JudgedWords words(program);
  for (std::size_t i = 0; i < program.ops.size(); ++i) {
    // The words first: a step may change what it takes.
    WrongStep of_words = words.look_at(program.ops[i], constants);
    WrongStep found = constants.look_at(program.ops[i]);
    if (found || of_words) {
      wrong.emplace(static_cast<std::int32_t>(i), *std::move(found ? found : of_words));
    }
  }
  return wrong;
}

}  // namespace g31::analysis
