#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/dialects/sinumerik/code/globals.h"
#include "interpreter/dialects/sinumerik/state/block_words.h"
#include "interpreter/dialects/sinumerik/state/channel_state.h"
#include "interpreter/dialects/sinumerik/state/compensation_data.h"
#include "interpreter/dialects/sinumerik/state/failure.h"
#include "interpreter/dialects/sinumerik/state/frame.h"
#include "interpreter/dialects/sinumerik/state/motion_data.h"
#include "interpreter/dialects/sinumerik/state/tool_lengths.h"
#include "interpreter/dialects/sinumerik/state/transformation_data.h"
#include "interpreter/dialects/sinumerik/vocabulary/g_codes.h"
#include "interpreter/dialects/sinumerik/vocabulary/system_variables.h"
#include "interpreter/dialects/sinumerik/vocabulary/words.h"
#include "interpreter/path/outlet.h"
#include "interpreter/runtime/block_watch.h"
#include "interpreter/runtime/input_scripts.h"
#include "interpreter/runtime/observer.h"
#include "interpreter/runtime/warnings.h"
#include "machine/kinematics/transformation.h"
#include "machine/port/machine_port.h"
#include "machine/units/length_unit.h"

namespace g31::sinumerik {

/// Plane by storage indices; `normal` is the infeed axis.
struct Plane {
  int first = 0;
  int second = 1;
  int normal = 2;
};

/// One channel of the control: its state, what machine data and frames in force make of it, and
/// what it works with.
class Channel : public ChannelState {
 public:
  Channel(machine::MachinePort& machine, runtime::Observer& listener, const Globals& globals);

  // Modal state
  [[nodiscard]] Plane plane() const;
  /// Of the lengths in a block's words: inches with G70 and G700.
  [[nodiscard]] double mm_per_length() const;
  [[nodiscard]] double mm_per_feed() const;
  /// Of the lengths that a program reads and writes as data: system variables, machine data, tools,
  /// settable frames.  Inches with G700; G70 leaves them in the basic system, which is metric.
  /// Source: Basic Functions 09/2011 (6FC5397-0BP40-2BA0), G2 7.3 page 341; Fundamentals, table of
  /// what G70 and G700 act on.
  [[nodiscard]] double mm_per_datum() const;
  /// What one unit of a machine or setting datum, as programs count it, is in the unit that it is
  /// kept in.
  /// @param axis  that it is of, if it is of one
  [[nodiscard]] double kept_per_datum(DatumUnit unit, std::optional<int> axis) const;
  /// MD20100: the axis that DIAMON counts in diameters; -1: its name is none of an axis.
  [[nodiscard]] int transverse_axis() const;
  /// How a length axis counts, a number of group 29: DIAMONA of its own, or DIAMON of the channel.
  [[nodiscard]] int diameter_code(int axis) const;
  /// A coordinate as a word of a block has it, in mm or degrees.
  [[nodiscard]] double stored(int axis, double value) const;
  enum class Counts { Absolute, Incremental };
  /// The same in the work coordinate system, where DIAMON counts, unless DAC and its kind say.
  [[nodiscard]] double stored_place(int axis, double value, Counts counts,
                                    Modification modification) const;
  /// A coordinate as a datum, in mm or degrees; and back.
  [[nodiscard]] double stored_datum(int axis, double value) const;
  [[nodiscard]] double shown_datum(int axis, double value) const;
  /// The same in the work coordinate system, where DIAMON counts.
  [[nodiscard]] double shown_place(int axis, double value) const;
  /// A frame's component as a datum: shifts are lengths.
  [[nodiscard]] double shown_component(int axis, Component component, const Frame& frame) const;
  [[nodiscard]] MaybeFailure set_component(int axis, Component component, double value,
                                           Frame& frame) const;

