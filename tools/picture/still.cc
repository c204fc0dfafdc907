#include "tools/picture/still.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "machine/base/contract.h"
#include "machine/base/xml_text.h"
#include "tools/picture/still_view.h"

namespace g31::picture {
namespace {

constexpr int kMargin = 14;
constexpr int kHead = 66;
constexpr int kFoot = 40;

std::string style_of(const Palette& p) {
  return fmt::format(
      R"(<style>
text {{ font-family: "Segoe UI", Inter, "DejaVu Sans", Arial, sans-serif; font-size: 12px; fill: {ink}; }}
.title {{ font-size: 17px; font-weight: 600; }} .faint {{ fill: {faint}; }} .name {{ fill: {faint}; font-style: italic; }}
.paper {{ fill: {paper}; }} .frame {{ fill: none; stroke: {faint}; stroke-opacity: .35; }}
.edge, .way, .leader, .axis, .scale, .whisker, .latched {{ fill: none; stroke-linecap: round; stroke-linejoin: round; }}
.edge {{ stroke: {faint}; stroke-width: .8; }} .axis, .scale {{ stroke: {faint}; stroke-width: 1.4; }}
.way {{ stroke-width: 1.6; }} .rapid {{ stroke: {rapid}; stroke-dasharray: 6 4; stroke-width: 1.2; }}
.feed {{ stroke: {feed}; }} .skip {{ stroke: {skip}; stroke-width: 2.4; }}
.hidden {{ stroke-dasharray: .1 4; stroke-opacity: .55; }}
.leader {{ stroke: {accent}; stroke-width: .8; }} .leader.crash {{ stroke: {bad}; }} .latched {{ stroke: {faint}; stroke-width: .8; stroke-opacity: .6; }}
.ball {{ fill: {faint}; fill-opacity: .25; stroke: {faint}; }}
.whisker, .added {{ stroke: {accent}; }} .whisker {{ stroke-width: 3; stroke-linecap: butt; }}
.touch {{ fill: {accent}; stroke: {paper}; stroke-width: 1; }} .behind {{ fill: {paper}; stroke: {accent}; stroke-width: 1.4; }}
rect.number {{ fill: {paper}; stroke: {accent}; }} text.number {{ font-size: 11px; }}
.collision {{ fill: {bad}; stroke: {paper}; stroke-width: 1.5; }} rect.crash {{ fill: {paper}; stroke: {bad}; }} text.crash {{ fill: {bad}; font-weight: 600; font-size: 11px; }}
</style>
)",
      fmt::arg("ink", p.ink), fmt::arg("faint", p.faint), fmt::arg("paper", p.paper),
      fmt::arg("accent", p.accent), fmt::arg("bad", p.bad), fmt::arg("rapid", p.ways[0]),
      fmt::arg("feed", p.ways[1]), fmt::arg("skip", p.ways[2]));
}

/// What the lines mean, from left to right.
class StillLegend {
 public:
  StillLegend(std::string& svg, double y) : svg_(svg), y_(y) {}

  void line(std::string_view style, std::string_view words) {
    svg_ += fmt::format("<path class=\"{}\" d=\"M{:.1f} {:.1f}h26\"/>\n", style, x_, y_ - 4.0);
    say(34.0, words);
  }
  void dot(std::string_view style, std::string_view words) {
    svg_ += fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\"/>\n", style,
                        x_ + 5.0, y_ - 4.0);
    say(15.0, words);
  }

 private:
  void say(double gap, std::string_view words) {
    constexpr double kPerSign = 6.6;
    svg_ += fmt::format("<text class=\"faint\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", x_ + gap, y_,
                        words);
    x_ += gap + kPerSign * static_cast<double>(words.size()) + 16.0;
  }

  std::string& svg_;
  double x_ = kMargin;
  double y_;
};

