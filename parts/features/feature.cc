#include "parts/features/feature.h"

#include <cmath>
#include <numbers>

namespace g31::parts {
namespace {

struct KindNames {
  std::string_view name;
  std::string_view words;
};

constexpr KindNames kKinds[] = {
#define FEATURE(kind, name, words) {name, words},
#include "parts/features/features.def"
#undef FEATURE
};

constexpr std::string_view kSideNames[kSides] = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};

Point turned(const Point& p, double angle_deg) {
  if (angle_deg == 0.0) {
    return p;  // to the last bit
  }
  const double angle = angle_deg * std::numbers::pi / 180.0;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z()};
}

}  // namespace

std::string_view name_of(FeatureKind kind) {
  return kKinds[static_cast<std::size_t>(kind)].name;
}

std::string_view words_of(FeatureKind kind) {
  return kKinds[static_cast<std::size_t>(kind)].words;
}

std::string_view name_of(Side side) {
  return kSideNames[static_cast<std::size_t>(side)];
}

Point OwnAxes::own_of(const Point& p_P) const {
  return turned(p_P, -angle_deg);
}

Point OwnAxes::part_of(const Point& p_own) const {
  return turned(p_own, angle_deg);
}

}  // namespace g31::parts