  // Frames
  static constexpr int kSettableFrames = 100;  ///< 0 is G500
  [[nodiscard]] int settable_number() const { return group[Group::SettableFrame] - 1; }
  /// G500 to G599, programmed or restored: the stored frames come into force.
  void take_stored_frames() {
    settable_now = settable[static_cast<std::size_t>(settable_number())];
    const FrameSet::BaseMasks masks = frames_now.masks;
    frames_now = stored_frames;
    frames_now.masks = masks;  // which of them count G500 to G599 do not say
    frame_written();
  }
  /// A basic or system frame is another one now.
  void frame_written() {
    chains_.reset();
    frames_changed();
  }
  /// All outside of the settable frame.
  [[nodiscard]] const Frame& frames_outside() const { return chains().outer; }
  /// MD28081 and MD18602: how many basic frames there are.
  [[nodiscard]] double base_frames() const { return numbers[base_frames_]; }
  [[nodiscard]] double global_base_frames() const { return numbers[global_base_frames_]; }
  /// MD10617 bit 0: SAVE restores the settable frame, too.
  [[nodiscard]] bool keeps_settable_frame() const;
  /// $MA_POS_LIMIT_PLUS and $MA_POS_LIMIT_MINUS
  [[nodiscard]] AxisPositions upper_soft_limits() const;
  /// MD33100, mm: how far G642 may round an axis off its corner.
  [[nodiscard]] double rounding_tolerance(int axis) const;
  [[nodiscard]] AxisPositions lower_soft_limits() const;
  /// MD51740 bit 14, SD55700: how far two probes that measure at once may go on behind the first
  /// signal, mm; nullopt: as far as the block goes.
  [[nodiscard]] std::optional<double> simultaneous_limit() const;
  /// Whether > and < make a difference where == makes none ($MN_PROG_FUNCTION_MASK).
  [[nodiscard]] bool orders_exactly() const;
  /// All frames but the programmable one, outermost first.
  [[nodiscard]] Frame frames_below() const;
  /// All frames in force, outermost first.
  [[nodiscard]] Frame active_frame() const;
  /// Another point of the tool is led from now on; the program stands where it stood.
  void offset_changed() {
    placement_.reset();
    transformation_.reset();
    leads_.reset();
    path_turn_is_old_ = true;
    q_M_of_path_.reset();
  }
  /// Something changed that positions depend on: work coordinates are to be asked for again.
  void frames_changed() {
    programmed_place.is_stale = true;
    offset_changed();
  }

  // Tools
  [[nodiscard]] const EdgeData* active_edge() const { return edge_now ? &*edge_now : nullptr; }
  /// mm, wear included; 0 without an edge
  [[nodiscard]] double tool_radius() const;
  [[nodiscard]] LengthRules length_rules() const;
  /// mm, wear and adapter included, radii across the spindle; 0 without an edge
  [[nodiscard]] ToolLengths tool_lengths() const;
  /// mm: from the tip to the adapter, as the data of the active edge have it.  G41 and G42 lead the
  /// centre of a turning tool's nose, other motions its theoretical tip.
  [[nodiscard]] AxisPositions edge_offset() const;
  /// mm: what it adds to the machine coordinates without TRAORI: turned by a tool carrier.
  [[nodiscard]] AxisPositions tool_offset() const;

  // Rotary axes
  /// SD42974: fine offsets of carriers act.
  [[nodiscard]] bool carriers_have_fine_offsets() const { return numbers[carrier_fine_] != 0.0; }
  /// MD18088: how many there may be.
  [[nodiscard]] double most_carriers() const { return numbers[most_carriers_]; }
  /// TRAORI with the tool in force; nullptr: it is off.  It stays where it is as long as the
  /// channel.
  [[nodiscard]] const machine::Transformation* transformation() const;
  /// The same as what leads the axes along a path, whose coordinates are its base coordinates;
  /// null: it is off.
  [[nodiscard]] const machine::AxisTransformPtr& leads() const;
  /// How the basic coordinates are turned in the machine: with TRAORI as the table turns the part.
  [[nodiscard]] Eigen::Matrix3d turn_of_part(const AxisPositions& q_M) const;
  /// The direction from the tip to the holder in the basic coordinates, the axes at q_M.
  [[nodiscard]] Eigen::Vector3d tool_direction(const AxisPositions& q_M) const;
  /// Where the tool's side that looks along the plane's 1st axis, with the rotary axes at 0, looks;
  /// basic coordinates.
  [[nodiscard]] Eigen::Vector3d tool_side(const AxisPositions& q_M) const;
  /// nullptr: no such tool, or no such edge
  Tool* find_tool(int number);
  Tool* tool_to_write(int number);
  EdgeData* find_edge(int number, int which);

