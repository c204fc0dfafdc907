#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "probe/sensor/carrier_view.h"
#include "probe/sensor/cutting_tool.h"
#include "probe/sensor/touchable_parts.h"
#include "tools/setup/job.h"

namespace g31::session {

/// The axes of the machine, whatever tool it holds.
machine::AxisChain chain_of(const setup::Job& job);

/// Puts a part on what the sheet says that carries it.
void mount(probe::ProbedPart& part, const parts::PartSetup& setup, const setup::Job& job);

/// What carries a part that does not always go along with the table; nullopt: it does.
std::optional<probe::Carrier> carrier_of(const setup::Job& job, const probe::ProbedPart& part);

/// Parts on one carrier, with what takes long to make; may be shared by threads.
struct CarriedParts {
  std::optional<std::size_t> link;  ///< as Carrier has it
  std::vector<std::size_t> which;   ///< of all parts; never empty
  double reach_mm = 0.0;            ///< from the rotary axes; 0 where there are none
  std::shared_ptr<const probe::TouchableParts> by_balls;   ///< null without a probe
  std::shared_ptr<const probe::TouchableParts> by_second;  ///< null without a second one
  std::shared_ptr<const probe::ToolObstacles> by_tools;    ///< null where the sheet names no tools
};

/// Which parts are carried together; nothing of them is made yet.
std::vector<CarriedParts> carried_parts(const setup::Job& job,
                                        const std::vector<probe::ProbedPart>& parts);

}  // namespace g31::session
