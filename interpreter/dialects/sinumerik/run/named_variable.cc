#include "interpreter/dialects/sinumerik/run/named_variable.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/dialects/sinumerik/vocabulary/frame_components.h"
#include "interpreter/dialects/sinumerik/vocabulary/names.h"
#include "interpreter/dialects/sinumerik/vocabulary/system_variables.h"
#include "machine/base/letters.h"

namespace g31::sinumerik {
namespace {

constexpr std::string_view kNameCharacters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_$";

/// NAME or NAME[first,second]; an index may be left out.
struct Written {
  std::string name;  ///< upper case
  bool has_brackets = false;
  std::vector<std::string> indices;  ///< upper case, without blanks
};

std::string without_blanks(std::string_view text) {
  std::string rest = upper(text);
  std::erase(rest, ' ');
  return rest;
}

/// Nullopt: brackets are not closed, or something stands behind them.
std::optional<Written> written_in(std::string_view text) {
  const std::string all = without_blanks(text);
  const std::size_t open = all.find('[');
  Written written;
  written.name = all.substr(0, open);
  if (open == std::string::npos) {
    return written;
  }
  const std::size_t close = all.find(']', open);
  if (close + 1 != all.size()) {
    return std::nullopt;
  }
  written.has_brackets = true;
  for (std::size_t begin = open + 1; begin <= close;) {
    const std::size_t end = std::min(all.find(',', begin), close);
    written.indices.push_back(all.substr(begin, end - begin));
    begin = end + 1;
  }
  return written;
}

std::optional<int> whole_number(std::string_view text) {
  int number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  return read.ec == std::errc() && read.ptr == text.data() + text.size() ? std::optional(number)
                                                                         : std::nullopt;
}

/// R5 for R[5].
std::optional<Written> as_element(const Written& written) {
  const std::string_view digits = std::string_view(written.name).substr(1);
  const bool is_r = written.name.starts_with('R') && !digits.empty() && !written.has_brackets &&
                    std::ranges::all_of(digits, [](char c) { return is_digit(c); });
  return is_r ? std::optional(Written{"R", true, {std::string(digits)}}) : std::nullopt;
}

/// Of an index as it is written: whether it may be one of its kind.  Only a whole number says which
/// element it means; of what is to be worked out nothing is known.
struct IndexCheck {
  const Globals& globals;
  const CompiledProgram& program;

  [[nodiscard]] bool is_number(const std::string& index, int below) const {
    const auto number = whole_number(index);
    return number ? *number >= 0 && *number < below : is_axis(index);
  }
  [[nodiscard]] bool is_axis(const std::string& index) const {
    const bool is_one_name = index.find_first_not_of(kNameCharacters) == std::string::npos;
    return !is_one_name || globals.axis(index) >= 0 || names_variable(globals, program, index);
  }
  static bool is_component(const std::string& index) { return find_component(index).has_value(); }
};

/// As many indices as it has dimensions; a frame goes on with an axis and a component, a text with
/// a character.
bool has_element(const IndexCheck& check, const Variable& variable, const Written& written) {
  const auto own = static_cast<std::size_t>(variable.shape.dimensions);
  const std::size_t count = written.indices.size();
  const bool is_of_frame = variable.type == Type::Frame && count == own + 2;
  const bool is_character = variable.type == Type::String && count == own + 1;
  if (count != own && !is_of_frame && !is_character) {
    return false;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::string& index = written.indices[i];
    const bool fits = index.empty()  ? i < own
                      : i < own      ? check.is_number(index, variable.shape.size[i])
                      : is_character ? check.is_number(index, variable.longest)
                      : i == own     ? check.is_axis(index)
                                     : IndexCheck::is_component(index);
    if (!fits) {
      return false;
    }
  }
  return true;
}

/// Indices by their kinds, as the table of system variables has them; a frame goes on with an axis
/// and a component.
bool has_element(const IndexCheck& check, const SystemVariable& row, const Written& written) {
  std::string kinds(row.indices);
  const auto must = static_cast<std::size_t>(
      std::ranges::count_if(kinds, [](char kind) { return kind == 'N' || kind == 'A'; }));
  const std::size_t own = kinds.size();
  kinds += row.type == Type::Frame ? "AC" : "";
  const std::size_t count = written.indices.size();
  if (count > kinds.size() || count < must || (count > own && count != kinds.size())) {
    return false;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::string& index = written.indices[i];
    const bool fits = index.empty()     ? true
                      : kinds[i] == 'C' ? IndexCheck::is_component(index)
                      : kinds[i] == 'A' ? check.is_axis(index)
                                        : check.is_number(index, std::numeric_limits<int>::max());
    if (!fits) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool names_variable(const Globals& globals, const CompiledProgram& program, std::string_view text) {
  auto written = written_in(text);
  if (!written || written->name.empty()) {
    return false;
  }
  const auto local = program.locals.find(written->name);
  const Variable* variable = local != program.locals.end()
                                 ? &program.variables[static_cast<std::size_t>(local->second)]
                                 : globals.find(written->name);
  if (variable == nullptr) {
    if (const auto element = as_element(*written)) {
      written = element;
      variable = globals.find(written->name);
    }
  }
  if (variable == nullptr && program.sees_main) {
    variable = globals.find_of_main(written->name);
  }
  const IndexCheck check{globals, program};
  if (variable != nullptr) {
    return !written->has_brackets || has_element(check, *variable, *written);
  }
  const auto system = find_system_variable(written->name);
  return system && (!written->has_brackets || has_element(check, *system->row, *written));
}

}  // namespace g31::sinumerik