  // Positions, mm and degrees
  [[nodiscard]] AxisPositions to_machine(const AxisPositions& q_W) const;
  [[nodiscard]] AxisPositions to_work(const AxisPositions& q_M) const;
  /// Between the tip within all frames and the axes.
  [[nodiscard]] AxisPositions to_basic(const AxisPositions& q_M) const;
  // Paths are planned in coordinates of their own (P): those of the machine; with TRAORI the place
  // of the tip in the part, turned as the frames were where the path began, so that the plane of
  // the program is a plane of two of them.
  [[nodiscard]] AxisPositions to_path(const AxisPositions& q_W) const;
  [[nodiscard]] AxisPositions path_to_work(const AxisPositions& q_P) const;
  [[nodiscard]] AxisPositions path_to_basic(const AxisPositions& q_P) const;
  [[nodiscard]] AxisPositions machine_to_path(const AxisPositions& q_M) const;
  [[nodiscard]] AxisPositions path_to_machine(const AxisPositions& q_P) const;
  /// How they are turned in the basic coordinates.
  [[nodiscard]] const Eigen::Matrix3d& path_turn() const;
  /// Where the axes stand, in work coordinates: what an axis that is not programmed keeps.
  AxisPositions present();
  /// The end that the program wrote last: what incremental words count from.
  [[nodiscard]] const AxisPositions& programmed() const { return programmed_place.q_W; }
  /// The same place in work coordinates and in those of paths.
  void arrived_at_programmed(const AxisPositions& q_W, const AxisPositions& q_P);
  void arrived_at_machine();
  /// The same as machine_position() in the coordinates of paths.
  [[nodiscard]] AxisPositions path_position() const;
  /// Where the program has the axes: with a block that waits for the next one as if it were done.
  [[nodiscard]] AxisPositions machine_position() const;

  /// MD30310: a rotary axis that goes round, whose places are 0 to 360.
  [[nodiscard]] bool is_modulo(int axis) const;
  /// Bits of MD30455, of modulo axes.
  enum class AxisFunction { TakesAnyPlace = 0, ShorterWay = 2 };
  [[nodiscard]] bool has_axis_function(int axis, AxisFunction function) const;
  /// A place as programs see it: of a modulo axis from 0 on, below 360.
  [[nodiscard]] double within_turn(int axis, double degrees) const;

  // Motion
  MotionData motion_data;
  CompensationData compensation_data;
  TransformationData transformation_data;
  /// MD22550: T brings the tool, as on a turret, else M6 does.
  [[nodiscard]] bool changes_with_t() const { return numbers[tool_change_mode_] == 0.0; }
  /// As machine data want it at the start of a program.
  void preset_rapids();
  /// The same of the G groups whose codes MD20150 gives; on a lathe G18 in the place of G17.
  void preset_codes();
  /// A machine with X and without Y, or one whose MD52200 is 1.
  [[nodiscard]] bool is_lathe() const;
  /// MD35000: the rotary axis that a spindle is when it is positioned; nullopt: none.
  [[nodiscard]] std::optional<int> axis_of_spindle(int spindle_number) const;
  /// Data of that axis that limit the speed of the spindle.
  enum class SpeedDatum {
    OfMachine,  ///< MD35100
    OfG26,      ///< SD43220
    OfLims      ///< SD43230: under G96, G961 and G97
  };
  /// rev/min, once the datum is written; before, and of a spindle that is no axis, without limit.
  [[nodiscard]] double speed_limit(SpeedDatum datum, int spindle_number) const;
  /// The program says a limit.  @returns whether there is a datum that keeps it
  bool keep_speed_limit(SpeedDatum datum, int spindle_number, double speed);
  [[nodiscard]] int master_number() const { return static_cast<int>(master_spindle); }
  /// SETMS: words without the number of a spindle are of this one from now on.
  void make_master(int spindle_number);
  /// As the machine knows a spindle: kToolSpindle turns the tools.
  [[nodiscard]] int port_spindle(int spindle_number) const;
  /// The way of G0: RTLIOF acts in exact stop alone, and neither compensated nor compressed.
  /// Source: SINUMERIK ONE programming, 6FC5398-2EP40, RTLION and RTLIOF.
  [[nodiscard]] machine::RapidPath rapid_path() const;
  /// nullptr: the machine has it not
  [[nodiscard]] const FurtherAxis* further(int axis) const {
    const auto found = further_axes.find(axis);
    return found != further_axes.end() ? &found->second : nullptr;
  }

