#include "interpreter/dialects/fanuc/code/data_setting.h"

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/vocabulary/offset_numbers.h"

namespace g31::fanuc {
namespace {

using runtime::OffsetMemory;
using runtime::ToolEntry;

constexpr OffsetForm kOffsetForms[] = {
    {1, &ToolEntry::length_wear_mm, false, OffsetMemory::A},
    {10, &ToolEntry::length_mm, false, OffsetMemory::B},
    {11, &ToolEntry::length_wear_mm, false, OffsetMemory::A},
    {12, &ToolEntry::radius_mm, true, OffsetMemory::C},
    {13, &ToolEntry::radius_wear_mm, true, OffsetMemory::C},
};

}  // namespace

const OffsetForm* find_offset_form(int l, OffsetMemory memory) {
  for (const OffsetForm& form : kOffsetForms) {
    if (form.l == l && memory >= form.from) {
      return &form;
    }
  }
  return nullptr;
}

MaybeWrong missing_offset_word(bool has_p, bool has_r) {
  return !has_p   ? MaybeWrong(WrongValue{AlarmId::DataInputFormat, "P is missing"})
         : !has_r ? MaybeWrong(WrongValue{AlarmId::NoValueInG10, "R is missing"})
                  : std::nullopt;
}

MaybeWrong wrong_data_number(int l, int p, const Profile& profile) {
  const int least = l == 2 ? 0 : 1;
  const int most = l == 2 ? kWorkSystems : l == 20 ? profile.additional_systems : kToolOffsets;
  return p < least || p > most ? MaybeWrong(WrongValue{AlarmId::IllegalPInG10,
                                                       fmt::format("P is {} to {}", least, most)})
                               : std::nullopt;
}

}  // namespace g31::fanuc
