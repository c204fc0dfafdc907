#pragma once

#include <cstdint>
#include <optional>

#include "interpreter/dialects/fanuc/state/control.h"
#include "interpreter/dialects/fanuc/vocabulary/system_variables.h"

// How the rows of system_variables.def are read and written, one function for each kind; files by
// subject.  Access rights are checked before: these functions serve programs and set-up sheets
// alike.

namespace g31::fanuc::system {

/// One number of a row.
struct Place {
  const SystemVariable& row;
  std::int32_t number;
  [[nodiscard]] int index() const { return number - row.first; }  ///< from 0
};

using ReadResult = Result<Cell, AlarmId>;
using WriteResult = std::optional<AlarmId>;  ///< why not; nullopt: written

// ports.cc
ReadResult read_further_input(Control& control, const Place& place);
ReadResult read_input_bit(Control& control, const Place& place);
WriteResult write_input_bit(Control& control, const Place& place, Cell value);
/// Input and output bits as one number, and the words beside them.
ReadResult read_word(Control& control, const Place& place);
WriteResult write_input_bits(Control& control, const Place& place, Cell value);
WriteResult write_input_word(Control& control, const Place& place, Cell value);
ReadResult read_output_bit(Control& control, const Place& place);
WriteResult write_output_bit(Control& control, const Place& place, Cell value);
WriteResult write_output_bits(Control& control, const Place& place, Cell value);
WriteResult write_output_word(Control& control, const Place& place, Cell value);

// offsets.cc
ReadResult read_tool_entry(Control& control, const Place& place);
WriteResult write_tool_entry(Control& control, const Place& place, Cell value);
ReadResult read_work_offset(Control& control, const Place& place);
WriteResult write_work_offset(Control& control, const Place& place, Cell value);
ReadResult read_local_shift(Control& control, const Place& place);
WriteResult write_local_shift(Control& control, const Place& place, Cell value);

/// #26000 and on: a cell of ten for each number of G54.4.
ReadResult read_setting_error(Control& control, const Place& place);
WriteResult write_setting_error(Control& control, const Place& place, Cell value);

// state.cc
ReadResult read_timer(Control& control, const Place& place);
WriteResult write_timer(Control& control, const Place& place, Cell value);
ReadResult read_hours(Control& control, const Place& place);
WriteResult write_hours(Control& control, const Place& place, Cell value);
ReadResult read_single_block(Control& control, const Place& place);
WriteResult write_single_block(Control& control, const Place& place, Cell value);
ReadResult read_override(Control& control, const Place& place);
WriteResult write_override(Control& control, const Place& place, Cell value);
ReadResult read_settings(Control& control, const Place& place);
WriteResult write_settings(Control& control, const Place& place, Cell value);
ReadResult read_unit(Control& control, const Place& place);
WriteResult write_unit(Control& control, const Place& place, Cell value);
ReadResult read_mirror(Control& control, const Place& place);
WriteResult write_mirror(Control& control, const Place& place, Cell value);
ReadResult read_restart(Control& control, const Place& place);
WriteResult write_restart(Control& control, const Place& place, Cell value);
ReadResult read_date(Control& control, const Place& place);
WriteResult write_date(Control& control, const Place& place, Cell value);
ReadResult read_time_of_day(Control& control, const Place& place);
WriteResult write_time_of_day(Control& control, const Place& place, Cell value);
ReadResult read_constant(Control& control, const Place& place);
ReadResult read_parts(Control& control, const Place& place);
WriteResult write_parts(Control& control, const Place& place, Cell value);
ReadResult read_further_common(Control& control, const Place& place);
WriteResult write_further_common(Control& control, const Place& place, Cell value);
ReadResult read_alias(Control& control, const Place& place);
WriteResult write_alias(Control& control, const Place& place, Cell value);
ReadResult read_datum(Control& control, const Place& place);
WriteResult write_datum(Control& control, const Place& place, Cell value);
ReadResult read_named_parameter(Control& control, const Place& place);
ReadResult read_datum_alias(Control& control, const Place& place);
WriteResult write_datum_alias(Control& control, const Place& place, Cell value);
ReadResult read_chosen_parameter(Control& control, const Place& place);
ReadResult read_tool_datum(Control& control, const Place& place);
WriteResult write_nothing(Control& control, const Place& place, Cell value);

// modal.cc
ReadResult read_main_program(Control& control, const Place& place);
ReadResult read_modal_group(Control& control, const Place& place);
ReadResult read_modal_word(Control& control, const Place& place);
ReadResult read_last_argument(Control& control, const Place& place);

// positions.cc
ReadResult read_block_end(Control& control, const Place& place);
ReadResult read_machine_position(Control& control, const Place& place);
ReadResult read_work_position(Control& control, const Place& place);
ReadResult read_skip_position(Control& control, const Place& place);
ReadResult read_tool_offset(Control& control, const Place& place);
ReadResult read_nothing_left(Control& control, const Place& place);

}  // namespace g31::fanuc::system
