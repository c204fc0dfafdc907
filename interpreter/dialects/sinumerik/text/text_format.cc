#include "interpreter/dialects/sinumerik/text/text_format.h"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/vocabulary/functions.h"
#include "interpreter/dialects/sinumerik/vocabulary/names.h"
#include "interpreter/dialects/sinumerik/vocabulary/words.h"
#include "machine/units/axis_positions.h"

namespace g31::sinumerik {
namespace {

constexpr int kShownDigits = 10;  // of a REAL behind <<
constexpr int kPlaces = 6;        // of %f and %e without their own
constexpr int kMostWidth = 400;   // of what a directive makes, and of its places

/// %[-+0][width][.places]kind
struct Directive {
  bool left = false;
  bool plus = false;
  bool zeros = false;
  int width = 0;
  std::optional<int> places;
  char kind = '\0';
};

/// The exponent as the language writes it: 1.5e-07 is 1.5EX-07.
std::string with_exponent(std::string text) {
  const std::size_t exponent = text.find('e');
  return exponent == std::string::npos ? text : text.replace(exponent, 1, "EX");
}

/// A constant within a text: its digits, and how many of them are eight bits.
struct Coded {
  int base = 0;
  std::size_t most = 0;
  std::string_view digits;
};

/// What stands at the beginning of `text`, if that is 'H..' or 'B..'.
std::optional<Coded> coded_at(std::string_view text) {
  const char kind = text.size() > 3 && text.front() == '\'' ? upper(text[1]) : '\0';
  const std::size_t end = kind == 'H' || kind == 'B' ? text.find('\'', 2) : std::string_view::npos;
  if (end == std::string_view::npos || end == 2) {
    return std::nullopt;
  }
  Coded found{kind == 'H' ? 16 : 2, kind == 'H' ? 2U : 8U, text.substr(2, end - 2)};
  const std::string_view valid = kind == 'H' ? "0123456789ABCDEFabcdef" : "01";
  const bool is_number = found.digits.find_first_not_of(valid) == std::string_view::npos;
  return is_number ? std::optional(found) : std::nullopt;
}

class DirectiveReader {
 public:
  explicit DirectiveReader(std::string_view rest) : rest_(rest) {}

  /// @returns nullopt when it is cut off or one of its numbers is too large
  std::optional<Directive> read() {
    Directive directive;
    for (;
         at_ < rest_.size() && std::string_view("-+0 ").find(rest_[at_]) != std::string_view::npos;
         ++at_) {
      directive.left = directive.left || rest_[at_] == '-';
      directive.plus = directive.plus || rest_[at_] == '+';
      directive.zeros = directive.zeros || rest_[at_] == '0';
    }
    const auto width = number();
    directive.width = width.value_or(0);
    bool fits = width.has_value();
    if (at_ < rest_.size() && rest_[at_] == '.') {
      ++at_;
      directive.places = number();
      fits = fits && directive.places.has_value();
    }
    if (at_ == rest_.size() || !fits) {
      return std::nullopt;
    }
    directive.kind = upper(rest_[at_++]);
    return directive;
  }
  [[nodiscard]] std::size_t length() const { return at_; }

 private:
  /// 0 where none stands.
  std::optional<int> number() {
    int value = 0;
    const auto read = std::from_chars(rest_.data() + at_, rest_.data() + rest_.size(), value);
    at_ = static_cast<std::size_t>(read.ptr - rest_.data());
    const bool fits =
        read.ec != std::errc::result_out_of_range && value >= 0 && value <= kMostWidth;
    return fits ? std::optional(value) : std::nullopt;
  }

