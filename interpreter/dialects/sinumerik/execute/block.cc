#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/circle_form.h"
#include "interpreter/dialects/sinumerik/execute/feed.h"
#include "interpreter/dialects/sinumerik/execute/travel.h"

namespace g31::sinumerik {
namespace {

/// Another feed type wants a new F.  Behind G96 the spindle stays at the speed it has, but G94 and
/// G95 have the last S in rev/min count (programming manual, fundamentals 10/2004, G96).
void change_feed_type(Channel& channel, int before) {
  if (feed_meaning(before) != feed_meaning(channel.group[Group::FeedType])) {
    channel.feed = {};
  }
  if (cuts_at_constant_speed(before) && keeps_speed(channel.group[Group::FeedType])) {
    const int now = std::exchange(channel.group[Group::FeedType], before);
    channel.spindle.speed = kept_speed(channel);
    channel.group[Group::FeedType] = now;
  }
}

/// Sets the groups of the block's codes.
void take_codes(Channel& channel, const Block& block) {
  for (const Group group : kOneBlockGroups) {
    channel.group[group] = 0;
  }
  const int feed_before = channel.group[Group::FeedType];
  for (const std::uint16_t bits : block.codes) {
    const FoundCode code = unpacked(bits);
    const GCode& row = g_codes()[code.row];
    int& group = channel.group[row.group];
    const bool changes = group != row.number + code.beyond;
    group = row.number + code.beyond;
    if (row.group == Group::SettableFrame) {
      channel.take_stored_frames();
    } else if (changes && row.group == Group::Plane) {
      channel.frames_changed();
    } else if (changes && row.group == Group::RadiusCompensation) {
      channel.offset_changed();
    }
  }
  channel.suppression = channel.group[Group::FrameSuppression];
  if (channel.suppression != 0) {
    channel.frames_changed();
  }
  if (channel.group[Group::FeedType] != feed_before) {
    change_feed_type(channel, feed_before);
  }
}

/// G54 to G599 that neither sheet nor program has given.
MaybeFailure refuse_left_out(const Channel& channel, const Block& block) {
  if (block.code_of(Group::SettableFrame) == nullptr ||
      !channel.left_out.contains(channel.settable_number())) {
    return std::nullopt;
  }
  const auto code =
      find_g_code(static_cast<double>(Group::SettableFrame), channel.group[Group::SettableFrame]);
  return message_failure(runtime::Status::Setup, source::DiagnosticId::SetupMissingOffset,
                         name_of(*code));
}

/// Whether a program has stopped at one place as often as no operator would start it again.
bool waits_for_ever(Channel& channel, const Block& block) {
  ProgramStops& before = channel.stops;
  const AxisPositions q_M = channel.machine_position();
  const bool is_same = before.place == block.where && before.q_M == q_M;
  before = {block.where, q_M, is_same ? before.count + 1 : 1};
  return before.count > ProgramStops::kMost;
}

MaybeFailure stop(Channel& channel, const Block& block) {
  for (std::size_t i = 0; i < block.words.machine_code_count; ++i) {
    const double code = block.words.machine_codes[i];
    if (code != 0.0 && code != 1.0) {
      continue;
    }
    if (waits_for_ever(channel, block)) {
      return message_failure(runtime::Status::Budget, source::DiagnosticId::WaitsForOperator,
                             channel.message.empty() ? "" : ": " + channel.message);
    }
    channel.observer.on_stop({code == 0.0 ? "M0" : "M1", "", block.where});
  }
  return std::nullopt;
}

MaybeFailure refuse_unknown(const Block& block) {
  for (const Address address : kOnlyZero) {
    const BlockWords::Word& word = block.words[address];
    if (word.present && word.value != 0.0) {
      return failure(only_zero(address, word.value));
    }
  }
  return std::nullopt;
}

/// What group 2 or 3 does in the place of a motion; nullptr: nothing.
using Special = MaybeFailure (*)(Channel&, const Block&, const GCode&);

Special special_of(GAction action) {
  switch (action) {
    case GAction::Dwell:
      return
          [](Channel& channel, const Block& block, const GCode&) { return dwell(channel, block); };
    case GAction::Reference:
      return [](Channel& channel, const Block& block, const GCode&) {
        return approach_reference(channel, block);
      };
    case GAction::FixedPoint:
      return [](Channel& channel, const Block& block, const GCode&) {
        return approach_fixed_point(channel, block);
      };
    case GAction::Frame:
      return program_frame;
    case GAction::AxialShift:
      return shift_by_axis;
    case GAction::SolidAngles:
      return turn_by_solid_angles;
    case GAction::Pole:
      return set_pole;
    case GAction::LowerLimit:
    case GAction::UpperLimit:
      return limit;
    case GAction::Modal:
    case GAction::OneBlock:
    case GAction::Refused:
      break;
  }
  return nullptr;
}

/// Whether a word says where to go.
bool has_place(const Block& block) {
  return block.words.has_axes() || is_polar(block) || block.words.has(Address::Angle) ||
         has_direction(block) || block.words.has(Address::ToolWay);
}

/// The code that takes the block's axis words for something else than a motion of the path.
const GCode* special_code(const Block& block) {
  for (const Group group : {Group::OneBlock, Group::ProgrammableFrame}) {
    const GCode* const code = block.code_of(group);
    if (code != nullptr && takes_words(code->action)) {
      return code;
    }
  }
  return nullptr;
}

/// ANG is of straight lines, and a line that waits for its end wants such a one next.
MaybeFailure judge_lines(Channel& channel, const Block& block) {
  const bool has_angle = block.words.has(Address::Angle);
  if (!has_angle && !channel.held_line) {
    return std::nullopt;
  }
  const bool listens = listens_to_probe(channel, block);
  const bool is_special = special_code(block) != nullptr;
  if (has_angle &&
      (listens || is_special || is_polar(block) || is_circle(channel.group[Group::Motion]))) {
    return failure(AlarmId::BadSyntax, "ANG is the angle of a straight line, without AP and RP");
  }
  const bool acts = commands_motion(block) || listens || is_special || block.words.has_positioning;
  const bool goes_on = has_angle && !block.words.has_positioning;
  return channel.held_line && acts && !goes_on ? line_without_end(channel) : std::nullopt;
}

/// Whether a block says something that would count for the line in front of it, too, were it only
/// travelled now: frames, units, feed type, tool.
bool changes_held_line(const Block& block) {
  constexpr Group kGroups[] = {Group::ProgrammableFrame, Group::Plane, Group::SettableFrame,
                               Group::FrameSuppression,  Group::Unit,  Group::FeedType,
                               Group::ToolRotation};
  constexpr Address kAddresses[] = {Address::Tool, Address::Edge, Address::Additive};
  return std::ranges::any_of(kGroups, [&](Group g) { return block.code_of(g) != nullptr; }) ||
         std::ranges::any_of(kAddresses, [&](Address a) { return block.words.has(a); });
}

/// What a block says to U, V and W.
FurtherMotion further_motion(const Channel& channel, const Block& block) {
  if (const GCode* const code = special_code(block)) {
    return code->action == GAction::Reference ? FurtherMotion::ToHome
           : code->action == GAction::Frame || code->action == GAction::AxialShift
               ? FurtherMotion::IntoFrame
               : FurtherMotion::Refused;
  }
  const bool has_circle =
      is_circle(channel.group[Group::Motion]) && has_centre(block, channel.plane());
  return listens_to_probe(channel, block) ? FurtherMotion::Refused
         : has_place(block) || has_circle ? FurtherMotion::WithPath
                                          : FurtherMotion::Alone;
}

MaybeFailure move_path(Channel& channel, const Block& block) {
  if (is_circle(channel.group[Group::Motion]) &&
      (has_place(block) || has_centre(block, channel.plane()))) {
    return move_along_circle(channel, block);
  }
  return has_place(block) ? move_straight(channel, block) : std::nullopt;
}

/// A rapid ends when its slowest axis arrives, U, V and W among them.
/// @param needed_s  what these need
MaybeFailure move_path_with_further(Channel& channel, const Block& block, double needed_s) {
  if (MaybeFailure wrong = finish_motion(channel)) {
    return wrong;
  }
  const double began_s = channel.port.time_s();
  if (MaybeFailure wrong = move_path(channel, block)) {
    return wrong;
  }
  if (MaybeFailure wrong = finish_motion(channel)) {
    return wrong;
  }
  const double left_s = needed_s - (channel.port.time_s() - began_s);
  return left_s > 0.0 ? pause(channel, {left_s, block.where}) : std::nullopt;
}

/// @param special  the block's special_code()
MaybeFailure wrong_beside_dwell(const Block& block, const GCode* special) {
  const bool dwells = special != nullptr && special->action == GAction::Dwell;
  return dwells && (has_place(block) || block.words.has_positioning)
             ? MaybeFailure(failure(axis_beside_dwell()))
             : std::nullopt;
}

/// @param special  the block's special_code()
bool moves_axes(const Channel& channel, const Block& block, const GCode* special) {
  if (special != nullptr) {
    return special->action == GAction::Reference || special->action == GAction::FixedPoint ||
           block.words.has_positioning;
  }
  return has_place(block) || block.words.has_positioning || listens_to_probe(channel, block) ||
         (is_circle(channel.group[Group::Motion]) && has_centre(block, channel.plane()));
}

MaybeFailure move(Channel& channel, const Block& block) {
  double further_s = 0.0;
  const GCode* const special = special_code(block);
  if (channel.idle_edge && moves_axes(channel, block, special)) [[unlikely]] {
    tell_idle_edge(channel);
  }
  if (MaybeFailure wrong = wrong_beside_dwell(block, special)) {
    return wrong;
  }
  if (MaybeFailure wrong = fits_into_contour(channel, block)) {
    return wrong;
  }
  if (MaybeFailure wrong = judge_lines(channel, block)) {
    return wrong;
  }
  if (block.words.has_positioning) {
    if (MaybeFailure wrong = move_positioning_axes(channel, block)) {
      return wrong;
    }
  }
  if (moves_further_axes(block)) {
    const bool at_rapid = channel.group[Group::Motion] == number_in_group("G0");
    further_s = at_rapid && special == nullptr && has_place(block)
                    ? further_rapid_seconds(channel, block)
                    : 0.0;
    if (MaybeFailure wrong = move_further_axes(channel, block, further_motion(channel, block))) {
      return wrong;
    }
  }
  if (channel.deletes_distance && commands_motion(block)) {
    return std::nullopt;
  }
  if (special != nullptr) {
    return special_of(special->action)(channel, block, *special);
  }
  if (listens_to_probe(channel, block)) {
    return measure(channel, block);
  }
  return further_s > 0.0 ? move_path_with_further(channel, block, further_s)
                         : move_path(channel, block);
}

}  // namespace

Block::Block(const BlockWords& block_words, std::span<const std::uint16_t> packed_codes,
             source::Location place)
    : words(block_words), codes(packed_codes), where(place) {
  for (const std::uint16_t bits : codes) {
    groups |= std::uint64_t{1} << static_cast<unsigned>(g_codes()[unpacked(bits).row].group);
  }
}

const GCode* Block::find_code(Group group) const {
  for (const std::uint16_t bits : codes) {
    const GCode& row = g_codes()[unpacked(bits).row];
    if (row.group == group) {
      return &row;
    }
  }
  return nullptr;
}

bool commands_motion(const Block& block) {
  return has_place(block) && special_code(block) == nullptr;
}

MaybeFailure execute_block(Channel& channel, const Block& block) {
  if (channel.held_line && changes_held_line(block)) {
    return line_without_end(channel);
  }
  if (channel.clocks.block_began) {
    channel.clocks.block_began = channel.port.time_s();
  }
  take_codes(channel, block);
  if (MaybeFailure wrong = finish_passing_by(channel, block)) {
    return wrong;
  }
  if (MaybeFailure wrong = take_tool_carrier(channel, block)) {
    return wrong;
  }
  if (const GCode* const code = block.code_of(Group::ToolRotation)) {
    turn_to_tool(channel, *code);
  }
  if (MaybeFailure wrong = refuse_unknown(block)) {
    return wrong;
  }
  if (MaybeFailure wrong = refuse_left_out(channel, block)) {
    return wrong;
  }
  take_axis_settings(channel, block);
  if (MaybeFailure wrong = take_technology(channel, block)) {
    return wrong;
  }
  if (MaybeFailure wrong = select_tool(channel, block)) {
    return wrong;
  }
  if (MaybeFailure wrong = take_tool_technology(channel, block)) {
    return wrong;
  }
  if (MaybeFailure wrong = read_compensation(channel, block)) {
    return wrong;
  }
  if (MaybeFailure wrong = read_corner(channel, block)) {
    return wrong;
  }
  MaybeFailure wrong = move(channel, block);
  if (!wrong) {
    wrong = end_compensated_block(channel);
  }
  if (channel.suppression != 0) {
    channel.suppression = 0;
    channel.arrived_at_machine();
  }
  return wrong ? wrong : stop(channel, block);
}

}  // namespace g31::sinumerik
