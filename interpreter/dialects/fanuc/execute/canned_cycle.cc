#include "interpreter/dialects/fanuc/execute/canned_cycle.h"

#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/codes.h"

namespace g31::fanuc {
namespace {

constexpr int kMostRepeats = 9999;
constexpr double kMostPecks = 1e5;   // more is a slip of the keyboard
constexpr double kSameDepth = 1e-9;  // mm: pecks add up to a depth but for their rounding

/// One hole at work: moves along the drilling axis of the point where the machine stands.
class Hole {
 public:
  Hole(Control& control, const CannedCycle& cycle, const Plane& plane)
      : control_(control),
        data_(control.cycle),
        cycle_(cycle),
        plane_(plane),
        q_L_(control.coordinates.programmed()) {}

  MaybeFailure drill();

 private:
  using Step = MaybeFailure (Hole::*)();

  // The steps.
  MaybeFailure enter();
  MaybeFailure feed_in();
  MaybeFailure dwell();
  MaybeFailure step_aside();
  MaybeFailure step_back();
  MaybeFailure leave();

  MaybeFailure peck();
  MaybeFailure draw_back(double done, double sign, bool clears);
  MaybeFailure move(double level, machine::Traverse traverse);
  MaybeFailure rapid(double level) { return move(level, machine::Traverse::Rapid); }
  MaybeFailure feed(double level);
  [[nodiscard]] AxisPositions shift() const;
  /// Scaling leaves Q and the parameters of pecking as they are.
  [[nodiscard]] double unscaled(double mm) const {
    return mm / control_.coordinates.transform().stretch(plane_.across);
  }
  [[nodiscard]] bool to_initial() const {
    return control_.modal.group[Group::CycleReturn].whole == 98 ||
           cycle_.feeding == CannedCycle::Feeding::Back;
  }

