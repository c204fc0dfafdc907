#include "interpreter/dialects/sinumerik/code/sheet_data.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/vocabulary/names.h"
#include "interpreter/dialects/sinumerik/vocabulary/system_variables.h"
#include "interpreter/dialects/sinumerik/vocabulary/words.h"

namespace g31::sinumerik {
namespace {

constexpr std::string_view kAxisMark = "axis ";
constexpr std::int32_t kLongestText = 200;
constexpr int kLargestIndex = 9999;

/// The name of a datum and the sizes that its indices ask for.
struct Named {
  std::string stem;
  Shape shape;
};

/// One more than an index; an axis stands for all of them.
int size_for(std::string_view index) {
  int number = 0;
  const auto read = std::from_chars(index.data(), index.data() + index.size(), number);
  const bool is_number = read.ec == std::errc() && read.ptr == index.data() + index.size();
  return is_number ? std::clamp(number, 0, kLargestIndex) + 1 : static_cast<int>(kAxisCount);
}

Named named(std::string_view written) {
  const std::size_t bracket = std::min(written.find('['), written.size());
  Named found{upper(written.substr(0, bracket)), {}};
  std::string_view rest = written.substr(std::min(bracket + 1, written.size()));
  while (!rest.empty() && found.shape.dimensions < Shape::kMostDimensions) {
    const std::size_t end = std::min(rest.find_first_of(",]"), rest.size());
    found.shape.size[static_cast<std::size_t>(found.shape.dimensions++)] =
        size_for(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return found;
}

Type type_of(const SheetDatum& datum) {
  const auto* const text = std::get_if<std::string>(&datum);
  return text == nullptr ? Type::Real : text->starts_with(kAxisMark) ? Type::Axis : Type::String;
}

}  // namespace

void define_missing(const SheetData& data, Globals& globals) {
  std::map<std::string, Variable> missing;
  for (const auto& [written, datum] : data) {
    Named found = named(written);
    const auto system = find_system_variable(found.stem);
    const bool has_value = system && system->row->access != Access::Refused;
    if (has_value || globals.find(found.stem) != nullptr) {
      continue;
    }
    if (const auto* const list = std::get_if<std::vector<double>>(&datum)) {
      found.shape = {1, {static_cast<int>(std::max<std::size_t>(list->size(), 1)), 1, 1}};
    }
    Variable& variable = missing[found.stem];
    variable.name = found.stem;
    variable.type = type_of(datum);
    variable.longest = variable.type == Type::String ? kLongestText : 0;
    variable.shape.dimensions = std::max(variable.shape.dimensions, found.shape.dimensions);
    for (std::size_t i = 0; i < found.shape.size.size(); ++i) {
      variable.shape.size[i] = std::max(variable.shape.size[i], found.shape.size[i]);
    }
  }
  for (const auto& [name, variable] : missing) {
    globals.define(variable);
  }
}

void shorten_memory(const SheetData& data, Globals& globals) {
  for (const auto& [name, datum] : data) {
    const auto* const count = std::get_if<double>(&datum);
    const std::string known = upper(name);
    if (count != nullptr && known == "$MC_MM_NUM_AC_PARAM") {
      globals.shorten("$AC_PARAM", static_cast<int>(*count));
    } else if (count != nullptr && known == "$MC_MM_NUM_AC_MARKER") {
      globals.shorten("$AC_MARKER", static_cast<int>(*count));
    }
  }
}

bool are_main_variables_global(const SheetData& data) {
  return std::ranges::none_of(data, [](const auto& row) {
    const auto* const value = std::get_if<double>(&row.second);
    return value != nullptr && *value == 0.0 && upper(row.first) == "$MN_LUD_EXTENDED_SCOPE";
  });
}

std::string written_number(double value) {
  std::string number = fmt::format("{}", value);
  if (const std::size_t exponent = number.find('e'); exponent != std::string::npos) {
    number.replace(exponent, 1, "EX");
  }
  return number;
}

std::vector<std::string> assignments_of(const std::string& name, const SheetDatum& datum) {
  std::vector<std::string> all;
  if (const auto* const list = std::get_if<std::vector<double>>(&datum)) {
    for (std::size_t i = 0; i < list->size(); ++i) {
      all.push_back(fmt::format("{}[{}]={}", name, i, written_number((*list)[i])));
    }
  } else if (const auto* const text = std::get_if<std::string>(&datum)) {
    all.push_back(text->starts_with(kAxisMark)
                      ? fmt::format("{}={}", name, text->substr(kAxisMark.size()))
                      : fmt::format("{}=\"{}\"", name, *text));
  } else {
    all.push_back(fmt::format("{}={}", name, written_number(std::get<double>(datum))));
  }
  return all;
}

}  // namespace g31::sinumerik
