#include "tests/fuzz/tape_choices.h"

#include <optional>
#include <vector>

#include "machine/base/contract.h"
#include "parts/artefacts/ring_gauge.h"
#include "parts/geometry/placement.h"
#include "probe/sensor/touch_probe.h"
#include "tests/support/world_of_pieces.h"

namespace g31::fuzz {
namespace {

/// Every kind of answer in turn: none, late, at once, already there; an obstacle now and then.
class ScriptedWorld final : public testing::WorldOfPieces {
  std::optional<machine::SkipTrigger> trigger_on(const machine::Sweep& /*sweep*/) override {
    switch (triggers_++ % 5) {
      case 0:
        return machine::SkipTrigger{0.5, false, 0.0, std::nullopt};
      case 1:
        return std::nullopt;
      case 2:
        return machine::SkipTrigger{0.9, false, 0.004, std::nullopt};
      case 3:
        return machine::SkipTrigger{0.0, false, 0.0, std::nullopt};
      default:
        return machine::SkipTrigger{0.0, true, 0.0, std::nullopt};
    }
  }
  std::optional<machine::Obstacle> obstacle_on(const machine::Sweep& sweep) override {
    if (++moves_ % 400 != 0) {
      return std::nullopt;
    }
    return machine::Obstacle{
        0.5, "stylus ball touches clamp", {sweep.q_M_from.head<3>(), Point::UnitZ(), "clamp"}};
  }

  unsigned triggers_ = 0;
  unsigned moves_ = 0;
};

/// A ball in a coarse ring around the machine's zero.
std::unique_ptr<machine::Surroundings> probe_in_ring() {
  parts::RingGauge ring;
  ring.sagitta_mm = 0.5;
  const auto mesh_P = parts::ring_gauge_mesh(ring);
  G31_EXPECTS(mesh_P);
  probe::ProbeSetup setup;
  setup.trigger_delay_s = 0.002;
  setup.repeatability_mm = 0.001;
  const Point p_M_at(0.0, 0.0, 10.0 - setup.length_mm);
  const parts::Mesh mesh_M = parts::placed_mesh(mesh_P.value(), {p_M_at, Point(0.0, 0.0, 30.0)});
  return std::make_unique<probe::TouchProbe>(setup,
                                             std::vector<probe::ProbedPart>{{"ring", mesh_M}}, 0);
}

}  // namespace

TapeChoices::TapeChoices(std::string_view text) {
  if (text.starts_with('%')) {
    letters_ = text.substr(1, text.find_first_of("\r\n") - 1);
  }
}

unsigned TapeChoices::choice(std::size_t place) const {
  return place < letters_.size() ? static_cast<unsigned char>(letters_[place]) - unsigned{'0'} : 0;
}

const fanuc::Profile& TapeChoices::profile() const {
  return fanuc::profiles()[choice(0) % fanuc::profiles().size()];
}

runtime::ControlSetup TapeChoices::fanuc_setup() const {
  const unsigned sum = choice(1);
  runtime::ControlSetup setup;
  setup.lookahead_blocks = (sum & 1U) != 0 ? 4 : 0;
  if ((sum & 2U) != 0) {
    setup.block_skip = {1, 2};
  }
  setup.offset_memory = (sum & 4U) != 0 ? runtime::OffsetMemory::A : runtime::OffsetMemory::C;
  setup.increment = (sum & 8U) != 0 ? "IS-C" : "";
  if ((sum & 16U) != 0) {
    setup.parameters = {{"3401.0", 1}, {"3410", 0.0}, {"5003.0", 1}, {"5101.0", 1}, {"5114", 0.5},
                        {"5115", 0.5}, {"5400.0", 1}, {"5400.6", 1}, {"6001.5", 1}, {"6004.0", 1},
                        {"6006.0", 1}, {"6031", 500}, {"6032", 510}, {"6202", 1},   {"6241", 100},
                        {"6251", 2},   {"6254", 1},   {"6071", 20},  {"19625", 3.0}};
  }
  setup.macro_calls = {{"G100", 9010}, {"G101", 9011}, {"M100", 9020}};
  setup.tools[1] = {120.0, 0.1, 5.0, -0.01};
  setup.tools[2] = {-80.0, 0.0, 0.5, 0.0};
  return setup;
}

runtime::ControlSetup TapeChoices::sinumerik_setup() const {
  const unsigned sum = choice(1);
  runtime::ControlSetup setup;
  if ((sum & 2U) != 0) {
    setup.block_skip = {1, 2};
  }
  if ((sum & 16U) != 0) {
    setup.variables = {{"$SNS_MEA_WP_BALL_DIAM[0]", 6.0},
                       {"$SCS_MEA_FEED_MEASURE", 100.0},
                       {"R1", 1.5},
                       {"$P_UIFR[1,Z,RT]", 30.0}};
  }
  setup.work_offsets["G54"] = AxisPositions::Constant(10.0);
  setup.tools[1] = {120.0, 0.1, 3.0, -0.01, "PROBE", 710.0};
  setup.tools[2] = {80.0, 0.0, 5.0, 0.0, "MILL", 120.0};
  return setup;
}

machine::MachineSetup TapeChoices::machine_setup() const {
  machine::MachineSetup setup;
  if ((choice(2) & 4U) != 0) {
    setup.axes[3].present = true;
    setup.axes[0].travel_min = -500.0;
    setup.axes[0].travel_max = 500.0;
    setup.axes[2].travel_min = -500.0;
  }
  return setup;
}

std::unique_ptr<machine::Surroundings> TapeChoices::surroundings() const {
  switch (choice(2) & 3U) {
    case 0:
      return nullptr;
    case 1:
      return std::make_unique<ScriptedWorld>();
    default:
      return probe_in_ring();
  }
}

}  // namespace g31::fuzz
