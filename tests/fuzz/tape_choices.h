#pragma once

#include <memory>
#include <string_view>

#include "interpreter/dialects/fanuc/vocabulary/profile.h"
#include "interpreter/runtime/control_setup.h"
#include "machine/port/surroundings.h"
#include "machine/sim/machine_setup.h"

namespace g31::fuzz {

/// How a text is to be run.  What follows `%` in the first line means nothing to a control; here
/// its letters choose, so that an input stays an NC program:
///
///   1st  Fanuc control: 0 to 6, in the order of profiles()
///   2nd  control set-up, a sum as the character behind `0`: 1 read-ahead, 2 block skip,
///        4 memory A, 8 IS-C, 16 parameters; of SINUMERIK 2 and 16, setting data
///   3rd  machine: 0 empty, 1 scripted signals, 2 a probe in a ring; 4 more: travel limits and A
///
/// What is left out is `0`: an ideal 16i, or the SINUMERIK control.
class TapeChoices {
 public:
  explicit TapeChoices(std::string_view text);

  [[nodiscard]] const fanuc::Profile& profile() const;
  [[nodiscard]] runtime::ControlSetup fanuc_setup() const;
  [[nodiscard]] runtime::ControlSetup sinumerik_setup() const;
  [[nodiscard]] machine::MachineSetup machine_setup() const;
  /// Null: an empty world.
  [[nodiscard]] std::unique_ptr<machine::Surroundings> surroundings() const;

 private:
  [[nodiscard]] unsigned choice(std::size_t place) const;

  std::string_view letters_;
};

}  // namespace g31::fuzz
