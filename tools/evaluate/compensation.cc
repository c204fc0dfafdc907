#include "tools/evaluate/compensation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/evaluate/fanuc_compensation.h"
#include "tools/evaluate/sinumerik_compensation.h"

namespace g31::evaluate {
namespace {

struct FormatRow {
  CompensationFormat format;
  std::string_view word;
};

constexpr std::array kFormats = {
#define COMPENSATION_FORMAT(name, word, text) FormatRow{CompensationFormat::name, word},
#include "tools/evaluate/compensation_formats.def"
#undef COMPENSATION_FORMAT
};

/// A set-up sheet: a pair of place and correction, the deviation with its sign reversed, for every
/// point of the curve.
std::string compensation_sheet(const MachineError& error) {
  std::string text = fmt::format(
      "# Corrections, mm, at machine coordinates of the moving axis.\n[machine.compensation]\n"
      "{} = [\n",
      error.name);
  for (const auto& [place, deviation] : error.deviations.points) {
    // Adding 0 makes a zero of -0; TOML wants a point in a number.
    text += fmt::format("  [{:.6f}, {:.9f}],\n", place + 0.0, 0.0 - deviation);
  }
  return text + "]\n";
}

bool is_linear_axis(char axis) {
  return axis == 'X' || axis == 'Y' || axis == 'Z';
}

}  // namespace

std::optional<CompensationFormat> compensation_format(std::string_view word) {
  for (const FormatRow& row : kFormats) {
    if (word.empty() || row.word == word) {
      return row.format;
    }
  }
  return std::nullopt;
}

std::vector<std::string> compensation_format_names() {
  std::vector<std::string> names;
  for (const FormatRow& row : kFormats) {
    names.emplace_back(row.word);
  }
  return names;
}

std::optional<std::string> why_no_compensation(CompensationFormat format,
                                               const MachineError& error) {
  const bool is_known =
      error.name.size() == 3 && is_linear_axis(error.name[1]) && is_linear_axis(error.name[2]);
  if (!is_known) {
    return fmt::format("{} is compensated on no machine of g31; the axes are X, Y and Z",
                       error.name);
  }
  if (error.deviations.points.size() < 2) {
    return "a compensation runs between two places at least, and the record has one";
  }
  constexpr double kLeastStep = 1e-6;  // places have so many decimals
  const auto are_too_near = [](const auto& before, const auto& behind) {
    return std::abs(behind[0] - before[0]) < kLeastStep;
  };
  if (std::ranges::adjacent_find(error.deviations.points, are_too_near) !=
      error.deviations.points.end()) {
    return fmt::format("places of a compensation are {} mm apart at least", kLeastStep);
  }
  return format == CompensationFormat::Fanuc ? why_no_fanuc_compensation(error) : std::nullopt;
}

std::string compensation_text(CompensationFormat format, const MachineError& error) {
  switch (format) {
    case CompensationFormat::Sinumerik:
      return sinumerik_compensation(error);
    case CompensationFormat::Fanuc:
      return fanuc_compensation(error);
    case CompensationFormat::Sheet:
      break;
  }
  return compensation_sheet(error);
}

}  // namespace g31::evaluate
