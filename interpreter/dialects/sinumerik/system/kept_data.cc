#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/system/system.h"

namespace g31::sinumerik::system {
namespace {

/// Axes and numbers of kept data are not negative; there is no upper end.
MaybeFailure negative_index(const SystemAccess& access) {
  for (const int index : access.indices) {
    if (index < 0) {
      return failure(AlarmId::IndexOne, fmt::format("index {}", index));
    }
  }
  return std::nullopt;
}

/// Before anybody writes it.
std::string first_text(const SystemAccess& access) {
  if (access.id == SystemId::NameOfChannel) {
    return "CHAN1";
  }
  if (access.id != SystemId::NameOfGeometryAxis && access.id != SystemId::NameOfChannelAxis &&
      access.id != SystemId::NameOfMachineAxis) {
    return "";
  }
  const auto index = static_cast<std::size_t>(access.indices.front());
  const std::size_t count = access.id == SystemId::NameOfGeometryAxis
                                ? std::size_t{kLinearAxisCount}
                                : std::size_t{kAxisCount};
  if (index >= count) {
    return "";
  }
  const std::string letter(1, kAxisLetters[index]);
  return access.id == SystemId::NameOfMachineAxis ? letter + "1" : letter;
}

}  // namespace

Number kept_datum(Channel& channel, const SystemAccess& access) {
  if (MaybeFailure wrong = negative_index(access)) {
    return *wrong;
  }
  const auto found = channel.kept_data.find({access.id, access.parameter, access.indices});
  return found != channel.kept_data.end() ? found->second : 0.0;
}

MaybeFailure set_kept_datum(Channel& channel, const SystemAccess& access, double value) {
  if (MaybeFailure wrong = negative_index(access)) {
    return wrong;
  }
  channel.kept_data[{access.id, access.parameter, access.indices}] = value;
  return std::nullopt;
}

MaybeFailure set_table_datum(Channel& channel, const SystemAccess& access, double value) {
  if (MaybeFailure wrong = negative_index(access)) {
    return wrong;
  }
  CompensationData& tables = channel.compensation_data;
  const bool is_sag = !CompensationData::is_of_encoder(access.id);
  if (is_sag && access.indices.front() >= CompensationData::kSagTables) {
    return failure(AlarmId::IndexOne, fmt::format("table {}", access.indices.front()));
  }
  const int most =
      is_sag ? tables.most_points(channel, access.indices.front()) : CompensationData::kMostPoints;
  const bool is_value = access.id == SystemId::SagTable || access.id == SystemId::EncoderTable;
  if (is_value && access.indices[1] >= most) {
    return failure(AlarmId::IndexTwo, fmt::format("point {}", access.indices[1]));
  }
  if (tables.is_protected(channel, access.id, access.indices)) {
    return failure(AlarmId::WriteProtected, is_sag ? "$MA_CEC_ENABLE of its output axis is on"
                                                   : "$MA_ENC_COMP_ENABLE of its axis is on");
  }
  tables.written();
  return set_kept_datum(channel, access, value);
}

MaybeFailure set_chain_datum(Channel& channel, const SystemAccess& access, double value) {
  constexpr int kComponents = 3;
  if (access.id == SystemId::ChainElementVector && access.indices[1] >= kComponents) {
    return failure(AlarmId::IndexTwo, fmt::format("component {}, 0 to 2", access.indices[1]));
  }
  constexpr double kFar = 1e9;
  if (!(std::abs(value) <= kFar)) {
    return failure(AlarmId::ValueOutOfLimits, fmt::format("{:g}", value));
  }
  return set_kept_datum(channel, access, value);
}

Text kept_text(Channel& channel, const SystemAccess& access) {
  if (MaybeFailure wrong = negative_index(access)) {
    return *wrong;
  }
  const auto found = channel.kept_texts.find({access.id, access.parameter, access.indices});
  return found != channel.kept_texts.end() ? found->second : first_text(access);
}

MaybeFailure set_kept_text(Channel& channel, const SystemAccess& access, const std::string& text) {
  if (MaybeFailure wrong = negative_index(access)) {
    return wrong;
  }
  channel.kept_texts[{access.id, access.parameter, access.indices}] = text;
  return std::nullopt;
}

}  // namespace g31::sinumerik::system
