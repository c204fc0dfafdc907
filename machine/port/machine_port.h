#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "machine/base/rare.h"
#include "machine/base/result.h"
#include "machine/port/axis_data.h"
#include "machine/port/axis_transform.h"
#include "machine/port/contact.h"
#include "machine/port/machine_events.h"
#include "machine/port/skip_signal.h"
#include "machine/units/axis_positions.h"

namespace g31::machine {

enum class Traverse { Rapid, Feed };

/// The way of a rapid.
enum class RapidPath {
  Straight,    ///< all axes arrive together
  Independent  ///< each axis goes at its own rapid rate: a curve that bends as axes arrive
};

/// When a control goes on to the next block.
enum class BlockEnd {
  ExactStop,    ///< once the axes have followed to the end (G61, G09, rapids of most controls)
  CoarseStop,   ///< the same within the wider window (G602)
  CommandStop,  ///< once the command stands; what lags behind it passes the corner (G603)
  PassOn        ///< without a stop, as fast as corners allow; lagging axes round them (G64)
};

/// How a control smooths the speed of a move.
struct Smoothness {
  bool limits_jerk = true;  ///< false: the acceleration steps, whatever jerk axes have (BRISK)
  /// mm: so far a curve may leave the corner to the move before; the speed there is that of such a
  /// curve (compressors).  The way stays that of the moves.
  double corner_tolerance = 0.0;

  bool operator==(const Smoothness&) const = default;
};

/// How a control plans the speed of moves at feed that pass on.  Axes that follow at once show no
/// difference: theirs is planned in any case.
enum class ContourControl {
  Off,          ///< each move keeps its feed; what smooths it comes after the interpolation
  LookAhead,    ///< before the interpolation: slowed to what corners and accelerations allow
  FeedForward,  ///< the same, and the axes are driven by the speed of their command, too
};

/// What the caller knows a move by; a fault that comes late brings it back.
using MoveTag = std::array<std::uint64_t, 3>;

/// A move of all axes to an end point: straight, unless it is a rapid of each axis on its own or a
/// transformation leads it.
struct LinearMove {
  AxisPositions q_M_end = AxisPositions::Zero();  ///< mm and deg, machine coordinates
  Traverse traverse = Traverse::Rapid;
  double feed_mm_min = 0.0;  ///< > 0 with Traverse::Feed; a rapid takes the machine's own rates
  BlockEnd ends = BlockEnd::ExactStop;
  /// What a degree counts for in the length that the feed covers, mm.  0: the feed is that of X Y Z
  /// where they move, else one in degrees.
  double mm_per_degree = 0.0;
  RapidPath rapid_path = RapidPath::Straight;  ///< with Traverse::Rapid
  ContourControl contour_control = ContourControl::Off;
  MoveTag tag = {};
  /// Leads the axes: the way is straight in its base coordinates, rapids too, and the feed that of
  /// the way there.
  AxisTransformPtr transform = {};
  Smoothness smoothness = {};
};

/// How far an axis may go; mm and deg, machine coordinates.
struct AxisTravel {
  double min = 0.0;
  double max = 0.0;
};

enum class Turn { Clockwise, Counterclockwise };

/// An arc at feed in the plane of two linear axes; the other axes go along in proportion (helix).
///
/// Clockwise as seen when first_axis points right and second_axis up.  A start and an end that
/// coincide in the plane make a full circle.  With a transformation all of it but q_M_end is in its
/// base coordinates.
struct ArcMove {
  AxisPositions q_M_end = AxisPositions::Zero();  ///< mm and deg, machine coordinates
  int first_axis = 0;                             ///< storage indices of the plane
  int second_axis = 1;
  double centre_first = 0.0;   ///< mm, machine coordinate of the centre along first_axis
  double centre_second = 0.0;  ///< mm, machine coordinate of the centre along second_axis
  Turn turn = Turn::Clockwise;
  double feed_mm_min = 0.0;  ///< > 0, along the arc
  BlockEnd ends = BlockEnd::ExactStop;
  ContourControl contour_control = ContourControl::Off;
  MoveTag tag = {};
  AxisTransformPtr transform = {};  ///< leads the axes
  Smoothness smoothness = {};
};

/// What the further signal of a move has left.
struct FurtherTouch {
  AxisPositions q_M_latched;
  std::optional<Contact> contact;
};

/// The skip signal came during the move; the axes have stopped past the touch by the overtravel, or
/// gone on to the end.
struct Touched {
  AxisPositions q_M_latched;       ///< what the control stored, trigger delay included
  AxisPositions q_M_stopped;       ///< where the axes came to rest
  std::optional<Contact> contact;  ///< where the ball touched; none for a signal without a part
  int signals = 1;                 ///< more where the probe's signal came several times
  std::optional<FurtherTouch> further = std::nullopt;  ///< of a move that listened to two
};

/// The whole distance was travelled without a signal, or all that a move goes on behind the first
/// of two without the other.
struct NoTouch {
  /// Of a move that listened to two: what the one that gave its signal has left.
  struct Alone {
    bool is_main = true;  ///< that of SkipMove::input; false: the further one
    FurtherTouch touch;
  };
  std::optional<Alone> alone = std::nullopt;
};

/// The signal was already as its edge would leave it when the move was to begin: no edge could
/// come.  Nothing moved.
struct NoEdge {
  std::optional<Contact> contact;
};

/// What the axes do after the signal.
enum class AfterSignal {
  Stop,  ///< the rest of the way is not travelled
  GoOn   ///< the position is latched, the move goes to its end
};

/// A second sensor that the same move waits for, as that of a second spindle beside the first.
struct FurtherSignal {
  int input = 0;  ///< measuring input, from 1
  /// mm: so far behind the first of both signals the move waits for the other one.
  double within_mm = std::numeric_limits<double>::infinity();
  /// Its signal counts only behind that of the other one.
  bool comes_second = false;
};

/// A straight move that listens to the skip signal.
struct SkipMove {
  // Most moves ask for nothing but the way.
  SkipMove(const LinearMove& straight) : way(straight) {}  // NOLINT(google-explicit-constructor)

