#pragma once

#include <array>
#include <cstdint>
#include <map>

#include "interpreter/dialects/fanuc/text/word_values.h"
#include "interpreter/dialects/fanuc/vocabulary/parameters.h"
#include "interpreter/dialects/fanuc/vocabulary/profile.h"
#include "interpreter/syntax/tree.h"

namespace g31::fanuc {

/// A subprogram that a word calls, and the common variable that takes the word's value.
struct AddressCall {
  int program = 0;  ///< 0: none
  int variable = 0;

  bool operator==(const AddressCall&) const = default;
};

/// Which codes and addresses call a program, as parameters or the set-up sheet say.
struct CodeCalls {
  std::map<int, int> macro_by_g;       ///< G number to macro program (MB-207)
  std::map<int, int> macro_by_m;       ///< M number to macro program (MB-209)
  std::map<int, int> subprogram_by_m;  ///< M number to subprogram (MB-210)
  std::array<AddressCall, syntax::kLetterCount> by_address{};  ///< by letter - A (MB-211, MB-212)
  /// The letters that may call: G, M and those of by_address.
  std::uint32_t letters = kCodes;

  /// Parameters changed: calls of the old ones go, those of the new ones come; what the sheet named
  /// by code stays.
  void turn_over(const Parameters& before, const Parameters& now, const Profile& profile);

  bool operator==(const CodeCalls&) const = default;

 private:
  static constexpr std::uint32_t kCodes = letters_of("GM");
  void choose_addresses(const Parameters& parameters, const Profile& profile);
};

}  // namespace g31::fanuc
