#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "machine/units/point.h"
#include "parts/geometry/mesh.h"
#include "probe/contact/contact_mesh.h"
#include "probe/contact/leave_contact.h"
#include "probe/contact/offset_tree.h"

namespace g31::probe {

enum class SweepStatus {
  Miss,            ///< the whole way is free
  Contact,         ///< the ball touches at s
  StartInContact,  ///< the ball is in the part before it moves
};

inline constexpr std::uint32_t kNoTriangle = ~std::uint32_t{0};

/// Where a ball on its straight way meets a mesh.  Of a miss only the status counts.
struct SweepHit {
  SweepStatus status = SweepStatus::Miss;
  double s = 0.0;                    ///< mm from the start to p_M_centre: the primary result
  Point p_M_centre = Point::Zero();  ///< the ball centre at the contact
  Point p_M_point = Point::Zero();   ///< the point of touch on the mesh
  Point n_M = Point::Zero();         ///< unit vector from the point of touch to the ball centre
  std::uint32_t triangle = 0;        ///< of the mesh, as given; kNoTriangle on a true sphere
  double cos_incidence = 0.0;        ///< 1 head-on, 0 grazing; negative if the start moves away
};

/// How a ball comes out of contact on a straight way.
struct StraightLeaving {
  SweepHit hit;        ///< what stops it before it is free
  double share = 0.0;  ///< 0..1 of the way, until it is free or stopped; 1 if it does not come free
};

/// Moves a ball of fixed radius against a fixed mesh: closed form, no steps, no tolerance to
/// choose.
///
/// Triangles count from both sides, so the mesh may be open or unoriented.  Immutable: all queries
/// may be asked from many threads at once.
///
/// From a free start the way of the centre is tested against the patches of the surface on which a
/// touching ball has its centre (offset_tree.h): how many triangles lie within the radius does not
/// matter.  From a start in contact those have to be looked at.  The patches are made when the
/// first way comes near the mesh.
///
/// A mesh that stands for a true sphere is met as that sphere: a ball touches it where a ball as
/// much larger as the sphere touches its centre, so all of the above is asked about that one point.
/// It is solid: a ball whose centre is in it is as deep as its way out is long.
///
/// Accuracy: |distance - radius| <= kContactErrorMm at the contact, for coordinates and ways of up
/// to 1000 mm; s is as good as that divided by cos_incidence.  A ball that goes in by more than
/// kContactErrorMm is never let through.
class MeshSweeper {
 public:
  /// @param mesh_M       in the machine frame; may be empty; fewer than 2^27 triangles
  /// @param ball_radius  mm, > 0
  MeshSweeper(const parts::Mesh& mesh_M, double ball_radius);

  /// The same with a mesh that others share.
  MeshSweeper(std::shared_ptr<const ContactMesh> mesh, double ball_radius);

  /// The first contact of the ball centre's way from `p_M_from` to `p_M_to`.
  ///
  /// Overlapping any triangle at the start: StartInContact at the deepest one, whatever the
  /// direction.  Touching at the start (within kTouchBandMm): a contact with s = 0 if the ball goes
  /// in, none there if it goes away or along (kLeaveExactly).  A way without length asks for
  /// StartInContact alone.
  [[nodiscard]] SweepHit sweep(const Point& p_M_from, const Point& p_M_to) const;

  /// The same for a move that may begin in contact: to leave is allowed, to push is not
  /// (kLeaveFreely in leave_contact.h).  Once the ball is free, every touch is a contact.
  ///
  /// Depth is measured from the ball centre's distance, so a centre that is in the surface itself,
  /// or has gone through it, may go on.  Never StartInContact.
  [[nodiscard]] SweepHit first_contact_leaving(const Point& p_M_from, const Point& p_M_to) const;

  // For ways that are not straight (sweep_curve.h):

  /// The share of a straight way, 0..1, on which the ball is certainly free on every way that goes
  /// along with it at `slack` mm at most.  The start must be free.
  [[nodiscard]] double free_share(const Point& p_M_from, const Point& p_M_to, double slack) const;

  /// The distance of the ball centre from the mesh if the ball touches or overlaps it; negative in
  /// a true sphere.
  [[nodiscard]] std::optional<double> distance_if_touching(const Point& p_M_centre) const;

  /// Where a ball at rest touches or overlaps the mesh, the deepest first: each place whose
  /// distance is least compared with the surface around it, and of those whose normals differ by
  /// less than kCreaseDeg (smooth_normal.h), which are of one surface, the deepest alone.
  [[nodiscard]] std::vector<SweepHit> contacts_at(const Point& p_M_centre) const;

  /// Whether a ball that moves from here by no more than `reach` mm, wherever to, can touch only
  /// what has a normal within kCreaseDeg of this one; of the zero vector: nothing at all.
  [[nodiscard]] bool can_touch_only(const Point& n_M, const Point& p_M_centre, double reach) const;

  /// The way until the ball is free.  @param start_distance  where the whole move began
  [[nodiscard]] StraightLeaving leave(const Point& p_M_from, const Point& p_M_to,
                                      double start_distance, const LeavingRule& rule) const;

  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  struct OffsetsOnce {
    std::once_flag made;
    OffsetTree tree;
  };

  /// Whether some of the ways beside this one, at `slack` mm at most, may touch.
  [[nodiscard]] bool comes_near(const parts::Path& path, double slack) const;
  [[nodiscard]] const OffsetTree& offsets() const;
  /// From a free start.
  [[nodiscard]] std::optional<Meeting> first_meeting(const parts::Path& path) const;
  /// From a start in contact, or touching.
  [[nodiscard]] std::optional<Meeting> first_meeting_leaving(const parts::Path& path,
                                                             double start_distance,
                                                             const LeavingRule& rule) const;
  [[nodiscard]] SweepHit hit_at(SweepStatus status, const parts::Path& path,
                                const Meeting& meeting) const;

  double skin_ = 0.0;                        ///< mm: the radius of the true sphere
  double radius_;                            ///< of the ball, and the skin
  std::shared_ptr<const ContactMesh> mesh_;  ///< of a true sphere its centre
  std::unique_ptr<OffsetsOnce> offsets_;
};

/// Five times the worst error seen; tests/probe/sweep_mesh_test.cc holds it against quadruple
/// precision.
inline constexpr double kContactErrorMm = 5e-12;

}  // namespace g31::probe
