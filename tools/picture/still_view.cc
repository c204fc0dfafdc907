#include "tools/picture/still_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include <fmt/format.h>

#include "machine/base/xml_text.h"
#include "tools/picture/base64.h"
#include "tools/picture/feature_edges.h"
#include "tools/picture/png.h"

namespace g31::picture {
namespace {

/// Pixels of the raster for one of the picture: half of them go into its smoothness.
constexpr int kRasterScale = 4;
constexpr std::size_t kMostEdges = 20'000;
constexpr double kTextPixels = 12.0;
/// How much darker the lowest place of a plan is than the highest one.
constexpr double kDepthTone = 0.3;

constexpr std::array<std::string_view, kPathKinds> kWayClasses = {"way rapid", "way feed",
                                                                  "way skip"};

/// The share of a line, from and to, that lies within the picture; from > to: none of it does.
std::array<double, 2> within(const View& view, const Seen& from, const Seen& to) {
  std::array<double, 2> share = {0.0, 1.0};
  const auto limit = [&](double start, double way, double most) {
    if (way == 0.0) {
      share[1] = start < 0.0 || start > most ? -1.0 : share[1];
      return;
    }
    const double at_low = -start / way;
    const double at_high = (most - start) / way;
    share[0] = std::max(share[0], std::min(at_low, at_high));
    share[1] = std::min(share[1], std::max(at_low, at_high));
  };
  limit(from.x, to.x - from.x, view.width);
  limit(from.y, to.y - from.y, view.height);
  return share;
}

Seen between(const Seen& from, const Seen& to, double share) {
  return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y),
          from.depth + share * (to.depth - from.depth)};
}

/// "3", "3, 7", "1, 5 ... 25".
std::string numbers_of(const std::vector<const Mark*>& marks) {
  if (marks.size() == 1) {
    return fmt::format("{}", marks[0]->touch);
  }
  if (marks.size() <= 3) {
    return fmt::format("{}, {}{}", marks[0]->touch, marks[1]->touch,
                       marks.size() == 3 ? fmt::format(", {}", marks[2]->touch) : "");
  }
  return fmt::format("{}, {} \u2026 {}", marks[0]->touch, marks[1]->touch, marks.back()->touch);
}

double width_of(std::string_view words) {
  constexpr double kPerSign = 6.7;
  return kPerSign * static_cast<double>(std::ranges::count_if(words, [](char c) {
           return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
         }));
}

}  // namespace

StillView::StillView(const StillScene& scene, const View& view, std::optional<CutOpen> cut,
                     const Palette& palette, Extras extras)
    : scene_(scene),
      view_(view),
      cut_(cut),
      palette_(palette),
      extras_(extras),
      raster_(raster_of_parts(scene, view.enlarged(kRasterScale), cut, palette)),
      slack_mm_(1.5 / view.pixels_per_mm) {
  draw_bodies();
  draw_edges();
  draw_ways();
  if (!extras_.stylus) {
    draw_balls();
  }
  find_groups();
  if (extras_.whiskers) {
    draw_whiskers();
  }
  draw_axes();
  draw_scale();
  draw_collisions();
  draw_touches();
  draw_names();
}

void StillView::draw_bodies() {
  Raster all = raster_;
  if (extras_.stylus) {
    for (const StylusPiece& piece : scene_.stylus) {
      all.draw(standing_at(piece.mesh_S, scene_.last),
               piece.is_ball ? palette_.ball : palette_.stylus, false);
    }
  }
  constexpr int kPictureScale = kRasterScale / 2;
  const std::string png =
      png_of(kPictureScale * view_.width, kPictureScale * view_.height,
             all.pixels(palette_.paper_rgb, palette_.line, extras_.stylus ? 0.0 : kDepthTone));
  svg_ += fmt::format(
      "<image width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
      "xlink:href=\"data:image/png;base64,{}\"/>\n",
      view_.width, view_.height, base64(png));
}

bool StillView::is_visible(const Seen& seen) const {
  return raster_.shows({kRasterScale * seen.x, kRasterScale * seen.y, seen.depth}, slack_mm_);
}

