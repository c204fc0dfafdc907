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

/// What stands at one place between the brackets.
struct Slot {
  enum class Kind { Number, Axis, Component };
  Kind kind = Kind::Number;
  int below = std::numeric_limits<int>::max();  ///< of Number
  bool may_be_empty = true;
};

/// As many indices as `fewest` to `most`, or all slots: a frame goes on with an axis and a
/// component.
struct Slots {
  std::vector<Slot> all;
  std::size_t fewest = 0;
  std::size_t most = 0;
};

/// One for each dimension; a text goes on with a character.
Slots slots_of(const Variable& variable) {
  const auto own = static_cast<std::size_t>(variable.shape.dimensions);
  Slots slots{{}, own, own};
  for (std::size_t i = 0; i < own; ++i) {
    slots.all.push_back({Slot::Kind::Number, variable.shape.size[i]});
  }
  if (variable.type == Type::Frame) {
    slots.all.push_back({Slot::Kind::Axis, 0, false});
    slots.all.push_back({Slot::Kind::Component, 0, false});
  } else if (variable.type == Type::String) {
    slots.all.push_back({Slot::Kind::Number, variable.longest, false});
  }
  return slots;
}

/// As the table of system variables has them: small letters may be left out.
Slots slots_of(const SystemVariable& row) {
  Slots slots{{}, 0, row.indices.size()};
  for (const char kind : row.indices) {
    slots.all.push_back({kind == 'A' ? Slot::Kind::Axis : Slot::Kind::Number});
    slots.fewest += kind == 'N' || kind == 'A' ? 1 : 0;
  }
  if (row.type == Type::Frame) {
    slots.all.push_back({Slot::Kind::Axis});
    slots.all.push_back({Slot::Kind::Component});
  }
  return slots;
}

/// Of an index as it is written: whether it may be one of its kind.  Only a whole number says which
/// element it means; of what is to be worked out nothing is known.
class IndexCheck {
 public:
  /// Both outlive it.
  IndexCheck(const Globals& globals, const CompiledProgram& program)
      : globals_(globals), program_(program) {}

  [[nodiscard]] bool fits(const std::string& index, const Slot& slot) const {
    if (index.empty()) {
      return slot.may_be_empty;
    }
    if (slot.kind == Slot::Kind::Component) {
      return find_component(index).has_value();
    }
    const auto number = slot.kind == Slot::Kind::Number ? whole_number(index) : std::nullopt;
    return number ? *number >= 0 && *number < slot.below : may_be_axis(index);
  }

 private:
  [[nodiscard]] bool may_be_axis(const std::string& index) const {
    const bool is_one_name = index.find_first_not_of(kNameCharacters) == std::string::npos;
    return !is_one_name || globals_.axis(index) >= 0 || names_variable(globals_, program_, index);
  }

  const Globals& globals_;
  const CompiledProgram& program_;
};

bool has_element(const IndexCheck& check, const Slots& slots, const Written& written) {
  const std::size_t count = written.indices.size();
  if ((count < slots.fewest || count > slots.most) && count != slots.all.size()) {
    return false;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!check.fits(written.indices[i], slots.all[i])) {
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
  const IndexCheck check(globals, program);
  if (variable != nullptr) {
    return !written->has_brackets || has_element(check, slots_of(*variable), *written);
  }
  const auto system = find_system_variable(written->name);
  return system && (!written->has_brackets || has_element(check, slots_of(*system->row), *written));
}

}  // namespace g31::sinumerik