  Control& control_;
  const CycleData& data_;
  const CannedCycle& cycle_;
  Plane plane_;
  AxisPositions q_L_;
  AxisPositions q_B_aside_ = AxisPositions::Zero();
};

MaybeFailure Hole::drill() {
  constexpr Step kInwards[] = {&Hole::enter,      &Hole::feed_in, &Hole::dwell,
                               &Hole::step_aside, &Hole::leave,   &Hole::step_back};
  constexpr Step kBackwards[] = {&Hole::step_aside, &Hole::enter,    &Hole::step_back,
                                 &Hole::feed_in,    &Hole::dwell,    &Hole::step_aside,
                                 &Hole::leave,      &Hole::step_back};
  const bool backwards = cycle_.feeding == CannedCycle::Feeding::Back;
  const auto steps =
      backwards ? std::span<const Step>(kBackwards) : std::span<const Step>(kInwards);
  for (const Step step : steps) {
    if (auto failure = (this->*step)()) {
      return failure;
    }
  }
  control_.coordinates.arrived_at_programmed(q_L_);
  return std::nullopt;
}

MaybeFailure Hole::move(double level, machine::Traverse traverse) {
  if (const auto halt = control_.watch.before_work()) {
    return halt_failure(*halt);
  }
  q_L_[plane_.across] = level;
  const AxisPositions q_B_end = control_.coordinates.to_path(q_L_) + q_B_aside_;
  return traverse == machine::Traverse::Rapid ? rapid_to(control_, q_B_end, control_.rapid_path())
                                              : feed_to(control_, q_B_end, 1);
}

MaybeFailure Hole::feed(double level) {
  if (!(taps(cycle_) && data_.is_synchronous)) {
    return move(level, machine::Traverse::Feed);
  }
  constexpr GNumber kPerTurn{95, 0};
  GNumber& mode = control_.modal.group[Group::FeedMode];
  const GNumber in_force = std::exchange(mode, kPerTurn);
  auto failure = move(level, machine::Traverse::Feed);
  mode = in_force;
  return failure;
}

MaybeFailure Hole::enter() {
  return rapid(data_.r);
}

MaybeFailure Hole::feed_in() {
  const bool pecks = cycle_.feeding == CannedCycle::Feeding::ChipBreak ||
                     cycle_.feeding == CannedCycle::Feeding::FullRetract;
  return pecks ? peck() : feed(data_.bottom);
}

MaybeFailure Hole::peck() {
  const double sign = data_.bottom < data_.r ? -1.0 : 1.0;
  const ShrinkingPeck cuts = data_.shrinking.value_or(ShrinkingPeck{data_.q, 0.0, data_.q});
  const double least = unscaled(cuts.less > 0.0 ? std::min(cuts.least, cuts.first) : cuts.first);
  const double depth = std::abs(data_.bottom - data_.r);
  if (least == 0.0 || depth > least * kMostPecks) {
    return block_failure(
        AlarmId::CycleWithoutDepth,
        fmt::format("{} is {} for a depth of {}", data_.shrinking ? "I or K" : "Q", least, depth));
  }
  double done = 0.0;
  double cleared = 0.0;
  double cut = unscaled(cuts.first);
  while (true) {
    const double next = done + cut;
    cut = std::max(cut - unscaled(cuts.less), least);
    const bool last = next >= depth - kSameDepth;
    if (auto failure = feed(last ? data_.bottom : data_.r + sign * next)) {
      return failure;
    }
    if (last) {
      return std::nullopt;
    }
    const bool clears =
        cycle_.feeding == CannedCycle::Feeding::FullRetract ||
        (data_.clear_after > 0.0 && next - cleared >= unscaled(data_.clear_after) - kSameDepth);
    if (auto failure = draw_back(next, sign, clears)) {
      return failure;
    }
    cleared = clears ? next : cleared;
    done = next;
  }
}

/// Between two pecks.
/// @param done    depth so far below R
/// @param clears  out to R and in again; else a little
MaybeFailure Hole::draw_back(double done, double sign, bool clears) {
  const double way = unscaled(
      control_.parameters.get(clears ? ParameterId::PeckClearance : ParameterId::ChipBreakRetract));
  if (clears) {
    if (auto failure = rapid(data_.r)) {
      return failure;
    }
  }
  return rapid(data_.r + sign * std::max(0.0, done - way));
}

MaybeFailure Hole::dwell() {
  if (cycle_.dwell != CannedCycle::Dwell::None && data_.dwell_s > 0.0) {
    if (const auto late = control_.outlet.pause({data_.dwell_s, control_.block})) {
      return from_late_fault(control_, *late);
    }
  }
  return std::nullopt;
}

/// The shift of G76 and G87, in path coordinates: the spindle stands still where it was oriented,
/// however the program is turned.
AxisPositions Hole::shift() const {
  if (data_.aside) {
    return with_two(AxisPositions::Zero(), plane_.first, data_.aside->front(), plane_.second,
                    data_.aside->back());
  }
  const bool second = control_.parameters.is_on(ParameterId::ShiftAlongSecond);
  const bool negative = control_.parameters.is_on(ParameterId::ShiftNegative);
  AxisPositions q_B_shift = AxisPositions::Zero();
  q_B_shift[second ? plane_.second : plane_.first] = negative ? -data_.q : data_.q;
  return q_B_shift;
}

MaybeFailure Hole::step_aside() {
  q_B_aside_ = cycle_.shift == CannedCycle::Shift::Aside ? shift() : AxisPositions::Zero();
  if (q_B_aside_ == AxisPositions::Zero()) {
    return std::nullopt;
  }
  return rapid(q_L_[plane_.across]);
}

MaybeFailure Hole::step_back() {
  if (q_B_aside_ == AxisPositions::Zero()) {
    return std::nullopt;
  }
  q_B_aside_.setZero();
  return rapid(q_L_[plane_.across]);
}

MaybeFailure Hole::leave() {
  if (cycle_.retract == CannedCycle::Retract::Rapid) {
    return rapid(to_initial() ? data_.initial : data_.r);
  }
  const bool by_feed = cycle_.retract == CannedCycle::Retract::Feed;
  if (auto failure = by_feed ? feed(data_.r) : rapid(data_.r)) {
    return failure;
  }
  if (cycle_.dwell == CannedCycle::Dwell::BottomAndR) {
    if (auto failure = dwell()) {
      return failure;
    }
  }
  return to_initial() ? rapid(data_.initial) : std::nullopt;
}

/// What I, J and K are for, beside Q or in its place.
void take_distances(const Control& control, const NcBlock& block, const Plane& plane,
                    CycleData& data) {
  const Profile& profile = control.profile;
  const auto length = [&](char address) {
    const EvaluatedWord* const word = block.words.find(address);
    return word != nullptr ? control.scale.length_mm(*word) : 0.0;
  };
  if (block.words.has('Q')) {
    data.shrinking.reset();
    data.aside.reset();
    data.clear_after = profile.pecks_clear ? std::abs(length('K')) : 0.0;
  } else if (cycle_in_force(control)->shift == CannedCycle::Shift::Aside) {
    if (profile.shifts_by_distances &&
        (block.words.has(plane.first_centre) || block.words.has(plane.second_centre))) {
      data.aside = {length(plane.first_centre), length(plane.second_centre)};
    }
  } else if (profile.pecks_shrink && block.code == nullptr && block.words.has('I')) {
    data.shrinking =
        ShrinkingPeck{std::abs(length('I')), std::abs(length('J')), std::abs(length('K'))};
  }
}

/// Takes Z, R, Q and P of the block into the cycle's data; G91 counts R from the initial level and
/// Z from R.
MaybeFailure take_data(Control& control, const NcBlock& block, const Plane& plane) {
  CycleData& data = control.cycle;
  const bool adds = control.modal.incremental();
  const double depth = data.bottom - data.r;
  const char letter = kAxisLetters[static_cast<std::size_t>(plane.across)];
  if (const EvaluatedWord* const r = block.words.find('R')) {
    data.r = (adds ? data.initial : 0.0) + control.scale.length_mm(*r);
    data.bottom = adds ? data.r + depth : data.bottom;
  }
  if (const EvaluatedWord* const z = block.words.find(letter)) {
    data.bottom = (adds ? data.r : 0.0) + control.scale.length_mm(*z);
  }
  if (const EvaluatedWord* const q = block.words.find('Q')) {
    data.q = std::abs(control.scale.length_mm(*q));
  }
  take_distances(control, block, plane, data);
  if (const EvaluatedWord* const r = block.words.find(syntax::kRoundingWord)) {
    data.is_synchronous = r->number != 0.0;
  }
  if (const EvaluatedWord* const p = block.words.find('P')) {
    const auto seconds = dwell_seconds(control, *p);
    if (!seconds) {
      return seconds.error();
    }
    data.dwell_s = seconds.value();
    if (auto failure = at_word(wrong_dwell(data.dwell_s), *p)) {
      return failure;
    }
  }
  return std::nullopt;
}

/// Tells of a cycle that takes the level where it begins for its R or its bottom.
void tell_missing_level(Control& control, const NcBlock& block, const Plane& plane) {
  const char letter = kAxisLetters[static_cast<std::size_t>(plane.across)];
  const bool has_r = block.words.has('R');
  const bool has_bottom = block.words.has(letter);
  if (!has_r || !has_bottom) {
    control.warn_once(source::DiagnosticId::CycleWithoutLevel, block.where,
                      has_r        ? std::string(1, letter)
                      : has_bottom ? "R"
                                   : fmt::format("R and {}", letter));
  }
}

Result<int, Failure> repeats_of(Control& control, const NcBlock& block) {
  const char letter =
      control.parameters.is_on(ParameterId::TapeFormat) ? 'L' : control.profile.cycle_repeats;
  if (letter == 'K' && block.words.has('L')) {  // K is of the cycle itself where L repeats
    control.warn_once(source::DiagnosticId::WordWithoutEffect, block.where,
                      "K repeats a canned cycle, L with parameter 0001.1");
  }
  const EvaluatedWord* const word = block.words.find(letter);
  if (word == nullptr) {
    return 1;
  }
  const auto number = integer_of(*word, control.profile);
  if (number && (number.value() < 0 || number.value() > kMostRepeats)) {
    return at_word(AlarmId::IllegalAddress, *word, fmt::format("{} is 0 to 9999", letter));
  }
  return number;
}

/// Rapid to the place of the next hole; the drilling axis waits, and a changed tool offset with it.
MaybeFailure position(Control& control, AxisPositions q_L_end, const Plane& plane) {
  q_L_end[plane.across] = control.coordinates.programmed()[plane.across];
  AxisPositions q_B_end = control.coordinates.to_path(q_L_end);
  q_B_end[plane.across] = control.path_position()[plane.across];
  if (auto failure = position_to(control, q_B_end)) {
    return failure;
  }
  control.coordinates.arrived_at_programmed(q_L_end);
  return std::nullopt;
}

bool names_a_place(const NcBlock& block, const Plane& plane) {
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (static_cast<int>(axis) != plane.across && block.words.has(kAxisLetters[axis])) {
      return true;
    }
  }
  return false;
}

}  // namespace

