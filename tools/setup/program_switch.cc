#include "tools/setup/program_switch.h"

#include <charconv>

namespace g31::setup {
namespace {

/// How a switch is written, and which numbers there are.
struct Form {
  std::string_view before;
  std::string_view behind;
  probe::ProgramSwitch::Kind kind;
  int least;
  int most;
};

constexpr Form kForms[] = {{"M", "", probe::ProgramSwitch::Kind::Code, 0, 99'999'999},
                           {"#", "", probe::ProgramSwitch::Kind::Output, 1100, 1115},
                           {"$A_OUT[", "]", probe::ProgramSwitch::Kind::Output, 1, 64}};

}  // namespace

std::optional<probe::ProgramSwitch> program_switch(std::string_view text) {
  for (const Form& form : kForms) {
    if (!text.starts_with(form.before) || !text.ends_with(form.behind) ||
        text.size() <= form.before.size() + form.behind.size()) {
      continue;
    }
    const std::string_view digits =
        text.substr(form.before.size(), text.size() - form.before.size() - form.behind.size());
    int number = -1;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (error == std::errc() && end == digits.data() + digits.size() && digits.front() != '-' &&
        number >= form.least && number <= form.most) {
      return probe::ProgramSwitch{form.kind, number};
    }
  }
  return std::nullopt;
}

}  // namespace g31::setup
