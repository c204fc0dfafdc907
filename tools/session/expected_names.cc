#include "tools/session/expected_names.h"

#include <string>

#include <fmt/format.h>

namespace g31::session {
namespace {

/// A name of a sheet or of --expect that the control has not.
Refusal refused_name(const source::ShownPlace& at, const std::string& wrong) {
  return refusal_of({error_at({at.file, at.line, at.column, at.text},
                              setup::SetupErrorId::SettingRefused, {wrong})});
}

}  // namespace

std::optional<Refusal> wrong_expectation(const expect::Expectations& expectations, Run& run) {
  for (const expect::Characteristic& row : expectations.characteristics) {
    if (const auto wrong = run.wrong_name({row.variable})) {
      return refused_name(row.place, *wrong);
    }
  }
  for (const expect::Expectation& row : expectations.rows) {
    std::optional<std::string> wrong;
    if (const auto* const variable = std::get_if<expect::Variable>(&row.what)) {
      wrong = run.wrong_name({variable->name});
    } else if (const auto* const offset = std::get_if<expect::WorkOffset>(&row.what);
               offset != nullptr && !run.session().work_offset(offset->name, 0)) {
      wrong = fmt::format("work offset {}: this control has none of this name", offset->name);
    }
    if (wrong) {
      return refused_name(row.place, *wrong);
    }
  }
  return std::nullopt;
}

}  // namespace g31::session
