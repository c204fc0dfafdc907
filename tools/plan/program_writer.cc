#include "tools/plan/program_writer.h"

#include <cstddef>

namespace g31::plan {
namespace {

/// Where the ball's centre is at the end of a touch that does not come.
Point end_of_touch(const probe::PlannedPoint& point, const ProgramOptions& options) {
  return point.at_P + (options.ball_radius_mm - options.overtravel_mm) * point.normal_P;
}

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

std::string ProgramWriter::text() {
  write_head();
  for (const ProgramStep& step : steps_.steps) {
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
  return std::move(text_);
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
  if (step.begins_feature) {
    comment(plan_.features[step.feature]);
  }
  comment(words_of(point));
  if (!point.moved.empty()) {
    comment(point.moved);
  }
  line("{}={}", words_.point, number);
  go_to_start(point, number);
  write_skip(skip_of(point, number));
  line("{}={}", variable(step.contact), contact(point, step));
  line("{} {} Z{} {}", words_.feed, above_, z_, words_.ways_feed);
}

void ProgramWriter::go_to_start(const probe::PlannedPoint& point, std::size_t number) {
  const std::string above =
      fmt::format("X{} Y{}", coordinate(point.start_P.x()), coordinate(point.start_P.y()));
  const std::string z = height(point.start_P.z());
  if (above != above_) {
    if (!above_.empty()) {
      line("{} Z{}", words_.rapid, height(options_.clear_z_P));
    }
    line("{} {}", words_.rapid, above);
  }
  if (above != above_ || z != z_) {
    write_way_down(z, number);
  }
  above_ = above;
  z_ = z;
}

ProgramWriter::Skip ProgramWriter::skip_of(const probe::PlannedPoint& point,
                                           std::size_t number) const {
  constexpr int kZ = 2;
  const Point end = end_of_touch(point, options_);
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
  comment(fmt::format("{}: nominal {}", measure.id, nominal_text(measure.nominal)));
  if (measure.what == probe::Characteristic::Size) {
    line("{}={}-{}", variable(result.variable), to, from);
  } else {
    line("{}={}{}{}+{}{}/2{}", variable(result.variable), is_against ? "-" : "", words_.open, from,
         to, words_.close, less_exact(measure.origin_mm));
  }
  write_print(names_[result.measure], variable(result.variable), decimals_of(measure));
}

}  // namespace g31::plan
