#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "machine/port/machine_port.h"

namespace g31::testing {

/// A machine that only writes down what it was asked: the readable half of every golden file.
///
///   move 12.500 0.000 -5.000 rapid          X Y Z in mm; a rotary axis follows when it is not 0:
///   skip 20.000 0.000 -5.000 A30.000 F300
///   arc cw 10.000 0.000 0.000 centre X5.000 Y0.000 F300
///   dwell 0.5
///   orient 90
///
/// Touches come from a script, in order: latched and stopped are both the scripted position, the
/// contact is empty.  After the script's end every skip move is a NoTouch.  Nothing takes time.
class RecordingMachine final : public machine::MachinePort {
 public:
  explicit RecordingMachine(std::vector<AxisPositions> touches = {},
                            const AxisPositions& q_M_start = AxisPositions::Zero())
      : touches_(std::move(touches)), q_M_(q_M_start) {}

  Result<AxisPositions, machine::MachineFault> move(const machine::LinearMove& move) override {
    log_.push_back(line("move", move));
    ends_.push_back(move.ends);
    contour_controls_.push_back(move.contour_control);
    if (move.traverse == machine::Traverse::Rapid) {
      rapid_paths_.push_back(move.rapid_path);
    }
    q_M_ = move.q_M_end;
    return q_M_;
  }

  Result<AxisPositions, machine::MachineFault> move(const machine::ArcMove& arc) override {
    log_.push_back(fmt::format(
        "arc {}{} centre {}{} {}{} F{:.6g}", arc.turn == machine::Turn::Clockwise ? "cw" : "ccw",
        axes(arc.q_M_end), letter(arc.first_axis), three_decimals(arc.centre_first),
        letter(arc.second_axis), three_decimals(arc.centre_second), arc.feed_mm_min));
    ends_.push_back(arc.ends);
    contour_controls_.push_back(arc.contour_control);
    q_M_ = arc.q_M_end;
    return q_M_;
  }

  Result<machine::SkipOutcome, machine::MachineFault> move_until_skip(
      const machine::SkipMove& move) override {
    log_.push_back(line("skip", move.way));
    if (next_ == touches_.size()) {
      q_M_ = move.way.q_M_end;
      return machine::SkipOutcome(machine::NoTouch{});
    }
    q_M_ = touches_[next_++];
    return machine::SkipOutcome(machine::Touched{q_M_, q_M_, std::nullopt});
  }

  /// No signal is on, and nothing is wired.
  [[nodiscard]] bool skip_signal(int /*input*/) const override { return false; }
  [[nodiscard]] std::optional<machine::SensorState> sensor_state(int /*input*/) const override {
    return std::nullopt;
  }
  [[nodiscard]] std::optional<bool> digital_input(int /*number*/) const override {
    return std::nullopt;
  }

  [[nodiscard]] std::optional<double> displacement(int /*input*/) const override { return {}; }

  void change_tool(const machine::ToolChange& change) override {
    commands_.push_back(fmt::format("tool {} L{:.6g} R{:.6g}", change.tool.number,
                                    change.tool.length_mm, change.tool.radius_mm));
  }
  void turn_spindle(const machine::SpindleTurn& turn) override {
    if (turn.angle_deg) {
      log_.push_back(fmt::format("orient {:.6g}", *turn.angle_deg));
      return;
    }
    const char* const way = turn.rotation == machine::Rotation::Stopped     ? "stop"
                            : turn.rotation == machine::Rotation::Clockwise ? "cw"
                                                                            : "ccw";
    commands_.push_back(fmt::format("spindle {} {} {:.6g}", turn.spindle, way, turn.speed_rev_min));
  }
  void auxiliary_code(const machine::AuxiliaryCode& code) override {
    commands_.push_back(fmt::format("M{}", code.number));
  }
  void digital_output(const machine::DigitalOutput& output) override {
    commands_.push_back(fmt::format("output {} {}", output.number, output.is_on ? "on" : "off"));
  }

  // Nothing passes on, lags or is wrong.
  [[nodiscard]] std::string stands_inside() const override { return {}; }
  void stand_still() override {}
  void come_to_rest() override {}
  machine::MaybeFault take_late_fault() override { return std::nullopt; }
  [[nodiscard]] machine::AxisData axis_data() const override { return {}; }
  void set_axis_data(const machine::AxisData& /*data*/) override {}
  void compensate(const std::vector<machine::CompensationTable>& /*tables*/) override {}

  void dwell(double seconds) override { log_.push_back(fmt::format("dwell {:.6g}", seconds)); }

  [[nodiscard]] std::optional<machine::AxisTravel> travel(int /*axis*/) const override {
    return machine::AxisTravel{-1000.0, 1000.0};
  }
  [[nodiscard]] AxisPositions position() const override { return q_M_; }
  [[nodiscard]] double time_s() const override { return 0.0; }

  [[nodiscard]] const std::vector<std::string>& log() const { return log_; }
  /// What moves nothing, in order: "tool 5 L100 R8", "spindle 1 cw 3000", "M80".
  [[nodiscard]] const std::vector<std::string>& commands() const { return commands_; }
  /// How the moves and arcs of the log end, in order; skip moves and dwells are not counted.
  [[nodiscard]] const std::vector<machine::BlockEnd>& ends() const { return ends_; }
  /// How the control plans their speed.
  [[nodiscard]] const std::vector<machine::ContourControl>& contour_controls() const {
    return contour_controls_;
  }
  /// The ways of the rapids of the log, in order.
  [[nodiscard]] const std::vector<machine::RapidPath>& rapid_paths() const { return rapid_paths_; }

 private:
  static std::string line(const char* verb, const machine::LinearMove& move) {
    return verb + axes(move.q_M_end) +
           (move.traverse == machine::Traverse::Rapid ? std::string(" rapid")
                                                      : fmt::format(" F{:.6g}", move.feed_mm_min));
  }

  static std::string axes(const AxisPositions& q_M) {
    std::string text;
    for (std::size_t i = 0; i < kAxisCount; ++i) {
      const std::string number = three_decimals(q_M[static_cast<Eigen::Index>(i)]);
      if (i < 3) {
        text += " " + number;
      } else if (number != "0.000") {
        text += fmt::format(" {}{}", kAxisLetters[i], number);
      }
    }
    return text;
  }

  static char letter(int axis) { return kAxisLetters[static_cast<std::size_t>(axis)]; }

  static std::string three_decimals(double number) {
    std::string text = fmt::format("{:.3f}", number);
    return text == "-0.000" ? "0.000" : text;
  }

  std::vector<AxisPositions> touches_;
  std::size_t next_ = 0;
  AxisPositions q_M_;
  std::vector<std::string> log_;
  std::vector<std::string> commands_;
  std::vector<machine::BlockEnd> ends_;
  std::vector<machine::ContourControl> contour_controls_;
  std::vector<machine::RapidPath> rapid_paths_;
};

}  // namespace g31::testing
