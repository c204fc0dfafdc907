#include "interpreter/dialects/sinumerik/vocabulary/system_variables.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include "interpreter/dialects/sinumerik/vocabulary/names.h"

namespace g31::sinumerik {
namespace {

constexpr auto kSystemVariableRows = std::to_array<SystemVariable>({
#define Read(f) Access::Read
#define Write(f, g) Access::Write
#define Stored(f) Access::Write
#define OfLevel(f) Access::Read
#define Refused() Access::Refused
#define SYSTEM_VARIABLE(id, name, type, indices, work, text) \
  {SystemId::id, name, Type::type, indices, work, text},
#include "interpreter/dialects/sinumerik/vocabulary/system_variables.def"
#undef SYSTEM_VARIABLE
#undef Refused
#undef OfLevel
#undef Stored
#undef Write
#undef Read
});

/// Rows whose name is followed by a number: from where to where.
struct Family {
  SystemId id;
  int first;
  int last;
};
constexpr Family kFamilies[] = {
    {SystemId::EdgeParameter, 1, 25},   {SystemId::AdditiveParameter, 13, 71},
    {SystemId::SetupParameter, 13, 71}, {SystemId::EdgeOfBuilder, 1, 10},
    {SystemId::EdgeLife, 1, 15},        {SystemId::ToolOfBuilder, 1, 10},
    {SystemId::ToolDatum, 3, 11},       {SystemId::MagazineDatum, 1, 10},
    {SystemId::MagazinePlace, 1, 7},    {SystemId::MagazinePlaceBuilder, 1, 10},
    {SystemId::MagazineBuilder, 1, 10}, {SystemId::MagazineDistance, 1, 2},
    {SystemId::Multitool, 2, 8},        {SystemId::GrindingDatum, 1, 9},
    {SystemId::CarrierDatum, 1, 65},    {SystemId::Fifo, 1, 10},
};

/// A step keeps the number of a member in 8 bits.
static_assert(std::ranges::all_of(kFamilies, [](const Family& family) {
  return family.first >= 0 && family.last <= std::numeric_limits<std::uint8_t>::max();
}));

/// Additive offsets have 3 to 11 behind the number of DL.
bool is_member(const Family& family, int number) {
  const bool of_additive =
      family.id == SystemId::AdditiveParameter || family.id == SystemId::SetupParameter;
  return number >= family.first && number <= family.last &&
         (!of_additive || (number - 3) % 10 <= 8);
}

std::optional<SystemName> find_member(std::string_view name) {
  for (const Family& family : kFamilies) {
    const SystemVariable& row = kSystemVariableRows[static_cast<std::size_t>(family.id)];
    if (!name.starts_with(row.name)) {
      continue;
    }
    const std::string_view digits = name.substr(row.name.size());
    int number = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (read.ec == std::errc() && read.ptr == digits.data() + digits.size() &&
        is_member(family, number)) {
      return SystemName{&row, number};
    }
  }
  return std::nullopt;
}

bool is_family(SystemId id) {
  return std::ranges::find(kFamilies, id, &Family::id) != std::end(kFamilies);
}

}  // namespace

std::span<const SystemVariable> system_variables() {
  return kSystemVariableRows;
}

std::optional<SystemName> find_system_variable(std::string_view name) {
  static const NameMap<const SystemVariable*> kByName = [] {
    NameMap<const SystemVariable*> map;
    for (const SystemVariable& row : kSystemVariableRows) {
      map.emplace(std::string(row.name), &row);
    }
    return map;
  }();
  if (const auto found = kByName.find(name);
      found != kByName.end() && !is_family(found->second->id)) {
    return SystemName{found->second, 0};
  }
  return find_member(name);
}

}  // namespace g31::sinumerik
