#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "interpreter/dialects/sinumerik/vocabulary/words.h"
#include "interpreter/path/contour_corners.h"
#include "interpreter/path/cutter_compensation.h"
#include "interpreter/source/location.h"
#include "machine/port/skip_signal.h"
#include "machine/units/axis_positions.h"

namespace g31::sinumerik {

/// The axis that DIAMON counts in diameters, and whose work coordinate G96 takes as the radius: X.
inline constexpr int kTransverseAxis = 0;

/// Cutting speeds count in m/min, some machine data in m.
inline constexpr double kMmPerMetre = 1000.0;

/// What programs said about the spindle.
struct Spindle {
  static constexpr int kPositioned = -19;
  static constexpr int kNothingYet = -5;

  double speed = 0.0;          ///< rev/min
  double cutting_speed = 0.0;  ///< m/min, S of G96
  double lowest = 0.0;         ///< rev/min, G25 S and G26 S
  double highest = std::numeric_limits<double>::infinity();
  double limit = std::numeric_limits<double>::infinity();  ///< LIMS: with G96, G961 and G97
  std::optional<double> angle = 0.0;                       ///< degrees; nullopt: it turns
  double override_percent = 100.0;                         ///< OVRA[S1]
  int direction = kNothingYet;    ///< of $P_SDIR: 3, 4, 5 of M3, M4, M5, or one of these two
  bool builder_may_turn = false;  ///< an M code of the builder's came behind its last command

  [[nodiscard]] bool turns() const { return direction == 3 || direction == 4; }
  /// A speed as it turns: with OVRA, within G25 and G26.  @param programmed  > 0
  [[nodiscard]] double limited(double programmed) const {
    return std::clamp(programmed * override_percent / 100.0, std::min(lowest, highest), highest);
  }

  /// Of one that is not the master, with S in rev/min.
  [[nodiscard]] double turning_speed() const {
    return speed == 0.0 ? 0.0 : limited(std::abs(speed));
  }

  bool operator==(const Spindle&) const = default;
};

/// What ends POS of an axis, as $AA_MOTEND shows it.
enum class MotionEnd : std::uint8_t {
  Fine = 1,     ///< FINEA
  Coarse = 2,   ///< COARSEA
  Command = 3,  ///< IPOENDA
  Braking = 4,  ///< IPOBRKA
};

/// What programs set of the axes one by one, and the overrides that they write.
struct AxisSettings {
  AxisSettings() {
    motion_end.fill(MotionEnd::Fine);
    override_percent.fill(100.0);
  }

  std::array<double, kAxisNumbers> feed = {};                  ///< FA, mm/min or deg/min; 0: rapid
  std::array<double, kAxisNumbers> override_percent;           ///< OVRA
  std::array<bool, kAxisCount> counts = {true, true, true};    ///< FGROUP
  AxisPositions mm_per_degree = AxisPositions::Constant(1.0);  ///< FGREF, of rotary axes
  bool counts_as_usual = true;           ///< neither FGROUP nor FGREF was written
  double path_override_percent = 100.0;  ///< OVR
  std::array<MotionEnd, kAxisNumbers> motion_end;
  std::array<int, kAxisNumbers> diameter = {};  ///< DIAMONA: number in group 29; 0: as the channel

  bool operator==(const AxisSettings&) const = default;
};

/// U, V or W: it carries neither tool nor part, so it has a place and takes its time, no more.
struct FurtherAxis {
  double at = 0.0;             ///< mm
  double home = 0.0;           ///< mm, where G74 brings it
  double rapid_per_min = 0.0;  ///< mm/min
  double travel_min = 0.0;     ///< mm
  double travel_max = 0.0;     ///< mm

  bool operator==(const FurtherAxis&) const = default;
};

/// The pole of polar coordinates, and the last ones.
struct Pole {
  AxisPositions q_W = AxisPositions::Zero();
  std::optional<double> angle;   ///< degrees, since the pole was set
  std::optional<double> radius;  ///< mm

  bool operator==(const Pole&) const = default;
};

/// G25 and G26, machine coordinates of the tool tip.
struct WorkingArea {
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  AxisPositions q_low = AxisPositions::Constant(-kFar);
  AxisPositions q_high = AxisPositions::Constant(kFar);
  bool is_set = false;

  bool operator==(const WorkingArea&) const = default;
};

/// Points that the machine's builder has set, machine coordinates.
struct MachinePoints {
  static constexpr int kFixedPoints = sinumerik::kFixedPoints;
  AxisPositions q_M_reference = AxisPositions::Zero();
  std::array<AxisPositions, kFixedPoints> q_M_fixed = {
      AxisPositions::Zero(), AxisPositions::Zero(), AxisPositions::Zero(), AxisPositions::Zero()};

