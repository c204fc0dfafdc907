#include "tools/plot/path_plot.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "tools/plot/frame.h"
#include "tools/plot/legend.h"
#include "tools/plot/scale.h"
#include "tools/plot/svg.h"
#include "tools/plot/words.h"

namespace g31::plot {
namespace {

constexpr double kLeft = 80.0;
constexpr double kTop = 56.0;
constexpr double kSize = 540.0;
constexpr double kColumn = 650.0;
constexpr double kLongestBar = 100.0;  // beside a detail: behind it is room for its words
constexpr double kMicrometres = 1e3;

using Points = std::vector<Eigen::Vector2d>;

double largest_deviation(const PathPlot& plot) {
  double largest = 0.0;
  for (const PathTrace& trace : plot.traces) {
    for (const double deviation : trace.deviations) {
      largest = std::max(largest, std::abs(deviation));
    }
  }
  return largest;
}

/// The nominal path and those that lie beside it by a deviation.
Points ring(const PathPlot& plot, double shift) {
  Points points;
  for (int degree = 0; degree <= 720; ++degree) {
    const double angle = (0.5 * degree + 45.0) * std::numbers::pi / 180.0;
    const double radius = std::max(plot.nominal_radius(angle) + shift, 0.0);
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

Eigen::Vector2d enlarged_point(const PathPlot& plot, const PathTrace& trace, std::size_t i,
                               double magnification) {
  const Eigen::Vector2d& p = trace.points[i];
  const double angle = std::atan2(p.y(), p.x());
  const double radius =
      std::max(plot.nominal_radius(angle) + magnification * trace.deviations[i], 0.0);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

Points enlarged(const PathPlot& plot, const PathTrace& trace, double magnification) {
  Points points;
  for (const std::size_t i : shown_points(trace.deviations)) {
    points.push_back(enlarged_point(plot, trace, i, magnification));
  }
  return points;
}

/// A square of a drawing, mm.
struct Window {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  double half = 0.0;
};

std::optional<Window> detail_of(const PathPlot& plot) {
  if (!plot.detail) {
    return std::nullopt;
  }
  const auto& [x, y, width] = *plot.detail;
  return Window{{x - plot.centre[0], y - plot.centre[1]}, 0.5 * width};
}

/// The pieces of the traces that come near a detail, so that what is shown of them is fine.
std::vector<PathTrace> pieces_near(const PathPlot& plot, const Window& detail,
                                   double magnification) {
  constexpr double kNear = 2.0;  // halves of the detail
  std::vector<PathTrace> pieces;
  for (const PathTrace& trace : plot.traces) {
    const std::size_t first = pieces.size();
    bool goes_on = false;
    for (std::size_t i = 0; i < trace.points.size(); ++i) {
      const Eigen::Vector2d off = enlarged_point(plot, trace, i, magnification) - detail.middle;
      const bool is_near = off.cwiseAbs().maxCoeff() < kNear * detail.half;
      if (is_near && !goes_on) {
        pieces.push_back({pieces.size() == first ? trace.name : "", {}, {}, trace.colour});
      }
      if (is_near) {
        pieces.back().points.push_back(trace.points[i]);
        pieces.back().deviations.push_back(trace.deviations[i]);
      }
      goes_on = is_near;
    }
  }
  return pieces;
}

/// The frame of a plot in which both axes have the same scale.
class SquareFrame {
 public:
  explicit SquareFrame(const Window& shown)
      : x_(shown.middle.x() - shown.half, shown.middle.x() + shown.half, kLeft, kLeft + kSize),
        y_(shown.middle.y() - shown.half, shown.middle.y() + shown.half, kTop + kSize, kTop) {}

  [[nodiscard]] Eigen::Vector2d at(const Eigen::Vector2d& p) const {
    return {x_.at(p.x()), y_.at(p.y())};
  }
  [[nodiscard]] Points at(const Points& points) const {
    Points shown;
    shown.reserve(points.size());
    for (const Eigen::Vector2d& p : points) {
      shown.push_back(at(p));
    }
    return shown;
  }

  void draw_into(Svg& svg, const PathPlot& plot) const {
    constexpr Frame kFrame{kLeft, kLeft + kSize, kTop, kTop + kSize};
    kFrame.draw_grid(svg, x_, y_, plot.centre);
    kFrame.draw_border(svg);
    svg.text({kLeft + 0.5 * kSize, kTop + kSize + 38.0}, plot.axes[0] + " mm", Anchor::Middle);
    svg.text_upwards({kLeft - 58.0, kTop + 0.5 * kSize}, plot.axes[1] + " mm");
  }

 private:
  Scale x_;
  Scale y_;
};

/// Arrow heads along a trace where it runs on: the direction of travel.
void draw_arrows(Svg& svg, const Points& shown, std::string_view style) {
  double length = 0.0;
  for (std::size_t i = 1; i < shown.size(); ++i) {
    length += (shown[i] - shown[i - 1]).norm();
  }
  double way = 0.0;
  double next = 0.1 * length;
  for (std::size_t i = 1; i < shown.size(); ++i) {
    way += (shown[i] - shown[i - 1]).norm();
    const std::size_t from = i > 8 ? i - 8 : 0;
    if (way >= next) {
      svg.arrow(shown[i], shown[i] - shown[from], style);
      next += 0.25 * length;
    }
  }
}

/// A bar as long as a deviation is drawn.
void draw_bar(Svg& svg, double y, double pixels, double step, Language language) {
  const double right = kColumn + std::max(pixels, 1.0);
  svg.line({kColumn, y}, {right, y}, "frame");
  svg.line({kColumn, y - 5.0}, {kColumn, y + 5.0}, "frame");
  svg.line({right, y - 5.0}, {right, y + 5.0}, "frame");
  svg.text({right + 8.0, y + 4.0},
           said(language, Word::BarOfError,
                fmt::arg("amount", label_of(kMicrometres * step, kMicrometres * step))));
}

/// How errors are shown.
struct Enlargement {
  bool is_exact = false;  ///< there are none
  double magnification = 1.0;
  double step = 1e-3;  ///< of the bar beside the drawing, mm
};

Enlargement enlargement_of(const PathPlot& plot) {
  const double largest = largest_deviation(plot);
  const double radius = plot.nominal_radius(0.0);
  const bool is_exact = largest < 1e-9 * radius;
  const double magnification = plot.magnification > 0.0 ? plot.magnification
                               : is_exact               ? 1.0
                                                        : round_down(0.25 * radius / largest);
  return {is_exact, magnification, is_exact ? 1e-3 : round_down(0.5 * largest * 1.2)};
}

/// What may reach out of the frame of a detail.
template <typename Draw>
void draw_within(Svg& svg, const std::optional<Window>& detail, const Draw& draw_it) {
  if (detail) {
    svg.begin_window({kLeft, kTop}, {kSize, kSize});
  }
  draw_it();
  if (detail) {
    svg.end_window();
  }
}

std::string draw_shown(const PathPlot& plot, const Enlargement& enlargement);

}  // namespace

std::string draw(const PathPlot& plot) {
  Enlargement enlargement = enlargement_of(plot);
  if (const auto detail = detail_of(plot)) {
    const double longest = kLongestBar * 2.0 * detail->half / kSize;  // mm, as it is drawn
    enlargement.step = std::min(enlargement.step, round_down(longest / enlargement.magnification));
    PathPlot near = plot;
    near.traces = pieces_near(plot, *detail, enlargement.magnification);
    return draw_shown(near, enlargement);
  }
  return draw_shown(plot, enlargement);
}

namespace {

std::string draw_shown(const PathPlot& plot, const Enlargement& enlargement) {
  double width = 900.0;
  for (const std::string& fact : plot.facts) {
    width = std::max(width, kColumn + width_of(fact));
  }
  Svg svg(width, 660.0, plot.title, plot.language, plot.growth);
  const auto [is_exact, magnification, step] = enlargement;
  const auto detail = detail_of(plot);
  double half = 0.0;
  std::vector<Points> traces;
  for (const PathTrace& trace : plot.traces) {
    traces.push_back(enlarged(plot, trace, magnification));
  }
  traces.push_back(ring(plot, is_exact || !plot.has_rings ? 0.0 : magnification * step));
  for (const Points& points : traces) {
    for (const Eigen::Vector2d& p : points) {
      half = std::max(half, p.cwiseAbs().maxCoeff());
    }
  }
  traces.pop_back();
  const Window shown = detail.value_or(Window{Eigen::Vector2d::Zero(), 1.06 * half});
  const SquareFrame frame(shown);
  svg.text({kLeft, 32.0}, plot.title, Anchor::Start, "title");
  frame.draw_into(svg, plot);
  for (const double shift : {-step, step}) {
    if (plot.has_rings && !is_exact) {
      const Points way = ring(plot, magnification * shift);
      draw_within(svg, detail, [&] { svg.way(frame.at(way), "grid"); });
    }
  }
  draw_within(svg, detail, [&] { svg.way(frame.at(ring(plot, 0.0)), "nominal"); });
  Legend legend(svg, kColumn, kTop + 12.0);
  for (std::size_t i = 0; i < traces.size(); ++i) {
    const Points way = frame.at(traces[i]);
    const std::string style = fmt::format("way line{}", plot.traces[i].colour);
    draw_within(svg, detail, [&] {
      svg.way(way, style);
      draw_arrows(svg, way, fmt::format("fill{}", plot.traces[i].colour));
    });
    if (!plot.traces[i].name.empty()) {
      legend.line(style, plot.traces[i].name);
    }
  }
  legend.line("nominal", text_of(Word::Nominal, plot.language));
  legend.skip(10.0);
  svg.text({kColumn, legend.row()},
           said(plot.language, magnification == 1.0 ? Word::TrueSize : Word::Enlarged,
                fmt::arg("times", magnification)));
  const double pixels = magnification * step * kSize / (2.0 * shown.half);
  draw_bar(svg, legend.row() + 22.0, pixels, step, plot.language);
  legend.skip(56.0);
  legend.facts(plot.facts);
  return svg.finish();
}

}  // namespace
}  // namespace g31::plot
