#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "parts/import/text_lines.h"
#include "parts/import/whole_file.h"

namespace g31::parts {
namespace {

struct PlyType {
  std::string_view name;
  std::size_t bytes;
  bool is_signed;
};

constexpr PlyType kPlyTypes[] = {
    {"char", 1, true},   {"int8", 1, true},     {"uchar", 1, false},  {"uint8", 1, false},
    {"short", 2, true},  {"int16", 2, true},    {"ushort", 2, false}, {"uint16", 2, false},
    {"int", 4, true},    {"int32", 4, true},    {"uint", 4, false},   {"uint32", 4, false},
    {"float", 4, false}, {"float32", 4, false}, {"double", 8, false}, {"float64", 8, false},
};

const PlyType* ply_type(std::string_view name) {
  const auto* const row = std::ranges::find(kPlyTypes, name, &PlyType::name);
  return row == std::end(kPlyTypes) ? nullptr : row;
}

struct PlyProperty {
  const PlyType* count = nullptr;  ///< of a list
  const PlyType* value = nullptr;
};

struct PlyElement {
  std::string_view name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Of one in the binary form, lists empty.
  [[nodiscard]] std::size_t least_bytes() const {
    std::size_t bytes = 0;
    for (const PlyProperty& property : properties) {
      bytes += (property.count != nullptr ? property.count : property.value)->bytes;
    }
    return bytes;
  }
};

enum class PlyForm { Text, LittleEndian, BigEndian };

class PlyCheck {
 public:
  explicit PlyCheck(std::string_view bytes) : lines_(bytes) {}

  std::optional<std::string> why_not() {
    auto wrong = of_head();
    for (std::size_t i = 0; !wrong && i < elements_.size(); ++i) {
      wrong = promises_too_much(elements_[i]);
    }
    if (!wrong) {
      wrong = form_ == PlyForm::Text ? of_text() : of_binary();
    }
    return wrong;
  }

 private:
  std::optional<std::string> of_head() {
    if (const auto first = lines_.next(); !first || *first != "ply") {
      return "a PLY file begins with a line ply";
    }
    while (const auto line = lines_.next()) {
      std::string_view rest = *line;
      const std::string_view word = take_word(rest);
      if (word == "end_header") {
        return std::nullopt;
      }
      const bool is_known = word == "comment" || word == "obj_info" || word.empty() ||
                            (word == "format" && takes_form(rest)) ||
                            (word == "element" && takes_element(rest)) ||
                            (word == "property" && !elements_.empty() && takes_property(rest));
      if (!is_known) {
        return fmt::format("line {}: no line of the head of a PLY file", lines_.number());
      }
    }
    return "it ends within its head: it was cut off";
  }

  bool takes_form(std::string_view rest) {
    const std::string_view name = take_word(rest);
    form_ = name == "binary_little_endian" ? PlyForm::LittleEndian
            : name == "binary_big_endian"  ? PlyForm::BigEndian
                                           : PlyForm::Text;
    return form_ != PlyForm::Text || name == "ascii";
  }

  bool takes_element(std::string_view rest) {
    PlyElement element;
    element.name = take_word(rest);
    const auto count = number_in<std::uint64_t>(take_word(rest));
    element.count = count.value_or(0);
    elements_.push_back(element);
    return count.has_value();
  }

  bool takes_property(std::string_view rest) {
    PlyProperty property;
    std::string_view type = take_word(rest);
    if (type == "list") {
      property.count = ply_type(take_word(rest));
      if (property.count == nullptr) {
        return false;
      }
      type = take_word(rest);
    }
    property.value = ply_type(type);
    elements_.back().properties.push_back(property);
    return property.value != nullptr && !take_word(rest).empty();
  }

  /// Before anything is read, or memory asked for.
  [[nodiscard]] std::optional<std::string> promises_too_much(const PlyElement& element) const {
    if (element.count == 0) {
      return std::nullopt;
    }
    // As a text each value has a digit and an end, which the last one may lack.
    const std::size_t least =
        form_ == PlyForm::Text ? 2 * element.properties.size() : element.least_bytes();
    const std::size_t held = lines_.rest().size() + (form_ == PlyForm::Text ? 1 : 0);
    if (least == 0 || element.count > held / least) {
      return fmt::format(
          "its head promises {} of element {}, and {} bytes follow: it was cut off, "
          "or its head lies",
          element.count, element.name, lines_.rest().size());
    }
    return std::nullopt;
  }

  std::optional<std::string> of_text() {
    for (const PlyElement& element : elements_) {
      for (std::uint64_t i = 0; i < element.count; ++i) {
        std::string_view line = next_text_line();
        if (!has_values(element, line)) {
          return fmt::format("line {}: expected element {} number {} of {}{}", lines_.number(),
                             element.name, i + 1, element.count,
                             lines_.rest().empty() ? "; here the file ends: it was cut off" : "");
        }
      }
    }
    return next_text_line().empty() ? std::nullopt : std::optional(goes_on());
  }

  std::string_view next_text_line() {
    while (const auto line = lines_.next()) {
      std::string_view words = *line;
      if (!take_word(words).empty()) {
        return *line;
      }
    }
    return {};
  }

  static bool has_values(const PlyElement& element, std::string_view& line) {
    for (const PlyProperty& property : element.properties) {
      std::uint64_t values = 1;
      if (property.count != nullptr) {
        const auto listed = number_in<std::uint64_t>(take_word(line));
        if (!listed) {
          return false;
        }
        values = *listed;
      }
      for (std::uint64_t i = 0; i < values; ++i) {
        if (!number_in<double>(take_word(line))) {
          return false;
        }
      }
    }
    return take_word(line).empty();
  }

  std::optional<std::string> of_binary() {
    std::string_view rest = lines_.rest();
    for (const PlyElement& element : elements_) {
      for (std::uint64_t i = 0; i < element.count; ++i) {
        if (!takes_values(element, rest)) {
          return fmt::format(
              "it ends within element {} number {} of {}: it was cut off, or is "
              "damaged",
              element.name, i + 1, element.count);
        }
      }
    }
    return rest.empty() ? std::nullopt : std::optional(goes_on());
  }

  [[nodiscard]] bool takes_values(const PlyElement& element, std::string_view& rest) const {
    for (const PlyProperty& property : element.properties) {
      std::uint64_t values = 1;
      if (property.count != nullptr) {
        if (rest.size() < property.count->bytes) {
          return false;
        }
        values = listed_count(*property.count, rest);
        rest.remove_prefix(property.count->bytes);
      }
      if (values > rest.size() / property.value->bytes) {
        return false;
      }
      rest.remove_prefix(static_cast<std::size_t>(values) * property.value->bytes);
    }
    return true;
  }

  /// A negative one is as good as one beyond every file.
  [[nodiscard]] std::uint64_t listed_count(const PlyType& type, std::string_view bytes) const {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < type.bytes; ++i) {
      const std::size_t at = form_ == PlyForm::BigEndian ? i : type.bytes - 1 - i;
      count = count << 8U | static_cast<unsigned char>(bytes[at]);
    }
    const bool is_negative = type.is_signed && (count >> (8 * type.bytes - 1)) != 0;
    return is_negative ? ~std::uint64_t{0} : count;
  }

  [[nodiscard]] std::string goes_on() const {
    return "it goes on behind the elements that its head promises";
  }

  TextLines lines_;
  PlyForm form_ = PlyForm::Text;
  std::vector<PlyElement> elements_;
};

}  // namespace

std::optional<std::string> why_no_whole_ply(std::string_view bytes) {
  return PlyCheck(bytes).why_not();
}

}  // namespace g31::parts
