#include "interpreter/dialects/fanuc/profile.h"

#include <algorithm>
#include <array>

namespace g31::fanuc {
namespace {

constexpr auto kRows = std::to_array<Profile>({
#define PROFILE(name, numbers, decimals, digits, largest, smallest, sequence, macros, subs, alarm, \
                functions_30i, needs_popen, overflow, plus_sign)                                   \
  {name,                                                                                           \
   AlarmNumbers::numbers,                                                                          \
   ExcessDecimals::decimals,                                                                       \
   digits,                                                                                         \
   largest,                                                                                        \
   smallest,                                                                                       \
   sequence,                                                                                       \
   macros,                                                                                         \
   subs,                                                                                           \
   alarm,                                                                                          \
   functions_30i,                                                                                  \
   needs_popen,                                                                                    \
   {OutputStyle::LeadingZeros::Blank, OutputStyle::Overflow::overflow,                             \
    OutputStyle::PlusSign::plus_sign}},
#include "interpreter/dialects/fanuc/profiles.def"
#undef PROFILE
});

}  // namespace

std::span<const Profile> profiles() {
  return kRows;
}

const Profile* find_profile(std::string_view name) {
  const auto row = std::ranges::find(kRows, name, &Profile::name);
  return row != kRows.end() ? &*row : nullptr;
}

}  // namespace g31::fanuc
