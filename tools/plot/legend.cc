#include "tools/plot/legend.h"

namespace g31::plot {

void Legend::line(std::string_view style, std::string_view name, std::string_view mark) {
  constexpr double kLength = 28.0;
  const double middle = row_ - 4.0;
  if (!style.empty()) {
    svg_.line({left_, middle}, {left_ + kLength, middle}, style);
  }
  if (!mark.empty()) {
    svg_.dot({left_ + 0.5 * kLength, middle}, 2.5, mark);
  }
  svg_.text({left_ + 36.0, row_}, name);
  row_ += 20.0;
}

void Legend::facts(std::span<const std::string> facts) {
  for (const std::string& fact : facts) {
    svg_.text({left_, row_}, fact, Anchor::Start, "faint");
    row_ += 18.0;
  }
}

double width_of(std::string_view fact) {
  constexpr double kLetter = 7.6;
  constexpr double kSign = 5.0;
  constexpr double kWide = 12.0;  // of Japanese
  constexpr unsigned char kFirstOfThree = 0xE0;
  double width = 0.0;
  for (const char c : fact) {
    const auto byte = static_cast<unsigned char>(c);
    const bool goes_on = (byte & 0xC0U) == 0x80U;
    if (!goes_on) {
      const bool is_letter = (byte | 0x20U) >= 'a' && (byte | 0x20U) <= 'z';
      const bool is_digit = byte >= '0' && byte <= '9';
      width += byte >= kFirstOfThree                    ? kWide
               : is_letter || is_digit || byte >= 0x80U ? kLetter
                                                        : kSign;
    }
  }
  return width;
}

}  // namespace g31::plot
