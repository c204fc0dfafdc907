#pragma once

namespace g31::fanuc {

// How many offsets a control has.  kWorkSystems is in g_codes.h.

inline constexpr int kAdditionalSystems = 300;  ///< G54.1 P1..P300
inline constexpr int kToolOffsets = 999;        ///< H and D
inline constexpr int kTableOffsets = 8;         ///< G54.2 P1..P8
inline constexpr int kSettingErrors = 7;        ///< G54.4 P1..P7

}  // namespace g31::fanuc
