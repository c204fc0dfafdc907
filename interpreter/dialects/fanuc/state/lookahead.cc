#include "interpreter/dialects/fanuc/state/lookahead.h"

#include "interpreter/dialects/fanuc/vocabulary/g_codes.h"
#include "machine/base/contract.h"
#include "machine/units/axis_positions.h"

namespace g31::fanuc {
namespace {

bool is_fence(int m, const Parameters& parameters) {
  if (m == 0 || m == 1 || m == 2 || m == 30) {
    return true;
  }
  const auto count = [](ParameterId id) { return info(id).last - info(id).first + 1; };
  for (int i = 0; i < count(ParameterId::UnbufferedMCode); ++i) {
    if (m == nearest_integer(parameters.get(ParameterId::UnbufferedMCode, i))) {
      return true;
    }
  }
  for (int i = 0; i < count(ParameterId::UnbufferedMCodes); i += 2) {
    const double first = parameters.get(ParameterId::UnbufferedMCodes, i);
    const double last = parameters.get(ParameterId::UnbufferedMCodes, i + 1);
    if (first > 0.0 && m >= first && m <= last) {
      return true;
    }
  }
  return false;
}

/// #5001.. and #5061.. hold what an earlier block left, whatever the axes do meanwhile (MB-138).
bool is_settled_position(Shows shows) {
  return shows == Shows::BlockEnd || shows == Shows::SkipPosition || shows == Shows::SkipDetected;
}

}  // namespace

bool is_fence(const GCode& code, const Profile& profile) {
  switch (code.action) {
    case GAction::Skip:
    case GAction::MeasureTool:
    case GAction::MeasureDiameter:
    case GAction::MeasureWork:
    case GAction::MeasureCentre:
    case GAction::MachineMove:
    case GAction::CheckReference:
    case GAction::ToReference:
    case GAction::FromReference:
    case GAction::SetData:
    case GAction::EndData:
    case GAction::LocalShift:
    case GAction::SetPosition:
    case GAction::PresetSystem:
    case GAction::StrokeCheck:
    case GAction::ToolToPlane:
    case GAction::TableOffset:
    case GAction::SettingError:
    case GAction::OriginOnTable:
    case GAction::OriginOnTableOff:
    case GAction::LengthUnit:
      return true;
    case GAction::WorkOffset:
      return code.number.tenth != 0;
    case GAction::Dwell:
      return profile.dwell_is_fence;
    case GAction::Modal:
    case GAction::NoEffect:
    case GAction::ExactStop:
    case GAction::ContourControl:
    case GAction::SingleDirection:
    case GAction::Motion:
    case GAction::ToolLength:
    case GAction::TipControl:
    case GAction::MacroCall:
    case GAction::PolarOn:
    case GAction::PolarOff:
    case GAction::Mirror:
    case GAction::MirrorOff:
    case GAction::Scaling:
    case GAction::ScalingOff:
    case GAction::Rotation:
    case GAction::TiltedPlane:
    case GAction::RotationOff:
    case GAction::CannedCycle:
    case GAction::HolePattern:
    case GAction::CycleOff:
    case GAction::FeedType:
    case GAction::SurfaceSpeed:
    case GAction::ToolReplacement:
    case GAction::Unsimulated:
    case GAction::Refused:
      return false;
  }
  contract_violated("every action is a fence or none", __FILE__, __LINE__);
}

BlockEffect effect_of(const BlockWords& words, const Profile& profile,
                      const Parameters& parameters) {
  BlockEffect effect = BlockEffect::Nothing;
  for (const EvaluatedWord& word : words.all()) {
    bool fence = false;
    if (word.letter == 'G') {
      const GCode* const code = find_g_code(word.number, profile);
      fence = code != nullptr && is_fence(*code, profile);
    } else if (word.letter == 'M') {
      fence = is_fence(nearest_integer(word.number), parameters);
    }
    if (fence) {
      return BlockEffect::Finishes;
    }
    const bool takes_time = axis_index(word.letter) >= 0 || word.letter == 'M' ||
                            word.letter == 'S' || word.letter == 'T' ||
                            (word.letter == 'G' && word.number == 4.0);
    effect = takes_time ? BlockEffect::Runs : effect;
  }
  return effect;
}

void Lookahead::executed(BlockEffect effect) {
  switch (effect) {
    case BlockEffect::Finishes:
      runs_ = false;
      return;
    case BlockEffect::Runs:
      runs_ = true;
      blocks_behind_ = 0;
      return;
    case BlockEffect::Nothing:
      ++blocks_behind_;
      return;
  }
}

std::optional<source::DiagnosticId> Lookahead::judge(const SystemVariable& row,
                                                     source::Location where, std::int32_t number) {
  const bool settled = is_settled_position(row.shows);
  if (!is_ahead() || (row.while_moving == WhileMoving::Enabled && !settled)) {
    return std::nullopt;
  }
  if (!reported_.emplace(where.file, where.begin, number).second) {
    return std::nullopt;
  }
  return settled ? source::DiagnosticId::ReadAheadSettled : source::DiagnosticId::ReadAhead;
}

}  // namespace g31::fanuc
