#include "tools/study/grid.h"

#include "machine/base/contract.h"
#include "machine/base/random.h"

namespace g31::study {
namespace {

/// Streams of the study's seed: the seeds of programs take those below, drawn axes those from here.
constexpr std::uint32_t kFirstDrawStream = 1U << 31U;

/// Uses of a seed stand so far apart.
constexpr std::uint32_t kProgramsOfAUse = 1U << 16U;

}  // namespace

std::size_t point_count(const Study& study) {
  std::size_t count = 1;
  for (const ListedAxis& axis : study.listed) {
    count *= axis.values.size();
  }
  return count;
}

std::size_t run_count(const Study& study) {
  return point_count(study) * study.repeats;
}

std::vector<const ListedValue*> values_at(const Study& study, std::size_t point) {
  G31_EXPECTS(point < point_count(study));
  std::vector<const ListedValue*> values(study.listed.size());
  for (std::size_t i = study.listed.size(); i-- > 0;) {
    const auto& list = study.listed[i].values;
    values[i] = &list[point % list.size()];
    point /= list.size();
  }
  return values;
}

std::uint64_t seed_of(std::uint64_t study_seed, SeedUse use, std::uint64_t event,
                      std::uint32_t program) {
  constexpr std::uint64_t kBelow = std::uint64_t{1} << 53U;
  const std::uint32_t stream = static_cast<std::uint32_t>(use) * kProgramsOfAUse + program;
  const auto bits = philox4x32(
      {static_cast<std::uint32_t>(event), static_cast<std::uint32_t>(event >> 32U), stream, 0U},
      {static_cast<std::uint32_t>(study_seed), static_cast<std::uint32_t>(study_seed >> 32U)});
  return ((static_cast<std::uint64_t>(bits[1]) << 32U) | bits[0]) % kBelow;
}

double drawn_value(const DrawnAxis& axis, std::uint64_t study_seed, std::size_t which,
                   std::uint64_t run) {
  const Stream stream{study_seed, kFirstDrawStream + static_cast<std::uint32_t>(which)};
  if (axis.distribution == Distribution::Normal) {
    return axis.first + axis.second * standard_normal(stream, run);
  }
  return axis.first + (axis.second - axis.first) * uniform(stream, run);
}

}  // namespace g31::study
