#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "tools/plan/program_steps.h"

namespace g31::plan {
namespace {

/// A comment: capitals, and no brackets, which would end it.
std::string comment(std::string_view text) {
  std::string shown;
  for (const char c : text) {
    const bool is_plain = c >= ' ' && c <= '~' && c != '(' && c != ')';
    const char plain = is_plain ? c : '-';
    shown += plain >= 'a' && plain <= 'z' ? static_cast<char>(plain - 'a' + 'A') : plain;
  }
  return fmt::format("({})\n", shown);
}

constexpr std::string_view kAxes = "XYZ";
constexpr double kNearlyThereMm = 0.01;

class FanucWriter {
 public:
  FanucWriter(const probe::InspectionPlan& plan, const ProgramSteps& steps,
              const ProgramOptions& options)
      : plan_(plan), steps_(steps), options_(options), names_(printed_names(plan)) {}

  std::string text() {
    write_head();
    for (const ProgramStep& step : steps_.steps) {
      write_touch(step);
      for (const StepResult& result : step.results) {
        write_result(result);
      }
    }
    write_end();
    return std::move(text_);
  }

 private:
  template <typename... Parts>
  void line(fmt::format_string<Parts...> form, Parts&&... parts) {
    fmt::format_to(std::back_inserter(text_), form, std::forward<Parts>(parts)...);
    text_ += '\n';
  }

  static std::string variable(int number) { return variable_name(ProgramLanguage::Fanuc, number); }

  void write_head() {
    line("%\nO6900");
    text_ += comment("inspection of " + options_.product);
    text_ += comment("made by g31 plan, and run on the model before");
    text_ += comment("origin of G54: that of the model");
    if (steps_.variables.front() >= 0) {
      text_ +=
          comment(fmt::format("results: {} to {}", variable(steps_.variables.front()).substr(1),
                              variable(steps_.variables.back()).substr(1)));
    }
    if (options_.tool) {
      line("T{} M06", *options_.tool);
    }
    line("G90 G17 G40 G80{}", options_.has_metric_code ? " G21" : "");
    line("G54");
    if (!options_.switch_on.empty()) {
      line("{}", options_.switch_on);
      if (options_.start_up_s > 0.0) {
        line("G04 X{}", coordinate(options_.start_up_s));
      }
    }
    line("M05");
    line("#100={} (RADIUS OF THE BALL)", exact(options_.ball_radius_mm));
    line("#101={} (FEED OF THE WAYS)", coordinate(options_.approach_feed));
    line("#102={} (FEED OF THE TOUCHES)", coordinate(options_.touch_feed));
    line("POPEN");
    line("G00 G43 H{} Z{}", options_.length_offset, height(options_.clear_z_P));
  }

  /// Of the ball's centre in Z as the control counts it.
  [[nodiscard]] std::string height(double z_P) const {
    return coordinate(z_P - options_.tip_below_centre_mm);
  }

  void write_touch(const ProgramStep& step) {
    const probe::PlannedPoint& point = plan_.points[step.point];
    if (step.begins_feature) {
      text_ += comment(plan_.features[step.feature]);
    }
    text_ += comment(words_of(point));
    if (!point.moved.empty()) {
      text_ += comment(point.moved);
    }
    line("#103={}", step.point + 1);
    const std::string above =
        fmt::format("X{} Y{}", coordinate(point.start_P.x()), coordinate(point.start_P.y()));
    if (above != above_) {
      if (!above_.empty()) {
        line("G00 Z{}", height(options_.clear_z_P));
      }
      line("G00 {}", above);
    }
    const std::string z = height(point.start_P.z());
    if (above != above_ || z != z_) {
      write_way_down(z, step.point + 1);
    }
    above_ = above;
    z_ = z;
    write_skip(point, step.point + 1);
    line("{}={}", variable(step.contact), contact(point, step));
    line("G01 X{} Y{} Z{} F#101", coordinate(point.start_P.x()), coordinate(point.start_P.y()),
         height(point.start_P.z()));
  }

