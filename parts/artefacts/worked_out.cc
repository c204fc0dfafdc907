#include "parts/artefacts/worked_out.h"

#include <array>
#include <cmath>
#include <numbers>

namespace g31::parts {
namespace {

#define S(size) sizes.at(#size)

constexpr auto kStandIns = std::to_array<WorkedOut>({
#define STAND_IN(shape, name, formula)                                                           \
  {#shape, #name, Quantity::Length, []([[maybe_unused]] const Sizes& sizes) { return formula; }, \
   ""},
#define WORKED_OUT(shape, name, formula, text)
#define WORKED_OUT_ANGLE(shape, name, formula, text)
#include "parts/artefacts/worked_out.def"
#undef STAND_IN
#undef WORKED_OUT
#undef WORKED_OUT_ANGLE
});

constexpr auto kWorkedOut = std::to_array<WorkedOut>({
#define STAND_IN(shape, name, formula)
#define WORKED_OUT(shape, name, formula, text) \
  {#shape, #name, Quantity::Length, [](const Sizes& sizes) { return formula; }, text},
#define WORKED_OUT_ANGLE(shape, name, formula, text) \
  {#shape, #name, Quantity::Angle, [](const Sizes& sizes) { return formula; }, text},
#include "parts/artefacts/worked_out.def"
#undef STAND_IN
#undef WORKED_OUT
#undef WORKED_OUT_ANGLE
});

#undef S

}  // namespace

std::span<const WorkedOut> stand_ins() {
  return kStandIns;
}

std::span<const WorkedOut> worked_out() {
  return kWorkedOut;
}

}  // namespace g31::parts
