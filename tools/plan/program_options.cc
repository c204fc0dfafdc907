#include "tools/plan/program_options.h"

#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "tools/session/manual.h"

namespace g31::plan {
namespace {

/// The block by which a program switches the probe; "": it has nothing to do.
std::string switch_block(const std::optional<probe::ProgramSwitch>& by, ProgramLanguage language) {
  if (!by) {
    return "";
  }
  if (by->kind == probe::ProgramSwitch::Kind::Code) {
    return fmt::format("M{}", by->number);
  }
  return language == ProgramLanguage::Fanuc ? fmt::format("#{}=1", by->number)
                                            : fmt::format("$A_OUT[{}]=1", by->number);
}

/// The tool that the control takes the probe for: by its number, else by its length.  A FANUC has
/// the length under a number of its own.
std::optional<int> tool_of_probe(const setup::Job& job, bool has_own_numbers) {
  if (job.probe->switching.tool && job.control.tools.contains(*job.probe->switching.tool)) {
    return job.probe->switching.tool;
  }
  if (job.probe->switching.tool && !has_own_numbers) {
    return std::nullopt;
  }
  for (const auto& [number, tool] : job.control.tools) {
    if (std::abs(tool.length_mm - job.probe->length_mm) <= job.probe->ball_diameter_mm) {
      return number;
    }
  }
  return std::nullopt;
}

}  // namespace

Result<ProgramOptions, session::Refusal> program_options(const setup::Job& job,
                                                         const session::Control& control,
                                                         const PlannedTouches& touches) {
  const bool is_fanuc = std::holds_alternative<session::FanucControl>(control);
  const auto number = tool_of_probe(job, is_fanuc);
  if (!number && job.probe->switching.tool && !is_fanuc) {
    return session::bad_setup(fmt::format(
        "probe.tool is {0}, and the sheet has no [tools.{0}]; expected it with the length to the "
        "ball",
        *job.probe->switching.tool));
  }
  if (!number) {
    return session::bad_setup(fmt::format(
        "no tool of the sheet is about as long as its probe, {:g} mm; expected [tools.N] with the "
        "length to the ball",
        job.probe->length_mm));
  }
  const runtime::ToolEntry& tool = job.control.tools.at(*number);
  const probe::SwitchingSetup& switching = job.probe->switching;
  ProgramOptions options;
  options.language = is_fanuc ? ProgramLanguage::Fanuc : ProgramLanguage::Sinumerik;
  options.has_metric_code = !session::explain("G21", control).empty();
  options.ball_radius_mm = touches.ball_radius_mm;
  options.clear_z_P = touches.clear_z_P;
  options.tool = switching.tool;
  options.tool_name = tool.name;
  options.length_offset = *number;
  options.tip_below_centre_mm = tool.length_mm - job.probe->length_mm;
  options.switch_on = switch_block(switching.on, options.language);
  options.switch_off = switch_block(switching.off, options.language);
  options.start_up_s = switching.start_up_s;
  return options;
}

}  // namespace g31::plan
