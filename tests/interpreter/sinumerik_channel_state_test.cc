#include <functional>

#include <gtest/gtest.h>

#include "interpreter/dialects/sinumerik/state/channel_state.h"

namespace g31::sinumerik {
namespace {

ChannelState some_state() {
  ChannelState state;
  state.numbers = {1.5, -2.0};
  state.texts = {"one"};
  state.frames.resize(1);
  state.settable.resize(2);
  state.tools[3].edges[1][EdgeDatum::kRadius] = 4.0;
  state.files.content("LOG.MPF") = "a line\n";
  return state;
}

TEST(ChannelStates, ACopyIsEqual) {
  const ChannelState state = some_state();
  const ChannelState copy = state;
  EXPECT_TRUE(copy == state);
}

/// A change anywhere, however deep, makes another state; put back, it is the same again.
TEST(ChannelStates, AChangeAnywhereIsSeen) {
  const std::function<void(ChannelState&)> changes[] = {
      [](ChannelState& state) { state.numbers[1] = 2.0; },
      [](ChannelState& state) { state.texts[0] = "two"; },
      [](ChannelState& state) { state.frames[0].set_component(0, Component::Coarse, 1.0); },
      [](ChannelState& state) { state.settable[1].set_component(2, Component::Fine, 0.001); },
      [](ChannelState& state) {
        state.stored_frames.channel[15].set_component(1, Component::Mirror, 1.0);
      },
      [](ChannelState& state) { state.group[Group::Plane] += 1; },
      [](ChannelState& state) { state.spindle.angle.reset(); },
      [](ChannelState& state) { state.axis_settings.override_percent[0] = 50.0; },
      [](ChannelState& state) { state.tools.at(3).edges.at(1)[EdgeDatum::kRadius] = 4.0001; },
      [](ChannelState& state) { state.tools.at(3).more[{}] = 1.0; },
      [](ChannelState& state) { state.carriers[1].kind = "P"; },
      [](ChannelState& state) { state.pole.q_W[1] = 1.0; },
      [](ChannelState& state) { state.working_area.q_low[2] = -10.0; },
      [](ChannelState& state) { state.points.q_M_fixed[3][0] = 1.0; },
      [](ChannelState& state) { state.q_M_measured[2] = 1e-9; },
      [](ChannelState& state) { state.kept_data[{}] = 0.5; },
      [](ChannelState& state) { state.files.content("LOG.MPF") += "more\n"; },
      [](ChannelState& state) { state.digital_outputs[64] = true; },
  };
  const ChannelState before = some_state();
  int which = 0;
  for (const auto& change : changes) {
    SCOPED_TRACE(which++);
    ChannelState state = before;
    change(state);
    EXPECT_FALSE(state == before);
    state = before;
    EXPECT_TRUE(state == before);
  }
}

}  // namespace
}  // namespace g31::sinumerik
