#include "interpreter/analysis/look_alikes.h"

#include <array>
#include <string_view>

#include <fmt/format.h>

namespace g31::analysis {
namespace {

struct LookAlike {
  std::string_view bytes;
  std::string_view plain;
  std::string_view name;
};

constexpr auto kLookAlikes = std::to_array<LookAlike>({
#define LOOK_ALIKE(bytes, plain, name) {bytes, plain, name},
#include "interpreter/analysis/look_alikes.def"
#undef LOOK_ALIKE
});

}  // namespace

std::optional<Repair> plain_character(const source::SourceFile& file, syntax::ShortSpan fault) {
  const std::string_view there = file.text().substr(fault.begin);
  for (const LookAlike& row : kLookAlikes) {
    if (there.starts_with(row.bytes)) {
      const auto end = fault.begin + static_cast<std::uint32_t>(row.bytes.size());
      const std::string mended = row.plain.empty()
                                     ? fmt::format("remove the {}", row.name)
                                     : fmt::format("write '{}' for the {}", row.plain, row.name);
      return Repair{mended, {fault.begin, end}, std::string(row.plain)};
    }
  }
  return std::nullopt;
}

}  // namespace g31::analysis
