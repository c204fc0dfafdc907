#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "machine/units/point.h"
#include "parts/geometry/bvh.h"
#include "parts/geometry/mesh.h"
#include "probe/contact/contact_triangle.h"
#include "probe/contact/sweep_triangle.h"

namespace g31::probe {

enum class SweepStatus {
  Miss,            ///< the whole way is free
  Contact,         ///< the ball touches at s
  StartInContact,  ///< the ball is in the part before it moves
};

/// Where a ball on its straight way meets a mesh.  Of a miss only the status counts.
struct SweepHit {
  SweepStatus status = SweepStatus::Miss;
  double s = 0.0;                    ///< mm from the start to p_M_centre: the primary result
  Point p_M_centre = Point::Zero();  ///< the ball centre at the contact
  Point p_M_point = Point::Zero();   ///< the point of touch on the mesh
  Point n_M = Point::Zero();         ///< unit vector from the point of touch to the ball centre
  std::uint32_t triangle = 0;        ///< of the mesh, as given
  double cos_incidence = 0.0;        ///< 1 head-on, 0 grazing; negative if the start moves away
};

/// A ball whose surface is no farther than this from a triangle, outside or inside, touches it
/// without overlapping it, mm.
inline constexpr double kTouchBandMm = 1e-9;

/// Moves a ball of fixed radius against a fixed mesh: closed form, no steps, no tolerance to
/// choose.
///
/// Triangles count from both sides, so the mesh may be open or unoriented.  Immutable: all queries
/// may be asked from many threads at once.
///
/// Accuracy: |distance - radius| <= kContactErrorMm at the contact, for coordinates and ways of up
/// to 1000 mm; s is as good as that divided by cos_incidence.  A ball that goes in by more than
/// kContactErrorMm is never let through.
class MeshSweeper {
 public:
  /// @param mesh_M       in the machine frame; may be empty
  /// @param ball_radius  mm, > 0
  MeshSweeper(const parts::Mesh& mesh_M, double ball_radius);

  /// The first contact of the ball centre's way from `p_M_from` to `p_M_to`.
  ///
  /// Overlapping any triangle at the start: StartInContact at the deepest one, whatever the
  /// direction.  Touching at the start (within kTouchBandMm): a contact with s = 0 if the ball goes
  /// in, none with that triangle if it goes away or along.  A way without length asks for
  /// StartInContact alone.
  [[nodiscard]] SweepHit sweep(const Point& p_M_from, const Point& p_M_to) const;

  /// The same for a move that may begin in contact: to go on touching is allowed, to push is not.
  ///
  /// A triangle that the ball touches or overlaps at the start is a hit only where the ball has
  /// gone deeper into it by kTouchBandMm; every other triangle where it is touched.  So a ball that
  /// rubs along a face deep in contact, or leaves it at less than the angle of its dent (10 degrees
  /// for 0.05 mm at r = 3 mm), may be stopped by the next triangle of that same face.  Depth is
  /// measured from the ball centre's distance, so a centre that has gone through the surface may go
  /// on.  Never StartInContact.
  [[nodiscard]] SweepHit first_contact_leaving(const Point& p_M_from, const Point& p_M_to) const;

 private:
  /// A triangle that a ball at rest touches or overlaps.
  struct Touch {
    std::uint32_t slot = 0;
    double distance = 0.0;  ///< of the ball centre, mm
  };
  /// A triangle that a moving ball meets after s mm.
  struct Meeting {
    double s = 0.0;
    std::uint32_t slot = 0;
  };

  /// What to test where the centre meets a patch of the offset surface: 4 bits of Features, then 28
  /// of the triangle's slot.
  class Patch {
   public:
    Patch(Features features, std::uint32_t slot) : bits_(features << 28U | slot) {}
    [[nodiscard]] Features features() const { return bits_ >> 28U; }
    [[nodiscard]] std::uint32_t slot() const { return bits_ & 0x0FFF'FFFFU; }

   private:
    std::uint32_t bits_;
  };

  /// The deepest touch of the ball at rest.
  [[nodiscard]] std::optional<Touch> touch_at(const Point& p_M_centre) const;

  /// The radius of the ball that the triangle allows from this start: the whole ball, or as much of
  /// it as is not in touch already.  To meet *that* ball is to go deeper.
  [[nodiscard]] double free_radius(std::uint32_t slot, const Point& p_M_from) const;

  /// From a free start.
  [[nodiscard]] std::optional<Meeting> first_meeting(const parts::Path& path) const;
  /// From a start in touch: free_radius matters.
  [[nodiscard]] std::optional<Meeting> first_meeting_leaving(const parts::Path& path) const;
  [[nodiscard]] SweepHit hit_at(SweepStatus status, const parts::Path& path,
                                const Meeting& meeting) const;

  double radius_;
  parts::Bvh tree_;                         ///< of the triangles
  std::vector<ContactTriangle> triangles_;  ///< in slot order of tree_
  parts::Bvh patch_tree_;                   ///< of the offset surface
  std::vector<Patch> patches_;              ///< in slot order of patch_tree_
};

/// Five times the worst error seen; tests/probe/sweep_mesh_test.cc holds it against quadruple
/// precision.
inline constexpr double kContactErrorMm = 5e-12;

}  // namespace g31::probe
