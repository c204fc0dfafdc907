#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace g31 {

/// How many letters must be inserted, left out, replaced or swapped with their neighbour to make
/// `b` out of `a` (optimal string alignment distance; bytes, case counts).
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  const std::size_t width = b.size() + 1;
  std::vector<std::size_t> two_above(width);
  std::vector<std::size_t> above(width);
  std::vector<std::size_t> row(width);
  for (std::size_t j = 0; j < width; ++j) {
    row[j] = j;
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(two_above, above);
    std::swap(above, row);
    row[0] = i;
    for (std::size_t j = 1; j < width; ++j) {
      const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], two_above[j - 2] + 1);
      }
    }
  }
  return row.back();
}

/// The known name that was most probably meant; nullopt when none is near.
///
/// Near means: at most a third of the longer name's letters are wrong, but one always may be.
/// Of equally near names the first one of `known` is taken.
inline std::optional<std::string_view> nearest_name(std::string_view unknown,
                                                    std::span<const std::string_view> known) {
  std::optional<std::string_view> nearest;
  std::size_t fewest = 0;
  for (const std::string_view name : known) {
    const std::size_t wrong = edit_distance(unknown, name);
    const std::size_t longer = std::max(unknown.size(), name.size());
    // A one-letter name would be "near" to every other one-letter name.
    const bool near = wrong <= std::max<std::size_t>(1, longer / 3) && wrong < longer;
    if (near && (!nearest || wrong < fewest)) {
      nearest = name;
      fewest = wrong;
    }
  }
  return nearest;
}

}  // namespace g31
