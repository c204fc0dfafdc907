#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/run/runner.h"
#include "interpreter/dialects/sinumerik/system/system.h"

namespace g31::sinumerik {
namespace {

SystemAccess access_of(SystemId id, int parameter) {
  SystemAccess access;
  access.id = id;
  access.parameter = parameter;
  return access;
}

}  // namespace

MaybeFailure Runner::read_system(const Op& op) {
  const auto id = static_cast<SystemId>(op.a.place);
  const SystemVariable& row = system_variables()[static_cast<std::size_t>(op.a.place)];
  SystemAccess access = access_of(id, op.detail);
  for (const Argument& index : arguments_of(op)) {
    access.indices.push_back(static_cast<int>(number(index.value)));
  }
  // These know the levels; the channel does not.
  if (id == SystemId::ArgumentGiven) {
    const auto which = static_cast<std::size_t>(access.indices[0]);
    const auto& given = level().given;
    number(op.result) = which >= 1 && which <= given.size() && given[which - 1] ? 1.0 : 0.0;
    return std::nullopt;
  }
  if (id == SystemId::CallDepth) {
    number(op.result) = static_cast<double>(depth_);
    return std::nullopt;
  }
  if (id == SystemId::ProgramName) {
    const auto which = static_cast<std::size_t>(access.indices[0]);
    text(op.result) = which <= depth_ ? levels_[which]->program->name : std::string();
    return std::nullopt;
  }
  if (id == SystemId::ProgramFolder) {
    text(op.result) = level().program->folder;
    return std::nullopt;
  }
  if (row.type == Type::Frame) {
    const auto found = frame_of(channel_, access);
    if (!found) {
      return found.error();
    }
    if (access.component) {
      number(op.result) = channel_.shown_component(
          access.axis, *access.component, found.value().component(access.axis, *access.component));
    } else {
      frame(op.result) = found.value();
    }
    return std::nullopt;
  }
  if (row.type == Type::String) {
    const Tool* const tool = channel_.find_tool(access.indices[0]);
    text(op.result) = tool != nullptr ? tool->name : std::string();
    return std::nullopt;
  }
  const auto value = number_of(channel_, access);
  if (!value) {
    return value.error();
  }
  number(op.result) = value.value();
  return std::nullopt;
}

MaybeFailure Runner::write_system(const Op& op) {
  SystemAccess access = access_of(static_cast<SystemId>(op.a.place), op.detail);
  const Arguments list = arguments_of(op);
  for (const Argument& index : list.first(list.size() - 1)) {
    access.indices.push_back(static_cast<int>(number(index.value)));
  }
  const Argument& value = list.back();
  if (value.type == Type::Frame) {
    return set_frame(channel_, access, frame(value.value));
  }
  if (value.type == Type::String) {
    Tool* const tool = channel_.tool_to_write(access.indices[0]);
    if (tool == nullptr) {
      return failure(AlarmId::BadTNumber, fmt::format("T{}", access.indices[0]));
    }
    tool->name = text(value.value);
    return std::nullopt;
  }
  return set_number(channel_, access, number(value.value));
}

}  // namespace g31::sinumerik
