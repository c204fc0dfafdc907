#include "tools/page/html.h"

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

std::string micrometres(const std::optional<double>& value_mm) {
  constexpr double kUmPerMm = 1000.0;
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
