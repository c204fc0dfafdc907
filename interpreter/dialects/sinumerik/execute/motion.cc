#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/feed.h"
#include "interpreter/dialects/sinumerik/execute/travel.h"
#include "machine/units/within_turn.h"

namespace g31::sinumerik {
namespace {

constexpr double kTurn = 360.0;
constexpr int kRapid = number_in_group("G0");

bool is_thread(int motion) {
  return motion == number_in_group("G33") || motion == number_in_group("G331") ||
         motion == number_in_group("G332");
}
constexpr Address kLeads[] = {Address::CentreX, Address::CentreY, Address::CentreZ};

/// The nearest place of a rotary axis at `angle` that the modification allows.
double rotary_end(double now, double angle, Modification modification) {
  const double ahead = machine::within_turn(angle - now);
  switch (modification) {
    case Modification::Direct:
      return now + (ahead > kTurn / 2.0 ? ahead - kTurn : ahead);
    case Modification::Plus:
      return now + ahead;
    case Modification::Minus:
      return now - machine::within_turn(now - angle);
    case Modification::None:
    case Modification::Absolute:
    case Modification::Incremental:
    case Modification::Quick:
    case Modification::AbsoluteDiameter:
    case Modification::IncrementalDiameter:
    case Modification::AbsoluteRadius:
    case Modification::IncrementalRadius:
      break;
  }
  return angle;
}

/// Where an absolute word sends a modulo axis: within the turn that it is in, or the way that DC,
/// ACP and ACN say (MD30455 bit 2: without a word as DC).  Source: SINUMERIK 840D sl Axes and
/// Spindles (A5E47437747B), 7.2 Modulo 360 degrees.
Result<double, Failure> modulo_place(const Channel& channel, int axis, const BlockWords::Word& word,
                                     double now) {
  using Function = Channel::AxisFunction;
  if ((word.value < 0.0 || word.value >= kTurn) &&
      !channel.has_axis_function(axis, Function::TakesAnyPlace)) {
    return failure(AlarmId::BadModuloPosition,
                   fmt::format("{}{:g}", kAxisLetters[axis], word.value));
  }
  const double angle = machine::within_turn(word.value);
  const bool is_shorter = word.modification == Modification::None &&
                          channel.has_axis_function(axis, Function::ShorterWay);
  const bool is_plain =
      word.modification == Modification::None || word.modification == Modification::Absolute;
  return is_shorter ? rotary_end(now, angle, Modification::Direct)
         : is_plain ? now - machine::within_turn(now) + angle
                    : rotary_end(now, angle, word.modification);
}

/// G33, G331 and G332: the lead counts along its axis, the feed along the path.
Result<double, Failure> thread_feed(Channel& channel, const Block& block, const FeedWay& way,
                                    const AxisPositions& q_M_way) {
  const auto speed = mean_speed(channel, way);
  if (!speed) {
    return speed;
  }
  if (channel.group[Group::Motion] == number_in_group("G33")) {  // the others turn it themselves
    tell_standing_spindle(channel, block);
  }
  for (int axis = 0; axis < kLinearAxisCount; ++axis) {
    const BlockWords::Word& lead = block.words[kLeads[axis]];
    if (lead.present && lead.value != 0.0 && q_M_way[axis] != 0.0) {
      const double along_axis = std::abs(lead.value) * channel.mm_per_length() * speed.value();
      return along_axis * q_M_way.head<3>().norm() / std::abs(q_M_way[axis]);
    }
  }
  return failure(AlarmId::NoLead);
}

}  // namespace

bool counts_from_present(const Channel& channel, Modification modification) {
  return is_incremental(modification) ||
         (modification == Modification::None && channel.suppression == 0 &&
          channel.group[Group::Distance] == number_in_group("G91"));
}

/// Incremental words count from the end that was written last; where frames are suppressed, from
/// where the axes stand.
Result<double, Failure> programmed_place(const Channel& channel, int axis,
                                         const BlockWords::Word& word, double now) {
  const bool turns = word.modification == Modification::Direct ||
                     word.modification == Modification::Plus ||
                     word.modification == Modification::Minus;
  if (turns && is_linear_axis(axis)) {
    return failure(AlarmId::BadModification,
                   fmt::format("{} is not a rotary axis", kAxisLetters[axis]));
  }
  if (says_across(word.modification) && !is_linear_axis(axis)) {
    return failure(AlarmId::BadModification,
                   fmt::format("{} is not a linear axis", kAxisLetters[axis]));
  }
  const bool adds = counts_from_present(channel, word.modification);
  const double value = channel.stored_place(
      axis, word.value, adds ? Channel::Counts::Incremental : Channel::Counts::Absolute,
      word.modification);
  if (!adds && channel.is_modulo(axis)) {
    return modulo_place(channel, axis, {value, word.modification, true}, now);
  }
  return turns  ? rotary_end(now, value, word.modification)
         : adds ? (channel.suppression != 0 ? now : channel.programmed()[axis]) + value
                : value;
}

Result<AxisPositions, Failure> programmed_end(Channel& channel, const Block& block) {
  const AxisPositions q_W_now = channel.present();
  AxisPositions q_W_end = q_W_now;
  for (int axis = 0; axis < static_cast<int>(kAxisCount); ++axis) {
    const BlockWords::Word& word = block.words.axis(axis);
    if (!word.present) {
      continue;
    }
    const auto place = programmed_place(channel, axis, word, q_W_end[axis]);
    if (!place) {
      return place.error();
    }
    q_W_end[axis] = place.value();
  }
  if (block.words.has(Address::Angle) && plane_words(channel, block) > 0) {
    if (MaybeFailure wrong = take_angle(channel, block, q_W_end, q_W_now)) {
      return *wrong;
    }
  }
  if (is_polar(block)) {
    if (MaybeFailure wrong = take_polar(channel, block, q_W_end)) {
      return *wrong;
    }
  }
  if (MaybeFailure wrong = take_joint_position(channel, block)) {
    return *wrong;
  }
  if (has_direction(block)) {
    if (MaybeFailure wrong = take_direction(channel, block, q_W_end)) {
      return *wrong;
    }
  }
  if (block.words.has(Address::ToolWay)) {
    if (MaybeFailure wrong = take_tool_way(channel, block, q_W_end)) {
      return *wrong;
    }
  }
  return q_W_end;
}

machine::BlockEnd block_end(const Channel& channel) {
  const bool stops = channel.group[Group::ExactStop] == number_in_group("G9") ||
                     channel.group[Group::BlockTransition] == number_in_group("G60");
  if (!stops) {
    return machine::BlockEnd::PassOn;
  }
  const bool is_rapid = channel.group[Group::Motion] == kRapid;
  if (const auto stop = channel.motion_data.stop(channel.numbers, is_rapid)) {
    return *stop;
  }
  const int window = channel.group[Group::ExactStopWindow];
  return window == number_in_group("G602")   ? machine::BlockEnd::CoarseStop
         : window == number_in_group("G603") ? machine::BlockEnd::CommandStop
                                             : machine::BlockEnd::ExactStop;
}

machine::ContourControl contour_control(const Channel& channel) {
  return channel.group[Group::Feedforward] == number_in_group("FFWON")
             ? machine::ContourControl::FeedForward
             : machine::ContourControl::LookAhead;
}

namespace {

/// Of a block with a compressor: how far a curve may leave its corners; 0: it is not compressed.
///
/// What curve a control makes is not documented.  Here the lines stay, and only the speed at their
/// corners is that of an arc within the tolerance, which the way therefore keeps as well.
/// Source: 840D sl Basic Functions B1, compressors: lines of G1, up to MD20170, within MD33100.
double compressor_tolerance(const Channel& channel, const path::PathBlock& path) {
  const bool is_line = channel.group[Group::Motion] == number_in_group("G1") && !path.arc;
  if (channel.group[Group::Compressor] == number_in_group("COMPOF") || !is_line ||
      is_compensation_on(channel)) {
    return 0.0;
  }
  const AxisPositions way = path.q_M_end - channel.machine_position();
  if (linear_axes(way).norm() > channel.motion_data.longest_compressed(channel.numbers)) {
    return 0.0;
  }
  double tolerance = std::numeric_limits<double>::infinity();
  const double given = channel.corners.axis_tolerance_mm;
  for (int axis = 0; axis < static_cast<int>(kAxisCount); ++axis) {
    if (way[axis] != 0.0) {
      tolerance = std::min(tolerance, given > 0.0 ? given : channel.rounding_tolerance(axis));
    }
  }
  return std::isfinite(tolerance) ? std::max(0.0, tolerance) : 0.0;
}

}  // namespace

MaybeFailure compensate_axes(Channel& channel) {
  auto tables = channel.compensation_data.changed(channel);
  if (!tables) {
    return tables.error();
  }
  if (tables.value()) {
    channel.port.compensate(*tables.value());
  }
  return std::nullopt;
}

void take_axis_data(Channel& channel) {
  if (const auto data = channel.motion_data.changed(channel.numbers)) {
    channel.port.set_axis_data(*data);
  }
}

bool limits_jerk(Channel& channel) {
  take_axis_data(channel);
  return channel.group[Group::Acceleration] == number_in_group("SOFT");
}

void take_modes(Channel& channel, path::PathBlock& path) {
  path.ends = block_end(channel);
  path.contour_control = contour_control(channel);
  path.smoothness.limits_jerk = limits_jerk(channel);
  path.smoothness.corner_tolerance = compressor_tolerance(channel, path);
}

MaybeFailure move_straight(Channel& channel, const Block& block) {
  if (block.words.has(Address::Angle) && plane_words(channel, block) == 0) {
    return hold_line(channel, block);
  }
  const auto q_W_end = programmed_end(channel, block);
  if (!q_W_end) {
    return q_W_end.error();
  }
  if (channel.held_line) {
    if (MaybeFailure wrong = release_line(channel, block, q_W_end.value())) {
      return wrong;
    }
  }
  path::PathBlock path;
  path.q_M_end = channel.to_path(q_W_end.value());
  path.where = block.where;
  path.g =
      channel.group[Group::Motion] == kRapid && block.code_of(Group::OneBlock) == nullptr ? 0 : 1;
  path.rapid_path = channel.rapid_path();
  if (path.g == 1) {
    const AxisPositions q_start = channel.path_position();
    const AxisPositions& q_end = path.q_M_end;
    const bool has_lead = is_thread(channel.group[Group::Motion]) &&
                          block.code_of(Group::OneBlock) == nullptr;  // G63 has F
    const FeedWay way = feed_way(channel, block, q_W_end.value(), feed_length(q_start, q_end));
    const auto feed = has_lead ? thread_feed(channel, block, way, q_end - q_start)
                               : feed_in_force(channel, block, way);
    if (!feed) {
      return feed.error();
    }
    path.feed_mm_min = feed.value();
  }
  take_modes(channel, path);
  if (goes_by_axes(channel)) {
    return travel_by_axes(channel, path, q_W_end.value());
  }
  return has_direction(block) ? travel_with_direction(channel, path, q_W_end.value())
                              : travel_to(channel, path, q_W_end.value());
}

/// G4 S: so many turns.  @param speed  rev/min
Result<double, Failure> seconds_of_turns(double turns, double speed) {
  return speed > 0.0 ? Result<double, Failure>(turns * 60.0 / speed)
                     : failure(AlarmId::NoFeed, "G4 S needs a spindle speed");
}

MaybeFailure dwell(Channel& channel, const Block& block) {
  const BlockWords& words = block.words;
  const auto other =
      std::ranges::find(words.spindle_words, Address::Speed, &BlockWords::SpindleWord::address);
  const bool has_other = other != words.spindle_words.end();
  if (!words.has(Address::Feed) && !words.has(Address::Speed) && !has_other) {
    channel.warnings.add(channel.diagnostics, source::DiagnosticId::WordWithoutEffect, block.where,
                         "G4 without F or S takes no time");
  }
  Result<double, Failure> seconds = words[Address::Feed].value;
  if (words.has(Address::Speed)) {
    seconds = seconds_of_turns(words[Address::Speed].value,
                               spindle_speed(channel, channel.present()[kTransverseAxis]));
  } else if (has_other) {
    seconds =
        seconds_of_turns(other->value, channel.other_spindles[other->spindle].turning_speed());
  }
  if (!seconds) {
    return seconds.error();
  }
  if (MaybeFailure wrong = failure(wrong_dwell(seconds.value()))) {
    return wrong;
  }
  return pause(channel, {seconds.value(), block.where});
}

}  // namespace g31::sinumerik
