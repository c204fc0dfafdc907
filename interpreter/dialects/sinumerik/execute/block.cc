#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"

namespace g31::sinumerik {
namespace {

constexpr int kOneBlockGroups[] = {2, 3, 9, 11};

/// Sets the groups of the block's codes.
MaybeFailure take_codes(Channel& channel, const Block& block) {
  for (const int group : kOneBlockGroups) {
    channel.group[static_cast<std::size_t>(group)] = 0;
  }
  const int unit_before = channel.group[13];
  for (const std::uint16_t bits : block.codes) {
    const FoundCode code = unpacked(bits);
    const GCode& row = g_codes()[code.row];
    int& group = channel.group[static_cast<std::size_t>(row.group)];
    const bool changes = group != row.number + code.beyond;
    group = row.number + code.beyond;
    if (changes && (row.group == 6 || row.group == 8)) {
      channel.frames_changed();
    }
  }
  channel.suppression = channel.group[9];
  if (channel.suppression != 0) {
    channel.frames_changed();
  }
  if (channel.group[13] != unit_before) {
    channel.observer.on_length_unit(channel.mm_per_length() == 1.0 ? LengthUnit::Millimetre
                                                                   : LengthUnit::Inch);
  }
  return std::nullopt;
}

void stop(Channel& channel, const Block& block) {
  for (std::size_t i = 0; i < block.words.machine_code_count; ++i) {
    const double code = block.words.machine_codes[i];
    if (code == 0.0 || code == 1.0) {
      channel.observer.on_stop({code == 0.0 ? "M0" : "M1", "", block.where});
    }
  }
}

/// F, S and SPOS.
MaybeFailure take_technology(Channel& channel, const Block& block) {
  const BlockWords& words = block.words;
  const bool dwells = block.code_of(2) != nullptr && block.code_of(2)->action == GAction::Dwell;
  if (words.has(Address::Feed) && !dwells) {
    channel.feed = words[Address::Feed].value;
  }
  if (words.has(Address::Speed) && !dwells) {
    channel.speed = words[Address::Speed].value;
  }
  for (const Address address : {Address::Spindle, Address::SpindleAsync}) {
    if (words.has(address)) {
      if (words[address].modification == Modification::Incremental) {
        return failure(AlarmId::NotImplemented, "SPOS=IC(...)");
      }
      channel.port.orient_spindle(words[address].value);
    }
  }
  return std::nullopt;
}

MaybeFailure refuse_unknown(const Block& block) {
  for (const Address address : {Address::Turns}) {
    if (block.words.has(address)) {
      return failure(AlarmId::NotImplemented,
                     std::string(addresses()[index_of(address) - kAxisCount].name));
    }
  }
  return std::nullopt;
}

MaybeFailure move(Channel& channel, const Block& block) {
  const GCode* const special = block.code_of(2);
  if (special != nullptr && special->action == GAction::Dwell) {
    return dwell(channel, block);
  }
  if (special != nullptr) {
    return failure(AlarmId::NotImplemented, std::string(special->name));
  }
  if (const GCode* const frame = block.code_of(3)) {
    return program_frame(channel, block, *frame);
  }
  const int motion = channel.group[1];
  if (listens_to_probe(channel, block)) {
    return measure(channel, block);
  }
  const bool has_centre = block.words.has(Address::CentreX) || block.words.has(Address::CentreY) ||
                          block.words.has(Address::CentreZ);
  if (motion >= 3 && (block.words.has_axes() || has_centre)) {
    return move_along_circle(channel, block);
  }
  return block.words.has_axes() ? move_straight(channel, block) : std::nullopt;
}

}  // namespace

const GCode* Block::code_of(int group) const {
  for (const std::uint16_t bits : codes) {
    const GCode& row = g_codes()[unpacked(bits).row];
    if (row.group == group) {
      return &row;
    }
  }
  return nullptr;
}

MaybeFailure execute_block(Channel& channel, const Block& block) {
  if (MaybeFailure wrong = take_codes(channel, block)) {
    return wrong;
  }
  if (MaybeFailure wrong = refuse_unknown(block)) {
    return wrong;
  }
  if (MaybeFailure wrong = take_technology(channel, block)) {
    return wrong;
  }
  if (MaybeFailure wrong = select_tool(channel, block)) {
    return wrong;
  }
  MaybeFailure wrong = move(channel, block);
  if (channel.suppression != 0) {
    channel.suppression = 0;
    channel.arrived_at_machine();
  }
  stop(channel, block);
  return wrong;
}

}  // namespace g31::sinumerik
