#include "tools/page/html.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "machine/base/utf_8.h"

namespace g31::page {

std::string escaped(std::string_view bytes) {
  const std::string utf_8 = as_valid_utf_8(bytes);
  std::string html;
  html.reserve(utf_8.size());
  for (const char c : utf_8) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      case '\'':
        html += "&#39;";
        break;
      default:
        if (static_cast<unsigned char>(c) >= ' ' || c == '\t' || c == '\n') {
          html += c;
        }
    }
  }
  return html;
}

std::string number(const std::optional<double>& value, int decimals, ShowSign sign) {
  if (!value || !std::isfinite(*value)) {
    return "–";
  }
  const std::string digits = fmt::format("{:.{}f}", std::abs(*value), decimals);
  if (digits.find_first_not_of("0.") == std::string::npos) {
    return digits;
  }
  const char* const shown = *value < 0.0 ? "−" : sign == ShowSign::Always ? "+" : "";
  return shown + digits;
}

std::string significant(const std::optional<double>& value, int decimals, ShowSign sign) {
  constexpr int kMostWrittenDecimals = 9;
  if (!value || !std::isfinite(*value) || *value == 0.0) {
    return number(value, decimals, sign);
  }
  std::string text = fmt::format("{:.1e}", std::abs(*value));
  const std::size_t exponent = text.find('e') + 1;
  int power = 0;
  std::from_chars(text.data() + exponent + (text[exponent] == '+' ? 1 : 0),
                  text.data() + text.size(), power);
  if (1 - power <= kMostWrittenDecimals) {
    return number(value, std::max(decimals, 1 - power), sign);
  }
  text = fmt::format("{}e−{}", text.substr(0, exponent - 1), -power);
  return (*value < 0.0 ? "−" : sign == ShowSign::Always ? "+" : "") + text;
}

int decimals_apart(double value, double limit, int decimals) {
  constexpr int kMostComparedDecimals = 15;
  for (int more = decimals; more <= kMostComparedDecimals; ++more) {
    if (number(value, more) != number(limit, more)) {
      return more;
    }
  }
  return decimals;
}

std::string micrometres(const std::optional<double>& value_mm) {
  return number(value_mm ? std::optional(*value_mm * kUmPerMm) : std::nullopt, 1, ShowSign::Always);
}

std::string json_for_script(std::string_view json) {
  std::string safe;
  safe.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

}  // namespace g31::page
