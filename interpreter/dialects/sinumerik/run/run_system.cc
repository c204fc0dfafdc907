#include <type_traits>

#include "interpreter/dialects/sinumerik/run/system_steps.h"
#include "interpreter/dialects/sinumerik/system/system.h"
#include "machine/base/contract.h"

namespace g31::sinumerik {
namespace {

template <typename Value>
consteval bool shows(Type type, Result<Value, Failure> (*)(Channel&, const SystemAccess&)) {
  if constexpr (std::is_same_v<Value, double>) {
    return is_held_as_number(type);
  } else if constexpr (std::is_same_v<Value, std::string>) {
    return type == Type::String;
  } else {
    return type == Type::Frame;
  }
}
consteval bool shows(Type /*type*/, std::nullptr_t) {
  return true;
}
#define Read(f) system::f
#define Write(f, g) system::f
#define Stored(f) system::f
#define OfLevel(f) nullptr
#define Refused() nullptr
#define SYSTEM_VARIABLE(id, name, type, indices, work, text) \
  static_assert(shows(Type::type, work), name " is of another type");
#include "interpreter/dialects/sinumerik/vocabulary/system_variables.def"
#undef SYSTEM_VARIABLE
#undef Refused
#undef OfLevel
#undef Stored
#undef Write
#undef Read

/// Takes axis and component from the end of a frame's indices, if they are there.
MaybeFailure split(SystemAccess& access) {
  const bool is_frame = system_variables()[static_cast<std::size_t>(access.id)].type == Type::Frame;
  if (!is_frame || access.indices.size() < 2) {
    return std::nullopt;
  }
  access.component = static_cast<Component>(access.indices.back());
  access.indices.pop_back();
  access.axis = access.indices.back();
  access.indices.pop_back();
  return has_frame(access.axis) ? std::nullopt : MaybeFailure(failure(AlarmId::BadAxisIndex));
}

/// What the column `work` of system_variables.def calls OfLevel: the channel knows no levels.
namespace of_level {

Result<double, Failure> argument_given(const CallStack& stack, const SystemAccess& access) {
  const auto which = static_cast<std::size_t>(access.indices[0]);
  const auto& given = stack.level().given;
  return which >= 1 && which <= given.size() && given[which - 1] ? 1.0 : 0.0;
}

Result<double, Failure> call_depth(const CallStack& stack, const SystemAccess& /*access*/) {
  return static_cast<double>(stack.depth());
}

/// In the notation of the control's memory (NC programming 12/2019, 3.4.1.5).
Result<std::string, Failure> level_name(const CallStack& stack, const SystemAccess& access) {
  const auto which = static_cast<std::size_t>(access.indices[0]);
  if (which > stack.depth()) {
    return std::string();
  }
  const CompiledProgram& program = *stack.level(which).program;
  return "_N_" + program.name + "_" + (program.type.empty() ? "MPF" : program.type);
}

Result<double, Failure> modal_call_active(const CallStack& stack, const SystemAccess& /*access*/) {
  return stack.modal_call ? 1.0 : 0.0;
}

/// "/_N_WKS_DIR/_N_PART_WPD/" for "PART_WPD"; empty where the archive does not say.
std::string path_of(const std::string& folder) {
  if (folder.empty()) {
    return folder;
  }
  return (folder.ends_with("_WPD") ? "/_N_WKS_DIR/_N_" : "/_N_") + folder + "/";
}

Result<std::string, Failure> level_path(const CallStack& stack, const SystemAccess& access) {
  const auto which = static_cast<std::size_t>(access.indices[0]);
  return which <= stack.depth() ? path_of(stack.level(which).program->folder) : std::string();
}

/// As programs in use have it: $P_PROGPATH<<"_N_INSPECTION_MPF" names a file beside the program.
Result<std::string, Failure> running_path(const CallStack& stack, const SystemAccess& /*access*/) {
  return path_of(stack.level().program->folder);
}

}  // namespace of_level
}  // namespace

Result<SystemAccess, Failure> SystemSteps::access_of(const Op& op, Arguments indices) {
  SystemAccess access;
  access.id = static_cast<SystemId>(op.a.place);
  access.parameter = op.detail;
  for (const Argument& index : indices) {
    access.indices.push_back(static_cast<int>(operands_.number(index.value)));
  }
  if (MaybeFailure wrong = split(access)) {
    return *wrong;
  }
  return access;
}

MaybeFailure SystemSteps::read(const Op& op) {
  const auto found = access_of(op, operands_.arguments_of(op));
  if (!found) {
    return found.error();
  }
  const SystemAccess& access = found.value();
  switch (access.id) {
#define Read(f) return show(op, access, system::f(channel_, access))
#define Write(f, g) return show(op, access, system::f(channel_, access))
#define Stored(f) return show(op, access, system::f(channel_, access))
#define OfLevel(f) return show(op, access, of_level::f(stack_, access))
#define Refused() break
#define SYSTEM_VARIABLE(id, name, type, indices, work, text) \
  case SystemId::id:                                         \
    work;
#include "interpreter/dialects/sinumerik/vocabulary/system_variables.def"
#undef SYSTEM_VARIABLE
#undef Refused
#undef OfLevel
#undef Stored
#undef Write
#undef Read
  }
  contract_violated("every system variable has a row, and a refused one no step", __FILE__,
                    __LINE__);
}

MaybeFailure SystemSteps::write(const Op& op) {
  const Arguments list = operands_.arguments_of(op);
  const auto found = access_of(op, list.first(list.size() - 1));
  if (!found) {
    // Spindles have components in the frames of an INI file.
    const bool is_of_spindle = channel_.loads_data && found.error().id == AlarmId::BadAxisIndex;
    return is_of_spindle ? std::nullopt : MaybeFailure(found.error());
  }
  const SystemAccess& access = found.value();
  switch (access.id) {
#define Read(f) break
#define Write(f, g) return set(access, list.back(), system::g)
#define Stored(f) return set(access, list.back(), system::f)
#define OfLevel(f) break
#define Refused() break
#define SYSTEM_VARIABLE(id, name, type, indices, work, text) \
  case SystemId::id:                                         \
    work;
#include "interpreter/dialects/sinumerik/vocabulary/system_variables.def"
#undef SYSTEM_VARIABLE
#undef Refused
#undef OfLevel
#undef Stored
#undef Write
#undef Read
  }
  contract_violated("what is only read is compiled to an alarm", __FILE__, __LINE__);
}

MaybeFailure SystemSteps::show(const Op& op, const SystemAccess& /*access*/,
                               const Result<double, Failure>& value) {
  if (!value) {
    return value.error();
  }
  if (!std::isfinite(value.value())) {
    return failure(AlarmId::ArithmeticError, "too large");
  }
  operands_.number(op.result) = value.value();
  missed_.follow_read(op);
  return std::nullopt;
}

MaybeFailure SystemSteps::show(const Op& op, const SystemAccess& /*access*/,
                               const Result<std::string, Failure>& value) {
  if (!value) {
    return value.error();
  }
  operands_.text(op.result) = value.value();
  return std::nullopt;
}

MaybeFailure SystemSteps::show(const Op& op, const SystemAccess& access,
                               const Result<Frame, Failure>& value) {
  if (!value) {
    return value.error();
  }
  if (access.component) {
    operands_.number(op.result) =
        channel_.shown_component(access.axis, *access.component, value.value());
    missed_.follow_read(op);
  } else {
    operands_.frame(op.result) = value.value();
  }
  return std::nullopt;
}

MaybeFailure SystemSteps::show(const Op& op, const SystemAccess& access,
                               const Result<Frame*, Failure>& place) {
  return place ? show(op, access, Result<Frame, Failure>(*place.value())) : place.error();
}

MaybeFailure SystemSteps::set(const SystemAccess& access, const Argument& value,
                              MaybeFailure (*set_number)(Channel&, const SystemAccess&, double)) {
  return set_number(channel_, access, operands_.number(value));
}

MaybeFailure SystemSteps::set(const SystemAccess& access, const Argument& value,
                              MaybeFailure (*set_text)(Channel&, const SystemAccess&,
                                                       const std::string&)) {
  return set_text(channel_, access, operands_.text(value.value));
}

MaybeFailure SystemSteps::set(const SystemAccess& access, const Argument& value,
                              Result<Frame*, Failure> (*find_frame)(Channel&,
                                                                    const SystemAccess&)) {
  const auto place = find_frame(channel_, access);
  if (!place) {
    return place.error();
  }
  Frame& stored = *place.value();
  if (access.component) {
    if (MaybeFailure wrong = channel_.set_component(access.axis, *access.component,
                                                    operands_.number(value), stored)) {
      return wrong;
    }
  } else {
    stored = operands_.frame(value.value);
  }
  if (access.id == SystemId::SettableFrames) {
    channel_.left_out.erase(access.indices.front());
  }
  channel_.frame_written();
  return std::nullopt;
}

}  // namespace g31::sinumerik
