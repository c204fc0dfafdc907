#pragma once

#include "interpreter/dialects/fanuc/vocabulary/g_codes.h"

namespace g31::fanuc {

/// Whether axis words beside a code are its data and no motion.
constexpr bool takes_axis_words(GAction action) {
  return action == GAction::Dwell || action == GAction::SetData || action == GAction::LocalShift ||
         action == GAction::SetPosition || action == GAction::PresetSystem ||
         action == GAction::Mirror || action == GAction::MirrorOff || action == GAction::Scaling ||
         action == GAction::Rotation || action == GAction::StrokeCheck ||
         action == GAction::Unsimulated;
}

}  // namespace g31::fanuc
