#pragma once

#include "interpreter/dialects/fanuc/vocabulary/g_codes.h"

namespace g31::fanuc {

/// One of the planes of G17, G18, G19: storage indices of its axes, and the letters of the centre
/// distances along them.  `first` turns towards `second` counterclockwise; `across` stands on both.
struct Plane {
  int first;
  int second;
  int across;
  char first_centre;
  char second_centre;
  char across_centre;

  bool operator==(const Plane&) const = default;
};

/// @param code  G17, G18 or G19
constexpr Plane plane_of(GNumber code) {
  switch (code.whole) {
    case 18:
      return {2, 0, 1, 'K', 'I', 'J'};
    case 19:
      return {1, 2, 0, 'J', 'K', 'I'};
    default:
      return {0, 1, 2, 'I', 'J', 'K'};
  }
}

}  // namespace g31::fanuc
