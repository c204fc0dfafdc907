#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>

#include <Eigen/Core>

#include "machine/units/point.h"

namespace g31 {

/// What an axis does.
enum class AxisKind {
  Linear,  ///< goes straight: mm
  Rotary   ///< turns: deg
};

/// Rows of axes.def.
struct AxisRow {
  char letter;
  AxisKind kind;
};
inline constexpr AxisRow kAxes[] = {
#define AXIS(letter, kind) {letter, AxisKind::kind},
#include "machine/units/axes.def"
#undef AXIS
};

/// How many axes a machine may have here, in this order: X Y Z A B C.
inline constexpr std::size_t kAxisCount = std::size(kAxes);

/// The letters of the axes in storage order.
inline constexpr char kAxisLetters[] = {
#define AXIS(letter, kind) letter,
#include "machine/units/axes.def"
#undef AXIS
    '\0'};

/// @param axis  storage index; what lies beyond the axes of a machine does not go straight
constexpr bool is_linear_axis(int axis) {
  return axis >= 0 && axis < static_cast<int>(kAxisCount) &&
         kAxes[static_cast<std::size_t>(axis)].kind == AxisKind::Linear;
}

/// @param axis  storage index
constexpr bool is_rotary_axis(int axis) {
  return axis >= 0 && axis < static_cast<int>(kAxisCount) && !is_linear_axis(axis);
}

constexpr int count_axes(AxisKind kind) {
  int count = 0;
  for (const AxisRow& axis : kAxes) {
    count += axis.kind == kind ? 1 : 0;
  }
  return count;
}

inline constexpr int kLinearAxisCount = count_axes(AxisKind::Linear);
inline constexpr int kRotaryAxisCount = count_axes(AxisKind::Rotary);
static_assert(is_linear_axis(kLinearAxisCount - 1) && is_rotary_axis(kLinearAxisCount),
              "the linear axes stand first");

/// One number per axis: mm for linear ones, degrees for rotary ones; written `q_M` for machine
/// coordinates, `q_W` for work coordinates.  Axes a machine does not have stay 0.
using AxisPositions = Eigen::Matrix<double, static_cast<int>(kAxisCount), 1>;

/// The three linear axes as a point: on a three-axis machine the spindle gauge point.
inline Point linear_axes(const AxisPositions& q) {
  return q.head<kLinearAxisCount>();
}

/// The rotary axes A B C, deg.
inline Eigen::Matrix<double, kRotaryAxisCount, 1> rotary_axes(const AxisPositions& q) {
  return q.tail<kRotaryAxisCount>();
}

namespace detail {

/// Two axes at a time.
using Pair = double __attribute__((vector_size(16)));
using PairBits = std::int64_t __attribute__((vector_size(16)));
static_assert(kAxisCount % 2 == 0);

/// All bits of one axis, none of the others.
inline constexpr auto kBitsOf = [] {
  struct alignas(16) Rows {
    std::int64_t of[kAxisCount][kAxisCount] = {};
  } rows;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    rows.of[i][i] = -1;
  }
  return rows;
}();

}  // namespace detail

/// `q` with another number for one axis.  All axes are written at once: what reads them together
/// right behind would wait for one that is written by itself (15 cycles each time).
inline AxisPositions with_one(AxisPositions q, int axis, double number) {
  using detail::Pair;
  using detail::PairBits;
  const auto bits = reinterpret_cast<PairBits>(Pair{number, number});
  for (std::size_t i = 0; i < kAxisCount; i += 2) {
    PairBits old{};
    PairBits mask{};
    std::memcpy(&old, q.data() + i, sizeof old);
    std::memcpy(&mask, &detail::kBitsOf.of[axis][i], sizeof mask);
    const PairBits made = (bits & mask) | (old & ~mask);
    std::memcpy(q.data() + i, &made, sizeof made);
  }
  return q;
}

/// The same for two different axes.
inline AxisPositions with_two(const AxisPositions& q, int first, double at_first, int second,
                              double at_second) {
  return with_one(with_one(q, first, at_first), second, at_second);
}

/// Whether no axis is at infinity or at no number, asked of all at once.
inline bool all_finite(const AxisPositions& q) {
  return (q - q).sum() == 0.0;
}

/// The storage index of an axis letter, or -1.
constexpr int axis_index(char letter) {
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    if (kAxisLetters[i] == letter) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

}  // namespace g31
