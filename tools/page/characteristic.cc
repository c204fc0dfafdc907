#include <algorithm>
#include <charconv>
#include <string_view>

#include <fmt/format.h>

#include "tools/page/html.h"
#include "tools/page/report.h"

namespace g31::page {
namespace {

constexpr int kUsualDecimals = 4;
constexpr int kMostDecimals = 6;

/// Of the shortest text that means the number: 3 of 39.996, 5 of 1e-05.
int decimals_in(double value) {
  const std::string text = fmt::format("{}", value);
  const std::size_t exponent = std::min(text.find('e'), text.size());
  const std::size_t point = text.find('.');
  int decimals = point < exponent ? static_cast<int>(exponent - point) - 1 : 0;
  if (exponent < text.size()) {
    int power = 0;
    const std::size_t digits = exponent + (text[exponent + 1] == '+' ? 2 : 1);
    std::from_chars(text.data() + digits, text.data() + text.size(), power);
    decimals -= power;
  }
  return decimals;
}

/// The deviation that a value may have at most on the side where it is out.
double limit_passed(const Characteristic& row) {
  return excess_of(row) > 0.0 ? row.tolerance->upper : row.tolerance->lower;
}

/// Of differences of a row: one, and as many more as tell a deviation from the limit that it is
/// beyond.
int micrometre_decimals(const Characteristic& row) {
  const double um = row.unit->mm * kUmPerMm;
  return is_out(row) ? decimals_apart(*deviation_of(row) * um, limit_passed(row) * um, 1) : 1;
}

std::string_view sign_of(const expect::ResultUnit& unit) {
  return unit.name == "um" ? "µm" : unit.name == "none" ? "" : unit.name;
}

}  // namespace

std::optional<double> deviation_of(const Characteristic& row) {
  return row.measured && row.nominal ? std::optional(*row.measured - *row.nominal) : std::nullopt;
}

double excess_of(const Characteristic& row) {
  const auto deviation = deviation_of(row);
  return deviation && row.tolerance ? expect::excess_of(*deviation, *row.tolerance) : 0.0;
}

bool is_out(const Characteristic& row) {
  return excess_of(row) != 0.0;
}

int decimals_of(const Characteristic& row) {
  if (!row.nominal || !row.tolerance) {
    return kUsualDecimals;
  }
  const int most = std::max({decimals_in(*row.nominal), decimals_in(row.tolerance->lower),
                             decimals_in(row.tolerance->upper)});
  const int usual = std::clamp(most + 1, 0, kMostDecimals);
  return is_out(row) ? decimals_apart(*row.measured, *row.nominal + limit_passed(row), usual)
                     : usual;
}

std::string_view unit_name(const Characteristic& row) {
  return row.unit ? sign_of(*row.unit) : "";
}

std::string difference_text(const Characteristic& row, const std::optional<double>& difference) {
  if (!difference) {
    return "–";
  }
  if (row.unit && row.unit->mm > 0.0) {
    return number(*difference * row.unit->mm * kUmPerMm, micrometre_decimals(row),
                  ShowSign::Always) +
           " µm";
  }
  const std::string_view unit = unit_name(row);
  return number(difference, decimals_of(row), ShowSign::Always) +
         (unit.empty() ? std::string() : fmt::format(" {}", unit));
}

}  // namespace g31::page
