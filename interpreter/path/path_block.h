#pragma once

#include <cstdint>
#include <optional>
#include <tuple>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "interpreter/source/location.h"
#include "machine/port/machine_port.h"
#include "machine/units/axis_positions.h"

namespace g31::path {

/// A point or a direction in the offset plane: mm along its first and second axis.
using PlanePoint = Eigen::Vector2d;

/// Positive where b points to the left of a.
inline double cross(const PlanePoint& a, const PlanePoint& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The plane of the compensation: storage indices of its axes; `first` turns towards `second`
/// counterclockwise.
struct OffsetPlane {
  int first = 0;
  int second = 1;
  friend bool operator==(OffsetPlane, OffsetPlane) = default;

  [[nodiscard]] PlanePoint of(const AxisPositions& q) const { return {q[first], q[second]}; }
  /// `q` with other coordinates in the plane.
  [[nodiscard]] AxisPositions moved(const AxisPositions& q, const PlanePoint& p) const {
    return with_two(q, first, p.x(), second, p.y());
  }
};

struct ArcShape {
  PlanePoint centre = PlanePoint::Zero();
  machine::Turn turn = machine::Turn::Clockwise;

  bool operator==(const ArcShape&) const = default;
};

/// A way in the plane: straight, or an arc.  Start and end of an arc that coincide make a full
/// circle; a straight way has a length.
struct PlaneWay {
  PlanePoint from;
  PlanePoint to;
  std::optional<ArcShape> arc;

  bool operator==(const PlaneWay&) const = default;
};

/// Start and end of an arc closer than this are one point, as machine::ArcPath sees it too; mm.
inline constexpr double kOnePointMm = 1e-6;

/// Unit directions of travel at the ends of a way.
PlanePoint direction_at_start(const PlaneWay& way);
PlanePoint direction_at_end(const PlaneWay& way);

/// The angle an arc turns through, rad, in (0, 2 pi]; 0 for a straight way.
double sweep_rad(const PlaneWay& way);

/// In how many chords an arc is travelled, none of them further than `error_mm` from it: from 1 to
/// ten million.
int chords_of(double sweep_rad, double radius_mm, double error_mm);

/// One block of motion: as it is programmed, or as the compensation gives it to the machine.  Where
/// a transformation leads the axes (Outlet::lead_by), its places are in base coordinates.
struct PathBlock {
  AxisPositions q_M_end = AxisPositions::Zero();  ///< mm and deg, machine coordinates
  std::optional<ArcShape> arc;                    ///< machine coordinates in the plane
  int g = 1;                                      ///< 0 rapid, 1 line, 2 and 3 arcs
  double feed_mm_min = 0.0;                       ///< > 0; 0: at rapid, g = 0 or an arc
  source::Location where = {};
  std::uint64_t calls = 0;  ///< Outlet::calls_now() where it was programmed; 0: not said
  machine::BlockEnd ends = machine::BlockEnd::ExactStop;
  double mm_per_degree = 0.0;  ///< of a line: see machine::LinearMove
  machine::RapidPath rapid_path = machine::RapidPath::Straight;  ///< for g = 0
  machine::ContourControl contour_control = machine::ContourControl::Off;
  machine::Smoothness smoothness = {};
  bool feed_at_contour = false;  ///< of an arc: the tool beside it goes round in the same time
  bool goes_on = false;          ///< a piece behind the first of a block, which is one all the same
  bool of_axes = false;          ///< its end is a position of the axes, whatever leads them (G53)
  /// Leads the axes in the place of what the outlet is led by: the block's places are in its base
  /// coordinates.  Null: see Outlet::lead_by.
  machine::AxisTransformPtr leads = {};

  /// The same block, in another run of the same program, too: what leads the axes there is another
  /// object, and counts as whether something does; numbers of calls do not count.
  friend bool operator==(const PathBlock& a, const PathBlock& b) {
    const auto told = [](const PathBlock& block) {
      return std::tie(block.arc, block.g, block.feed_mm_min, block.where, block.ends,
                      block.mm_per_degree, block.rapid_path, block.contour_control,
                      block.feed_at_contour, block.goes_on, block.of_axes, block.smoothness);
    };
    return a.q_M_end == b.q_M_end && told(a) == told(b) &&
           (a.leads == nullptr) == (b.leads == nullptr);
  }
};

struct Pause {
  double seconds = 0.0;
  source::Location where = {};

  bool operator==(const Pause&) const = default;
};

/// What the machine is to do, in order.
using PathItem = std::variant<PathBlock, Pause>;
using PathItems = std::vector<PathItem>;

}  // namespace g31::path
