#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "machine/units/point.h"

namespace g31::probe {

/// A touch of a plan; product frame P, mm.
struct PlannedPoint {
  std::string id;                   ///< "P1"
  Point at_P = Point::Zero();       ///< on the surface
  Point normal_P = Point::UnitZ();  ///< there, unit: out of the material
  Point start_P = Point::Zero();    ///< of the ball's centre, on the line from `at` along `normal`
  std::string moved;                ///< why it is not where the method wants it; empty: it is
};

enum class Characteristic {
  Size,   ///< (c2 - c1) . d, c1 and c2 the contacts, d the direction
  Place,  ///< (c1 + c2) / 2 . d - origin
};

/// Limits of a deviation from the nominal value, mm; lower <= upper.
struct Tolerance {
  double lower = 0.0;
  double upper = 0.0;
};

/// A length between two touches.
struct PlannedMeasure {
  std::string id;           ///< "F1.X", "F1.X.place"
  std::size_t feature = 0;  ///< index
  char axis = 'X';          ///< X, Y or Z, of the feature's own axes
  Characteristic what = Characteristic::Size;
  double nominal = 0.0;  ///< mm
  std::optional<Tolerance> tolerance;
  std::size_t first = 0;  ///< indices of its points
  std::size_t second = 0;
  Point direction_P = Point::UnitX();  ///< unit, parallel to the normals of both points
  double origin_mm = 0.0;  ///< of a place: the minus corner of the stock, along direction
};

/// A size of a feature that is left out.
struct LeftOut {
  std::size_t feature = 0;  ///< index
  char axis = 'X';
  std::string why;
};

/// A hole or a boss whose round wall is touched from four sides, as a cycle for circles does.
struct PlannedRound {
  std::size_t feature = 0;                   ///< index
  Point centre_P = Point::Zero();            ///< of the circle, at the height of the touches
  double diameter_mm = 0.0;                  ///< > 0
  bool is_standing = false;                  ///< a boss
  double approach_mm = 3.0;                  ///< from the ball to the wall before a touch, at least
  std::array<std::size_t, 4> points = {};    ///< indices: towards the walls at -X, +X, -Y, +Y
  std::array<std::size_t, 4> measures = {};  ///< indices: X, its place, Y, its place
  std::string by_points;                     ///< why no cycle measures it; empty: one does
};

/// What is touched and what comes of it.
struct InspectionPlan {
  std::vector<std::string> features;  ///< for comments: "F1 closed pocket"
  std::vector<PlannedPoint> points;
  std::vector<PlannedMeasure> measures;
  std::vector<LeftOut> left_out;
  std::vector<PlannedRound> rounds = {};  ///< by their features
};

}  // namespace g31::probe
