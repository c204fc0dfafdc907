#pragma once

#include <exception>
#include <string>
#include <string_view>

#include "interpreter/runtime/outcome.h"
#include "interpreter/source/source_map.h"
#include "tools/cli/exit_code.h"
#include "tools/session/refusal.h"

namespace g31::cli {

/// What ended a command from within: memory that there is not, or a defect of g31.
session::Refusal refusal_of(const std::exception& thrown);

/// The message of what could not be done.
source::Diagnostic message_of(const session::Refusal& wrong);

/// What the document of a command that did not begin tells: a status, and a message for each thing
/// that is wrong.
runtime::Outcome outcome_of(const session::Refusal& wrong);

/// A document of `schema`, `status`, `exit_code` and `diagnostics`, for commands whose result is
/// something else.
/// @param sources  that places of messages are in
std::string document_of(const runtime::Outcome& outcome, ExitCode code, std::string_view schema,
                        const source::SourceMap& sources);

/// Why a document may not take the place of what is there; nullopt: that is nothing, an earlier
/// document, or what is called one.  The value of --json may be a word that was meant otherwise:
/// `run --json part.nc`.
std::optional<session::Refusal> why_not_replaced(std::string_view option, const std::string& path);

/// Writes why in a document of `schema`, `status`, `exit_code` and `diagnostics`, where it takes
/// nobody else's place.  @returns why it could not be written
std::optional<session::Refusal> write_refusal(const session::Refusal& wrong,
                                              const std::string& json, std::string_view schema);

/// Says why on standard error and, where --json wants a document, as write_refusal().
/// Work that was interrupted leaves none.
/// @param json  of the option: "" for none
ExitCode refuse(const session::Refusal& wrong, const std::string& json, std::string_view schema);

}  // namespace g31::cli
