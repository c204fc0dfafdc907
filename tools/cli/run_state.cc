#include "tools/cli/run_state.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace g31::cli {
namespace {

using runtime::Cell;
using runtime::Scope;
using runtime::ShownValue;

bool are_equal(const ShownValue& a, const ShownValue& b) {
  const auto* const text = std::get_if<std::string>(&a);
  const auto* const other = std::get_if<std::string>(&b);
  if (text != nullptr || other != nullptr) {
    return text != nullptr && other != nullptr && *text == *other;
  }
  return equal(std::get<Cell>(a), std::get<Cell>(b));
}

/// Where nothing has written it yet.
ShownValue fresh_value(const StateValue& of, const session::Session& session) {
  if (of.fresh) {
    return *of.fresh;
  }
  return std::holds_alternative<std::string>(of.value) ? ShownValue(std::string())
                                                       : ShownValue(session.unset_number());
}

}  // namespace

RunState state_of(session::Session& session) {
  RunState state;
  for (const auto& [name, value] : session.values(0, Scope::Common)) {
    state[name] = {value, std::nullopt};
  }
  for (const auto& [name, value] : session.values_at_start()) {
    state[name].fresh = value;
  }
  for (const auto& [name, entry] : session.tables()) {
    state[name] = {Cell(entry.value), Cell(entry.fresh)};
  }
  return state;
}

std::vector<report::ValueChange> changes_since(const RunState& before, session::Session& session) {
  const RunState after = state_of(session);
  std::map<std::string, report::ValueChange> changes;
  for (const auto& [name, now] : after) {
    const auto was = before.find(name);
    const ShownValue old = was != before.end() ? was->second.value : fresh_value(now, session);
    if (!are_equal(old, now.value)) {
      changes[name] = {name, old, now.value};
    }
  }
  for (const auto& [name, was] : before) {
    if (!after.contains(name)) {
      const auto now = session.variable(name);
      const bool is_variable = !was.fresh && now;
      changes[name] = {name, was.value, is_variable ? now.value() : fresh_value(was, session)};
    }
  }
  std::vector<report::ValueChange> list;
  for (auto& [name, change] : changes) {
    list.push_back(std::move(change));
  }
  return list;
}

runtime::NamedValues all_values(session::Session& session) {
  runtime::NamedValues values = session.values(0, Scope::Common);
  if (const std::size_t levels = session.call_levels().size(); levels > 0) {
    std::ranges::move(session.values(levels - 1, Scope::Local), std::back_inserter(values));
  }
  return values;
}

runtime::NamedValues locals_of(session::Session& session, const runtime::Alarm& alarm) {
  const auto levels = session.call_levels();
  const auto level = std::ranges::find(levels, alarm.level, &runtime::CallLevel::number);
  return level != levels.end()
             ? session.values(static_cast<std::size_t>(level - levels.begin()), Scope::Local)
             : runtime::NamedValues();
}

}  // namespace g31::cli