void StillView::add_line(const Seen& from, const Seen& to, std::string_view seen_class,
                         std::string_view hidden_class) {
  const auto [first, last] = within(view_, from, to);
  if (first >= last) {
    return;
  }
  const Seen a = between(from, to, first);
  const Seen b = between(from, to, last);
  constexpr double kStepPixels = 1.5;
  const int steps = 1 + static_cast<int>((b.place() - a.place()).norm() / kStepPixels);
  const auto state = [&](int step) { return is_visible(between(a, b, (step + 0.5) / steps)); };
  int begin = 0;
  for (int i = 1; i <= steps; ++i) {
    if (i < steps && state(i) == state(begin)) {
      continue;
    }
    const std::string_view style = state(begin) ? seen_class : hidden_class;
    if (!style.empty()) {
      const Seen p = between(a, b, static_cast<double>(begin) / steps);
      const Seen q = between(a, b, static_cast<double>(i) / steps);
      svg_ += fmt::format("<path class=\"{}\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>\n", style, p.x,
                          p.y, q.x, q.y);
    }
    begin = i;
  }
}

void StillView::draw_edges() {
  for (const PicturedPart& part : scene_.parts) {
    const auto edges = feature_edges(*part.mesh_M);
    if (edges.size() > kMostEdges) {
      continue;  // a scan: its surface is seen in the picture
    }
    for (const Segment& edge : edges) {
      const Point middle = 0.5 * (edge.p_from + edge.p_to);
      if (cut_ && cut_->removes(middle)) {
        continue;
      }
      add_line(view_.seen(edge.p_from), view_.seen(edge.p_to), "edge", "");
    }
  }
}

void StillView::draw_ways() {
  draw_kind(PathKind::Rapid);
  draw_kind(PathKind::Feed);
  draw_kind(PathKind::Skip);
}

/// Each line once, however often and in whatever direction it was travelled.
void StillView::draw_kind(PathKind kind) {
  const std::string style(kWayClasses[static_cast<std::size_t>(kind)]);
  std::set<std::array<long, 4>> drawn;
  for (const Way& way : scene_.ways) {
    if (way.kind != kind) {
      continue;
    }
    Seen from = view_.seen(way.points.front());
    for (std::size_t i = 1; i < way.points.size(); ++i) {
      const Seen to = view_.seen(way.points[i]);
      // Chords of a fast rapid that are not longer than a pixel go into the next one.
      if ((to.place() - from.place()).norm() < 1.0 && i + 1 < way.points.size()) {
        continue;
      }
      std::array<long, 4> key = {std::lround(from.x), std::lround(from.y), std::lround(to.x),
                                 std::lround(to.y)};
      if (key[0] > key[2] || (key[0] == key[2] && key[1] > key[3])) {
        key = {key[2], key[3], key[0], key[1]};
      }
      if (drawn.insert(key).second) {
        add_line(from, to, style, style + " hidden");
      }
      from = to;
    }
  }
}

/// The balls in true size: filled where they stand, and each that touched where it was latched.
void StillView::draw_balls() {
  std::set<std::array<long, 3>> drawn;
  const auto circle = [&](const TouchingBall& ball, std::string_view style) {
    const Seen seen = view_.seen(ball.p_M);
    const double radius = ball.radius_mm * view_.pixels_per_mm;
    if (drawn.insert({std::lround(seen.x), std::lround(seen.y), std::lround(radius)}).second) {
      svg_ += fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\"/>\n",
                          style, seen.x, seen.y, radius);
    }
  };
  if (scene_.tip_radius_mm > 0.0) {
    circle({scene_.last.p_M, scene_.tip_radius_mm}, "ball");
  }
  for (const StylusPiece& piece : scene_.stylus) {
    if (piece.is_ball) {
      circle({scene_.last.p_M + scene_.last.turn * piece.p_S_centre, piece.radius_mm}, "ball");
    }
  }
  for (const Mark& mark : scene_.contacts) {
    if (mark.ball && mark.stylus.tool == scene_.last.tool) {
      circle(*mark.ball, "latched");
    }
  }
}

void StillView::find_groups() {
  constexpr double kOnePlacePixels = 7.0;
  for (const Mark& mark : scene_.contacts) {
    const Seen seen = view_.seen(mark.p_M);
    const auto near = std::ranges::find_if(groups_, [&](const Group& group) {
      return (group.seen.place() - seen.place()).norm() < kOnePlacePixels;
    });
    if (near != groups_.end()) {
      near->marks.push_back(&mark);
    } else {
      groups_.push_back({seen, {&mark}});
    }
    taken_.push_back({seen.place() - Eigen::Vector2d(5, 5), seen.place() + Eigen::Vector2d(5, 5)});
  }
}

/// Nullopt: a tool is shown, or no ball is known.
std::optional<double> StillView::deviation_mm(const Mark& mark) const {
  return scene_.last.tool != 0 ? std::nullopt : latched_depth_mm(mark);
}

