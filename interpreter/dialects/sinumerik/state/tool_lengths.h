#pragma once

#include <array>

namespace g31::sinumerik {

/// Which axes the lengths of a tool count in, and what of them is a diameter.
///
/// Source: SINUMERIK 840D sl function manual Tools (W1), tool length compensation: milling tools
/// have length 1 square to the plane, turning tools along its 2nd axis; with a negative plane the
/// two axes of the plane change places.
struct LengthRules {
  int plane = 0;          ///< SD42940, 17 18 19 of whatever plane is active; 0: the active one
  int turning_plane = 0;  ///< SD42942: the same of turning tools; 0: as SD42940
  int kind = 0;           ///< SD42950: 1 all tools as mills, 2 all as turning tools, else by type
  int diameters = 0;      ///< MD20360, of turning tools across the spindle: bit 0 wear, 1 length
};

/// Lengths 1 to 3 of a tool and the storage indices of the axes that they count in.
struct ToolLengths {
  std::array<double, 3> mm = {};
  std::array<int, 3> axes = {};
  bool as_turning_tool = false;
};

/// $TC_DP1 500 to 599: turning tools and the probes of lathes.
constexpr bool is_turning_type(double type) {
  constexpr double kFirst = 500.0;
  constexpr double kEnd = 600.0;
  return type >= kFirst && type < kEnd;
}

/// The axes of a tool's lengths, and whether they are those of a turning tool; mm are 0.
/// @param group_number  of the active plane in its G group: 1 G17, 2 G18, 3 G19
ToolLengths axes_of_lengths(const LengthRules& rules, int group_number, double type);

/// From the theoretical tip of a turning tool, which its lengths are of, to the centre of its nose,
/// along the 1st and 2nd axis of the plane, in nose radii; 0 for positions that are none.
/// @param position  $TC_DP2: in G18 1 cuts towards +Z +X, 2 -Z +X, 3 -Z -X, 4 +Z -X, 5 +Z, 6 +X, 7
///                  -Z, 8 -X; the lengths of 9 are of the centre itself
std::array<double, 2> nose_centre(double position);

}  // namespace g31::sinumerik
