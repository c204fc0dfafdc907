#include "tools/plot/svg.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "machine/base/xml_text.h"

namespace g31::plot {
namespace {

/// What goes by the light that a drawing is seen in.
struct Palette {
  std::string_view ink;
  std::string_view paper;
  std::string_view faint;
  std::string_view grid;
  std::string_view nominal;
  std::array<std::string_view, 4> colours;
};
constexpr Palette kLight{"#1c2329", "#ffffff", "#5b6770",
                         "#dde3e8", "#8b979f", {"#0b5fa5", "#c2410c", "#2a7f3e", "#7a3e9d"}};
constexpr Palette kDark{"#e6ebef", "#14181c", "#a3b0b9",
                        "#2b333a", "#7f8c95", {"#6db3f2", "#ff9d6b", "#7fd191", "#c9a0e6"}};

// Every rule is one of `.plot`: a page that has the drawing within it keeps its own texts.
constexpr std::string_view kShapes = R"(
.plot text { font-family: "DejaVu Sans", Helvetica, Arial, sans-serif; font-size: 12px; }
.plot .title { font-size: 16px; font-weight: bold; }
.plot .frame, .plot .grid, .plot .nominal, .plot .way { fill: none; }
.plot .frame, .plot .grid { stroke-width: 1; }
.plot .nominal { stroke-width: 1; stroke-dasharray: 8 3 2 3; }
.plot .way { stroke-width: 1.4; stroke-linejoin: round; }
.plot .area { fill-opacity: 0.2; stroke-width: 1.4; }
.plot .dashed { stroke-dasharray: 5 3; stroke-width: 1; }
)";

/// @param plot  what the rules are for
std::string colours_of(std::string_view plot, const Palette& palette) {
  std::string rules = fmt::format(
      "{0} text {{ fill: {1}; }}\n{0} .paper {{ fill: {2}; }}\n{0} .faint {{ fill: {3}; }}\n"
      "{0} .frame {{ stroke: {3}; }}\n{0} .grid {{ stroke: {4}; }}\n{0} .nominal {{ stroke: {5}; "
      "}}\n",
      plot, palette.ink, palette.paper, palette.faint, palette.grid, palette.nominal);
  for (std::size_t i = 0; i < palette.colours.size(); ++i) {
    rules += fmt::format("{0} .line{1} {{ stroke: {2}; }} {0} .fill{1} {{ fill: {2}; }}\n", plot, i,
                         palette.colours[i]);
  }
  return rules;
}

/// Light and dark follow the system; in a page its button overrides.
std::string style_element() {
  return fmt::format(
      "<style>{}{}@media screen and (prefers-color-scheme: dark) {{\n{}}}\n@media screen "
      "{{\n{}{}}}\n</style>\n",
      kShapes, colours_of(".plot", kLight), colours_of(".plot", kDark),
      colours_of(":root[data-theme=light] .plot", kLight),
      colours_of(":root[data-theme=dark] .plot", kDark));
}

constexpr std::string_view kAnchors[] = {"start", "middle", "end"};

}  // namespace

template <typename... Values>
void Svg::add(fmt::format_string<const Values&...> piece, const Values&... values) {
  const std::string added = fmt::format(piece, values...);
  text_ += added;
  if (growth_) {
    growth_(added.size());
  }
}

Svg::Svg(double width, double height, std::string_view title, Language language, Growth growth)
    : growth_(std::move(growth)) {
  text_ = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" class=\"plot\" role=\"img\"{4}>\n<title>{2}</title>\n{3}"
      "<rect class=\"paper\" width=\"{0}\" height=\"{1}\"/>\n",
      width, height, xml_escaped(title), style_element(),
      language == Language::English ? std::string()
                                    : fmt::format(" xml:lang=\"{}\"", name_of(language)));
}

void Svg::line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, std::string_view style) {
  add("<line class=\"{}\" x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\"/>\n", style,
      from.x(), from.y(), to.x(), to.y());
}

void Svg::begin_window(const Eigen::Vector2d& top_left, const Eigen::Vector2d& size) {
  add("<svg x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\" "
      "viewBox=\"{0} {1} {2} {3}\">\n",
      top_left.x(), top_left.y(), size.x(), size.y());
}

void Svg::end_window() {
  text_ += "</svg>\n";
}

void Svg::way(std::span<const Eigen::Vector2d> points, std::string_view style) {
  if (points.empty()) {
    return;
  }
  add("<polyline class=\"{}\" points=\"", style);
  for (const Eigen::Vector2d& p : points) {
    add("{:.2f},{:.2f} ", p.x(), p.y());
  }
  text_.back() = '"';
  text_ += "/>\n";
}

void Svg::area(std::span<const Eigen::Vector2d> corners, std::string_view style) {
  add("<polygon class=\"{}\" points=\"", style);
  for (const Eigen::Vector2d& p : corners) {
    add("{:.2f},{:.2f} ", p.x(), p.y());
  }
  text_ += "\"/>\n";
}

void Svg::dot(const Eigen::Vector2d& at, double radius, std::string_view style) {
  add("<circle class=\"{}\" cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"/>\n", style, at.x(), at.y(),
      radius);
}

void Svg::arrow(const Eigen::Vector2d& tip, const Eigen::Vector2d& along, std::string_view style) {
  if (along.squaredNorm() == 0.0) {
    return;
  }
  const Eigen::Vector2d a = along.normalized();
  const Eigen::Vector2d across(-a.y(), a.x());
  const Eigen::Vector2d back = tip - 11.0 * a;
  const Eigen::Vector2d left = back + 5.0 * across;
  const Eigen::Vector2d right = back - 5.0 * across;
  add("<polygon class=\"{}\" points=\"{:.2f},{:.2f} {:.2f},{:.2f} {:.2f},{:.2f}\"/>\n", style,
      tip.x(), tip.y(), left.x(), left.y(), right.x(), right.y());
}

void Svg::text(const Eigen::Vector2d& at, std::string_view words, Anchor anchor,
               std::string_view style) {
  add("<text class=\"{}\" x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"{}\">{}</text>\n", style, at.x(),
      at.y(), kAnchors[static_cast<std::size_t>(anchor)], xml_escaped(words));
}

void Svg::text_upwards(const Eigen::Vector2d& at, std::string_view words) {
  add("<text transform=\"translate({:.2f} {:.2f}) rotate(-90)\" "
      "text-anchor=\"middle\">{}</text>\n",
      at.x(), at.y(), xml_escaped(words));
}

std::string Svg::finish() const {
  return text_ + "</svg>\n";
}

}  // namespace g31::plot
