#include "interpreter/dialects/fanuc/system/control_variables.h"

#include <array>
#include <cmath>
#include <type_traits>

#include "interpreter/dialects/fanuc/system/access.h"

namespace g31::fanuc {
namespace {

/// What a system variable takes at most: far beyond any machine, and every sum of them is finite.
constexpr double kLargestValue = 4'294'967'295.0;

/// How one kind of system variable is read and written; nullptr where no row of it lets one.
struct Accessor {
  system::ReadResult (*read)(Control&, const system::Place&);
  system::WriteResult (*write)(Control&, const system::Place&, Cell);
};

using namespace system;

constexpr auto kAccessors = std::to_array<Accessor>({
#define SHOWS(name, read, write) {read, write},
#include "interpreter/dialects/fanuc/vocabulary/shows.def"
#undef SHOWS
});

/// Which of the two an accessor has; told by type, for g++ 12 compares no functions in constants
/// where undefined behaviour is looked for.
struct Lets {
  bool read;
  bool write;
};

constexpr auto kLets = std::to_array<Lets>({
#define SHOWS(name, read, write) \
  {!std::is_null_pointer_v<decltype(read)>, !std::is_null_pointer_v<decltype(write)>},
#include "interpreter/dialects/fanuc/vocabulary/shows.def"
#undef SHOWS
});

consteval bool has_what_it_lets(Shows shows, Access access) {
  const Lets& lets = kLets[static_cast<std::size_t>(shows)];
  const bool reads = access != Access::Write;
  const bool writes = access != Access::Read;  // the set-up sheet writes inputs
  return (!reads || lets.read) && (!writes || lets.write);
}
#define SYSTEM_VARIABLE(first, last, shows, groups, unit, access, while_moving, text) \
  static_assert(has_what_it_lets(Shows::shows, Access::access),                       \
                "#" #first ": " #shows " has no function for " #access);
#include "interpreter/dialects/fanuc/vocabulary/system_variables.def"
#undef SYSTEM_VARIABLE

const Accessor& accessor_of(const SystemVariable& row) {
  return kAccessors[static_cast<std::size_t>(row.shows)];
}

}  // namespace

Result<Cell, AlarmId> ControlVariables::read(std::int32_t number) {
  const SystemVariable* const row = control_->system_variables.find(number);
  if (const auto why = why_unreadable(row)) {
    return *why;
  }
  if (control_->lookahead.is_ahead()) {
    control_->report_read_ahead(*row, number);
  }
  if (row->while_moving == WhileMoving::Disabled && !control_->is_inspected()) {
    control_->port.stand_still();
  }
  return accessor_of(*row).read(*control_, {*row, number});
}

std::optional<AlarmId> ControlVariables::write(std::int32_t number, Cell value) {
  const SystemVariable* const row = control_->system_variables.find(number);
  if (const auto why = why_unwritable(row)) {
    return why;
  }
  return store(*row, number, value);
}

std::optional<AlarmId> ControlVariables::preset(std::int32_t number, Cell value) {
  const SystemVariable* const row = control_->system_variables.find(number);
  if (row == nullptr) {
    return AlarmId::IllegalVariable;
  }
  if (row->access == Access::Read || row->access == Access::Write) {
    return AlarmId::WriteProtected;
  }
  return store(*row, number, value);
}

std::optional<AlarmId> ControlVariables::store(const SystemVariable& row, std::int32_t number,
                                               Cell value) {
  if (std::abs(value.or_zero()) > kLargestValue) {
    return AlarmId::IllegalOffsetValue;
  }
  return accessor_of(row).write(*control_, {row, number}, value);
}

}  // namespace g31::fanuc
