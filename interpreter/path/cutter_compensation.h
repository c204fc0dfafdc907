#pragma once

#include <optional>
#include <vector>

#include "interpreter/path/corner.h"
#include "interpreter/path/path_block.h"
#include "machine/base/result.h"

namespace g31::path {

/// What a control says about the compensation.
struct CompensationRules {
  StartUp start_up = StartUp::TypeA;
  /// How many blocks without motion in the plane the control reads past.
  int idle_limit = 1;
  double minute_mm = 0.0;  ///< of corners
  /// Whether straight blocks that would lead backwards are looked for.
  enum class InterferenceCheck { On, Off } check = InterferenceCheck::On;
  OutsideCorner outside = OutsideCorner::Lines;
  /// What the feed of a programmed arc counts along.
  enum class ArcFeed { AtTool, AtContour, AtContourInside } arc_feed = ArcFeed::AtTool;

  bool operator==(const CompensationRules&) const = default;
};

/// What a block commands: G40, or G41 or G42 and D, in the plane in force.
struct CompensationCommand {
  enum class State { Off, On } state = State::Off;
  OffsetPlane plane;
  double offset = 0.0;  ///< mm, positive to the left of the direction of travel
  /// Whether G41 or G42 is written in this very block.
  enum class Written { Before, Here } written = Written::Before;
  source::Location where;

  bool operator==(const CompensationCommand&) const = default;
};

enum class CompensationError {
  NoIntersection,
  StartOrEndWithinArc,  ///< of an outside corner that the tool would have to touch from inside
  ArcAtStartOrEnd,
  PlaneChanged,
  ArcWithoutRadius,  ///< the offset arc is a point
  Interference,      ///< the tool would go backwards, or does not fit into an arc
};

struct CompensationFault {
  CompensationError error;
  source::Location where;   ///< the block that cannot be compensated
  std::uint64_t calls = 0;  ///< PathBlock::calls of that block
};

using CompensationResult = Result<PathItems, CompensationFault>;

/// Cutter radius compensation (G40, G41, G42) with one block of motion read ahead.
///
/// Fed with programmed blocks in machine coordinates, it gives back what the machine is to do.  A
/// block waits until the next motion in the plane shows how its end lies; moves of other axes and
/// pauses between the two wait with it and are done at the first point of the corner.  Corner lines
/// belong to the block behind the corner: its axes outside the plane, its feed.  When nothing can
/// be read ahead the block ends at the point beside its end.
///
/// Pure geometry: it knows neither the machine nor the program.
class CutterCompensation {
 public:
  void set_rules(const CompensationRules& rules) { rules_ = rules; }

  /// Whether blocks must come through here; otherwise they go to the machine as they are.
  [[nodiscard]] bool engaged() const { return mode_ != Mode::Off; }

  /// G41 or G42 is in force from now on, the axes standing at q_M; the next motion starts up.
  void engage(const AxisPositions& q_M, OffsetPlane plane);

  /// From now on blocks go past here; nothing may wait.
  void disengage() { mode_ = Mode::Off; }

  /// A block of motion.
  CompensationResult take(const PathBlock& block, const CompensationCommand& command);

  /// A block without motion: a pause, or nothing that the machine would do.
  CompensationResult pass(std::optional<Pause> pause, const CompensationCommand& command);

  /// Nothing more can be read ahead: whatever waits is given out.
  CompensationResult flush();

  /// How many blocks without motion in the plane stand behind the last one with it.
  [[nodiscard]] int idle_blocks() const { return idle_; }

  /// Where the tool stands, were nothing more to be read.
  [[nodiscard]] AxisPositions position() const;

  bool operator==(const CutterCompensation&) const = default;

 private:
  enum class Mode {
    Off,
    Starting,  ///< G41 or G42 is in force, no motion yet
    On,
    Leaving,  ///< G40 came alone: the next motion in the plane leads back to the path
  };
  enum class Role { StartUp, Normal, Cancel };

  /// A block whose end waits for the next one.
  struct Held {
    PathBlock block;
    PlaneWay way;
    Role role = Role::Normal;
    double offset = 0.0;
    CornerPoints start;  ///< points of the corner in front of it that are still to be passed
    std::optional<ArcShape> start_arc;  ///< the way to the first of them, if it is no line

    bool operator==(const Held&) const = default;
  };
  struct Join {
    CornerPoints points;
    std::optional<ArcShape> arc;  ///< from the first to the second
  };

  std::optional<CompensationFault> take_in_plane(const PathBlock& block,
                                                 const CompensationCommand& command);
  std::optional<CompensationFault> idle(std::optional<PathItem> item,
                                        const CompensationCommand& command);
  std::optional<CompensationFault> finish_held(Join end);
  std::optional<CompensationFault> clear_interference(Join& end);
  std::optional<CompensationFault> end_beside();
  [[nodiscard]] Held prepared(const PathBlock& block, const CompensationCommand& command) const;
  [[nodiscard]] Result<Join, CompensationError> join(const Held& behind) const;
  [[nodiscard]] double contour_feed() const;
  [[nodiscard]] bool plane_changed(const CompensationCommand& command) const;
  void give_corner_lines();
  void give_path(const PlanePoint& end);
  void give_at_tool(PathItem item);
  CompensationResult given(const std::optional<CompensationFault>& fault);

  CompensationRules rules_;
  Mode mode_ = Mode::Off;
  OffsetPlane plane_;
  AxisPositions q_M_path_ = AxisPositions::Zero();  ///< programmed
  AxisPositions q_M_tool_ = AxisPositions::Zero();  ///< given out so far
  std::optional<Held> held_;
  PathItems between_;                   ///< behind held_, without motion in the plane
  int idle_ = 0;                        ///< blocks without motion in the plane behind held_
  CornerPoints corner_;                 ///< what the last block left of its corner for the next one
  std::optional<ArcShape> corner_arc_;  ///< the way to its first point
  PathItems given_;
};

}  // namespace g31::path
