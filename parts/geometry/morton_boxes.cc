#include "parts/geometry/morton_boxes.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "machine/base/contract.h"

namespace g31::parts {
namespace {

constexpr float kNone = std::numeric_limits<float>::infinity();
constexpr RoundedBox kEmpty = {{kNone, kNone, kNone}, {-kNone, -kNone, -kNone}};

constexpr unsigned int kBitsOfAxis = 10;

/// The ten bits of a number, two places apart.
std::uint32_t spread(std::uint32_t bits) {
  bits = (bits | bits << 16U) & 0x030000FFU;
  bits = (bits | bits << 8U) & 0x0300F00FU;
  bits = (bits | bits << 4U) & 0x030C30C3U;
  return (bits | bits << 2U) & 0x09249249U;
}

/// Where on the curve a box lies, by its middle; `whole` is around all.
std::uint32_t place_on_curve(const Box& box, const Box& whole) {
  constexpr double kCells = 1U << kBitsOfAxis;
  std::uint32_t place = 0;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double size = whole.max[axis] - whole.min[axis];
    const double share =
        size > 0.0 ? (0.5 * (box.min[axis] + box.max[axis]) - whole.min[axis]) / size : 0.0;
    const auto cell = static_cast<std::uint32_t>(std::clamp(kCells * share, 0.0, kCells - 1.0));
    place |= spread(cell) << static_cast<unsigned int>(axis);
  }
  return place;
}

/// A box with where it is on the curve in the upper half.
using Placed = std::uint64_t;

/// By places on the curve, ten bits of them after the other; those of one place keep their order.
void sort_by_place(std::vector<Placed>& all) {
  constexpr unsigned int kHalf = 32;
  constexpr std::size_t kDigits = 1U << kBitsOfAxis;
  std::vector<Placed> sorted(all.size());
  for (unsigned int shift = kHalf; shift < kHalf + 3 * kBitsOfAxis; shift += kBitsOfAxis) {
    const auto digit = [&](Placed one) { return (one >> shift) % kDigits; };
    std::array<std::size_t, kDigits + 1> first{};
    for (const Placed one : all) {
      ++first[digit(one) + 1];
    }
    for (std::size_t i = 1; i < first.size(); ++i) {
      first[i] += first[i - 1];
    }
    for (const Placed one : all) {
      sorted[first[digit(one)]++] = one;
    }
    std::swap(all, sorted);
  }
}

std::vector<std::uint32_t> ordered(const std::vector<Box>& boxes, const Box& whole) {
  std::vector<Placed> all;
  all.reserve(boxes.size());
  for (const Box& box : boxes) {
    all.push_back(Placed{place_on_curve(box, whole)} << 32U | all.size());
  }
  sort_by_place(all);
  std::vector<std::uint32_t> order(all.size());
  std::ranges::transform(all, order.begin(),
                         [](Placed one) { return static_cast<std::uint32_t>(one); });
  return order;
}

/// Of float32, and once more for the sum.
float loss_of(const Box& whole) {
  return static_cast<float>(0x1p-22 * (whole.max - whole.min).maxCoeff());
}

RoundedBox rounded(const Box& box, const Point& middle, float loss) {
  RoundedBox small{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    small.min[axis] = static_cast<float>(box.min[i] - middle[i]) - loss;
    small.max[axis] = static_cast<float>(box.max[i] - middle[i]) + loss;
  }
  return small;
}

}  // namespace

void RoundedBox::include(const RoundedBox& other) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    min[axis] = std::min(min[axis], other.min[axis]);
    max[axis] = std::max(max[axis], other.max[axis]);
  }
}

EightBoxes::EightBoxes() {
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    put(lane, kEmpty);
  }
}

void EightBoxes::put(std::size_t lane, const RoundedBox& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    min_[lane / 4][axis][lane % 4] = box.min[axis];
    max_[lane / 4][axis][lane % 4] = box.max[axis];
  }
}

RoundedBox EightBoxes::at(std::size_t lane) const {
  RoundedBox box{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.min[axis] = min_[lane / 4][axis][lane % 4];
    box.max[axis] = max_[lane / 4][axis][lane % 4];
  }
  return box;
}

RoundedBox EightBoxes::around() const {
  RoundedBox all = kEmpty;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    all.include(at(lane));
  }
  return all;
}

MortonBoxes::MortonBoxes(const std::vector<Box>& boxes) {
  constexpr std::size_t kLanes = EightBoxes::kLanes;
  G31_EXPECTS(!boxes.empty() && boxes.size() < 1U << 30U);
  Box whole;
  for (const Box& box : boxes) {
    whole.include(box);
  }
  order_ = ordered(boxes, whole);
  const Point middle = 0.5 * (whole.min + whole.max);
  const float loss = loss_of(whole);
  std::vector<EightBoxes> level((boxes.size() + kLanes - 1) / kLanes);
  for (std::size_t slot = 0; slot < order_.size(); ++slot) {
    level[slot / kLanes].put(slot % kLanes, rounded(boxes[order_[slot]], middle, loss));
  }
  levels_.push_back(std::move(level));
  while (levels_.back().size() > 1) {
    const std::vector<EightBoxes>& below = levels_.back();
    std::vector<EightBoxes> above((below.size() + kLanes - 1) / kLanes);
    for (std::size_t i = 0; i < below.size(); ++i) {
      above[i / kLanes].put(i % kLanes, below[i].around());
    }
    levels_.push_back(std::move(above));
  }
}

std::size_t MortonBoxes::groups_near(const RoundedBox& box, std::size_t first,
                                     std::vector<std::uint32_t>& found) const {
  found.clear();
  if (levels_.size() == 1) {
    found.push_back(0);
    return 0;
  }
  return look_at(levels_.size() - 1, 0, box, first, found);
}

/// As deep as there are levels, which are ten at most.
std::size_t MortonBoxes::look_at(std::size_t level, std::size_t number, const RoundedBox& box,
                                 std::size_t first, std::vector<std::uint32_t>& found) const {
  std::size_t compared = EightBoxes::kLanes;
  for (unsigned int left = levels_[level][number].meet(box); left != 0; left &= left - 1) {
    const std::size_t below =
        EightBoxes::kLanes * number + static_cast<std::size_t>(std::countr_zero(left));
    if (level == 1) {
      if (below >= first) {
        found.push_back(static_cast<std::uint32_t>(below));
      }
    } else if ((below + 1) << 3U * (level - 1) > first) {
      compared += look_at(level - 1, below, box, first, found);
    }
  }
  return compared;
}

}  // namespace g31::parts