void StillView::draw_whiskers() {
  double largest = 0.0;
  for (const Mark& mark : scene_.contacts) {
    largest = std::max(largest, std::fabs(deviation_mm(mark).value_or(0.0)));
  }
  constexpr double kLeastMm = 1e-5;
  constexpr double kLongestPixels = 34.0;
  if (largest < kLeastMm) {
    return;
  }
  constexpr std::array<double, 12> kMagnifications = {10000, 5000, 2000, 1000, 500, 200,
                                                      100,   50,   20,   10,   5,   2};
  const auto fits = std::ranges::find_if(kMagnifications, [&](double times) {
    return times * largest * view_.pixels_per_mm <= kLongestPixels;
  });
  magnification_ = fits == kMagnifications.end() ? 1.0 : *fits;
  for (const Mark& mark : scene_.contacts) {
    const auto deviation = deviation_mm(mark);
    if (!deviation) {
      continue;
    }
    const Seen from = view_.seen(mark.p_M);
    const Seen to = view_.seen(mark.p_M - magnification_ * *deviation * mark.n_M);
    svg_ += fmt::format("<path class=\"whisker\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>\n", from.x,
                        from.y, to.x, to.y);
    const Eigen::Vector2d about(3.0, 3.0);
    for (const double share : {0.5, 1.0}) {
      const Eigen::Vector2d at = between(from, to, share).place();
      taken_.push_back({at - about, at + about});
    }
  }
}

bool StillView::is_free(const Room& room) const {
  constexpr double kGap = 2.0;
  return room.low.x() > kGap && room.low.y() > kGap && room.high.x() < view_.width - kGap &&
         room.high.y() < view_.height - kGap &&
         std::ranges::none_of(taken_, [&](const Room& other) {
           return room.low.x() < other.high.x() + kGap && other.low.x() < room.high.x() + kGap &&
                  room.low.y() < other.high.y() + kGap && other.low.y() < room.high.y() + kGap;
         });
}

void StillView::label(const Eigen::Vector2d& at, const Eigen::Vector2d& wish,
                      const std::string& words, std::string_view style) {
  const Eigen::Vector2d half(std::max(9.0, 0.5 * width_of(words) + 6.0), 9.0);
  const double begin = std::atan2(wish.y(), wish.x());
  constexpr int kDirections = 16;
  for (double away = 20.0; away < 260.0; away += 12.0) {
    for (int i = 0; i < kDirections; ++i) {
      // To the left and the right of the wish by turns.
      const double turn =
          (i % 2 == 0 ? 1.0 : -1.0) * ((i + 1) / 2) * 2.0 * std::numbers::pi / kDirections;
      const Eigen::Vector2d ray(std::cos(begin + turn), std::sin(begin + turn));
      const Eigen::Vector2d middle = at + (away + std::fabs(ray.x()) * (half.x() - 9.0)) * ray;
      const Room room = {middle - half, middle + half};
      if (!is_free(room)) {
        continue;
      }
      taken_.push_back(room);
      svg_ += fmt::format(
          "<path class=\"leader {}\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>\n"
          "<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"18\" rx=\"9\"/>\n"
          "<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
          style, at.x(), at.y(), middle.x(), middle.y(), style, room.low.x(), room.low.y(),
          2.0 * half.x(), style, middle.x(), middle.y() + 4.0, xml_escaped(words));
      return;
    }
  }
}

void StillView::draw_touches() {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Group& group : groups_) {
    middle += group.seen.place() / static_cast<double>(groups_.size());
  }
  for (const Group& group : groups_) {
    const Mark& mark = *group.marks.front();
    const Eigen::Vector2d out(-mark.n_M.dot(view_.right), mark.n_M.dot(view_.up));
    const Eigen::Vector2d wish =
        out.norm() > 0.3 ? out : Eigen::Vector2d(group.seen.place() - middle);
    label(group.seen.place(), wish.norm() > 1e-6 ? wish : Eigen::Vector2d(1.0, -1.0),
          numbers_of(group.marks), "number");
    const Seen before = view_.seen(mark.p_M + mark.n_M / view_.pixels_per_mm);
    svg_ += fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\"/>\n",
                        is_visible(before) ? "touch" : "touch behind", group.seen.x, group.seen.y);
  }
}

