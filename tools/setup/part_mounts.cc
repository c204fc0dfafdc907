#include "tools/setup/part_mounts.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>

#include <fmt/format.h>

#include "tools/setup/table_keys.h"

namespace g31::setup {
namespace {

/// Axes in the order in which sheets name them.
std::string axes_of(const machine::AxisChainSetup& chain) {
  std::string axes;
  std::ranges::copy_if(kAxisLetters, std::back_inserter(axes), [&](char letter) {
    return machine::link_on_axis(chain, letter).has_value();
  });
  return axes;
}

bool is_there(const machine::AxisChainSetup& chain, const std::string& mount) {
  const bool is_axis = mount.size() == 1 && machine::link_on_axis(chain, mount.front());
  return mount == parts::kTableMount || mount == parts::kBedMount || is_axis;
}

void fill_mount(parts::PartSetup& part, const TableKeys& keys, const machine::AxisChainSetup& chain,
                ErrorList& errors) {
  const Entry* const given = keys.find(KeyId::PartMount);
  if (given == nullptr) {
    return;
  }
  const auto& mount = std::get<std::string>(given->value);
  if (!is_there(chain, mount)) {
    errors.add(SetupErrorId::MountUnknown, given->where, {mount, axes_of(chain)},
               "\"table\", \"bed\" or one of these letters");
    return;
  }
  const Entry* const fixture = keys.find(KeyId::PartFixture);
  if (mount != parts::kTableMount && fixture != nullptr && !part.is_fixture) {
    errors.add(SetupErrorId::OutOfRange, fixture->where,
               {"part.fixture", "false", fmt::format("true of what is on \"{}\"", mount)},
               "what is measured goes along with the table");
    return;
  }
  part.mount = mount;
  part.is_fixture = part.is_fixture || mount != parts::kTableMount;
}

}  // namespace

void fill_mounts(Job& job, const Sheet& sheet, ErrorList& errors) {
  const auto tables = list_of(sheet, SectionId::Part);
  for (std::size_t i = 0; i < tables.size() && i < job.parts.size(); ++i) {
    fill_mount(job.parts[i], TableKeys(tables[i]), job.machine.chain, errors);
  }
}

}  // namespace g31::setup
