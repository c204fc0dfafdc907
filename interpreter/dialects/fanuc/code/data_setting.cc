#include "interpreter/dialects/fanuc/code/data_setting.h"

#include <string_view>

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

int usual_data(const BlockWords& words, const Profile& profile) {
  constexpr int kToolOffset = 1;
  constexpr int kWorkOffset = 2;
  constexpr std::uint32_t kAxes = letters_of({kAxisLetters, kAxisCount});
  return profile.sets_system_in_force && words.has_any(kAxes) ? kWorkOffset : kToolOffset;
}

int data_of(const BlockWords& words, const Profile& profile) {
  const EvaluatedWord* const l = words.find('L');
  return l != nullptr ? nearest_integer(l->number) : usual_data(words, profile);
}

bool ends_data(const Profile& profile) {
  constexpr GNumber kEndOfData{11, 0};
  return find_g_code(kEndOfData, profile) != nullptr;
}

MaybeWrong foreign_to_offset(char letter, int l) {
  constexpr std::string_view kDistances = "IJK";
  const bool is_foreign =
      axis_index(letter) >= 0 || kDistances.find(letter) != std::string_view::npos;
  return is_foreign ? MaybeWrong(WrongValue{AlarmId::DataInputFormat,
                                            fmt::format("{} beside G10 L{}", letter, l)})
                    : std::nullopt;
}

MaybeWrong missing_offset_word(bool has_p, bool has_r) {
  return !has_p   ? MaybeWrong(WrongValue{AlarmId::DataInputFormat, "P is missing"})
         : !has_r ? MaybeWrong(WrongValue{AlarmId::NoValueInG10, "R is missing"})
                  : std::nullopt;
}

MaybeWrong wrong_data_number(int l, int p, const Profile& profile) {
  const int least = l == 2 ? 0 : 1;
  const int most = l == 2 ? kWorkSystems : l == 20 ? profile.additional_systems : kToolOffsets;
  const AlarmId id = sets_work_offset(l) ? AlarmId::IllegalPInG10 : AlarmId::IllegalOffsetInG10;
  return p < least || p > most
             ? MaybeWrong(WrongValue{id, fmt::format("P is {} to {}", least, most)})
             : std::nullopt;
}

}  // namespace g31::fanuc
