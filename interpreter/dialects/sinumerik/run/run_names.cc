// What a name means: STRINGIS.  Source: SINUMERIK ONE NC programming, STRINGIS: the last two digits
// tell the kind of a word that can be programmed, 2 before them; 100: known, not programmable here.

#include <algorithm>
#include <string>

#include "interpreter/dialects/sinumerik/code/block_reader.h"
#include "interpreter/dialects/sinumerik/code/globals.h"
#include "interpreter/dialects/sinumerik/run/functions.h"
#include "interpreter/dialects/sinumerik/vocabulary/g_codes.h"
#include "interpreter/dialects/sinumerik/vocabulary/names.h"
#include "interpreter/dialects/sinumerik/vocabulary/system_variables.h"
#include "interpreter/dialects/sinumerik/vocabulary/words.h"

namespace g31::sinumerik {
namespace {

/// The values that STRINGIS gives.
enum class NameKind {
  Unknown = 0,
  NotProgrammable = 100,
  Unspecific = 200,
  Address = 201,
  GCode = 202,
  Function = 203,
  Procedure = 204,
  Keyword = 205,
  Datum = 206,
  SystemVariable = 207,
  Cycle = 208,
  UserDatum = 209,
  Macro = 210,
  LocalVariable = 211,
  OtherAddress = 400,
};

bool are_digits(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, is_digit);
}

/// A letter, or one with a number.
NameKind kind_of_letter(char letter, std::string_view number) {
  constexpr std::string_view kAddressLetters = "ABCEIJKQUVWXYZ";
  constexpr std::string_view kOtherLetters = "DFHLMNOPST";
  const bool is_alone = number.empty();
  if (kAddressLetters.find(letter) != std::string_view::npos) {
    return NameKind::Address;
  }
  if (letter == 'R') {
    return NameKind::SystemVariable;
  }
  if (letter == 'G' && !is_alone && number.size() <= 3) {
    const auto code = find_g_code(std::stod(std::string(number)));
    return !code                                             ? NameKind::Unknown
           : g_codes()[code->row].action == GAction::Refused ? NameKind::NotProgrammable
                                                             : NameKind::GCode;
  }
  return is_alone && kOtherLetters.find(letter) != std::string_view::npos ? NameKind::OtherAddress
         : is_alone && letter == 'G'                                      ? NameKind::Unspecific
                                                                          : NameKind::Unknown;
}

/// A name with $ before it.
NameKind kind_of_system_name(const Globals& globals, const std::string& name) {
  const bool is_datum = name.starts_with("$M") || name.starts_with("$S") || name.starts_with("$O");
  const auto row = find_system_variable(name);
  if (!row && globals.find(name) == nullptr) {
    return NameKind::Unknown;
  }
  return row && row->row->access == Access::Refused ? NameKind::NotProgrammable
         : is_datum                                 ? NameKind::Datum
                                                    : NameKind::SystemVariable;
}

/// A word of the language.
NameKind kind_of_word(const std::string& name) {
  if (const auto code = find_g_code(name)) {
    return g_codes()[code->row].action == GAction::Refused ? NameKind::NotProgrammable
                                                           : NameKind::GCode;
  }
  if (find_function(name)) {
    return NameKind::Function;
  }
  if (find_procedure(name)) {
    return NameKind::Procedure;
  }
  if (is_refused(name)) {
    return NameKind::NotProgrammable;
  }
  if (const AxisWordInfo* const word = find_axis_word(name)) {
    return word->role == AxisRole::Refused ? NameKind::NotProgrammable : NameKind::Address;
  }
  return is_keyword(name)     ? NameKind::Keyword
         : find_address(name) ? NameKind::Address
                              : NameKind::Unknown;
}

NameKind kind_of_long_name(const Globals& globals, CalledPrograms& programs,
                           const CompiledProgram& program, const std::string& name) {
  const NameKind kind = kind_of_word(name);
  return kind != NameKind::Unknown                                    ? kind
         : program.locals.contains(name)                              ? NameKind::LocalVariable
         : program.sees_main && globals.find_of_main(name) != nullptr ? NameKind::LocalVariable
         : globals.find(name) != nullptr                              ? NameKind::UserDatum
         : !name.empty() && programs.find(name) != nullptr            ? NameKind::Cycle
                                                                      : NameKind::Unknown;
}

}  // namespace

namespace function {

/// STRINGIS(name)
MaybeFailure kind_of_name(const Globals& globals, CalledPrograms& programs, Operands& at,
                          const Op& op, Arguments list) {
  const std::string name = upper(at.text(list[0].value));
  const bool is_macro =
      globals.macros.find(name) != nullptr || globals.offered_macros.find(name) != nullptr;
  const bool is_letter_name = !name.empty() && is_letter(name.front()) &&
                              (name.size() == 1 || are_digits(std::string_view(name).substr(1)));
  at.number(op.result) = static_cast<double>(
      is_macro                ? NameKind::Macro
      : is_letter_name        ? kind_of_letter(name.front(), std::string_view(name).substr(1))
      : name.starts_with('$') ? kind_of_system_name(globals, name)
                              : kind_of_long_name(globals, programs, at.program(), name));
  return std::nullopt;
}

}  // namespace function
}  // namespace g31::sinumerik
