#pragma once

#include <optional>
#include <string>

#include "interpreter/dialects/fanuc/alarms.h"
#include "interpreter/runtime/outcome.h"
#include "interpreter/source/location.h"
#include "interpreter/syntax/tree.h"

namespace g31::fanuc {

/// Why a block could not be executed.
struct Failure {
  AlarmId id = AlarmId::AddressNotFound;
  syntax::ShortSpan where;  ///< empty: the whole block
  source::Location block;   ///< an earlier block that was executed late; no file: the present one
  std::string detail;
  runtime::Status status = runtime::Status::Alarm;
  int alarm_number = 0;    ///< 0: the row's own; macro alarms count from it
  std::string alarm_text;  ///< empty: the row's own
};

/// nullopt: the block was executed.
using MaybeFailure = std::optional<Failure>;

}  // namespace g31::fanuc
