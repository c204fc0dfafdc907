#include "probe/contact/leave_contact.h"

#include <algorithm>

namespace g31::probe {
namespace {

using parts::Path;

/// Farther from the surface than this beyond the radius, a ball is free, mm.
constexpr double kFreeGapMm = 2.0 * kTouchBandMm;

Path reversed(const Path& path) {
  return {path.from + path.length * path.direction, Point(-path.direction), path.length};
}

class Leaver {
 public:
  Leaver(const ContactMesh& mesh, const Path& path, double radius, const LeavingRule& rule)
      : mesh_(mesh), path_(path), radius_(radius), rule_(rule) {}

  Leaving leave(double start_distance) {
    Leaving leaving;
    leaving.free_from = free_from();
    limit_ = leaving.free_from;
    stop_by_depth(std::min(start_distance, radius_) - rule_.allowance_mm);
    stop_by_old_contacts();
    stop_by_new_contacts();
    leaving.stop = stop_;
    return leaving;
  }

 private:
  /// The path as far as it still matters.
  [[nodiscard]] Path rest() const { return {path_.from, path_.direction, limit_}; }

  [[nodiscard]] Point at(double s) const { return path_.from + s * path_.direction; }

  void stop(double s, std::uint32_t slot) {
    if (s < limit_ || (!stop_ && s <= limit_)) {
      stop_ = Meeting{s, slot};
      limit_ = s;
    }
  }

  /// Where the ball has left every triangle, those too that it came to meanwhile.  Triangle by
  /// triangle: what touches the ball at s touches it without a break until it is left.
  [[nodiscard]] double free_from() const {
    constexpr int kMostSteps = 10'000;
    constexpr double kLeastStepMm = 1e-6;
    const double radius = radius_ + kFreeGapMm;
    const Path back = reversed(path_);
    double s = 0.0;
    for (int step = 0; step < kMostSteps; ++step) {
      double left_all = -1.0;
      mesh_.visit_within(at(s), radius, [&](std::uint32_t slot, const Nearest&) {
        left_all = std::max(left_all, left_at(back, slot, radius));
      });
      if (left_all < 0.0) {
        return s;
      }
      s = std::max(left_all, s + kLeastStepMm);
      if (s >= path_.length) {
        break;
      }
    }
    return path_.length;
  }

  /// Where on the path a ball leaves a triangle that it touches somewhere on the way.
  [[nodiscard]] double left_at(const Path& back, std::uint32_t slot, double radius) const {
    const ContactTriangle& triangle = mesh_.triangles()[slot];
    if (nearest_of(triangle, back.from).distance <= radius) {
      return path_.length;
    }
    const double s = sweep_triangle(back, triangle, radius);
    return s < kNoContact ? path_.length - s : 0.0;
  }

  void stop_by_depth(double radius) {
    if (radius > 0.0) {
      if (const auto deeper = mesh_.first_meeting(rest(), radius)) {
        stop(deeper->s, deeper->slot);
      }
    }
  }

  [[nodiscard]] bool goes_against(const Nearest& nearest) const {
    return path_.direction.dot(nearest.normal) < -rule_.steep;
  }

  /// Stops where such a contact is pushed in by the touch band.
  void stop_by_old_contacts() {
    mesh_.visit_within(
        path_.from, radius_ + kTouchBandMm, [&](std::uint32_t slot, const Nearest& nearest) {
          const double depth_kept = std::min(nearest.distance, radius_);
          const double radius = depth_kept - kTouchBandMm;
          if (radius > 0.0 && goes_against(nearest) && mesh_.rests_at(path_.from, nearest)) {
            stop(sweep_triangle(rest(), mesh_.triangles()[slot], radius), slot);
          }
        });
  }

  void stop_by_new_contacts() {
    mesh_.tree().visit_along(rest(), radius_ + kBoxMarginMm, [&](std::uint32_t slot) {
      const ContactTriangle& triangle = mesh_.triangles()[slot];
      const double s = sweep_triangle(rest(), triangle, radius_);
      if (s <= limit_ && nearest_of(triangle, path_.from).distance > radius_ + kTouchBandMm) {
        const Nearest nearest = nearest_of(triangle, at(s));
        if (goes_against(nearest) && mesh_.rests_at(at(s), nearest)) {
          stop(s, slot);
        }
      }
      return limit_;
    });
  }

  const ContactMesh& mesh_;
  const Path& path_;
  double radius_;
  const LeavingRule& rule_;
  double limit_ = 0.0;
  std::optional<Meeting> stop_;
};

}  // namespace

Leaving leave_contact(const ContactMesh& mesh, const Path& path, double radius,
                      double start_distance, const LeavingRule& rule) {
  return Leaver(mesh, path, radius, rule).leave(start_distance);
}

}  // namespace g31::probe
