#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>

#include "interpreter/path/cutter_compensation.h"
#include "interpreter/runtime/overloaded.h"

namespace g31::path::testing {

using machine::Turn;
using State = CompensationCommand::State;

/// Feeds a compensation in the XY plane block by block and keeps what comes out; a block's number
/// is the begin of its place.
class PathDriver {
 public:
  explicit PathDriver(const PlanePoint& from, const CompensationRules& rules = {}) {
    compensation_.set_rules(rules);
    AxisPositions q_M = AxisPositions::Zero();
    q_M.head<2>() = from;
    q_M_ = q_M;
    compensation_.engage(q_M, OffsetPlane{});
  }

  /// D of the blocks from here on; > 0 is G41.
  PathDriver& offset(double offset) {
    command_.state = State::On;
    command_.offset = offset;
    return *this;
  }
  PathDriver& off() {
    command_.state = State::Off;
    return *this;
  }
  PathDriver& line(double x, double y) { return take({x, y}, std::nullopt, 1); }
  PathDriver& rapid(double x, double y) { return take({x, y}, std::nullopt, 0); }
  PathDriver& left_arc(double x, double y, double centre_x, double centre_y) {
    return take({x, y}, ArcShape{{centre_x, centre_y}, Turn::Counterclockwise}, 3);
  }
  PathDriver& right_arc(double x, double y, double centre_x, double centre_y) {
    return take({x, y}, ArcShape{{centre_x, centre_y}, Turn::Clockwise}, 2);
  }
  PathDriver& height(double z) {
    q_M_[2] = z;
    return take(q_M_.head<2>(), std::nullopt, 1);
  }
  PathDriver& pause(double seconds) { return keep(compensation_.pass(Pause{seconds}, here())); }
  PathDriver& idle() { return keep(compensation_.pass(std::nullopt, here())); }
  PathDriver& renewed() {
    CompensationCommand command = here();
    command.written = CompensationCommand::Written::Here;
    return keep(compensation_.pass(std::nullopt, command));
  }
  PathDriver& plane(OffsetPlane plane) {
    command_.plane = plane;
    return *this;
  }
  PathDriver& flush() { return keep(compensation_.flush()); }

  [[nodiscard]] const PathItems& items() const { return items_; }
  [[nodiscard]] const std::optional<CompensationFault>& fault() const { return fault_; }
  [[nodiscard]] const CutterCompensation& compensation() const { return compensation_; }

  /// One item a text: "G1 10.0000 2.0000", Z where it is not 0, the centre of an arc, "P 0.5".
  [[nodiscard]] std::vector<std::string> text() const {
    std::vector<std::string> lines;
    for (const PathItem& item : items_) {
      lines.push_back(std::visit(
          runtime::Overloaded{[](const Pause& pause) { return fmt::format("P {}", pause.seconds); },
                              [](const PathBlock& block) { return of(block); }},
          item));
    }
    return lines;
  }

 private:
  static std::string of(const PathBlock& block) {
    const auto number = [](double value) { return fmt::format(" {:.4f}", value + 0.0); };
    std::string line =
        fmt::format("G{}", block.g) + number(block.q_M_end[0]) + number(block.q_M_end[1]);
    if (block.q_M_end[2] != 0.0) {
      line += " Z" + number(block.q_M_end[2]).substr(1);
    }
    if (block.arc) {
      line += " about" + number(block.arc->centre.x()) + number(block.arc->centre.y());
    }
    return line;
  }

  CompensationCommand here() {
    command_.where.begin = blocks_;
    ++blocks_;
    return command_;
  }
  PathDriver& take(const PlanePoint& to, std::optional<ArcShape> arc, int g) {
    const CompensationCommand command = here();
    q_M_.head<2>() = to;
    return keep(compensation_.take({q_M_, arc, g, g == 0 ? 0.0 : 100.0, command.where}, command));
  }
  PathDriver& keep(const CompensationResult& result) {
    if (!result) {
      fault_ = fault_ ? fault_ : result.error();
      return *this;
    }
    items_.insert(items_.end(), result.value().begin(), result.value().end());
    return *this;
  }

  CutterCompensation compensation_;
  CompensationCommand command_;
  AxisPositions q_M_ = AxisPositions::Zero();
  PathItems items_;
  std::optional<CompensationFault> fault_;
  std::size_t blocks_ = 0;
};

}  // namespace g31::path::testing
