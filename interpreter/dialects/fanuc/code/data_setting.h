#pragma once

#include "interpreter/dialects/fanuc/code/word_limits.h"
#include "interpreter/runtime/control_setup.h"

namespace g31::fanuc {

/// What `G10 L..` sets in the tool offset table, and the first memory, from A on, that has it
/// (MB-257, MB-258).
struct OffsetForm {
  int l;
  double runtime::ToolEntry::*field;
  bool is_radius;
  runtime::OffsetMemory from;
};

/// nullptr: L sets no tool offset of such a memory.
const OffsetForm* find_offset_form(int l, runtime::OffsetMemory memory);

inline constexpr int kToolLifeData = 3;  ///< G10 L3
/// G10 L50, and L52 where programs of newer controls write it.
constexpr bool sets_parameters(int l) {
  return l == 50 || l == 52;
}
/// L of G10, where there is none.
int usual_data(const BlockWords& words, const Profile& profile);
/// L of G10, or what counts in its place.  @pre an L is an integer
int data_of(const BlockWords& words, const Profile& profile);
/// G10 L2 and L20.
constexpr bool sets_work_offset(int l) {
  return l == 2 || l == 20;
}

/// Whether a control has the G11 that ends what L50, L52 and L3 begin: it has not these without it.
bool ends_data(const Profile& profile);

/// Of an address that has no place beside a tool offset: an axis does not move in such a block.
MaybeWrong foreign_to_offset(char letter, int l);
/// Of a tool offset.
MaybeWrong missing_offset_word(bool has_p, bool has_r);
/// P of G10 L2 and L20, and of tool offsets.
MaybeWrong wrong_data_number(int l, int p, const Profile& profile);

}  // namespace g31::fanuc
