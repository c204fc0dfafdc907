#pragma once

#include <cstdio>
#include <string>

#include "machine/base/result.h"
#include "tools/disk/waiting.h"

namespace g31::disk {

/// A pipe whose reader takes nothing for so long is given up, and sooner after Ctrl-C or --max-time
/// (waiting.h).
inline constexpr double kPipeStallS = 60.0;

/// A stream into a named pipe: whole lines go out at once, up to 4096 bytes together, so that its
/// reader finds no half line where it is given up.  What comes after that fails at once.  (A pager
/// that stops reading on purpose stands behind standard output, which waits for ever.)
///
/// @param descriptor  not blocking (O_NONBLOCK); the stream closes it
/// @returns nullptr: errno says why there is none
std::FILE* pipe_stream(int descriptor, double stall_s = kPipeStallS);

/// How long somebody who reads a named pipe is waited for.
inline constexpr double kPipePatienceS = 3.0;

/// The stream into a named pipe, once somebody reads it.
/// @returns why there is none, in the system's words or in ours
Result<std::FILE*, std::string> open_pipe(const std::string& path);

/// The errno of a pipe that was given up; nothing else that we write to says one of these.
int error_of(GivenUp why);

/// The system's words for errno; of a pipe that was given up, ours.
std::string words_for(int error);

}  // namespace g31::disk