  std::string_view rest_;
  std::size_t at_ = 0;
};

std::optional<std::string> character(double number) {
  constexpr double kLast = 255.0;
  return number >= 0.0 && number <= kLast ? std::optional(shown(Type::Char, number)) : std::nullopt;
}

/// Of 32 bits, the two's complement of negative ones.
std::optional<std::string> hexadecimal(double number) {
  const double whole = std::floor(number + 0.5);
  if (!(whole >= -2147483648.0 && whole <= 4294967295.0)) {
    return std::nullopt;
  }
  return fmt::format("{:X}", bits_of(whole));
}

/// Whether the language makes of a value what a directive shows (Programming Manual Job Planning,
/// implicit conversions): a text is no number, and an axis is its name alone.
bool converts(char kind, Type type) {
  constexpr std::string_view kNumbers = "DFEGX";
  return kind == 'S' || (type != Type::Axis &&
                         (type != Type::String || kNumbers.find(kind) == std::string_view::npos));
}

std::optional<std::string> converted(const Directive& directive, const SprintValue& value) {
  if (!converts(directive.kind, value.type)) {
    return std::nullopt;
  }
  const int places = directive.places.value_or(kPlaces);
  const double number = without_sign_of_zero(value.number);
  switch (directive.kind) {
    case 'B':
      return (value.type == Type::String ? !value.text.empty() : value.number != 0.0) ? "TRUE"
                                                                                      : "FALSE";
    case 'C':
      return value.type == Type::String ? value.text.substr(0, 1) : character(value.number);
    case 'D': {
      const auto whole = kept_as(Type::Int, value.number);
      return whole ? std::optional(fmt::format("{:.0f}", *whole)) : std::nullopt;
    }
    case 'F':
      return fmt::format("{:.{}f}", number, places);
    case 'E':
      return with_exponent(fmt::format("{:.{}e}", number, places));
    case 'G':
      return with_exponent(fmt::format("{:.{}g}", number, places));
    case 'X':
      return hexadecimal(value.number);
    case 'S': {
      std::string text = value.type == Type::String ? value.text : shown(value.type, value.number);
      return directive.places ? text.substr(0, static_cast<std::size_t>(*directive.places)) : text;
    }
    default:
      return std::nullopt;
  }
}

std::string filled(const Directive& directive, std::string text) {
  const bool is_number = std::string_view("DFEG").find(directive.kind) != std::string_view::npos;
  const bool has_digits = is_number || directive.kind == 'X';
  if (directive.plus && is_number && !text.starts_with('-')) {
    text.insert(0, "+");
  }
  const auto width = static_cast<std::size_t>(directive.width);
  if (text.size() >= width) {
    return text;
  }
  const std::size_t missing = width - text.size();
  if (directive.left) {
    return text + std::string(missing, ' ');
  }
  const bool signed_text = text.starts_with('-') || text.starts_with('+');
  const bool zeros = directive.zeros && has_digits;
  text.insert(zeros && signed_text ? 1 : 0, std::string(missing, zeros ? '0' : ' '));
  return text;
}

}  // namespace

std::string shown(Type type, double value) {
  const double number = without_sign_of_zero(value);
  switch (type) {
    case Type::Char:
      return std::string(1, static_cast<char>(static_cast<unsigned char>(number)));
    case Type::Axis:
      return number < 0.0 ? "" : std::string(1, letter_of_axis(static_cast<int>(number)));
    case Type::Real:
      return with_exponent(fmt::format("{:.{}g}", number, kShownDigits));
    case Type::None:
    case Type::Bool:
    case Type::Int:
    case Type::String:
    case Type::Frame:
      return fmt::format("{:.0f}", number);
  }
  return {};
}

std::string written_constant(Type type, double number) {
  if (type == Type::Bool) {
    return number != 0.0 ? "TRUE" : "FALSE";
  }
  if (type == Type::Axis) {
    return number < 0.0 ? "NO_AXIS" : shown(type, number);
  }
  std::string digits = fmt::format("{:.0f}", number);
  if (type == Type::Real) {
    digits = with_exponent(fmt::format("{}", number));
    digits += digits.find_first_of(".E") == std::string::npos ? ".0" : "";  // else it is an INT
  }
  return number < 0.0 ? "(" + digits + ")" : digits;
}

std::string written_constant(std::string_view text) {
  std::string written = "\"";
  for (const char c : text) {
    const bool is_plain = c != '"' && c != '\'' && static_cast<unsigned char>(c) >= ' ';
    written +=
        is_plain ? std::string(1, c) : fmt::format("'H{:02X}'", static_cast<unsigned char>(c));
  }
  return written + "\"";
}

Result<std::string, AlarmId> with_characters(std::string_view written) {
  constexpr std::string_view kQuotes = "'''";
  if (written.find('\'') == std::string_view::npos) {
    return std::string(written);
  }
  std::string text;
  for (std::size_t i = 0; i < written.size();) {
    const std::string_view rest = written.substr(i);
    const bool are_quotes = rest.starts_with(kQuotes);
    const auto coded = are_quotes ? std::nullopt : coded_at(rest);
    if (coded && coded->digits.size() > coded->most) {
      return coded->base == 16 ? AlarmId::HexTooLong : AlarmId::BinaryTooLong;
    }
    if (coded) {
      int code = 0;
      std::from_chars(coded->digits.data(), coded->digits.data() + coded->digits.size(), code,
                      coded->base);
      text.push_back(static_cast<char>(static_cast<unsigned char>(code)));
      i += coded->digits.size() + kQuotes.size();
    } else {
      const std::size_t plain = are_quotes ? kQuotes.size() : 1;
      text += rest.substr(0, plain);
      i += plain;
    }
  }
  return text;
}

std::optional<double> number_in(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) {
    return std::nullopt;
  }
  text = text.substr(first, text.find_last_not_of(' ') - first + 1);
  const bool is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) {
    text.remove_prefix(1);
  }
  const std::size_t exponent = upper(text).find("EX");
  const std::string_view mantissa = text.substr(0, exponent);
  if (mantissa.find_first_not_of("0123456789.") != std::string_view::npos) {
    return std::nullopt;
  }
  std::string plain(text);
  if (exponent != std::string::npos) {
    plain.replace(exponent, 2, "e");
  }
  double number = 0.0;
  const auto read = std::from_chars(plain.data(), plain.data() + plain.size(), number);
  const bool whole = read.ec == std::errc() && read.ptr == plain.data() + plain.size();
  return whole && std::isfinite(number) ? std::optional(is_negative ? -number : number)
                                        : std::nullopt;
}

std::optional<std::string> sprint(std::string_view format, const std::vector<SprintValue>& values) {
  std::string text;
  std::size_t used = 0;
  for (std::size_t i = 0; i < format.size(); ++i) {
    if (format[i] != '%') {
      text.push_back(format[i]);
      continue;
    }
    if (i + 1 < format.size() && format[i + 1] == '%') {
      text.push_back(format[++i]);
      continue;
    }
    DirectiveReader reader(format.substr(i + 1));
    const auto directive = reader.read();
    const auto piece =
        directive && used < values.size() ? converted(*directive, values[used]) : std::nullopt;
    if (!piece) {
      return std::nullopt;
    }
    ++used;
    text += filled(*directive, *piece);
    i += reader.length();
  }
  return text;
}

}  // namespace g31::sinumerik