  LinearMove way;
  int input = kAnyInput;  ///< measuring input it listens to, from 1
  SignalEdge edge = SignalEdge::Rising;
  AfterSignal after = AfterSignal::Stop;
  /// With it the move ends at the later signal, and touches only where both come.  Without a
  /// transformation, AfterSignal::Stop alone.
  std::optional<FurtherSignal> further = std::nullopt;
};

using SkipOutcome = std::variant<Touched, NoTouch, NoEdge>;

enum class FaultKind {
  SoftLimit,
  NoAxis,  ///< one was to move that the machine does not have
  Collision
};

/// Why a machine refused or broke off a move.  The *dialect* turns a soft limit into its own alarm
/// number; a collision ends the run.
struct MachineFault {
  FaultKind kind;
  std::string what;                ///< one line for people: axis and limit, or the bodies
  AxisPositions q_M_at;            ///< where the axes were
  std::optional<Contact> contact;  ///< for a collision: where the bodies met
  /// Of an earlier move, where it was found late; nullopt: of the one that was asked for.
  std::optional<MoveTag> tag = std::nullopt;
};
/// nullopt: the axes went where they were told.
using MaybeFault = Rare<MachineFault>;

/// Everything a running NC program may ask of a machine, and nothing else.
///
/// The interpreter knows only this header.  `machine/sim` implements it with axes and time;
/// `tests/support/recording_machine.h` implements it with a list of lines.
/// Each call completes before the next: look-ahead is the interpreter's business.
class MachinePort {
 public:
  MachinePort() = default;
  MachinePort(const MachinePort&) = delete;
  MachinePort& operator=(const MachinePort&) = delete;
  virtual ~MachinePort() = default;

  /// Moves and returns the reached position (the commanded end).  A move that meets a fault ends
  /// where the fault is.  The fault may be that of an earlier move that passed on (its tag says
  /// which): then nothing of this one is done.
  virtual Result<AxisPositions, MachineFault> move(const LinearMove& move) = 0;

  /// Moves along an arc and returns the reached position (the commanded end).
  virtual Result<AxisPositions, MachineFault> move(const ArcMove& move) = 0;

  /// Moves until the edge of the skip signal (G31, MEAS).  "No touch" is an outcome, not a fault:
  /// whether it is an alarm depends on the dialect and on the program.
  virtual Result<SkipOutcome, MachineFault> move_until_skip(const SkipMove& move) = 0;

  /// Whether the signal of a measuring input is on, the axes standing where they are.
  [[nodiscard]] virtual bool skip_signal(int input) const = 0;

  /// How what is wired to a measuring input is placed to give a signal; nullopt: nothing is there.
  [[nodiscard]] virtual std::optional<SensorState> sensor_state(int input) const = 0;

  /// The digital input of the machine's own wiring; nullopt: nothing is wired to that number.
  [[nodiscard]] virtual std::optional<bool> digital_input(int number) const = 0;

  /// What the displacement sensor of an analog input reads, mm, the axes standing where they are;
  /// nullopt: none is wired to it.
  [[nodiscard]] virtual std::optional<double> displacement(int input) const = 0;

  /// Puts a tool into a spindle.  Takes no time.
  virtual void change_tool(const ToolChange& change) = 0;

  /// The part in whose material a sensing tip is, the axes standing where they are; "": none.
  [[nodiscard]] virtual std::string stands_inside() const = 0;

  /// Starts a spindle, stops it, or stops it at an angle.  Takes no time.
  virtual void turn_spindle(const SpindleTurn& turn) = 0;

  /// An M code that the control has no use for itself.
  virtual void auxiliary_code(const AuxiliaryCode& code) = 0;

  virtual void digital_output(const DigitalOutput& output) = 0;

  /// The program waits until the axes stand, as where it reads what a move leaves: moves that pass
  /// on do so no further.  Without this they wait for the next one.
  virtual void stand_still() = 0;

  /// The program has ended: axes that lag still arrive, which takes no time of the program.
  virtual void come_to_rest() = 0;

  /// The fault of a move that passed on, found where the machine could not return it; once.  Until
  /// somebody has taken it, from here or from the next move, the machine does nothing.
  virtual MaybeFault take_late_fault() = 0;

  /// What holds of the axes until a control says otherwise.
  [[nodiscard]] virtual AxisData axis_data() const = 0;

  /// Holds from the next move on.
  virtual void set_axis_data(const AxisData& data) = 0;

  /// The control corrects places by these tables from now on, and by no other ones.
  virtual void compensate(const std::vector<CompensationTable>& tables) = 0;

  /// Lets simulated time pass.  @param seconds >= 0
  virtual void dwell(double seconds) = 0;

  /// The travel of an axis by its storage index; nullopt: the machine has no such axis.
  [[nodiscard]] virtual std::optional<AxisTravel> travel(int axis) const = 0;

  /// Present position of all axes in machine coordinates, as the control's encoders read it.
  [[nodiscard]] virtual AxisPositions position() const = 0;

  /// Simulated seconds since the start of the program; after moves that pass on as if the axes came
  /// to rest at the end of the last one.
  [[nodiscard]] virtual double time_s() const = 0;
};

}  // namespace g31::machine
