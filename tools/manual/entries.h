#pragma once

#include <string>
#include <string_view>

#include "interpreter/runtime/reference.h"
#include "tools/setup/keys.h"

namespace g31::manual {

// One function a vocabulary: what its tables say about a topic; none of them: no entry.  The second
// of a pair gives all of it in the order of the tables.

/// "[probe]", "probe.length", "length", "machine.axes.X.travel", "work_offsets.G54"
runtime::Entries sheet_entries(std::string_view topic);
runtime::Entries all_sheet_entries();

/// "ring", "bore", "ring.bore"
runtime::Entries shape_entries(std::string_view topic);
runtime::Entries all_shape_entries();

/// "[study]", "study.repeats", "repeats"
runtime::Entries study_entries(std::string_view topic);
runtime::Entries all_study_entries();

/// "S_TSA", or as screens of the control have it "TSA": what it means in which measuring cycles.
runtime::Entries parameter_entries(std::string_view topic);
runtime::Entries all_parameter_entries();

/// "PRB301", "SET103", "NC005", "DAT101"
runtime::Entries code_entries(std::string_view topic);
runtime::Entries all_code_entries();

/// What a key of a sheet takes: "a number greater than 0".
std::string value_words(const setup::KeyRow& row);

/// A text of a table with its {} as three points.
std::string readable(std::string_view text);

}  // namespace g31::manual
