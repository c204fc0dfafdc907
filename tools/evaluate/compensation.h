#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/evaluate/evaluation.h"

namespace g31::evaluate {

/// Rows of compensation_formats.def.
enum class CompensationFormat : std::uint8_t {
#define COMPENSATION_FORMAT(name, word, text) name,
#include "tools/evaluate/compensation_formats.def"
#undef COMPENSATION_FORMAT
};

/// The format of a word, the first one of ""; nullopt: it is none.
std::optional<CompensationFormat> compensation_format(std::string_view word);
/// Of --compensation-format.
std::vector<std::string> compensation_format_names();

/// Why an error cannot be compensated so; nullopt: it can.
std::optional<std::string> why_no_compensation(CompensationFormat format,
                                               const MachineError& error);

/// What takes an error away, as it is entered.
/// @pre why_no_compensation says nothing
std::string compensation_text(CompensationFormat format, const MachineError& error);

}  // namespace g31::evaluate
