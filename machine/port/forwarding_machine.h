#pragma once

#include <optional>
#include <string>
#include <vector>

#include "machine/port/machine_port.h"

namespace g31::machine {

/// A machine that another one does all the work for.  Who watches or changes some of it derives
/// from this and says only that: the rest goes through, what the port will have some day included,
/// for a port without defaults does not compile until it is passed on here.
class ForwardingMachine : public MachinePort {
 public:
  /// @param machine  not owned: it outlives this one
  explicit ForwardingMachine(MachinePort& machine) : machine_(machine) {}

  Result<AxisPositions, MachineFault> move(const LinearMove& move) override {
    return machine_.move(move);
  }
  Result<AxisPositions, MachineFault> move(const ArcMove& arc) override {
    return machine_.move(arc);
  }
  Result<SkipOutcome, MachineFault> move_until_skip(const SkipMove& move) override {
    return machine_.move_until_skip(move);
  }
  [[nodiscard]] bool skip_signal(int input) const override { return machine_.skip_signal(input); }
  [[nodiscard]] std::optional<SensorState> sensor_state(int input) const override {
    return machine_.sensor_state(input);
  }
  [[nodiscard]] std::optional<bool> digital_input(int number) const override {
    return machine_.digital_input(number);
  }
  [[nodiscard]] std::optional<double> displacement(int input) const override {
    return machine_.displacement(input);
  }
  void change_tool(const ToolChange& change) override { machine_.change_tool(change); }
  [[nodiscard]] std::string stands_inside() const override { return machine_.stands_inside(); }
  void turn_spindle(const SpindleTurn& turn) override { machine_.turn_spindle(turn); }
  void auxiliary_code(const AuxiliaryCode& code) override { machine_.auxiliary_code(code); }
  void digital_output(const DigitalOutput& output) override { machine_.digital_output(output); }
  void stand_still() override { machine_.stand_still(); }
  void come_to_rest() override { machine_.come_to_rest(); }
  MaybeFault take_late_fault() override { return machine_.take_late_fault(); }
  [[nodiscard]] AxisData axis_data() const override { return machine_.axis_data(); }
  void set_axis_data(const AxisData& data) override { machine_.set_axis_data(data); }
  void compensate(const std::vector<CompensationTable>& tables) override {
    machine_.compensate(tables);
  }
  void dwell(double seconds) override { machine_.dwell(seconds); }
  [[nodiscard]] std::optional<AxisTravel> travel(int axis) const override {
    return machine_.travel(axis);
  }
  [[nodiscard]] AxisPositions position() const override { return machine_.position(); }
  [[nodiscard]] double time_s() const override { return machine_.time_s(); }

 protected:
  MachinePort& machine_;
};

}  // namespace g31::machine
