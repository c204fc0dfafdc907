#include "tools/plan/round_cycles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <variant>

#include <fmt/format.h>

namespace g31::plan {
namespace {

/// What a control takes for the ball may differ from it by what calibrating finds.
constexpr double kCalibratedMm = 0.1;

/// Of a variable or a machine datum of the sheet.
std::optional<double> number_in(const runtime::ControlSetup& control, const std::string& name) {
  if (const auto found = control.variables.find(name); found != control.variables.end()) {
    return found->second;
  }
  const auto found = control.data.find(name);
  const auto* const number =
      found != control.data.end() ? std::get_if<double>(&found->second) : nullptr;
  return number != nullptr ? std::optional(*number) : std::nullopt;
}

/// O9010 reads the ball from #515 and takes what is vacant for 0.
std::string why_not_touched(const setup::Job& job, const ProgramOptions& options) {
  const auto ball = number_in(job.control, "#515");
  if (!ball) {
    return "#515, the ball of O9010, has no value in the sheet";
  }
  if (std::abs(*ball - 2.0 * options.ball_radius_mm) > kCalibratedMm) {
    return fmt::format("#515 is {:g}, the ball {:g} mm", *ball, 2.0 * options.ball_radius_mm);
  }
  return "";
}

/// CYCLE977 takes these probes, and record 1 of the calibration.
std::string why_not_cycled(const setup::Job& job, const ProgramOptions& options) {
  constexpr std::array kProbeTypes = {710.0, 712.0, 714.0};
  const runtime::ToolEntry& tool = job.control.tools.at(options.length_offset);
  if (std::ranges::find(kProbeTypes, tool.type) == kProbeTypes.end()) {
    return fmt::format("tool {} is of type {:g}, not of one that CYCLE977 measures with",
                       options.length_offset, tool.type);
  }
  const double radius = tool.radius_mm + tool.radius_wear_mm;
  if (std::abs(radius - options.ball_radius_mm) > kCalibratedMm) {
    return fmt::format("tool {} has the radius {:g}, the ball {:g} mm", options.length_offset,
                       radius, options.ball_radius_mm);
  }
  for (const char* const direction :
       {"MINUS_DIR_AX1", "PLUS_DIR_AX1", "MINUS_DIR_AX2", "PLUS_DIR_AX2"}) {
    const std::string name = fmt::format("$SNS_MEA_WP_TRIG_{}[0]", direction);
    const double trigger = std::abs(number_in(job.control, name).value_or(0.0));
    if (trigger == 0.0) {
      return "the probe is not calibrated in the sheet: no " + name;
    }
    if (std::abs(trigger - options.ball_radius_mm) > kCalibratedMm) {
      return fmt::format("{} is {:g} from 0, the ball's radius {:g} mm", name, trigger,
                         options.ball_radius_mm);
    }
  }
  return "";
}

/// O9010 draws back by 3 mm from its first touch.
std::string why_no_room(const probe::PlannedRound& round, const ProgramOptions& options) {
  constexpr double kBackMm = 3.0;
  constexpr double kFreeMm = 0.5;
  constexpr double kRoundingMm = 1e-6;  // of differences of coordinates
  const double room = round.is_standing ? round.approach_mm + kFreeMm
                                        : round.diameter_mm - 2.0 * options.ball_radius_mm;
  return room < kBackMm + kFreeMm - kRoundingMm
             ? fmt::format("O9010 draws back by {:g} mm, for which there is no room", kBackMm)
             : "";
}

}  // namespace

void choose_cycles(const setup::Job& job, const ProgramOptions& options,
                   probe::InspectionPlan& plan) {
  const bool is_fanuc = options.language == ProgramLanguage::Fanuc;
  const std::string why_none =
      is_fanuc ? why_not_touched(job, options) : why_not_cycled(job, options);
  for (probe::PlannedRound& round : plan.rounds) {
    if (round.by_points.empty()) {
      round.by_points = !why_none.empty() ? why_none : is_fanuc ? why_no_room(round, options) : "";
    }
  }
}

bool give_up_cycles(const std::string& why, probe::InspectionPlan& plan) {
  bool has_given_up = false;
  for (probe::PlannedRound& round : plan.rounds) {
    if (round.by_points.empty()) {
      round.by_points = why;
      has_given_up = true;
    }
  }
  return has_given_up;
}

std::string_view cycle_of(ProgramLanguage language) {
  return language == ProgramLanguage::Fanuc ? "O9010" : "CYCLE977";
}

}  // namespace g31::plan
