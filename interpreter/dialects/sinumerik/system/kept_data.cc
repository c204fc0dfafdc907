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

}  // namespace g31::sinumerik::system
