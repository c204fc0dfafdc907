#include "interpreter/analysis/fanuc_known_words.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "interpreter/dialects/fanuc/code/data_setting.h"
#include "machine/units/axis_positions.h"

namespace g31::analysis {
namespace {

using fanuc::EvaluatedWord;
using fanuc::GAction;
using fanuc::MaybeWrong;

WrongWord at_block(MaybeWrong wrong, syntax::ShortSpan whole) {
  return wrong ? WrongWord(WrongConstant{*std::move(wrong), whole}) : std::nullopt;
}

/// G10.  Of the memories of tool offsets the largest counts: which one it is says the sheet.
WrongWord wrong_data(const KnownWords& words, syntax::ShortSpan whole,
                     const fanuc::Profile& profile) {
  constexpr auto kMemory = runtime::OffsetMemory::C;
  if (words.is_open('L')) {
    return std::nullopt;
  }
  // One that g31 has not may be an option of the real control.
  if (WrongWord wrong = words.integer('L', [](int) -> MaybeWrong { return {}; })) {
    return wrong;
  }
  const int l = fanuc::data_of(words.words(), profile);
  const bool is_offset = fanuc::find_offset_form(l, kMemory) != nullptr;
  if (is_offset) {
    for (const EvaluatedWord& other : words.words().all()) {
      if (WrongWord wrong = KnownWords::at(fanuc::foreign_to_offset(other.letter, l), other)) {
        return wrong;
      }
    }
    if (auto missing = fanuc::missing_offset_word(words.stands('P'), words.stands('R'))) {
      return at_block(std::move(missing), whole);
    }
  }
  return is_offset || fanuc::sets_work_offset(l)
             ? words.integer('P', [&](int p) { return fanuc::wrong_data_number(l, p, profile); })
             : std::nullopt;
}

/// G04: U counts before X, X before P.
WrongWord wrong_pause(const KnownWords& words, syntax::ShortSpan whole,
                      const fanuc::Profile& profile) {
  const EvaluatedWord* const p = words.find('P');
  const bool is_seconds = p != nullptr && fanuc::is_dwell_in_seconds(*p, profile);
  if (p != nullptr && !is_seconds && !fanuc::is_dwell_in_milliseconds(*p)) {
    return KnownWords::at(fanuc::point_in(*p), *p);
  }
  const char last = words.stands('U') ? 'U' : words.stands('X') ? 'X' : 'P';
  const EvaluatedWord* const counts = words.find(last);
  if (counts == nullptr) {
    return std::nullopt;
  }
  fanuc::WordScale scale;
  scale.excess_decimals = profile.excess_decimals;
  const double time = last == 'P' ? counts->number : scale.seconds(*counts);
  return at_block(fanuc::wrong_dwell(time), whole);
}

/// G31.
WrongWord wrong_skip_words(const KnownWords& words, const fanuc::Profile& profile) {
  constexpr std::string_view kAxes(kAxisLetters, kAxisCount);
  const fanuc::SkipSelection selection = profile.skip_selection;
  if (WrongWord wrong =
          words.integer('P', [&](int p) { return fanuc::wrong_skip(p, selection); })) {
    return wrong;
  }
  const EvaluatedWord* const p = words.find('P');
  const bool takes_one_axis = p != nullptr && selection == fanuc::SkipSelection::Parameters &&
                              fanuc::skips_by_torque(fanuc::nearest_integer(p->number));
  if (!takes_one_axis || words.is_any_open(fanuc::letters_of(kAxes))) {
    return std::nullopt;
  }
  const auto count =
      std::ranges::count_if(kAxes, [&](char axis) { return words.words().has(axis); });
  return KnownWords::at(fanuc::wrong_skip_axes(static_cast<int>(count)), *p);
}

/// G51; whether I, J and K count says a parameter.
WrongWord wrong_scaling(const KnownWords& words, syntax::ShortSpan whole,
                        const fanuc::Profile& profile) {
  const EvaluatedWord* const p = words.find('P');
  if (p == nullptr || words.stands('I') || words.stands('J') || words.stands('K')) {
    return std::nullopt;
  }
  if (!fanuc::is_scale_factor(*p, profile) && !fanuc::is_integer(*p, profile)) {
    return KnownWords::at(fanuc::point_in(*p), *p);
  }
  return at_block(fanuc::wrong_scale(fanuc::scale_factor(*p, profile), false), whole);
}

}  // namespace

KnownWords::KnownWords(std::span<const syntax::Word> words, const fanuc::Profile& profile)
    : profile_(profile) {
  for (const syntax::Word& word : words) {
    if (word.form == syntax::ValueForm::Computed) {
      open_ |= syntax::letter_bit(word.letter);
    } else {
      words_.add(word);
    }
  }
}

WrongWord KnownWords::at(MaybeWrong wrong, const EvaluatedWord& word) {
  return wrong ? WrongWord(WrongConstant{*std::move(wrong), word.span}) : std::nullopt;
}

WrongWord wrong_for_code(const fanuc::GCode& code, const KnownWords& words, syntax::ShortSpan whole,
                         const fanuc::Profile& profile) {
  const fanuc::GNumber number = code.number;
  const GAction action = code.action;
  if (action == GAction::ToReference && number.whole == 30) {
    return words.integer('P', fanuc::wrong_reference);
  }
  if (action == GAction::TiltedPlane && number.tenth != 3) {
    return words.integer('P', fanuc::wrong_plane_form);
  }
  if (action == GAction::TableOffset || action == GAction::SettingError) {
    return words.integer('P', [number](int p) { return fanuc::wrong_part_error(p, number); });
  }
  return action == GAction::Dwell                       ? wrong_pause(words, whole, profile)
         : action == GAction::SetData                   ? wrong_data(words, whole, profile)
         : action == GAction::Skip && number.tenth == 0 ? wrong_skip_words(words, profile)
         : action == GAction::Scaling                   ? wrong_scaling(words, whole, profile)
                                                        : std::nullopt;
}

}  // namespace g31::analysis
