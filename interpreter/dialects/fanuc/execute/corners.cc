// ,C and ,R: chamfers and roundings between two blocks of a contour.  Sources: FANUC Series 0i-MB
// operator's manual B-63844EN, optional angle chamfering and corner rounding, with alarms 51 to 55;
// MELDAS corner chamfering and corner rounding, P382 to P385; Haas mill operator's manual, G01
// corner rounding and chamfering: a G04 may stand between the two blocks.

#include <algorithm>
#include <utility>

#include "interpreter/dialects/fanuc/execute/codes.h"
#include "interpreter/dialects/fanuc/execute/compensation.h"

namespace g31::fanuc {
namespace {

using path::CornerWish;

Failure at_corner(AlarmId id, source::Location block, std::string detail) {
  Failure failure = block_failure(id, std::move(detail));
  failure.block = block;
  return failure;
}

bool is_contour(const Control& control, const NcBlock& block) {
  const int g = control.modal.group[Group::Motion].whole;
  return block.code == nullptr && !in_canned_cycle(control) && g >= 1 && g <= 3;
}

/// Millimetres of a corner word behind scaling, as for R of an arc.
double corner_size_mm(const Control& control, const EvaluatedWord& word) {
  const WorkTransform& transform = control.coordinates.transform();
  const Plane plane = control.modal.plane();
  return control.scale.length_mm(word) *
         std::max(transform.stretch(plane.first), transform.stretch(plane.second));
}

/// Whether ,R says how a hole is tapped, and no radius.
bool rounds_nothing(const Control& control) {
  const CannedCycle* const cycle = cycle_in_force(control);
  return control.profile.has_synchronous_taps && cycle != nullptr && taps(*cycle);
}

/// What the block's ,C and ,R ask for.
Result<CornerWish, Failure> wish_of(const Control& control, const NcBlock& block) {
  CornerWish wish;
  const EvaluatedWord* asked = nullptr;
  for (const EvaluatedWord& word : block.words.all()) {
    if (word.letter != syntax::kChamferWord && word.letter != syntax::kRoundingWord) {
      continue;
    }
    if (word.letter == syntax::kRoundingWord && rounds_nothing(control)) {
      continue;
    }
    if (asked != nullptr && !control.profile.last_corner_word_counts) {
      return at_word(second_corner(), word);
    }
    if (auto wrong = wrong_corner(word.number)) {
      return at_word(*std::move(wrong), word);
    }
    asked = &word;
    wish.size_mm = corner_size_mm(control, word);
    wish.kind = wish.size_mm == 0.0                   ? CornerWish::Kind::Sharp
                : word.letter == syntax::kChamferWord ? CornerWish::Kind::ChamferWidth
                                                      : CornerWish::Kind::Rounding;
  }
  if (asked != nullptr && !(is_contour(control, block) && block.has_axis_word)) {
    return at_word(AlarmId::CornerAtRapid, *asked,
                   ",C and ,R stand in a block of G01, G02 or G03 that moves");
  }
  return wish;
}

}  // namespace

MaybeFailure read_corner(Control& control, const NcBlock& block) {
  CutterStage& cutter = control.cutter;
  const bool dwells = block.code != nullptr && block.code->action == GAction::Dwell;
  if (cutter.corners.holds() && !dwells && !(is_contour(control, block) && block.has_axis_word)) {
    return at_corner(AlarmId::CornerWithoutNext, control.block,
                     "the block behind ,C or ,R moves with G01, G02 or G03; a G04 may stand "
                     "between");
  }
  constexpr char kCornerWords[] = {syntax::kChamferWord, syntax::kRoundingWord};
  if (!block.words.has_any(letters_of({kCornerWords, std::size(kCornerWords)}))) {
    cutter.wish = {};
    return std::nullopt;
  }
  const auto wish = wish_of(control, block);
  if (!wish) {
    return wish.error();
  }
  cutter.wish = wish.value();
  return std::nullopt;
}

MaybeFailure refuse_waiting_corner(const Control& control) {
  return control.cutter.corners.holds()
             ? MaybeFailure(at_corner(AlarmId::CornerWithoutNext, control.block,
                                      "the corner of ,C or ,R still waits for its second block"))
             : std::nullopt;
}

Failure from_corner_fault(const path::CornerFault& fault) {
  const auto [id, detail] = [&fault]() -> std::pair<AlarmId, const char*> {
    switch (fault.error) {
      case path::CornerError::WayTooShort:
        return {AlarmId::CornerTooLarge, "the way in front of the corner is too short for it"};
      case path::CornerError::BehindTooShort:
        return {AlarmId::CornerTooLargeBehind, "the way behind the corner is too short for it"};
      case path::CornerError::ChamferAtArc:  // of other rules
      case path::CornerError::NotFlat:
        break;
    }
    return {AlarmId::CornerWithoutMove, "another axis moves along with those of the plane"};
  }();
  Failure failure = at_corner(id, fault.where, detail);
  failure.calls = fault.calls;
  return failure;
}

MaybeFailure refuse_corner_before(const Control& control, const path::PathBlock& block) {
  const path::ContourCorners& corners = control.cutter.corners;
  const path::OffsetPlane plane = corners.held_plane();
  if (plane != offset_plane(control)) {
    return at_corner(AlarmId::CornerWithoutMove, block.where, "the plane changes behind ,C or ,R");
  }
  if (plane.of(block.q_M_end) == plane.of(corners.held_end())) {
    return at_corner(AlarmId::CornerWithoutMove, block.where,
                     "the block behind ,C or ,R does not move in the plane");
  }
  return std::nullopt;
}

}  // namespace g31::fanuc
