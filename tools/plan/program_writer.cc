#include "tools/plan/program_writer.h"

#include <algorithm>
#include <cstddef>

namespace g31::plan {
namespace {

/// "P3 on a face that looks to +X": what a comment says of a touch.
std::string words_of(const probe::PlannedPoint& point) {
  const int axis = axis_along(point.normal_P);
  if (axis < 0) {
    return point.id + " on a turned wall";
  }
  return fmt::format("{} on a face that looks to {}{}", point.id,
                     point.normal_P[axis] > 0.0 ? '+' : '-', axis_letter(axis));
}

}  // namespace

WrittenProgram ProgramWriter::program() {
  write_head();
  for (const ProgramStep& step : steps_.steps) {
    if (step.begins_feature) {
      write_feature(step.feature);
    }
    if (step.round != nullptr) {
      write_round(step);
      continue;
    }
    write_touch(step);
    for (const StepResult& result : step.results) {
      write_result(result);
    }
  }
  line("{} Z{}", words_.rapid, height(options_.clear_z_P));
  if (!options_.switch_off.empty()) {
    line("{}", options_.switch_off);
  }
  write_end();
  return {std::move(text_), touches_, std::move(of_points_)};
}

void ProgramWriter::write_feature(std::size_t feature) {
  comment(plan_.features[feature]);
  const auto round = std::ranges::find(plan_.rounds, feature, &probe::PlannedRound::feature);
  if (round != plan_.rounds.end() && !round->by_points.empty()) {
    comment("point by point: " + round->by_points);
  }
}

std::string ProgramWriter::features_by_cycle() const {
  constexpr int kNamed = 8;  // no block gets longer than controls take it
  std::string features;
  int count = 0;
  for (const probe::PlannedRound& round : plan_.rounds) {
    if (round.by_points.empty() && ++count <= kNamed) {
      features += fmt::format("{}F{}", features.empty() ? "" : " ", round.feature + 1);
    }
  }
  return count > kNamed ? fmt::format("{} and {} more", features, count - kNamed) : features;
}

void ProgramWriter::write_round(const ProgramStep& step) {
  std::string points;
  for (const std::size_t point : step.round->points) {
    points += plan_.points[point].id + " ";
  }
  comment(fmt::format("{}by {}", points, words_.cycle));
  for (const std::size_t point : step.round->points) {
    if (!plan_.points[point].moved.empty()) {
      comment(plan_.points[point].moved);
    }
  }
  write_cycle(step);
}

void ProgramWriter::count_touches(std::size_t touches, std::size_t point) {
  touches_ += touches;
  of_points_[point] = touches_ - 1;
}

void ProgramWriter::write_switch_on() {
  if (options_.switch_on.empty()) {
    return;
  }
  line("{}", options_.switch_on);
  if (options_.start_up_s > 0.0) {
    line("{}{}", words_.dwell, coordinate(options_.start_up_s));
  }
}

void ProgramWriter::write_touch(const ProgramStep& step) {
  const probe::PlannedPoint& point = plan_.points[step.point];
  const std::size_t number = step.point + 1;
  comment(words_of(point));
  if (!point.moved.empty()) {
    comment(point.moved);
  }
  line("{}={}", words_.point, number);
  go_to(point.start_P, number);
  write_skip(skip_of(point, number));
  count_touches(1, step.point);
  line("{}={}", variable(step.contact), contact(point, step));
  line("{} {} Z{} {}", words_.feed, above_, z_, words_.ways_feed);
}

void ProgramWriter::go_above(const Point& p_P) {
  const std::string above = fmt::format("X{} Y{}", coordinate(p_P.x()), coordinate(p_P.y()));
  if (above != above_) {
    leave();
    line("{} {}", words_.rapid, above);
    above_ = above;
  }
}

void ProgramWriter::go_to(const Point& p_P, std::size_t point) {
  go_above(p_P);
  const std::string z = height(p_P.z());
  if (z != z_) {
    write_way_down(z, point);
    z_ = z;
  }
}

void ProgramWriter::leave() {
  if (!above_.empty()) {
    line("{} Z{}", words_.rapid, height(options_.clear_z_P));
  }
  above_.clear();
  z_.clear();
}

ProgramWriter::Skip ProgramWriter::skip_of(const probe::PlannedPoint& point,
                                           std::size_t number) const {
  constexpr int kZ = 2;
  const Point end = end_of_touch(point);
  Skip skip;
  skip.point = number;
  point.normal_P.cwiseAbs().maxCoeff(&skip.axis);
  for (int axis = 0; axis < 3; ++axis) {
    if (point.normal_P[axis] == 0.0) {
      continue;
    }
    const std::string target = axis == kZ ? height(end[axis]) : coordinate(end[axis]);
    skip.words += fmt::format("{}{}{}", skip.words.empty() ? "" : " ", axis_letter(axis), target);
    if (axis == skip.axis) {
      skip.target = target;
    }
  }
  return skip;
}

/// Where the ball touches: its centre less its radius along the normal.
std::string ProgramWriter::contact(const probe::PlannedPoint& point,
                                   const ProgramStep& step) const {
  constexpr int kZ = 2;
  const int axis = axis_along(step.direction_P);
  if (axis < 0) {
    return fmt::format("{0}*COS{2}{4}{3}+{1}*SIN{2}{4}{3}{5}{6}", words_.skip[0], words_.skip[1],
                       words_.open, words_.close, angle_text(step.direction_P),
                       point.normal_P.dot(step.direction_P) > 0.0 ? '-' : '+', words_.radius);
  }
  std::string text = fmt::format("{}{}{}", words_.skip[static_cast<std::size_t>(axis)],
                                 point.normal_P[axis] > 0.0 ? '-' : '+', words_.radius);
  if (axis == kZ && options_.tip_below_centre_mm != 0.0) {
    text += less_exact(-options_.tip_below_centre_mm);
  }
  return text;
}

void ProgramWriter::write_result(const StepResult& result) {
  const probe::PlannedMeasure& measure = plan_.measures[result.measure];
  // Contacts along an axis are coordinates, whatever way the measure counts.
  const int axis = axis_along(measure.direction_P);
  const bool is_against = axis >= 0 && measure.direction_P[axis] < 0.0;
  const std::string from = variable(is_against ? result.second : result.first);
  const std::string to = variable(is_against ? result.first : result.second);
  if (result.round != nullptr) {
    write_diameter(result, from, to);
    return;
  }
  write_value(result, measure.what == probe::Characteristic::Size
                          ? fmt::format("{}-{}", to, from)
                          : fmt::format("{}{}{}+{}{}/2{}", is_against ? "-" : "", words_.open, from,
                                        to, words_.close, less_exact(measure.origin_mm)));
}

/// Touches beside the middle are on a chord, whose distance from it the two across show.
void ProgramWriter::write_diameter(const StepResult& result, const std::string& from,
                                   const std::string& to) {
  const probe::PlannedMeasure& measure = plan_.measures[result.measure];
  const int across = 1 - axis_along(measure.direction_P);
  const auto [to_centre, back] =
      result.round->is_standing ? std::pair('+', '-') : std::pair('-', '+');
  line("{}={}{}+{}{}/2{}", words_.across, words_.open, variable(result.first_across),
       variable(result.second_across), words_.close,
       less(coordinate(plan_.points[measure.first].start_P[across])));
  write_no_less(words_.across);
  line("{}={}{}-{}{}/2{}{}", words_.along, words_.open, to, from, words_.close, to_centre,
       words_.radius);
  write_value(result, fmt::format("2*{0}SQRT{0}{1}*{1}+{2}*{2}{3}{4}{5}{3}", words_.open,
                                  words_.along, words_.across, words_.close, back, words_.radius));
}

void ProgramWriter::write_value(const StepResult& result, const std::string& value) {
  const probe::PlannedMeasure& measure = plan_.measures[result.measure];
  comment(fmt::format("{}: nominal {}", measure.id, nominal_text(measure.nominal)));
  line("{}={}", variable(result.variable), value);
  write_print(names_[result.measure], variable(result.variable), decimals_of(measure));
}

}  // namespace g31::plan
