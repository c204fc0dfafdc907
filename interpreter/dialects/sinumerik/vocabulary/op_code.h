#pragma once

#include <cstdint>

namespace g31::sinumerik {

/// What a step does: rows of op_codes.def.  Types are settled when compiling: an operation on INT
/// is another one than on REAL only where the result differs.
enum class OpCode : std::uint8_t {
#define STEP(name) name,
#include "interpreter/dialects/sinumerik/vocabulary/op_codes.def"
};

/// Each kind by itself: a switch over one of them is over all of its steps.
enum class NumberStep : std::uint8_t {
#define NUMBER_STEP(name) name = static_cast<std::uint8_t>(OpCode::name),
#define RARE_NUMBER_STEP(name) name = static_cast<std::uint8_t>(OpCode::name),
#include "interpreter/dialects/sinumerik/vocabulary/op_codes.def"
};

enum class RareNumberStep : std::uint8_t {
#define RARE_NUMBER_STEP(name) name = static_cast<std::uint8_t>(OpCode::name),
#include "interpreter/dialects/sinumerik/vocabulary/op_codes.def"
};

enum class ArrayStep : std::uint8_t {
#define ARRAY_STEP(name) name = static_cast<std::uint8_t>(OpCode::name),
#include "interpreter/dialects/sinumerik/vocabulary/op_codes.def"
};

enum class TextStep : std::uint8_t {
#define TEXT_STEP(name) name = static_cast<std::uint8_t>(OpCode::name),
#include "interpreter/dialects/sinumerik/vocabulary/op_codes.def"
};

enum class FrameStep : std::uint8_t {
#define FRAME_STEP(name) name = static_cast<std::uint8_t>(OpCode::name),
#include "interpreter/dialects/sinumerik/vocabulary/op_codes.def"
};

/// Whether a step takes numbers and leaves one, and nothing else.
constexpr bool is_number_step(OpCode code) {
  switch (code) {
#define NUMBER_STEP(name) case OpCode::name:
#define RARE_NUMBER_STEP(name) case OpCode::name:
#include "interpreter/dialects/sinumerik/vocabulary/op_codes.def"
    return true;
#define JUMP_STEP(name) case OpCode::name:
#define ARRAY_STEP(name) case OpCode::name:
#define TEXT_STEP(name) case OpCode::name:
#define FRAME_STEP(name) case OpCode::name:
#define RUNNER_STEP(name, handler, reach) case OpCode::name:
#include "interpreter/dialects/sinumerik/vocabulary/op_codes.def"
    return false;
  }
  return false;
}

/// Which blocks of its program a step needs.
enum class StepReach : std::uint8_t {
  Own,    ///< none but its own
  Other,  ///< it jumps, calls or repeats
  Row,    ///< what its row of procedures.def says
};

constexpr StepReach reach_of(OpCode code) {
  switch (code) {
#define STEP(name) case OpCode::name:
#define JUMP_STEP(name)
#define RUNNER_STEP(name, handler, reach)
#include "interpreter/dialects/sinumerik/vocabulary/op_codes.def"
    return StepReach::Own;
#define STEP(name)
#define JUMP_STEP(name) case OpCode::name:
#include "interpreter/dialects/sinumerik/vocabulary/op_codes.def"
    return StepReach::Other;
#define RUNNER_STEP(name, handler, reach) \
  case OpCode::name:                      \
    return StepReach::reach;
#include "interpreter/dialects/sinumerik/vocabulary/op_codes.def"
  }
  return StepReach::Other;
}

}  // namespace g31::sinumerik
