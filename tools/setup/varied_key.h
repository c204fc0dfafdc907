#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "machine/base/result.h"
#include "tools/setup/check_value.h"
#include "tools/setup/keys.h"
#include "tools/setup/sheet.h"

namespace g31::setup {

/// A key of a set-up sheet, named from outside of it.
struct VariedKey {
  std::string path;  ///< as written
  SectionId section = SectionId::Control;
  std::string name;  ///< of a named section, a part, a tool or a tool probe; else ""
  const KeyRow* row = nullptr;
  std::string key;                       ///< in its one spelling
  std::optional<std::size_t> component;  ///< of a key of three numbers
};

/// Takes a path apart: `probe.repeatability_mm`, `machine.axes.X.temperature`, `variables.#517`,
/// `work_offsets.G54.X`, `part.NAME.bore`, `tool.5.length`, `tool_probe.NAME.delay_s`; one of three
/// numbers as `part.NAME.at.X`.
///
/// Error: what is wrong with it, with the nearest known name.
Result<VariedKey, std::string> find_varied_key(std::string_view path);

/// The value of a node as the key wants it.
Result<SheetValue, ValueProblem> value_for(const VariedKey& key, const Node& node);

/// Whether the key takes any number of a range, so that one may be drawn.
bool takes_any_number(const VariedKey& key);

/// Puts the value in the place of the sheet's own.  @returns why there is no such place in this
/// sheet: no part or tool of that name, a size that its shape has not
std::optional<std::string> lay_value(Sheet& sheet, const VariedKey& key, const Entry& entry);

}  // namespace g31::setup
