#include "tools/plot/curve_plot.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "tools/plot/frame.h"
#include "tools/plot/legend.h"
#include "tools/plot/scale.h"
#include "tools/plot/svg.h"

namespace g31::plot {
namespace {

constexpr double kLeftEdge = 90.0;
constexpr double kRightEdge = 660.0;
constexpr double kTopEdge = 56.0;
constexpr double kBottomEdge = 480.0;
constexpr double kBeside = 680.0;

/// What the curves cover.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  void widen(double share) {
    const double room = share * (high - low);
    low -= room;
    high += room;
  }
};

struct Ranges {
  Range x;
  Range y;
};

/// Makes a unit as long along both axes.
void equalise(Ranges& ranges) {
  const double width = kRightEdge - kLeftEdge;
  const double height = kBottomEdge - kTopEdge;
  const double unit =
      std::max((ranges.x.high - ranges.x.low) / width, (ranges.y.high - ranges.y.low) / height);
  const auto fit = [&](Range& range, double pixels) {
    const double room = 0.5 * (unit * pixels - (range.high - range.low));
    range.low -= room;
    range.high += room;
  };
  fit(ranges.x, width);
  fit(ranges.y, height);
}

Ranges ranges_of(const CurvePlot& plot) {
  Ranges ranges;
  for (const CurveTrace& trace : plot.traces) {
    for (const auto& [x, y] : trace.points) {
      ranges.x.take(x);
      ranges.y.take(y);
    }
  }
  if (ranges.x.low > ranges.x.high) {
    ranges = {{0.0, 1.0}, {0.0, 1.0}};
  }
  if (plot.begins_at_zero) {
    ranges.y.take(0.0);
  }
  const double lowest = ranges.y.low;
  ranges.y.widen(0.06);
  ranges.x.widen(0.02);
  if (plot.begins_at_zero) {
    ranges.y.low = lowest;
  }
  if (plot.has_equal_scales) {
    equalise(ranges);
  }
  return ranges;
}

void draw_frame(Svg& svg, const CurvePlot& plot, const Scale& x, const Scale& y) {
  constexpr Frame kFrame{kLeftEdge, kRightEdge, kTopEdge, kBottomEdge};
  kFrame.draw_grid(svg, x, y, {0.0, 0.0});
  if (!plot.has_equal_scales && y.low() < 0.0 && y.high() > 0.0) {
    svg.line({kLeftEdge, y.at(0.0)}, {kRightEdge, y.at(0.0)}, "nominal");
  }
  kFrame.draw_border(svg);
  svg.text({0.5 * (kLeftEdge + kRightEdge), kBottomEdge + 40.0}, plot.x_label, Anchor::Middle);
  svg.text_upwards({kLeftEdge - 66.0, 0.5 * (kTopEdge + kBottomEdge)}, plot.y_label);
}

constexpr double kMark = 2.5;  // px, radius

bool is_marked(const CurveTrace& trace) {
  return trace.style == CurveStyle::Marked || trace.style == CurveStyle::DashedMarked;
}

std::string fill_of(const CurveTrace& trace) {
  return fmt::format("fill{}", trace.colour);
}

std::string style_of(const CurveTrace& trace) {
  const bool is_dashed =
      trace.style == CurveStyle::Dashed || trace.style == CurveStyle::DashedMarked;
  return fmt::format("way {}line{}", is_dashed ? "dashed " : "", trace.colour);
}

void draw_dots(Svg& svg, const CurveTrace& trace, const Scale& x, const Scale& y) {
  for (const std::size_t i : shown_points(trace.radii)) {
    svg.dot({x.at(trace.points[i][0]), y.at(trace.points[i][1])}, trace.radii[i], fill_of(trace));
  }
}

void draw_trace(Svg& svg, const CurveTrace& trace, const Scale& x, const Scale& y) {
  if (trace.style == CurveStyle::Dots) {
    return draw_dots(svg, trace, x, y);
  }
  std::vector<double> heights;
  heights.reserve(trace.points.size());
  for (const auto& point : trace.points) {
    heights.push_back(point[1]);
  }
  std::vector<Eigen::Vector2d> shown;
  for (const std::size_t i : shown_points(heights)) {
    shown.emplace_back(x.at(trace.points[i][0]), y.at(trace.points[i][1]));
  }
  svg.way(shown, style_of(trace));
  constexpr std::size_t kMostMarks = 200;
  if (is_marked(trace) && shown.size() <= kMostMarks) {
    for (const Eigen::Vector2d& at : shown) {
      svg.dot(at, kMark, fill_of(trace));
    }
  }
}

}  // namespace

std::string draw(const CurvePlot& plot) {
  Svg svg(980.0, 540.0, plot.title, plot.language, plot.growth);
  const Ranges ranges = ranges_of(plot);
  const Scale x(ranges.x.low, ranges.x.high, kLeftEdge, kRightEdge);
  const Scale y(ranges.y.low, ranges.y.high, kBottomEdge, kTopEdge);
  svg.text({kLeftEdge, 32.0}, plot.title, Anchor::Start, "title");
  draw_frame(svg, plot, x, y);
  Legend legend(svg, kBeside, kTopEdge + 12.0);
  for (const CurveTrace& trace : plot.traces) {
    draw_trace(svg, trace, x, y);
    if (!trace.name.empty()) {
      const bool is_dotted = trace.style == CurveStyle::Dots;
      legend.line(is_dotted ? std::string() : style_of(trace), trace.name,
                  is_dotted || is_marked(trace) ? fill_of(trace) : std::string());
    }
  }
  legend.skip(12.0);
  legend.facts(plot.facts);
  return svg.finish();
}

}  // namespace g31::plot
