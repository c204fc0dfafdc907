#include "tools/plot/legend.h"

namespace g31::plot {

void Legend::line(std::string_view style, std::string_view name, std::string_view mark) {
  constexpr double kLength = 28.0;
  const double middle = row_ - 4.0;
  svg_.line({left_, middle}, {left_ + kLength, middle}, style);
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

}  // namespace g31::plot
