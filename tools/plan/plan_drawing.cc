#include "tools/plan/plan_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "tools/plot/legend.h"
#include "tools/plot/scale.h"
#include "tools/plot/svg.h"

namespace g31::plan {
namespace {

using parts::Feature;
using Pixels = Eigen::Vector2d;

constexpr double kWidth = 960.0;
constexpr double kHeight = 560.0;
constexpr double kEdge = 40.0;
constexpr double kBeside = 720.0;
constexpr double kTop = 56.0;

/// Colours go by how open a feature is, so that like ones look alike; what stands in a pocket has
/// another one than it.
std::size_t colour_of(const Feature& feature) {
  return (static_cast<std::size_t>(feature.kind) + (feature.is_standing() ? 2 : 0)) % 4;
}

class Drawing {
 public:
  Drawing(const PlannedPart& planned, const DrawingWords& words)
      : planned_(planned),
        words_(words),
        svg_(kWidth, kHeight, words.title),
        view_(view_of(planned)),
        unit_(std::min((kBeside - 2 * kEdge) / (view_.max.x() - view_.min.x()),
                       (kHeight - kTop - kEdge) / (view_.max.y() - view_.min.y()))) {}

  std::string text() {
    svg_.text({kEdge, 32.0}, words_.title, plot::Anchor::Start, "title");
    draw_stock();
    draw_way();
    for (std::size_t i = 0; i < planned_.part.features.size(); ++i) {
      draw_feature(planned_.part.features[i], feature_id(i));
    }
    for (std::size_t i = 0; i < planned_.part.unknown.size(); ++i) {
      const auto& unknown = planned_.part.unknown[i];
      draw_box(unknown.box_P, "way nominal");
      name_box(unknown.box_P, feature_id(planned_.part.features.size() + i), "faint");
    }
    draw_points();
    draw_legend();
    return svg_.finish();
  }

 private:
  /// All that is drawn.
  static parts::Box view_of(const PlannedPart& planned) {
    parts::Box view = planned.part.stock_P;
    view.include(planned.product_P);
    for (const probe::PlannedPoint& point : planned.plan.points) {
      view.include(point.start_P);
    }
    return view;
  }

  [[nodiscard]] Pixels at(const Point& p_P) const {
    return {kEdge + unit_ * (p_P.x() - view_.min.x()),
            kHeight - kEdge - unit_ * (p_P.y() - view_.min.y())};
  }

  void draw_stock() { draw_box(planned_.part.stock_P, "frame"); }

  void draw_box(const parts::Box& box, std::string_view style) {
    const std::array<Pixels, 5> corners = {at(box.min), at({box.max.x(), box.min.y(), 0.0}),
                                           at(box.max), at({box.min.x(), box.max.y(), 0.0}),
                                           at(box.min)};
    svg_.way(corners, style);
  }

  void name_box(const parts::Box& box, std::string_view name, std::string_view style) {
    const Pixels corner = at({box.min.x(), box.max.y(), 0.0});
    svg_.text(corner + Pixels(4.0, 14.0), name, plot::Anchor::Start, style);
  }

  void draw_feature(const Feature& feature, const std::string& id) {
    const std::size_t colour = colour_of(feature);
    svg_.area(outline_of(feature), fmt::format("area line{0} fill{0}", colour));
    name_box(feature.box_P, id, "ink");
  }

  [[nodiscard]] std::vector<Pixels> outline_of(const Feature& feature) const {
    const parts::Box& own = feature.own;
    std::vector<Pixels> outline;
    if (feature.is_round) {
      constexpr int kPieces = 48;
      const Point middle = (own.min + own.max) / 2;
      const double radius = (own.max.x() - own.min.x()) / 2;
      for (int i = 0; i < kPieces; ++i) {
        const double angle = 2.0 * std::acos(-1.0) * i / kPieces;
        outline.push_back(at(middle + radius * Point(std::cos(angle), std::sin(angle), 0.0)));
      }
      return outline;
    }
    for (const auto& [x, y] :
         {std::array{own.min.x(), own.min.y()}, std::array{own.max.x(), own.min.y()},
          std::array{own.max.x(), own.max.y()}, std::array{own.min.x(), own.max.y()}}) {
      outline.push_back(at(feature.axes.part_of({x, y, 0.0})));
    }
    return outline;
  }

  void draw_way() {
    std::vector<Pixels> way;
    for (const probe::PlannedPoint& point : planned_.plan.points) {
      way.push_back(at(point.start_P));
    }
    svg_.way(way, "nominal");
  }

  /// A dot where the ball touches, a line from where it comes, the number beside that line.
  void draw_points() {
    for (const probe::PlannedPoint& point : planned_.plan.points) {
      const Pixels from = at(point.start_P);
      const Pixels to = at(point.at_P);
      svg_.line(from, to, "frame");
      svg_.dot(to, 3.0, "fill1");
      const Pixels middle = (from + to) / 2;
      const bool is_level = std::abs(point.normal_P.z()) > 0.5;
      const bool goes_across = std::abs(point.normal_P.x()) > std::abs(point.normal_P.y());
      if (is_level) {
        svg_.text(to + Pixels(-5.0, 14.0), point.id, plot::Anchor::End, "faint");
      } else if (goes_across) {
        svg_.text(middle - Pixels(0.0, 4.0), point.id, plot::Anchor::Middle, "faint");
      } else {
        svg_.text(middle + Pixels(4.0, 4.0), point.id, plot::Anchor::Start, "faint");
      }
    }
  }

  void draw_legend() {
    plot::Legend legend(svg_, kBeside, kTop + 20.0);
    std::vector<parts::FeatureKind> kinds;
    for (const Feature& feature : planned_.part.features) {
      if (std::ranges::find(kinds, feature.kind) == kinds.end()) {
        kinds.push_back(feature.kind);
        legend.line(fmt::format("way line{}", colour_of(feature)), words_.kind(feature.kind));
      }
    }
    legend.line("nominal", words_.way);
    legend.skip(12.0);
    legend.facts(words_.facts);
  }

  const PlannedPart& planned_;
  const DrawingWords& words_;
  plot::Svg svg_;
  parts::Box view_;
  double unit_;  // pixels a millimetre
};

}  // namespace

std::string plan_drawing(const PlannedPart& planned, const DrawingWords& words) {
  return Drawing(planned, words).text();
}

}  // namespace g31::plan