void StillView::draw_collisions() {
  for (const Mark& mark : scene_.collisions) {
    const Seen seen = view_.seen(mark.p_M);
    std::string corners;
    constexpr double kRadius = 9.0;
    for (int i = 0; i < 8; ++i) {
      const double angle = (i + 0.5) * std::numbers::pi / 4.0;
      corners += fmt::format("{:.1f},{:.1f} ", seen.x + kRadius * std::cos(angle),
                             seen.y + kRadius * std::sin(angle));
    }
    svg_ += fmt::format("<polygon class=\"collision\" points=\"{}\"/>\n", corners);
    taken_.push_back(
        {seen.place() - Eigen::Vector2d(10, 10), seen.place() + Eigen::Vector2d(10, 10)});
    label(seen.place(), {0.6, 1.0}, fmt::format("collision: {}", mark.what), "crash");
  }
}

void StillView::draw_names() {
  for (const PicturedPart& part : scene_.parts) {
    Eigen::AlignedBox2d box;
    for (const Point& p : part.mesh_M->vertices) {
      const Seen seen = view_.seen(p);
      if (seen.x > 0.0 && seen.x < view_.width && seen.y > 0.0 && seen.y < view_.height) {
        box.extend(seen.place());
      }
    }
    if (box.isEmpty()) {
      continue;
    }
    const double half = 0.5 * width_of(part.name);
    const std::array<Eigen::Vector2d, 4> places = {
        Eigen::Vector2d(box.center().x(), box.max().y() + 1.3 * kTextPixels),
        Eigen::Vector2d(box.center().x(), box.min().y() - 0.6 * kTextPixels),
        Eigen::Vector2d(box.min().x() + half, box.max().y() + 1.3 * kTextPixels),
        Eigen::Vector2d(box.max().x() - half, box.min().y() - 0.6 * kTextPixels)};
    for (const Eigen::Vector2d& at : places) {
      const Room room = {at - Eigen::Vector2d(half, kTextPixels), at + Eigen::Vector2d(half, 4.0)};
      if (is_free(room)) {
        taken_.push_back(room);
        svg_ += fmt::format(
            "<text class=\"name\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
            at.x(), at.y(), xml_escaped(part.name));
        break;
      }
    }
  }
}

void StillView::draw_axes() {
  constexpr double kLong = 30.0;
  const Eigen::Vector2d foot(40.0, view_.height - 40.0);
  taken_.push_back({foot - Eigen::Vector2d(38, 42), foot + Eigen::Vector2d(42, 38)});
  for (int axis = 0; axis < 3; ++axis) {
    const Point direction = Point::Unit(axis);
    const Eigen::Vector2d way(direction.dot(view_.right), -direction.dot(view_.up));
    if (way.norm() < 0.1) {
      continue;
    }
    const Eigen::Vector2d tip = foot + kLong * way;
    const Eigen::Vector2d word = foot + (kLong + 9.0) * way;
    svg_ += fmt::format(
        "<path class=\"axis\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>\n"
        "<text class=\"faint\" x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
        foot.x(), foot.y(), tip.x(), tip.y(), word.x(), word.y() + 4.0, "XYZ"[axis]);
  }
}

void StillView::draw_scale() {
  constexpr double kLongest = 110.0;
  double length_mm = 1e-3;
  for (double ten = 1e-3; ten < 1e5; ten *= 10.0) {
    for (const double step : {1.0, 2.0, 5.0}) {
      length_mm = step * ten * view_.pixels_per_mm <= kLongest ? step * ten : length_mm;
    }
  }
  const double right = view_.width - 16.0;
  const double left = right - length_mm * view_.pixels_per_mm;
  const auto bar = [&](double y, std::string_view style, const std::string& words) {
    svg_ += fmt::format(
        "<path class=\"{0}\" d=\"M{1:.1f} {3:.1f}V{4:.1f}H{2:.1f}V{3:.1f}\"/>\n"
        "<text class=\"faint\" x=\"{2:.1f}\" y=\"{5:.1f}\" text-anchor=\"end\">{6}</text>\n",
        style, left, right, y - 4.0, y, y - 8.0, words);
    taken_.push_back({{std::min(left, right - width_of(words)), y - 22.0}, {right, y + 2.0}});
  };
  bar(view_.height - 14.0, "scale", fmt::format("{:g} mm", length_mm));
  if (magnification_ > 0.0) {
    bar(view_.height - 44.0, "scale added",
        fmt::format("{:g} \u00b5m (\u00d7{:g})", 1000.0 * length_mm / magnification_,
                    magnification_));
  }
}

}  // namespace g31::picture
