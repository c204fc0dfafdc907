#include "interpreter/dialects/fanuc/vocabulary/g_codes.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace g31::fanuc {
namespace {

constexpr auto kGCodeRows = std::to_array<GCode>({
#define G_CODE(whole, tenth, group, action, text) \
  G_CODE_OF(Family, whole, tenth, group, action, text)
#define G_CODE_OF(set, whole, tenth, group, action, text) \
  {{whole, tenth}, Group::group, GAction::action, CodeSet::set, text},
#include "interpreter/dialects/fanuc/vocabulary/g_codes.def"
#undef G_CODE_OF
#undef G_CODE
});

constexpr std::size_t key(GNumber number) {
  return static_cast<std::size_t>(number.whole) * 10 + static_cast<std::size_t>(number.tenth);
}

consteval bool g_codes_rise() {
  for (std::size_t i = 1; i < kGCodeRows.size(); ++i) {
    const GCode& before = kGCodeRows[i - 1];
    const GCode& row = kGCodeRows[i];
    if (row.number < before.number || (row.number == before.number && row.set <= before.set)) {
      return false;
    }
  }
  return true;
}
static_assert(g_codes_rise(), "g_codes.def: rows must rise, of one number by their set");

constexpr std::size_t kKeys = 1000 * 10;
constexpr std::size_t kSets = static_cast<std::size_t>(CodeSet::Mazak) + 1;

/// Whether a control whose own codes are `set` has the row, if no row behind it takes its place.
constexpr bool has(std::size_t set, const GCode& row) {
  return row.set == CodeSet::Family || static_cast<std::size_t>(row.set) == set ||
         (row.set == CodeSet::Meldas && set == static_cast<std::size_t>(CodeSet::Mazak));
}

/// Row index + 1 by set and key: a million blocks look their codes up here.
constexpr auto kIndex = [] {
  std::array<std::array<std::uint8_t, kKeys>, kSets> index{};
  for (std::size_t i = 0; i < kGCodeRows.size(); ++i) {
    const GCode& row = kGCodeRows[i];
    for (std::size_t set = 0; set < kSets; ++set) {
      // Of one number the family's row comes first: that of the set takes its place.
      if (has(set, row)) {
        index[set][key(row.number)] = static_cast<std::uint8_t>(i + 1);
      }
    }
  }
  return index;
}();
static_assert(kGCodeRows.size() < 255);

}  // namespace

std::string to_text(GNumber number) {
  return number.tenth == 0 ? fmt::format("G{:02}", number.whole)
                           : fmt::format("G{}.{}", number.whole, number.tenth);
}

std::span<const GCode> g_codes() {
  return kGCodeRows;
}

[[gnu::hot]] const GCode* find_g_code(GNumber number, CodeSet own) {
  const std::size_t place = key(number);
  const auto& index = kIndex[static_cast<std::size_t>(own)];
  return place < kKeys && index[place] != 0 ? &kGCodeRows[index[place] - 1] : nullptr;
}

[[gnu::hot]] const GCode* find_g_code(double value, CodeSet own) {
  const auto plain = static_cast<std::int16_t>(value >= 0.0 && value < 1000.0 ? value : 0.0);
  if (plain == value) {
    return find_g_code(GNumber{plain, 0}, own);
  }
  const double tenths = value * 10.0;
  if (value < 0.0 || value >= 1000.0 || std::abs(tenths - std::round(tenths)) > 1e-6) {
    return nullptr;
  }
  const int whole = static_cast<int>(std::round(tenths));
  return find_g_code(
      GNumber{static_cast<std::int16_t>(whole / 10), static_cast<std::int8_t>(whole % 10)}, own);
}

}  // namespace g31::fanuc
