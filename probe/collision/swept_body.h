#pragma once

#include <Eigen/Geometry>

#include "machine/units/point.h"
#include "probe/collision/probe_section.h"
#include "probe/collision/swept_section.h"

namespace g31::probe {

/// How a section is turned, made ready for many questions.
class Turned {
 public:
  Turned(const ProbeSection& section, const Eigen::Quaterniond& turn)
      : section_(&section),
        is_upright_(turn.coeffs() == Eigen::Quaterniond::Identity().coeffs()),
        R_(is_upright_ ? Eigen::Matrix3d::Identity() : turn.toRotationMatrix()) {}

  [[nodiscard]] Point furthest(const Point& direction) const {
    return is_upright_ ? furthest_of(*section_, direction)
                       : Point(R_ * furthest_of(*section_, R_.transpose() * direction));
  }

 private:
  const ProbeSection* section_;
  bool is_upright_;
  Eigen::Matrix3d R_;
};

/// A swept section in coordinates that begin where its own frame begins its way.
class SweptBody {
 public:
  explicit SweptBody(const SweptSection& swept)
      : swept_(swept),
        way_(swept.way()),
        turns_(swept.turns()),
        from_(*swept.section, swept.from.turn),
        to_(*swept.section, swept.to.turn) {}

  [[nodiscard]] const SweptSection& swept() const { return swept_; }
  [[nodiscard]] const Point& way() const { return way_; }

  [[nodiscard]] Point furthest(const Point& direction) const {
    Point p = from_.furthest(direction);
    if (turns_) {
      const Point at_end = way_ + to_.furthest(direction);
      p = at_end.dot(direction) > p.dot(direction) ? at_end : p;
    } else if (direction.dot(way_) > 0.0) {
      p += way_;
    }
    const double growth = swept_.growth();
    const double norm = direction.norm();
    return growth > 0.0 && norm > 0.0 ? Point(p + growth / norm * direction) : p;
  }

 private:
  SweptSection swept_;
  Point way_;
  bool turns_;
  Turned from_;
  Turned to_;
};

}  // namespace g31::probe
