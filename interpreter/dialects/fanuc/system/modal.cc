#include <algorithm>

#include "interpreter/dialects/fanuc/system/access.h"

namespace g31::fanuc::system {
namespace {

/// Numbers within a hundred and what they show (MB-135).
struct ShownWord {
  int number;
  char letter;
};
constexpr ShownWord kShownWords[] = {{2, 'B'},  {7, 'D'},  {8, 'E'},  {13, 'M'},
                                     {14, 'N'}, {15, 'O'}, {19, 'S'}, {20, 'T'}};
constexpr int kFeed = 9;
constexpr int kLengthOffset = 11;
constexpr int kAdditionalSystem = 30;

}  // namespace

ReadResult read_main_program(Control& control, const Place& /*place*/) {
  return Cell(control.main_program);
}

ReadResult read_modal_group(Control& control, const Place& place) {
  const auto shown = static_cast<std::size_t>(place.index() + 1);
  const std::size_t group = control.profile.modal_layout.at(shown);
  return Cell(group != 0 ? control.modal.group.at(group).value() : 0.0);
}

ReadResult read_modal_word(Control& control, const Place& place) {
  const int number = place.number % 100;
  if (number == kFeed) {
    return Cell(control.modal.feed);
  }
  if (number == kLengthOffset) {
    return Cell(control.modal.length_offset);
  }
  if (number == kAdditionalSystem) {
    return Cell(control.modal.additional_system);
  }
  const auto* const word = std::ranges::find(kShownWords, number, &ShownWord::number);
  return Cell(word != std::end(kShownWords) ? control.modal.word(word->letter) : 0.0);
}

ReadResult read_last_argument(Control& control, const Place& place) {
  return Cell(control.modal.arguments.at(static_cast<std::size_t>(place.index() + 1)));
}

}  // namespace g31::fanuc::system
