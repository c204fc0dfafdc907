#pragma once

#include "interpreter/dialects/fanuc/vocabulary/g_codes.h"

namespace g31::fanuc {

/// Whether axis words beside a code are its data and no motion.
constexpr bool takes_axis_words(GAction action) {
  return action == GAction::Dwell || action == GAction::SetData || action == GAction::LocalShift ||
         action == GAction::SetPosition || action == GAction::PresetSystem ||
         action == GAction::Mirror || action == GAction::MirrorOff || action == GAction::Scaling ||
         action == GAction::Rotation || action == GAction::TiltedPlane ||
         action == GAction::StrokeCheck || action == GAction::Unsimulated;
}

/// Whether a modal code takes the words of its block for a frame, or for limits.
constexpr bool is_frame(GAction action) {
  return action == GAction::Mirror || action == GAction::MirrorOff || action == GAction::Scaling ||
         action == GAction::Rotation || action == GAction::TiltedPlane ||
         action == GAction::StrokeCheck;
}

/// Whether a code of one block leaves the words to others.
constexpr bool leaves_words(GAction action) {
  return action == GAction::ExactStop || action == GAction::ContourControl ||
         action == GAction::SingleDirection || action == GAction::NoEffect;
}

/// G27 to G30.
constexpr bool is_of_reference_point(GAction action) {
  return action == GAction::CheckReference || action == GAction::ToReference ||
         action == GAction::FromReference;
}

/// Whether a code of one block gives the work coordinates another origin.
constexpr bool shifts_origin(GAction action) {
  return action == GAction::SetPosition || action == GAction::PresetSystem ||
         action == GAction::LocalShift;
}

/// Whether a code has no place in a tilted plane (G68.2).
constexpr bool is_barred_in_plane(GAction action) {
  return action == GAction::WorkOffset || shifts_origin(action) || is_of_reference_point(action) ||
         action == GAction::MeasureTool || action == GAction::MeasureDiameter ||
         action == GAction::MeasureWork || action == GAction::MeasureCentre ||
         action == GAction::Mirror || action == GAction::Scaling || action == GAction::Rotation;
}

/// Whether a code of one block has no place in coordinates that G68 turns.
constexpr bool is_barred_in_rotation(GAction action) {
  return action == GAction::MachineMove || shifts_origin(action) || is_of_reference_point(action);
}

/// Whether a code has no place under tool centre point control (G43.4).
constexpr bool is_barred_under_tip_control(GAction action) {
  return action != GAction::WorkOffset &&
         (is_barred_in_plane(action) || action == GAction::ToolToPlane);
}

/// Whether a code is an option of machines with rotary axes.
constexpr bool needs_rotary_axes(GAction action) {
  return action == GAction::TipControl || action == GAction::ToolToPlane ||
         action == GAction::TableOffset || action == GAction::OriginOnTable;
}

}  // namespace g31::fanuc