void start_canned_cycle(Control& control) {
  const Plane plane = cycle_plane(control);
  const double level = control.coordinates.programmed()[plane.across];
  control.cycle = {};
  control.cycle.initial = control.cycle.r = control.cycle.bottom = level;
}

Plane cycle_plane(const Control& control) {
  const bool by_plane = control.parameters.is_on(ParameterId::DrillAcrossPlane);
  return by_plane ? control.modal.plane() : plane_of({17, 0});
}

MaybeFailure take_cycle_data(Control& control, const NcBlock& block) {
  const Plane plane = cycle_plane(control);
  if (!std::exchange(control.cycle.has_begun, true)) {
    tell_missing_level(control, block, plane);
  }
  return take_data(control, block, plane);
}

MaybeFailure drill_at(Control& control, const AxisPositions& q_L) {
  const Plane plane = cycle_plane(control);
  if (auto failure = position(control, q_L, plane)) {
    return failure;
  }
  const CannedCycle& cycle = *cycle_in_force(control);
  return Hole(control, cycle, plane).drill();
}

/// G73 to G89: a hole at each place that the block names; a block without axes makes none (MB-306
/// to MB-312).
MaybeFailure execute_canned_cycle(Control& control, const NcBlock& block) {
  const Plane plane = cycle_plane(control);
  if (!block.has_axis_word && !block.words.has('R')) {
    return std::nullopt;
  }
  if (auto failure = take_cycle_data(control, block)) {
    return failure;
  }
  const auto repeats = repeats_of(control, block);
  if (!repeats) {
    return repeats.error();
  }
  const CannedCycle& cycle = *cycle_in_force(control);
  if (taps(cycle) && block.words.has('Q')) {
    control.warn_once(source::DiagnosticId::NotSimulated, block.where,
                      "Q of a tapping cycle (pecks of rigid tapping)");
  }
  for (int i = 0; i < repeats.value(); ++i) {
    if (names_a_place(block, plane)) {
      if (auto failure = position(control, programmed_end(control, block), plane)) {
        return failure;
      }
    }
    if (auto failure = Hole(control, cycle, plane).drill()) {
      return failure;
    }
  }
  return std::nullopt;
}

}  // namespace g31::fanuc
