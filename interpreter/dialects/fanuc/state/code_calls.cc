#include "interpreter/dialects/fanuc/state/code_calls.h"

namespace g31::fanuc {
namespace {

/// 6050 to 6059 name the G codes that call macros O9010 to O9019, 6080 to 6089 the M codes of
/// macros O9020 to O9029, 6071 to 6079 the M codes of subprograms O9001 to O9009 (MB-207 to
/// MB-210).
constexpr int kCallParameters = 10;
constexpr int kFirstGMacro = 9010;
constexpr int kFirstMMacro = 9020;
constexpr int kBeforeFirstSubprogram = 9000;

/// An address that a bit makes a call (MB-211, MB-212).
struct SwitchedCall {
  ParameterId parameter;
  char letter;
  AddressCall call;
  bool only_30i;
};

constexpr SwitchedCall kSwitchedCalls[] = {{ParameterId::ToolCalls, 'T', {9000, 149}, false},
                                           {ParameterId::SpindleCalls, 'S', {9029, 147}, true},
                                           {ParameterId::AuxiliaryCalls, 'B', {9028, 146}, true}};

/// Of the addresses that 6090 and 6091 name (MB-212).
constexpr AddressCall kNamedCalls[] = {{9004, 146}, {9005, 147}};

void turn_over_codes(std::map<int, int>& calls, double old_code, double code, int program) {
  if (code == old_code) {
    return;
  }
  calls.erase(nearest_integer(old_code));
  if (code > 0.0) {
    calls[nearest_integer(code)] = program;
  }
}

}  // namespace

void CodeCalls::turn_over(const Parameters& before, const Parameters& now, const Profile& profile) {
  for (int i = 0; i < kCallParameters; ++i) {
    turn_over_codes(macro_by_g, before.get(ParameterId::MacroGCode, i),
                    now.get(ParameterId::MacroGCode, i), kFirstGMacro + i);
    turn_over_codes(macro_by_m, before.get(ParameterId::MacroMCode, i),
                    now.get(ParameterId::MacroMCode, i), kFirstMMacro + i);
    if (i > 0) {
      turn_over_codes(subprogram_by_m, before.get(ParameterId::SubprogramMCode, i - 1),
                      now.get(ParameterId::SubprogramMCode, i - 1), kBeforeFirstSubprogram + i);
    }
  }
  choose_addresses(now, profile);
}

void CodeCalls::choose_addresses(const Parameters& parameters, const Profile& profile) {
  by_address = {};
  letters = kCodes;
  const auto choose = [this](char letter, const AddressCall& call) {
    by_address.at(static_cast<std::size_t>(letter - 'A')) = call;
    letters |= syntax::letter_bit(letter);
  };
  for (const SwitchedCall& row : kSwitchedCalls) {
    if (parameters.is_on(row.parameter) && (profile.has_series_30i_functions() || !row.only_30i)) {
      choose(row.letter, row.call);
    }
  }
  int index = 0;
  for (const AddressCall& call : kNamedCalls) {
    const int letter = nearest_integer(parameters.get(ParameterId::AddressCall, index++));
    if (letter >= 'A' && letter <= 'Z') {
      choose(static_cast<char>(letter), call);
    }
  }
}

}  // namespace g31::fanuc