  // Outside world
  /// How far the program is, for what happens after a while.
  [[nodiscard]] runtime::InputScripts::Now now() const { return {port.time_s(), watch.blocks()}; }
  /// Where the program is, for reports from inside an expression.
  std::function<source::Location()> here;
  std::function<source::Location()> shown_block;  ///< of an alarm: behind DISPLOF the call
  std::vector<source::Diagnostic> diagnostics;
  runtime::Warnings warnings;  ///< which of them are of blocks
  runtime::BlockWatch watch{runtime::Budget{}};
  /// A value is looked at from outside the program: nothing moves for it.
  [[nodiscard]] bool is_inspected() const { return touches.is_inspected(); }
  machine::MachinePort& port;
  runtime::Observer& observer;
  path::Outlet outlet;

 private:
  /// What turns work coordinates into those of the machine.
  struct Placement {
    Frame frame;
    AxisPositions offset;
  };

  [[nodiscard]] const Placement& placement() const;

  /// What basic and system frames make together.
  struct Chains {
    Frame outer;
    Frame inner;
  };
  [[nodiscard]] const Chains& chains() const;
  /// A direction of the tool with the rotary axes at 0, as they have turned it.
  [[nodiscard]] Eigen::Vector3d tool_turned(const AxisPositions& q_M,
                                            const Eigen::Vector3d& upright) const;
  /// The angles of both axes of TRAORI.
  [[nodiscard]] std::array<double, 2> angles_of(const AxisPositions& q_M) const;

  /// Place of a datum of the axis that a spindle is.
  [[nodiscard]] std::optional<std::size_t> place_of(SpeedDatum datum, int spindle_number) const;
  /// Place of a group's element of MD20150.
  [[nodiscard]] std::size_t code_at_start(Group one) const;

  std::size_t frame_save_mask_;                 ///< place of MD10617
  std::size_t program_function_mask_;           ///< place of MD10280
  std::size_t upper_soft_limits_;               ///< place of MD36110
  std::size_t lower_soft_limits_;               ///< place of MD36100
  std::size_t rounding_tolerances_;             ///< place of MD33100
  std::size_t base_frames_;                     ///< place of MD28081
  std::size_t global_base_frames_;              ///< place of MD18602
  std::size_t rotary_is_modulo_;                ///< place of MD30310
  std::size_t axis_function_masks_;             ///< place of MD30455
  std::size_t measuring_mask_;                  ///< place of MD51740
  std::size_t simultaneous_limit_;              ///< place of SD55700
  std::size_t rapids_are_straight_;             ///< place of MD20730
  std::size_t codes_at_start_;                  ///< place of MD20150
  std::size_t technology_;                      ///< place of MD52200
  std::size_t tool_parameter_mask_;             ///< place of MD20360
  std::size_t length_plane_;                    ///< place of SD42940
  std::size_t turning_length_plane_;            ///< place of SD42942
  std::size_t length_kind_;                     ///< place of SD42950
  std::size_t spindles_of_axes_;                ///< place of MD35000
  std::array<std::size_t, 3> speed_limits_;     ///< places of MD35100, SD43220 and SD43230
  std::size_t tool_change_mode_;                ///< place of MD22550
  std::size_t diameter_axis_;                   ///< place of MD20100, among the texts
  std::size_t carrier_fine_;                    ///< place of SD42974
  std::size_t most_carriers_;                   ///< place of MD18088
  mutable std::optional<Chains> chains_;        ///< kept until one of them is written
  mutable std::optional<Placement> placement_;  ///< kept while nothing is suppressed
  mutable std::optional<machine::Transformation> transformation_;  ///< kept while the tool is
  mutable machine::AxisTransformPtr leads_;                        ///< made of it
  mutable Eigen::Matrix3d path_turn_ = Eigen::Matrix3d::Identity();
  mutable bool path_turn_is_old_ = true;  ///< the frames are others than when it was made
  mutable AxisPositions q_P_here_ = AxisPositions::Zero();  ///< with TRAORI: where the axes stand
  mutable std::optional<AxisPositions> q_M_of_path_;        ///< the same; nullopt: not known
  /// A block waits for the next one, or the contour is only read: the axes are not where the
  /// program is.
  [[nodiscard]] bool holds_path() const {
    return noted_contour || cutter.compensation.engaged() || corners.contour.holds();
  }
};

}  // namespace g31::sinumerik
