#include "tools/plot/frame.h"

namespace g31::plot {

void Frame::draw_grid(Svg& svg, const Scale& x, const Scale& y,
                      const std::array<double, 2>& origin) const {
  constexpr int kPieces = 8;
  const Ticks across = ticks_between(x.low() + origin[0], x.high() + origin[0], kPieces);
  for (const double tick : across.places) {
    const double at = x.at(tick - origin[0]);
    svg.line({at, top}, {at, bottom}, "grid");
    svg.text({at, bottom + 18.0}, label_of(tick, across.step), Anchor::Middle);
  }
  const Ticks up = ticks_between(y.low() + origin[1], y.high() + origin[1], kPieces);
  for (const double tick : up.places) {
    const double at = y.at(tick - origin[1]);
    svg.line({left, at}, {right, at}, "grid");
    svg.text({left - 8.0, at + 4.0}, label_of(tick, up.step), Anchor::End);
  }
}

void Frame::draw_border(Svg& svg) const {
  const std::array<Eigen::Vector2d, 5> corners = {
      {{left, top}, {right, top}, {right, bottom}, {left, bottom}, {left, top}}};
  svg.way(corners, "frame");
}

}  // namespace g31::plot
