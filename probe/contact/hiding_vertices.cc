#include "probe/contact/hiding_vertices.h"

#include <algorithm>
#include <cmath>

namespace g31::probe {
namespace {

/// The corners of a convex polygon in a plane that the directions of a piece go through; of two, a
/// line.
class Window {
 public:
  explicit Window(const ExposedPiece& piece) : middle_(piece.middle()), count_(piece.count) {
    for (std::size_t i = 0; i < count_; ++i) {
      corners_[i] = piece.corners[i] / piece.corners[i].dot(middle_);
    }
    measure();
  }

  [[nodiscard]] bool is_empty() const { return count_ == 0; }

  /// Whether `cut` would certainly take away nothing.  @param squared  of the length of across
  [[nodiscard]] bool is_beside(const Point& across, double squared, double limit) const {
    const double room = limit - across.dot(middle_);
    return room > 0.0 && room * room > squared * spread_squared_;
  }

  /// Takes away points p with across . p > limit |p|, all or some of them; whether there are any.
  bool cut(const Point& across, double limit) {
    const double bound = limit * farthest_;
    std::array<double, kMost> over;
    bool any = false;
    for (std::size_t i = 0; i < count_; ++i) {
      over[i] = across.dot(corners_[i]) - bound;
      any = any || over[i] > 0.0;
    }
    if (!any || count_ + 2 > kMost) {
      return false;
    }
    const auto before = corners_;
    const std::size_t sides = count_ == 2 ? 1 : count_;
    const std::size_t count = count_;
    count_ = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = i + 1 < count ? i + 1 : 0;
      if (over[i] <= 0.0) {
        corners_[count_++] = before[i];
      }
      if (i < sides && (over[i] > 0.0) != (over[next] > 0.0)) {
        corners_[count_++] =
            before[i] + over[i] / (over[i] - over[next]) * (before[next] - before[i]);
      }
    }
    measure();
    return true;
  }

  [[nodiscard]] ExposedPiece piece() const {
    ExposedPiece piece;
    for (std::size_t i = 0; i < count_; ++i) {
      piece.corners[piece.count++] = corners_[i].normalized();
    }
    return piece;
  }

 private:
  static constexpr std::size_t kMost = ExposedPiece::kMostCorners;

  void measure() {
    double most = 0.0;
    for (std::size_t i = 0; i < count_; ++i) {
      most = std::max(most, corners_[i].squaredNorm());
    }
    farthest_ = std::sqrt(most);
    spread_squared_ = std::max(0.0, most - 1.0);
  }

  Point middle_;  ///< of the plane, 1 mm from that of the sphere
  std::array<Point, kMost> corners_;
  std::size_t count_;
  double farthest_ = 1.0;        ///< from the middle of the sphere
  double spread_squared_ = 0.0;  ///< from the middle of the plane
};

}  // namespace

bool HidingVertices::hide_face(const ContactTriangle& triangle, const Point& up) {
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const Point& u = vertices_[i];
    const double height = (u - triangle.vertices[0]).dot(up);
    double squared = 0.0;
    for (const Point& corner : triangle.vertices) {
      squared = std::max(squared, (u - corner).squaredNorm());
    }
    if (2.0 * radius_ * (height - kHiddenMm) > squared) {
      ask_first(i);
      return true;
    }
  }
  return false;
}

ExposedPiece HidingVertices::left_of(const ExposedPiece& piece, const std::array<Point, 2>& ends) {
  Window window(piece);
  const double share = 1.0 / (2.0 * radius_);
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const Point across = vertices_[i] - ends[0];
    const double squared = across.squaredNorm();
    const double farther = std::max(squared, (vertices_[i] - ends[1]).squaredNorm());
    const double limit = farther * share + kHiddenMm;
    if (!window.is_beside(across, squared, limit) && window.cut(across, limit) &&
        window.is_empty()) {
      ask_first(i);
      break;
    }
  }
  return window.piece();
}

}  // namespace g31::probe
