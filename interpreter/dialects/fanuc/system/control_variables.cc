#include "interpreter/dialects/fanuc/system/control_variables.h"

#include <array>
#include <cmath>

#include "interpreter/dialects/fanuc/system/access.h"

namespace g31::fanuc {
namespace {

/// What a system variable takes at most: far beyond any machine, and every sum of them is finite.
constexpr double kLargestValue = 4'294'967'295.0;

/// How one kind of system variable is read and written; nullptr where no row of it lets one.
struct Accessor {
  Shows shows;
  system::ReadResult (*read)(Control&, const system::Place&);
  system::WriteResult (*write)(Control&, const system::Place&, Cell);
};

using namespace system;

constexpr auto kAccessors = std::to_array<Accessor>({
    {Shows::InputBit, read_input_bit, write_input_bit},
    {Shows::InputBits, read_input_bits, write_input_bits},
    {Shows::InputWord, read_input_word, write_input_word},
    {Shows::OutputBit, read_output_bit, write_output_bit},
    {Shows::OutputBits, read_output_bits, write_output_bits},
    {Shows::OutputWord, read_output_word, write_output_word},
    {Shows::LengthGeometry, read_tool_entry, write_tool_entry},
    {Shows::LengthWear, read_tool_entry, write_tool_entry},
    {Shows::RadiusGeometry, read_tool_entry, write_tool_entry},
    {Shows::RadiusWear, read_tool_entry, write_tool_entry},
    {Shows::DiameterGeometry, read_tool_entry, write_tool_entry},
    {Shows::DiameterWear, read_tool_entry, write_tool_entry},
    {Shows::LegacyOffset, read_work_offset, write_work_offset},
    {Shows::MacroAlarm, nullptr, write_nothing},  // the runner stops the program
    {Shows::Timer, read_timer, write_timer},
    {Shows::CycleHours, read_hours, write_hours},
    {Shows::SingleBlock, read_single_block, write_single_block},
    {Shows::Override, read_override, write_override},
    {Shows::Settings, read_settings, write_settings},
    {Shows::MessageStop, nullptr, write_nothing},
    {Shows::MirrorState, read_mirror, write_mirror},
    {Shows::RestartState, read_restart, write_restart},
    {Shows::Date, read_date, write_date},
    {Shows::TimeOfDay, read_time_of_day, write_time_of_day},
    {Shows::Null, read_constant, nullptr},
    {Shows::Pi, read_constant, nullptr},
    {Shows::Euler, read_constant, nullptr},
    {Shows::PartsCount, read_parts, write_parts},
    {Shows::PartsRequired, read_parts, write_parts},
    {Shows::ModalGroup, read_modal_group, nullptr},
    {Shows::ModalWord, read_modal_word, nullptr},
    {Shows::BlockEnd, read_block_end, nullptr},
    {Shows::MachinePosition, read_machine_position, nullptr},
    {Shows::WorkPosition, read_work_position, nullptr},
    {Shows::SkipPosition, read_skip_position, nullptr},
    {Shows::SkipTipPosition, read_skip_tip, nullptr},
    {Shows::ToolOffset, read_tool_offset, nullptr},
    {Shows::ServoDeviation, read_nothing_left, nullptr},
    {Shows::HandleInterrupt, read_nothing_left, nullptr},
    {Shows::DistanceToGo, read_nothing_left, nullptr},
    {Shows::SkipDetected, read_skip_position, nullptr},
    {Shows::WorkOffset, read_work_offset, write_work_offset},
    {Shows::LocalShift, read_local_shift, write_local_shift},
    {Shows::AdditionalOffset, read_work_offset, write_work_offset},
    {Shows::FurtherCommon, read_further_common, write_further_common},
    {Shows::CommonAlias, read_alias, write_alias},
});

consteval bool in_order_of_shows() {
  for (std::size_t i = 0; i < kAccessors.size(); ++i) {
    if (static_cast<std::size_t>(kAccessors[i].shows) != i) {
      return false;
    }
  }
  return kAccessors.size() == static_cast<std::size_t>(Shows::CommonAlias) + 1;
}
static_assert(in_order_of_shows(), "kAccessors: one row for each Shows, in its order");

const Accessor& accessor_of(const SystemVariable& row) {
  return kAccessors[static_cast<std::size_t>(row.shows)];
}

}  // namespace

Result<Cell, AlarmId> ControlVariables::read(std::int32_t number) {
  const SystemVariable* const row = control_->system_variables.find(number);
  if (row == nullptr) {
    return AlarmId::IllegalVariable;
  }
  if (row->access == Access::Write) {
    return AlarmId::ReadProtected;
  }
  if (control_->lookahead.is_ahead()) {
    control_->report_read_ahead(*row, number);
  }
  return accessor_of(*row).read(*control_, {*row, number});
}

std::optional<AlarmId> ControlVariables::write(std::int32_t number, Cell value) {
  const SystemVariable* const row = control_->system_variables.find(number);
  if (row == nullptr) {
    return AlarmId::IllegalVariable;
  }
  if (row->access == Access::Read || row->access == Access::Input) {
    return AlarmId::WriteProtected;
  }
  return store(*row, number, value);
}

std::optional<AlarmId> ControlVariables::preset(std::int32_t number, Cell value) {
  const SystemVariable* const row = control_->system_variables.find(number);
  if (row == nullptr) {
    return AlarmId::IllegalVariable;
  }
  if (row->access == Access::Read || row->access == Access::Write) {
    return AlarmId::WriteProtected;
  }
  return store(*row, number, value);
}

std::optional<AlarmId> ControlVariables::store(const SystemVariable& row, std::int32_t number,
                                               Cell value) {
  if (std::abs(value.or_zero()) > kLargestValue) {
    return AlarmId::IllegalOffsetValue;
  }
  return accessor_of(row).write(*control_, {row, number}, value);
}

}  // namespace g31::fanuc
