#include <algorithm>
#include <cmath>

#include "parts/artefacts/artefact.h"
#include "tools/page/run_parts.h"

namespace g31::page {
namespace {

using Shares = std::vector<std::optional<WallShare>>;

/// Which side of its wall the material of a size is.
enum class Side : unsigned char { Inside, Outside };

/// The touches that a characteristic rests on.
class Walls {
 public:
  Walls(const RunPage& run, const TouchGeometries& geometries, std::vector<std::size_t> touches,
        const expect::TrueSize& size)
      : run_(run), geometries_(geometries), touches_(std::move(touches)), size_(size) {}

  /// Where a touch met a wall of the size: a plug is of material inside, a bore outside; nullopt:
  /// it is another wall.
  [[nodiscard]] std::optional<Side> side_of(std::size_t touch) const {
    const TouchGeometry* const here = on_part(touch);
    if (here == nullptr) {
      return std::nullopt;
    }
    for (const std::size_t other : touches_) {
      const TouchGeometry* const there = on_part(other);
      constexpr double kOpposite = -0.9;  // cosine
      if (there != nullptr && here->n_M.dot(there->n_M) < kOpposite) {
        if (const auto side = side_for(here->n_M.dot(*here->p_M_contact - *there->p_M_contact))) {
          return side;
        }
      }
    }
    const auto part = std::ranges::find(run_.job.parts, size_.part, &parts::PartSetup::name);
    return side_for(2.0 * here->n_M.dot(*here->p_M_contact - part->p_M_at));
  }

 private:
  /// nullptr: the touch met no wall of the part.
  [[nodiscard]] const TouchGeometry* on_part(std::size_t touch) const {
    const auto& contact = run_.recorder.touches()[touch - 1].contact;
    const TouchGeometry& geometry = geometries_[touch - 1];
    return contact && contact->part == size_.part && geometry.p_M_contact ? &geometry : nullptr;
  }

  /// @param across_mm  from the wall to the one opposite, along the normal of the first
  [[nodiscard]] std::optional<Side> side_for(double across_mm) const {
    // As much as warmth and facets may make of it.
    const double slack_mm = std::max(0.05, 2e-3 * size_.value);
    if (std::abs(std::abs(across_mm) - size_.value) > slack_mm) {
      return std::nullopt;
    }
    return across_mm > 0.0 ? Side::Inside : Side::Outside;
  }

  const RunPage& run_;
  const TouchGeometries& geometries_;
  std::vector<std::size_t> touches_;
  const expect::TrueSize& size_;
};

/// Neither a place of a part is a size of it, nor an angle.
bool is_size(const RunPage& run, const expect::TrueSize& size) {
  const auto part = std::ranges::find(run.job.parts, size.part, &parts::PartSetup::name);
  const auto measure = parts::size_of(*part, size.key);
  return measure && measure->quantity == parts::Quantity::Length;
}

/// A larger size is deeper in the material of a bore, and less deep in that of a plug.
WallShare share_of(const expect::Characteristic& what, Side side) {
  const double half_mm = what.unit.mm / 2.0;
  const double own = (*what.true_value() - *what.nominal) * half_mm;
  const bool is_outside = side == Side::Outside;
  WallShare share{is_outside ? own : -own, std::nullopt};
  if (what.tolerance) {
    const auto [lower, upper] = *what.tolerance;
    share.limits_mm = is_outside ? expect::Limits{lower * half_mm, upper * half_mm}
                                 : expect::Limits{-upper * half_mm, -lower * half_mm};
  }
  return share;
}

}  // namespace

Shares wall_shares(const RunPage& run, const TouchGeometries& geometries, const Writers& writers) {
  Shares shares(geometries.size());
  for (const expect::MeasuredCharacteristic& row : run.result.characteristics) {
    if (!row.what.true_value() || !row.what.nominal || !is_size(run, *row.what.true_size)) {
      continue;
    }
    const std::vector<std::size_t> touches = writers.touches_of(row.what.variable);
    const Walls walls(run, geometries, touches, *row.what.true_size);
    for (const std::size_t touch : touches) {
      if (const auto side = walls.side_of(touch)) {
        shares[touch - 1] = share_of(row.what, *side);
      }
    }
  }
  return shares;
}

}  // namespace g31::page