bool has(const StillScene& scene, PathKind kind) {
  return std::ranges::any_of(scene.ways, [&](const Way& way) { return way.kind == kind; });
}

void add_legend(const StillScene& scene, double y, bool has_whiskers, std::string& svg) {
  const auto is_drawn = [&](std::string_view style) {
    return svg.find(style) != std::string::npos;
  };
  const bool has_hidden = is_drawn(" hidden\"");
  const bool has_behind = is_drawn("\"touch behind\"");
  StillLegend legend(svg, y);
  constexpr std::array<std::pair<std::string_view, std::string_view>, kPathKinds> kWays = {
      {{"way rapid", "rapid"}, {"way feed", "feed"}, {"way skip", "skip move"}}};
  for (std::size_t kind = 0; kind < kPathKinds; ++kind) {
    if (has(scene, static_cast<PathKind>(kind))) {
      legend.line(kWays[kind].first, kWays[kind].second);
    }
  }
  if (has_hidden) {
    legend.line("way feed hidden", "behind a wall");
  }
  if (!scene.contacts.empty()) {
    legend.dot("touch", "touch and its number");
    if (has_behind) {
      legend.dot("touch behind", "touch behind a wall");
    }
  }
  if (has_whiskers) {
    legend.line("whisker", "what measuring adds");
  }
  if (!scene.collisions.empty()) {
    legend.dot("collision", "collision");
  }
}

struct Placed {
  const StillView& view;
  std::string caption;
  int left;
};

void add_view(const Placed& placed, int width, int height, std::string& svg) {
  svg += fmt::format(
      "<text class=\"faint\" x=\"{}\" y=\"{}\">{}</text>\n"
      "<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\">\n{}</svg>\n"
      "<rect class=\"frame\" x=\"{}.5\" y=\"{}.5\" width=\"{}\" height=\"{}\"/>\n",
      placed.left, kHead - 8, placed.caption, placed.left, kHead, width, height, placed.view.svg(),
      placed.left, kHead, width - 1, height - 1);
}

std::string plan_caption(const std::string& plane) {
  return plane == "XY" ? "From above (XY)" : fmt::format("Plane {}", plane);
}

}  // namespace

std::string still_svg(const StillScene& scene, const StillLook& look) {
  G31_EXPECTS(look.width >= kLeastStillPixels && look.width <= kMostStillPixels);
  // Lines and words keep their size: more pixels show more of the same.
  constexpr int kDrawn = 1200;
  const int width = (kDrawn - 3 * kMargin) / 2;
  const int height = width * 9 / 10;
  const Palette& palette = palette_of(look.theme);
  const View from_front = isometric_view(scene, width, height);
  const auto cut = cut_for(scene, from_front);
  const StillView isometric(scene, from_front, cut, palette, {.stylus = true, .whiskers = false});
  const View plan = plan_view(scene, width, height);
  const StillView from_above(scene, plan, std::nullopt, palette,
                             {.stylus = false, .whiskers = true});
  const int whole_height = kHead + height + kFoot;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
      "width=\"{}\" height=\"{}\" viewBox=\"0 0 {} {}\" role=\"img\">\n<title>{}</title>\n{}"
      "<rect class=\"paper\" width=\"{}\" height=\"{}\"/>\n"
      "<text class=\"title\" x=\"{}\" y=\"30\">{}</text>\n",
      look.width, look.width * whole_height / kDrawn, kDrawn, whole_height,
      xml_escaped(scene.title), style_of(palette), kDrawn, whole_height, kMargin,
      xml_escaped(scene.title));
  add_view({isometric, cut ? "Isometric, cut open in front" : "Isometric", kMargin}, width, height,
           svg);
  add_view({from_above, plan_caption(plane_of(plan)), 2 * kMargin + width}, width, height, svg);
  add_legend(scene, kHead + height + 26.0, from_above.magnification() > 0.0, svg);
  return svg + "</svg>\n";
}

}  // namespace g31::picture
