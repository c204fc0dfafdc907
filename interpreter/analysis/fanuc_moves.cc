#include "interpreter/analysis/fanuc_moves.h"

#include <optional>
#include <vector>

#include "interpreter/dialects/fanuc/vocabulary/axis_words.h"
#include "interpreter/dialects/fanuc/vocabulary/g_codes.h"
#include "machine/units/axis_positions.h"

namespace g31::analysis {
namespace {

using fanuc::GAction;

Move::Kind kind_of_motion(int code) {
  return code == 0 || code == 60  ? Move::Kind::Rapid
         : code == 2 || code == 3 ? Move::Kind::Arc
                                  : Move::Kind::Line;
}

/// The move that a G code makes of its block; nullopt: it leaves that to others.
std::optional<Move::Kind> move_of(const fanuc::GCode& code) {
  switch (code.action) {
    case GAction::Motion:
    case GAction::SingleDirection:
      return kind_of_motion(code.number.whole);
    case GAction::Skip:
    case GAction::MeasureTool:
    case GAction::MeasureDiameter:
    case GAction::MeasureWork:
    case GAction::MeasureCentre:
      return Move::Kind::Measuring;
    case GAction::CheckReference:
    case GAction::ToReference:
    case GAction::FromReference:
    case GAction::ToolReplacement:
      return Move::Kind::Reference;
    case GAction::CannedCycle:
    case GAction::HolePattern:
      return Move::Kind::Cycle;
    case GAction::Modal:
    case GAction::LengthUnit:
    case GAction::NoEffect:
    case GAction::ExactStop:
    case GAction::ContourControl:
    case GAction::Dwell:
    case GAction::SetData:
    case GAction::EndData:
    case GAction::ToolLength:
    case GAction::TipControl:
    case GAction::LocalShift:
    case GAction::MachineMove:
    case GAction::ToolToPlane:
    case GAction::TableOffset:
    case GAction::SettingError:
    case GAction::OriginOnTable:
    case GAction::OriginOnTableOff:
    case GAction::WorkOffset:
    case GAction::MacroCall:
    case GAction::SetPosition:
    case GAction::PresetSystem:
    case GAction::PolarOn:
    case GAction::PolarOff:
    case GAction::Mirror:
    case GAction::MirrorOff:
    case GAction::Scaling:
    case GAction::ScalingOff:
    case GAction::Rotation:
    case GAction::TiltedPlane:
    case GAction::RotationOff:
    case GAction::CycleOff:
    case GAction::StrokeCheck:
    case GAction::FeedType:
    case GAction::SurfaceSpeed:
    case GAction::Unsimulated:
    case GAction::Refused:
      return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

void add_moves(const fanuc::CompiledProgram& program, const syntax::Block& block,
               const fanuc::Profile& profile, FlowBuilder& builder) {
  Move::Kind kind = Move::Kind::AsBefore;
  std::vector<AxisTarget> targets;
  for (syntax::Index i = block.first_word; i < block.first_word + block.word_count; ++i) {
    const syntax::Word& word = program.tree->words[i];
    const bool is_computed = word.form == syntax::ValueForm::Computed;
    if (axis_index(word.letter) >= 0) {
      targets.push_back({word.letter, is_computed, is_computed ? 0.0 : word.number, word.span});
      continue;
    }
    const fanuc::GCode* const code =
        word.letter == 'G' && !is_computed ? fanuc::find_g_code(word.number, profile) : nullptr;
    const bool calls = code != nullptr && code->action == GAction::MacroCall;
    if (word.letter == 'G' && (code == nullptr || calls || fanuc::takes_axis_words(code->action))) {
      return;  // what an unknown code does with axis words is for others to say
    }
    if (code != nullptr) {
      kind = move_of(*code).value_or(kind);
    }
  }
  if (!targets.empty()) {
    builder.move(kind, targets);
  }
}

}  // namespace g31::analysis
