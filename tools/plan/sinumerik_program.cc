#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "tools/plan/program_steps.h"

namespace g31::plan {
namespace {

constexpr std::string_view kAxisWords = "XYZ";

class SinumerikWriter {
 public:
  SinumerikWriter(const probe::InspectionPlan& plan, const ProgramSteps& steps,
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
    line("G0 Z{}", height(options_.clear_z_P));
    if (!options_.switch_off.empty()) {
      line("{}", options_.switch_off);
    }
    line("M30");
    return std::move(text_);
  }

 private:
  template <typename... Parts>
  void line(fmt::format_string<Parts...> form, Parts&&... parts) {
    fmt::format_to(std::back_inserter(text_), form, std::forward<Parts>(parts)...);
    text_ += '\n';
  }

  /// To the end of a line.
  void comment(std::string_view text) {
    text_ += "; ";
    for (const char c : text) {
      text_ += c >= ' ' && c <= '~' ? c : '-';
    }
    text_ += '\n';
  }

  static std::string variable(int number) {
    return variable_name(ProgramLanguage::Sinumerik, number);
  }

  void write_head() {
    comment("Inspection of " + options_.product);
    comment("made by g31 plan, and run on the model before");
    comment("Origin of G54: that of the model.  Results go to the file INSPECT_LOG");
    if (steps_.variables.front() >= 0) {
      comment(fmt::format("and stay in {} to {}", variable(steps_.variables.front()),
                          variable(steps_.variables.back())));
    }
    line("DEF INT FAULT");
    line("G90 G17 G40 G71 G94");
    line("G54");
    line("T{}", options_.tool_name.empty() ? fmt::format("{}", options_.length_offset)
                                           : fmt::format("=\"{}\"", options_.tool_name));
    line("M6");
    line("D1");
    if (!options_.switch_on.empty()) {
      line("{}", options_.switch_on);
      if (options_.start_up_s > 0.0) {
        line("G4 F{}", coordinate(options_.start_up_s));
      }
    }
    line("M5");
    line("R1={}  ; radius of the ball", exact(options_.ball_radius_mm));
    line("R3={}  ; feed of the ways", coordinate(options_.approach_feed));
    line("R4={}  ; feed of the touches", coordinate(options_.touch_feed));
    line("IF ISFILE(\"INSPECT_LOG\")");
    line("  DELETE(FAULT,\"INSPECT_LOG\")");
    line("ENDIF");
  }

  [[nodiscard]] std::string height(double z_P) const {
    return coordinate(z_P - options_.tip_below_centre_mm);
  }

  void write_touch(const ProgramStep& step) {
    const probe::PlannedPoint& point = plan_.points[step.point];
    if (step.begins_feature) {
      comment(plan_.features[step.feature]);
    }
    comment(words_of(point));
    if (!point.moved.empty()) {
      comment(point.moved);
    }
    line("R2={}", step.point + 1);
    const std::string above =
        fmt::format("X{} Y{}", coordinate(point.start_P.x()), coordinate(point.start_P.y()));
    if (above != above_) {
      line("G0 Z{}", height(options_.clear_z_P));
      line("{}", above);
    }
    // As a touch too, so that nothing breaks on what should not be there.
    const std::string z = height(point.start_P.z());
    if (above != above_ || z != z_) {
      line("MEAS=1 G1 Z{} F=R3", z);
      write_check("$AC_MEA[1]<>0", 65001, fmt::format("Something is in the way to {}", point.id));
    }
    above_ = above;
    z_ = z;
    std::string block = "MEAS=1 G1";
    const Point end = end_of_touch(point, options_);
    for (int i = 0; i < 3; ++i) {
      if (point.normal_P[i] != 0.0) {
        block += fmt::format(" {}{}", kAxisWords[static_cast<std::size_t>(i)],
                             i == 2 ? height(end[i]) : coordinate(end[i]));
      }
    }
    line("{} F=R4", block);
    write_check("$AC_MEA[1]==0", 65000, point.id + " is not touched");
    line("{}={}", variable(step.contact), contact(point, step));
    line("G1 X{} Y{} Z{} F=R3", coordinate(point.start_P.x()), coordinate(point.start_P.y()),
         height(point.start_P.z()));
  }

  /// The alarm of a move that did not come to what it should.
  void write_check(std::string_view wrong, int alarm, const std::string& text) {
    line("STOPRE");
    line("IF {}", wrong);
    line("  SETAL({},\"{}\")", alarm, text);
    line("  M0");
    line("ENDIF");
  }

  /// Where the ball touches: its centre less its radius along the normal.
  [[nodiscard]] std::string contact(const probe::PlannedPoint& point,
                                    const ProgramStep& step) const {
    const int axis = axis_along(step.direction_P);
    if (axis < 0) {
      const std::string angle = angle_text(step.direction_P);
      const bool is_along = point.normal_P.dot(step.direction_P) > 0.0;
      return fmt::format("$AA_MW[X]*COS({0})+$AA_MW[Y]*SIN({0}){1}R1", angle, is_along ? '-' : '+');
    }
    std::string text = fmt::format("$AA_MW[{}]{}R1", kAxisWords[static_cast<std::size_t>(axis)],
                                   point.normal_P[axis] > 0.0 ? '-' : '+');
    if (axis == 2 && options_.tip_below_centre_mm != 0.0) {
      text += less_exact(-options_.tip_below_centre_mm);
    }
    return text;
  }

  void write_result(const StepResult& result) {
    const probe::PlannedMeasure& measure = plan_.measures[result.measure];
    const int axis = axis_along(measure.direction_P);
    const bool is_against = axis >= 0 && measure.direction_P[axis] < 0.0;
    const int from = is_against ? result.second : result.first;
    const int to = is_against ? result.first : result.second;
    comment(fmt::format("{}: nominal {}", measure.id, nominal_text(measure.nominal)));
    if (measure.what == probe::Characteristic::Size) {
      line("{}={}-{}", variable(result.variable), variable(to), variable(from));
    } else {
      line("{}={}({}+{})/2{}", variable(result.variable), is_against ? "-" : "", variable(from),
           variable(to), less_exact(measure.origin_mm));
    }
    line("WRITE(FAULT,\"INSPECT_LOG\",SPRINT(\"{} %.{}f\",{}))", names_[result.measure],
         decimals_of(measure), variable(result.variable));
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

std::string sinumerik_program(const probe::InspectionPlan& plan, const ProgramSteps& steps,
                              const ProgramOptions& options) {
  return SinumerikWriter(plan, steps, options).text();
}

}  // namespace g31::plan
