#include "interpreter/dialects/sinumerik/vocabulary/g_codes.h"

#include <charconv>
#include <string>
#include <vector>

#include "interpreter/dialects/sinumerik/vocabulary/names.h"

namespace g31::sinumerik {
namespace {

constexpr auto kGCodeRows = std::to_array<GCode>({
#define G_CODE(name, group, number, action, text) \
  {name, Group::group, number, GAction::action, text},
#include "interpreter/dialects/sinumerik/vocabulary/g_codes.def"
#undef G_CODE
});

constexpr int kFirstSettable = 505;
constexpr int kLastSettable = 599;
static_assert(kGCodeRows.size() <= kPackedCount && kLastSettable - kFirstSettable < kPackedCount,
              "packed() keeps a row and what G505 adds to it in 8 bits each");
constexpr int kNumberCount = 1000;  // codes are G0 to G999

}  // namespace

std::span<const GCode> g_codes() {
  return kGCodeRows;
}

std::optional<FoundCode> find_g_code(std::string_view name) {
  static const NameMap<std::uint16_t> kByName = [] {
    NameMap<std::uint16_t> map;
    for (std::size_t i = 0; i < kGCodeRows.size(); ++i) {
      map.emplace(std::string(kGCodeRows[i].name), static_cast<std::uint16_t>(i));
    }
    return map;
  }();
  if (const auto found = kByName.find(name); found != kByName.end()) {
    return FoundCode{found->second, 0};
  }
  int number = 0;
  if (name.starts_with('G') && name.size() == 4) {
    std::from_chars(name.data() + 1, name.data() + name.size(), number);
  }
  if (number <= kFirstSettable || number > kLastSettable) {
    return std::nullopt;
  }
  return FoundCode{kByName.at("G505"), static_cast<std::uint16_t>(number - kFirstSettable)};
}

std::optional<FoundCode> find_g_code(double number) {
  static const std::vector<std::optional<FoundCode>> kByNumber = [] {
    std::vector<std::optional<FoundCode>> codes;
    for (int i = 0; i < kNumberCount; ++i) {
      codes.push_back(find_g_code("G" + std::to_string(i)));
    }
    return codes;
  }();
  return number < kNumberCount ? kByNumber[static_cast<std::size_t>(number)] : std::nullopt;
}

std::optional<FoundCode> find_g_code(double group, double number) {
  for (std::size_t i = 0; i < kGCodeRows.size(); ++i) {
    const GCode& row = kGCodeRows[i];
    const double beyond = number - row.number;
    const double most = row.name == "G505" ? kLastSettable - kFirstSettable : 0.0;
    if (static_cast<double>(row.group) == group && beyond >= 0.0 && beyond <= most) {
      return FoundCode{static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(beyond)};
    }
  }
  return std::nullopt;
}

std::string name_of(FoundCode code) {
  return code.beyond == 0 ? std::string(g_codes()[code.row].name)
                          : "G" + std::to_string(kFirstSettable + code.beyond);
}

int preset_number(Group group) {
  constexpr int kFirst = 1;
  return group == Group::Unit       ? number_in_group("G71")
         : group == Group::FeedType ? number_in_group("G94")
                                    : kFirst;
}

}  // namespace g31::sinumerik