  /// As a touch too, so that nothing breaks on what should not be there.
  void write_way_down(const std::string& z, std::size_t number) {
    line("G31 Z{} F#101", z);
    line("IF [ABS[{}{}] LT {}] GOTO {}", skip_position(2), less(z), kNearlyThereMm,
         10 * number - 1);
    line("#3000= 102 (SOMETHING IS IN THE WAY TO P{})", number);
    line("N{}", 10 * number - 1);
  }

  void write_skip(const probe::PlannedPoint& point, std::size_t number) {
    const Point end = end_of_touch(point, options_);
    int axis = 0;
    point.normal_P.cwiseAbs().maxCoeff(&axis);
    std::string block = "G31";
    for (int i = 0; i < 3; ++i) {
      if (point.normal_P[i] != 0.0) {
        block += fmt::format(" {}{}", kAxes[static_cast<std::size_t>(i)],
                             i == 2 ? height(end[i]) : coordinate(end[i]));
      }
    }
    line("{} F#102", block);
    line("IF [ABS[{}{}] GT {}] GOTO {}", skip_position(axis),
         less(axis == 2 ? height(end[axis]) : coordinate(end[axis])), kNearlyThereMm, 10 * number);
    line("#3000= 101 (P{} IS NOT TOUCHED)", number);
    line("N{}", 10 * number);
  }

  /// As it is programmed: #5063 includes the length of the tool.
  static std::string skip_position(int axis) {
    return axis == 2 ? "#5063-#5083" : fmt::format("#{}", 5061 + axis);
  }

  /// Where the ball touches: its centre less its radius along the normal.
  [[nodiscard]] std::string contact(const probe::PlannedPoint& point,
                                    const ProgramStep& step) const {
    const int axis = axis_along(step.direction_P);
    if (axis < 0) {
      const std::string angle = angle_text(step.direction_P);
      const bool is_along = point.normal_P.dot(step.direction_P) > 0.0;
      return fmt::format("#5061*COS[{0}]+#5062*SIN[{0}]{1}#100", angle, is_along ? '-' : '+');
    }
    std::string text =
        fmt::format("{}{}#100", skip_position(axis), point.normal_P[axis] > 0.0 ? '-' : '+');
    if (axis == 2 && options_.tip_below_centre_mm != 0.0) {
      text += less_exact(-options_.tip_below_centre_mm);
    }
    return text;
  }

  void write_result(const StepResult& result) {
    const probe::PlannedMeasure& measure = plan_.measures[result.measure];
    // Contacts along an axis are coordinates, whatever way the measure counts.
    const int axis = axis_along(measure.direction_P);
    const bool is_against = axis >= 0 && measure.direction_P[axis] < 0.0;
    const int from = is_against ? result.second : result.first;
    const int to = is_against ? result.first : result.second;
    text_ += comment(fmt::format("{}: nominal {}", measure.id, nominal_text(measure.nominal)));
    if (measure.what == probe::Characteristic::Size) {
      line("{}={}-{}", variable(result.variable), variable(to), variable(from));
    } else {
      line("{}={}[{}+{}]/2{}", variable(result.variable), is_against ? "-" : "", variable(from),
           variable(to), less_exact(measure.origin_mm));
    }
    const int decimals = decimals_of(measure);
    line("DPRNT[{}*{}[{}{}]]", names_[result.measure], variable(result.variable), 8 - decimals,
         decimals);
  }

  void write_end() {
    line("PCLOS");
    line("G00 Z{}", height(options_.clear_z_P));
    if (!options_.switch_off.empty()) {
      line("{}", options_.switch_off);
    }
    line("M30\n%");
  }

  const probe::InspectionPlan& plan_;
  const ProgramSteps& steps_;
  const ProgramOptions& options_;
  std::vector<std::string> names_;
  std::string text_;
  // Where the probe is: in X and Y, in Z.
  std::string above_;
  std::string z_;
};

}  // namespace

std::string fanuc_program(const probe::InspectionPlan& plan, const ProgramSteps& steps,
                          const ProgramOptions& options) {
  return FanucWriter(plan, steps, options).text();
}

}  // namespace g31::plan
