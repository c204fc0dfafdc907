#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <tuple>

#include "interpreter/dialects/fanuc/text/word_values.h"
#include "interpreter/dialects/fanuc/vocabulary/parameters.h"
#include "interpreter/dialects/fanuc/vocabulary/profile.h"
#include "interpreter/dialects/fanuc/vocabulary/system_variables.h"
#include "interpreter/source/diagnostic.h"

namespace g31::fanuc {

/// What a block of NC words means to a control that reads ahead (MB-160 to MB-163).
enum class BlockEffect : std::uint8_t {
  Nothing,   ///< only modes and values: nothing runs
  Runs,      ///< motion, a dwell or an auxiliary function, which takes time
  Finishes,  ///< reading ahead stops until everything has run: a fence
};

/// Whether a code stops reading ahead until everything has run.
bool is_fence(const GCode& code, const Profile& profile);

BlockEffect effect_of(const BlockWords& words, const Profile& profile,
                      const Parameters& parameters);

/// Judges which macro statements the control would evaluate while earlier blocks still run.
///
/// Statements are executed in order here, as if each of them waited; with a depth given, a read
/// that the real control would make too early is reported (MB-164).
class Lookahead {
 public:
  /// @param blocks  NC blocks that the control buffers behind the one that runs; 0: not judged
  void set_depth(int blocks) { depth_ = blocks; }

  [[nodiscard]] bool is_judged() const { return depth_ > 0; }

  void executed(BlockEffect effect);

  /// Whether a statement that stands here is evaluated while a block before it may still run.
  [[nodiscard]] bool is_ahead() const { return runs_ && blocks_behind_ < depth_; }

  /// The report that reading this variable ahead deserves; nullopt: none, or made before at this
  /// place.
  std::optional<source::DiagnosticId> judge(const SystemVariable& row, source::Location where,
                                            std::int32_t number);

 private:
  int depth_ = 0;
  bool runs_ = false;      ///< a block since the last fence takes time
  int blocks_behind_ = 0;  ///< NC blocks since that block
  std::set<std::tuple<source::FileId, std::uint64_t, std::int32_t>> reported_;
};

}  // namespace g31::fanuc
