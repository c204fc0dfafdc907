#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/execute/feed.h"
#include "interpreter/dialects/sinumerik/execute/travel.h"
#include "interpreter/runtime/machine_code.h"
#include "machine/units/within_turn.h"

namespace g31::sinumerik {
namespace {

// M codes
constexpr double kTurnClockwise = 3.0;
constexpr double kTurnCounterclockwise = 4.0;
constexpr double kFullTurn = 360.0;
constexpr double kStopTurning = 5.0;
constexpr double kOrient = 19.0;

/// F and S mean something else with G4, G25 and G26.
bool is_technology(const Block& block) {
  const GCode* const special = block.code_of(Group::OneBlock);
  const GCode* const limits = block.code_of(Group::ProgrammableFrame);
  const bool dwells = special != nullptr && special->action == GAction::Dwell;
  return !dwells && (limits == nullptr || (limits->action != GAction::LowerLimit &&
                                           limits->action != GAction::UpperLimit));
}

void take_speed(Channel& channel, double value) {
  if (cuts_at_constant_speed(channel.group[Group::FeedType])) {
    channel.spindle.cutting_speed = value * metres_of_cutting(channel);
  } else {
    channel.spindle.speed = value;
  }
}

/// A spindle that is a rotary axis of the machine, as that of a lathe with C, travels there.
MaybeFailure turn_axis(Channel& channel, int axis, double way_deg, const source::Location& where) {
  path::PathBlock path;
  AxisPositions q_M_end = channel.machine_position();
  q_M_end[axis] += way_deg;
  path.q_M_end = channel.machine_to_path(q_M_end);
  path.g = 0;
  path.where = where;
  return travel_to(channel, path, channel.to_work(q_M_end));
}

/// A spindle by its number.
struct Numbered {
  int number = 1;
  Spindle& spindle;
};

Numbered master_of(Channel& channel) {
  return {channel.master_number(), channel.spindle};
}

/// Where a spindle is to stand, or how far it is to turn from where it stands.
struct SpindlePlace {
  double degrees = 0.0;
  bool adds = false;
};

/// A spindle that is an axis stands where that was moved to last, and goes to a place by the
/// shorter way.
MaybeFailure orient(Channel& channel, const Numbered& which, const SpindlePlace& to,
                    const source::Location& where) {
  const auto axis = channel.axis_of_spindle(which.number);
  if (axis) {
    if (MaybeFailure wrong = finish_motion(channel)) {
      return wrong;
    }
  }
  const double stands_at =
      axis ? channel.machine_position()[*axis] : which.spindle.angle.value_or(0.0);
  const double degrees = to.adds ? stands_at + to.degrees : to.degrees;
  if (!std::isfinite(degrees)) {
    return failure(AlarmId::ValueOutOfLimits, fmt::format("SPOS=IC({:g})", to.degrees));
  }
  which.spindle.direction = Spindle::kPositioned;
  which.spindle.builder_may_turn = false;
  which.spindle.angle = degrees;
  channel.port.turn_spindle(
      {machine::Rotation::Stopped, 0.0, degrees, channel.port_spindle(which.number)});
  if (!axis) {
    return std::nullopt;
  }
  const double way = to.adds ? to.degrees : std::remainder(degrees - stands_at, kFullTurn);
  return turn_axis(channel, *axis, way, where);
}

/// rev/min as the control turns a spindle.
double turning_speed(Channel& channel, const Numbered& which) {
  const bool is_master = which.number == channel.master_number();
  if (is_master && cuts_at_constant_speed(channel.group[Group::FeedType])) {
    return spindle_speed(channel, channel.present()[kTransverseAxis]);
  }
  const double speed = std::abs(which.spindle.speed);
  return is_master && speed > 0.0
             ? limited_speed(channel, speed)
             : std::min(which.spindle.turning_speed(), highest_speed(channel, which.number));
}

/// As M3, M4 and M5 have it; the sign of S says nothing about the direction.
void turn(Channel& channel, const Numbered& which) {
  const int direction = which.spindle.direction;
  const machine::Rotation rotation =
      direction == static_cast<int>(kTurnClockwise)          ? machine::Rotation::Clockwise
      : direction == static_cast<int>(kTurnCounterclockwise) ? machine::Rotation::Counterclockwise
                                                             : machine::Rotation::Stopped;
  const bool stops = rotation == machine::Rotation::Stopped;
  channel.port.turn_spindle({rotation,
                             stops ? 0.0 : turning_speed(channel, which),
                             {},
                             channel.port_spindle(which.number)});
}

/// M3, M4, M5 and M19; other codes are none of a spindle.
MaybeFailure take_code(Channel& channel, const Numbered& which, double code,
                       const source::Location& where) {
  if (code == kOrient) {
    return orient(channel, which, {}, where);
  }
  if (code == kTurnClockwise || code == kTurnCounterclockwise || code == kStopTurning) {
    which.spindle.direction = static_cast<int>(code);
    which.spindle.builder_may_turn = false;
    if (code != kStopTurning) {
      which.spindle.angle.reset();
    }
    turn(channel, which);
  }
  return std::nullopt;
}

/// A spindle is a modulo axis always: absolute places lie within one turn, unless it is an axis of
/// the machine that takes any.
Result<double, Failure> place_in_turn(const Channel& channel, int spindle, double degrees) {
  if (degrees >= 0.0 && degrees < kFullTurn) {
    return degrees;
  }
  const auto axis = channel.axis_of_spindle(spindle);
  if (axis && channel.has_axis_function(*axis, Channel::AxisFunction::TakesAnyPlace)) {
    return machine::within_turn(degrees);
  }
  return failure(AlarmId::BadModuloPosition, fmt::format("SPOS={:g}", degrees));
}

/// SPOS and SPOSA
MaybeFailure orient_by(Channel& channel, const Numbered& which, const BlockWords::Word& word,
                       const source::Location& where) {
  const bool adds = word.modification == Modification::Incremental;
  if (adds && !which.spindle.angle) {
    return failure(AlarmId::NotImplemented,
                   "SPOS=IC(...) of a spindle that turned: where it "
                   "stopped is not simulated");
  }
  if (!std::isfinite(word.value)) {
    return failure(AlarmId::ValueOutOfLimits, fmt::format("SPOS={:g}", word.value));
  }
  const auto place =
      adds ? Result<double, Failure>(word.value) : place_in_turn(channel, which.number, word.value);
  return place ? orient(channel, which, {place.value(), adds}, where) : MaybeFailure(place.error());
}

/// LIMS
MaybeFailure take_limit(Channel& channel, const Numbered& which, double speed) {
  if (speed < 0.0) {
    return failure(AlarmId::NegativeSpeedLimit, fmt::format("LIMS={:g}", speed));
  }
  if (!channel.keep_speed_limit(Channel::SpeedDatum::OfLims, which.number, speed)) {
    which.spindle.limit = speed;
  }
  return std::nullopt;
}

/// S2=, M3=4, SPOS[2]=: of a spindle that is not the master.
MaybeFailure take_word(Channel& channel, const BlockWords::SpindleWord& word,
                       const source::Location& where) {
  const Numbered which{word.spindle, channel.other_spindles[word.spindle]};
  if (word.address == Address::Machine) {
    return take_code(channel, which, word.value, where);
  }
  if (word.address == Address::Spindle || word.address == Address::SpindleAsync) {
    return orient_by(channel, which, {word.value, word.modification, true, 1}, where);
  }
  if (word.address == Address::SpeedLimit) {
    return take_limit(channel, which, word.value);
  }
  which.spindle.speed = word.value;
  if (word.address == Address::Speed && which.spindle.turns()) {
    turn(channel, which);
  }
  return std::nullopt;
}

/// The M codes of a block and what they do to the master spindle.
MaybeFailure take_machine_codes(Channel& channel, const Block& block) {
  for (std::size_t i = 0; i < block.words.machine_code_count; ++i) {
    const double code = block.words.machine_codes[i];
    if (MaybeFailure wrong = take_code(channel, master_of(channel), code, block.where)) {
      return wrong;
    }
    channel.spindle.builder_may_turn =
        channel.spindle.builder_may_turn || runtime::may_turn_spindle(static_cast<int>(code));
    channel.port.auxiliary_code({static_cast<int>(code)});
    channel.inputs.hear(static_cast<int>(code), channel.now());
  }
  return std::nullopt;
}

}  // namespace

void tell_spindle(Channel& channel) {
  if (channel.spindle.turns()) {
    turn(channel, master_of(channel));
  }
}

void change_master(Channel& channel, int number) {
  const bool cuts =
      cuts_at_constant_speed(channel.group[Group::FeedType]) && number != channel.master_number();
  const double cutting_speed = channel.spindle.cutting_speed;
  if (cuts) {
    channel.spindle.speed = kept_speed(channel);
  }
  channel.make_master(number);
  if (cuts) {
    channel.spindle.cutting_speed = cutting_speed;
    tell_spindle(channel);
  }
}

MaybeFailure take_technology(Channel& channel, const Block& block) {
  const BlockWords& words = block.words;
  if (is_technology(block)) {
    if (words.has(Address::Feed)) {
      channel.feed = programmed(channel, words[Address::Feed].value);
    }
    if (words.has(Address::Speed)) {
      take_speed(channel, words[Address::Speed].value);
      tell_spindle(channel);
    }
  }
  if (const auto& angle = words[Address::ThreadAngle]; angle.present) {
    if (MaybeFailure wrong = failure(wrong_thread_angle(angle.value))) {
      return wrong;
    }
  }
  if (words.has(Address::SpeedLimit)) {
    if (MaybeFailure wrong =
            take_limit(channel, master_of(channel), words[Address::SpeedLimit].value)) {
      return wrong;
    }
  }
  if (MaybeFailure wrong = take_machine_codes(channel, block)) {
    return wrong;
  }
  for (const BlockWords::SpindleWord& word : words.spindle_words) {
    if (word.address == Address::Speed && !is_technology(block)) {
      continue;
    }
    if (MaybeFailure wrong = take_word(channel, word, block.where)) {
      return wrong;
    }
  }
  for (const Address address : {Address::Spindle, Address::SpindleAsync}) {
    if (words.has(address)) {
      if (MaybeFailure wrong =
              orient_by(channel, master_of(channel), words[address], block.where)) {
        return wrong;
      }
    }
  }
  return std::nullopt;
}

}  // namespace g31::sinumerik
