#include "tools/cli/result_watch.h"

#include <charconv>

namespace g31::cli {
namespace {

using runtime::Cell;
using runtime::ShownValue;

/// As WriteEvent has it, but for capitals: R[16] is R16 there.
std::string written_name(const std::string& name) {
  std::string written = setup::normal_variable_name(name).value_or(name);
  if (written.size() > 2 && (written[0] == 'R' || written[0] == 'r') && written[1] == '[') {
    written.pop_back();
    written.erase(1, 1);
  }
  return written;
}

/// What the control itself changes, or G10 does: assignments alone do not tell.
bool is_of_control(const std::string& name) {
  constexpr int kFirstSystemVariable = 1000;
  int number = 0;
  if (name.starts_with('#')) {
    std::from_chars(name.data() + 1, name.data() + name.size(), number);
  }
  return name.starts_with('$') || number >= kFirstSystemVariable;
}

}  // namespace

ResultWatch::ResultWatch(const expect::Expectations& expectations, const ValueOf& value_of,
                         runtime::BlockListener* other)
    : other_(other) {
  for (const expect::Characteristic& what : expectations.characteristics) {
    const auto value = value_of(what.variable);
    const auto* const cell = value ? std::get_if<Cell>(&*value) : nullptr;
    if (cell != nullptr && !cell->is_vacant() && !is_of_control(what.variable)) {
      before_.emplace(written_name(what.variable), *value);
    }
  }
}

bool ResultWatch::is_from_before(const std::string& name, const ShownValue& now) const {
  const auto found = before_.find(written_name(name));
  return found != before_.end() && !written_.contains(found->first) && now == found->second;
}

runtime::Verdict ResultWatch::on_block(const runtime::BlockPlace& place) {
  return other_ != nullptr ? other_->on_block(place) : runtime::Verdict::Run;
}

void ResultWatch::on_level(std::uint16_t depth, const std::string& program) {
  if (other_ != nullptr) {
    other_->on_level(depth, program);
  }
}

void ResultWatch::on_write(const runtime::WriteEvent& event) {
  if (before_.contains(event.name)) {
    written_.insert(event.name);
  }
  if (other_ != nullptr) {
    other_->on_write(event);
  }
}

void ResultWatch::on_condition(const source::Location& where, bool is_met) {
  if (other_ != nullptr) {
    other_->on_condition(where, is_met);
  }
}

}  // namespace g31::cli