  bool operator==(const MachinePoints&) const = default;
};

/// The end that the program wrote last, or where it was left otherwise.
struct ProgrammedPlace {
  AxisPositions q_W = AxisPositions::Zero();
  AxisPositions q_P = AxisPositions::Zero();  ///< the same place, coordinates of paths
  bool is_stale = false;  ///< work coordinates are others since: q_P alone counts

  bool operator==(const ProgrammedPlace&) const = default;
};

/// WHEN $A_PROBE[n]==level DO DELDTG.
struct SkipAction {
  int probe = 1;
  machine::SignalEdge edge = machine::SignalEdge::Rising;

  bool operator==(const SkipAction&) const = default;
};

/// M0 and M1 at one place while no axis moves.
struct ProgramStops {
  static constexpr int kMost = 1000;
  source::Location place;
  AxisPositions q_M = AxisPositions::Zero();
  int count = 0;

  bool operator==(const ProgramStops&) const = default;
};

/// How RND, CHF and CHR are judged.
inline constexpr path::CornerRules kCornerRules = {
    path::CornerRules::TooLarge::Shrinks, path::CornerRules::ChamferAtArc::Refused, 1e-9, true};

/// F, FB, FRC or FRCM, in the unit that was in force where it stands.  G700 and G710 behind it
/// change nothing of it (Basic Functions 09/2011, 6FC5397-0BP40-2BA0, G2 7.3, page 341).
struct Feed {
  double word = 0.0;      ///< as programmed, a minute or a revolution
  double per_word = 1.0;  ///< mm in one unit of the word; 1 with G93, which counts blocks a minute

  /// mm, or blocks; rotary axes that move alone go by degrees, as the word says.
  [[nodiscard]] double kept() const { return word * per_word; }
  bool operator==(const Feed&) const = default;
};

/// Roundings and chamfers, and what the present block says to them.
struct CornerStage {
  path::ContourCorners contour{kCornerRules};
  path::CornerWish wish;
  double modal_radius_mm = 0.0;    ///< RNDM
  Feed modal_feed;                 ///< FRCM
  double passing_mm = 0.0;         ///< ADIS: where G641 begins to round, at most
  double passing_rapid_mm = 0.0;   ///< ADISPOS: the same of rapids
  double axis_tolerance_mm = 0.0;  ///< ATOL; 0: that of the machine data

  bool operator==(const CornerStage&) const = default;
};

/// A straight line of which a block says only the angle (ANG): its end comes of the next block.
struct HeldLine {
  double degrees = 0.0;                           ///< from the first axis of the plane
  AxisPositions q_W_end = AxisPositions::Zero();  ///< but for the plane
  Feed feed;
  int g = 1;  ///< 0 rapid
  machine::BlockEnd ends = machine::BlockEnd::ExactStop;
  machine::RapidPath rapid_path = machine::RapidPath::Straight;
  path::CornerWish wish;
  path::CompensationCommand command;
  source::Location where;
  std::uint64_t calls = 0;  ///< PathBlock::calls

  bool operator==(const HeldLine&) const = default;
};

/// A contour that is read and not travelled (CONTOUR_NOTE): the program goes along it, the axes
/// stand.
struct NotedContour {
  static constexpr std::size_t kMostWays = 1000;
  AxisPositions q_P = AxisPositions::Zero();  ///< its end so far, coordinates of paths
  std::vector<path::PlaneWay> ways;           ///< mm, work coordinates in the plane

  bool operator==(const NotedContour&) const = default;
};

/// The times that programs read, s; the machine's clock is the measure of all of them.
struct Clocks {
  static constexpr int kTimers = 100;
  struct Timer {
    double value = 0.0;
    std::optional<double> since;  ///< nullopt: it stands
    [[nodiscard]] double at(double now) const { return value + (since ? now - *since : 0.0); }
    bool operator==(const Timer&) const = default;
  };
  std::array<Timer, kTimers> timers;  ///< $AC_TIMER
  /// When the last block of words began.  nullopt: no program that has run so far asks ($AC_TIME),
  /// so no block looks at the clock, which costs more than the block where moves pass on.
  std::optional<double> block_began;
  // What was written to these variables, less the time then.
  double operating_offset = 0.0;
  double cycle_offset = 0.0;
  double cutting_offset = 0.0;
  double setup_offset = 0.0;
  double power_on_offset = 0.0;

  bool operator==(const Clocks&) const = default;
};

/// Tool radius compensation and what the present block says to it.
struct CutterStage {
  path::CutterCompensation compensation;
  path::CompensationCommand command;
  path::CompensationCommand held_command;  ///< of the block that waits for its corner
  bool fed = false;  ///< a motion or pause of the present block has come through

  bool operator==(const CutterStage&) const = default;
};

}  // namespace g31::sinumerik
