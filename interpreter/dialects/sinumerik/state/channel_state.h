#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/dialects/sinumerik/state/frame.h"
#include "interpreter/dialects/sinumerik/state/frame_set.h"
#include "interpreter/dialects/sinumerik/state/motion_state.h"
#include "interpreter/dialects/sinumerik/state/program_files.h"
#include "interpreter/dialects/sinumerik/state/tool_carrier.h"
#include "interpreter/dialects/sinumerik/vocabulary/g_codes.h"
#include "interpreter/dialects/sinumerik/vocabulary/system_variables.h"
#include "interpreter/dialects/sinumerik/vocabulary/words.h"
#include "interpreter/runtime/busy_wait.h"
#include "interpreter/runtime/control_setup.h"
#include "interpreter/runtime/input_scripts.h"
#include "interpreter/runtime/touch_reports.h"

namespace g31::sinumerik {

/// Numbers of $TC_DP.
struct EdgeDatum {
  static constexpr std::size_t kType = 1;
  static constexpr std::size_t kPosition = 2;  ///< of the cutting edge
  static constexpr std::size_t kLength1 = 3;   ///< to 5
  static constexpr std::size_t kRadius = 6;
  static constexpr std::size_t kWear1 = 12;  ///< of lengths, to 14
  static constexpr std::size_t kRadiusWear = 15;
  static constexpr std::size_t kAdapter1 = 21;  ///< lengths, to 23
};

/// $TC_DP1.. of one cutting edge, by EdgeDatum.
using EdgeData = std::array<double, 26>;

struct Tool {
  std::string name;
  double duplo = 1.0;
  double state = 2.0;  ///< bit 1: released
  std::map<int, EdgeData> edges;
  std::map<int, double> teeth;  ///< $TC_DPNT

  /// A datum that is only kept, or that few tools have: $TC_SCPn, $TC_MOPn, $TC_TPn.
  struct Datum {
    SystemId id = SystemId::ToolDatum;
    int edge = 0;  ///< 0: of the tool
    int number = 0;
    friend auto operator<=>(const Datum&, const Datum&) = default;
  };
  std::map<Datum, double> more;
  bool operator==(const Tool&) const = default;
  /// 0: never written
  [[nodiscard]] double datum(const Datum& which) const {
    const auto found = more.find(which);
    return found != more.end() ? found->second : 0.0;
  }
};

/// What programs read and change of a channel, as a plain value: copies are keyframes, and two runs
/// that are alike have equal ones.  Where the axes are and what time it is says the machine.
struct ChannelState {
  // Global variables, by their places.
  std::vector<double> numbers;
  std::vector<std::string> texts;
  std::vector<Frame> frames;

  // Modal state
  GroupNumbers group;
  Feed feed;                              ///< F
  Spindle spindle;                        ///< the master spindle
  std::map<int, Spindle> other_spindles;  ///< by number, all others that programs have named
  AxisSettings axis_settings;
  int joint_position = 0;  ///< STAT
  double master_spindle = 1.0;
  std::optional<int> tool_spindle;  ///< its number, as the sheet says

  // Frames
  /// What the control keeps: $P_UIFR, $P_CHBFR, $P_SETFR and so on.
  std::vector<Frame> settable;
  /// Those that a sheet with settable frames leaves out, until the program writes them: G55 there
  /// is a mistake of the sheet or the program.
  std::set<int> left_out;
  FrameSet stored_frames;
  /// What G500 to G599 took of them when programmed last: $P_IFRAME, $P_CHBFRAME, $P_SETFRAME.
  Frame settable_now;
  FrameSet frames_now;
  Frame program_frame;
  Eigen::Matrix3d tool_turn = Eigen::Matrix3d::Identity();  ///< what TOROT or TOFRAME made of it
  int suppression = 0;  ///< number in group 9 of the running block

  // Tools
  std::map<int, Tool> tools;
  std::optional<int> selected_tool;  ///< the last T; none before the first
  /// A D without a tool while T waits for M6, until the tool comes or the path goes on.
  struct IdleEdge {
    int number = 0;
    source::Location where;

    bool operator==(const IdleEdge&) const = default;
  };
  std::optional<IdleEdge> idle_edge;
  int tool = 0;
  int edge = 0;
  int additive = 0;                         ///< DL
  std::optional<EdgeData> edge_now;         ///< its data when D or M6 took them
  std::array<double, 4> additive_now = {};  ///< mm, what DL added to parameters 3 to 6 of the edge
  std::map<int, ToolCarrier> carriers;      ///< $TC_CARR
  bool knows_tools = false;                 ///< the set-up sheet or an INI file has some
  bool loads_data = false;                  ///< of an INI file: data of a new tool make it
  Orientation orientation;

  // Motion
  Pole pole;
  WorkingArea working_area;
  MachinePoints points;
  std::map<int, FurtherAxis> further_axes;  ///< those of U, V and W that the machine has
  /// TRAILON: following and leading axis to the factor.
  std::map<std::pair<int, int>, double> couplings;
  ProgrammedPlace programmed_place;
  CornerStage corners;
  CutterStage cutter;
  std::optional<HeldLine> held_line;
  std::optional<NotedContour> noted_contour;  ///< nullopt: motions are travelled
  /// Of any length along the end of the last path, coordinates of paths; 0: there was none.
  Eigen::Vector3d along_P_end = Eigen::Vector3d::Zero();

  // Measuring
  static constexpr int kMostProbes = sinumerik::kMostProbes;
  AxisPositions q_M_measured = AxisPositions::Zero();
  AxisPositions q_W_measured = AxisPositions::Zero();
  AxisPositions q_M_second = AxisPositions::Zero();  ///< of the second trigger
  AxisPositions q_W_second = AxisPositions::Zero();
  std::array<bool, kMostProbes + 1> measured = {};  ///< by probe, from 1
  runtime::TouchReports touches;                    ///< of MEAS, MEAW, MEASA and MEAWA
  std::optional<SkipAction> skip_action;            ///< of the next move

  // What synchronised actions make of the running block.
  bool deletes_distance = false;           ///< DELDTG: its path is not travelled
  double action_override_percent = 100.0;  ///< $AC_OVR

  // Time
  Clocks clocks;
  ProgramStops stops;
  runtime::BusyWait busy_wait;

  // Outside world
  ProgramFiles files;                ///< what WRITE, READ and EXTWRITE work on
  std::set<std::string> open_files;  ///< EXTOPEN
  std::string call_path;
  std::string message;       ///< the last MSG
  std::set<int> block_skip;  ///< switches that are on
  runtime::FeedSwitches feed_switches;
  runtime::InputScripts inputs;               ///< of those that the set-up sheet scripts
  std::array<double, 9> analog_inputs = {};   ///< $A_INA, where nothing is wired to it
  std::array<bool, 65> digital_inputs = {};   ///< $A_IN, where nothing is wired to it
  std::array<bool, 65> digital_outputs = {};  ///< $A_OUT

  /// Data that are only kept: of which variable and row of its family, with which indices.
  struct KeptDatum {
    SystemId id = SystemId::ExternalShift;
    int parameter = 0;
    std::vector<int> indices;
    friend auto operator<=>(const KeptDatum&, const KeptDatum&) = default;
  };
  std::map<KeptDatum, double> kept_data;
  std::map<KeptDatum, std::string> kept_texts;

  bool operator==(const ChannelState&) const = default;
};

}  // namespace g31::sinumerik
