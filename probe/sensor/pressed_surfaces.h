#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "probe/contact/sweep_mesh.h"
#include "probe/sensor/touchable_parts.h"

namespace g31::probe {

/// A surface that a ball is pressed into on its way.
struct Pressed {
  SweepHit hit;  ///< where the ball, deflected as it is, meets it
  const TouchableParts::Part* part = nullptr;
  bool is_from_free = false;  ///< nothing deflected the ball before
  double s = 0.0;             ///< mm of the way of the undeflected ball, where it begins
  double depth = 0.0;  ///< mm: how deep the undeflected ball is there beyond the tangent plane
};

/// The surfaces that a ball is pressed into on a straight way, one after the other, of the parts in
/// which a skip move may end.
///
/// The ball is rigid and slides without friction: what it touches deflects it along the normals, as
/// far as tangent planes ask for.  What it meets as it slides is the next surface, of another part
/// or of the same one; what lies behind a surface, it never meets.  A surface that would have to
/// pull lets go.  Where the undeflected ball touches nothing, nothing deflects it any more.
///
/// A contact with the same part whose normal differs by less than kCreaseDeg (smooth_normal.h) from
/// one in force is of the same surface, as facets of a bore are: the ball slides on along it, and
/// that it is deflected began before.  It is told anew wherever its normal has turned by kToldDeg.
class PressedSurfaces {
 public:
  static constexpr double kToldDeg = 5.0;
  static constexpr double kToldCosine = 0.99619469809174555;  // of kToldDeg

  struct Ball {
    double radius = 0.0;
    std::size_t size = 0;  ///< which of the sweepers of each part
  };
  using Part = TouchableParts::Part;
  struct Met {
    SweepHit hit;
    const Part* part = nullptr;
  };

  /// What a ball meets first on a straight way, of the parts in which a skip move may end.
  static std::optional<Met> first_met(std::span<const Part> parts, const Ball& ball,
                                      const Point& p_M_from, const Point& p_M_to);

  /// @param parts  outlive the answers
  PressedSurfaces(std::span<const Part> parts, const Ball& ball, const Point& p_M_from,
                  const Point& p_M_to);

  /// @param until  mm of the way: what begins there or later is of no interest; never more than in
  ///               the question before
  std::optional<Pressed> next(double until);

 private:
  /// What holds the ball.
  struct Contact {
    Point n_M;
    double level = 0.0;  ///< mm along n_M: of the plane that the centre is held on
    const Part* part = nullptr;
    Point n_M_told = Point::Zero();  ///< n_M where its surface was told last
    double push = 0.0;               ///< mm: its share of the deflection, along n_M
    double rate = 0.0;               ///< of the push, by mm of the way
  };

  [[nodiscard]] Point undeflected(double s) const { return p_M_from_ + s * direction_; }
  [[nodiscard]] double depth_in(const Contact& contact) const {
    return contact.level - undeflected(s_).dot(contact.n_M);
  }
  /// Whether nothing more is to be met, for the ball is pressed straight in.
  [[nodiscard]] bool is_pressed_straight(double end) const;
  /// Whether nothing but the surface that holds the ball is as near as it and the undeflected ball
  /// may come.
  [[nodiscard]] bool is_alone(double end) const;
  /// Takes what has been met; nullopt: it is of a surface in force.
  std::optional<Pressed> take(const Met& met);
  /// @returns whether it is of a surface in force
  bool hold(const Contact& contact);
  /// Works out who pushes how far, and lets go of what would pull.
  void share_out();
  /// Goes on to where a contact lets go, or all of them do.  @returns whether that is before `end`
  bool let_go(double end);
  /// mm: from where on the undeflected ball touches nothing; `end` if not before.
  [[nodiscard]] double free_from(double end);

  std::span<const Part> parts_;
  Ball ball_;
  Point p_M_from_;
  Point p_M_to_;
  Point direction_ = Point::Zero();  ///< 0 where the way has no length
  double length_;
  // The ball now.
  bool has_begun_ = false;
  double s_ = 0.0;
  Point p_M_centre_;               ///< deflected; counts while something holds it
  std::vector<Contact> contacts_;  ///< the newest last
  Point slide_ = Point::Zero();    ///< of the deflected ball, by mm of the way
  double releases_at_ = std::numeric_limits<double>::infinity();  ///< mm: the first that lets go
  bool may_overlap_ = false;  ///< it began in contact, and may be in more than one
  double free_from_ = 0.0;    ///< mm, where it is not behind the ball
  int turns_left_;
};

}  // namespace g31::probe
