#pragma once

#include <cstdint>

namespace g31::sinumerik {

/// What a step does.  Types are settled when compiling: an operation on INT is another one than on
/// REAL only where the result differs.
enum class OpCode : std::uint8_t {
  // result = a op b, numbers
  Move,
  Add,
  Subtract,
  Multiply,
  Divide,
  DivideWhole,
  Modulo,
  Negate,
  Not,
  Equal,
  NotEqual,
  Less,
  Greater,
  LessEqual,
  GreaterEqual,
  And,
  Or,
  Xor,
  BitAnd,
  BitOr,
  BitXor,
  BitNot,
  ToBool,
  ToChar,       ///< 0..255 or an alarm
  ToInt,        ///< rounds; 32 bits or an alarm
  CheckInt,     ///< a is whole; 32 bits or an alarm
  CheckLimits,  ///< a lies within LLI and ULI of variable b, or an alarm
  Math,         ///< row `detail` of functions.def of a and b
  Jump,         ///< to step a.place
  JumpIfNot,    ///< to step b.place when number a is 0
  // arrays: `detail` is the dimension, b the variable
  Index,  ///< result = result * size + a, checked
  Load,   ///< result = element a of variable b
  Store,  ///< element a of variable b = result
  // texts and frames
  MoveText,
  Concatenate,
  NumberToText,  ///< a of type `detail`
  TextToNumber,  ///< a as type `detail` (BOOL, CHAR)
  EqualText,
  LessText,
  LoadText,
  StoreText,
  MoveFrame,
  LoadFrame,
  StoreFrame,
  Chain,  ///< frame a : frame b
  EqualFrame,
  LoadComponent,   ///< arguments: axis, component; a frame operand
  StoreComponent,  ///< arguments: value, axis, component, then the frame is stored by its own step
  // with arguments [b.place, b.place + count)
  Function,     ///< row `detail` of functions.def
  ReadSystem,   ///< row `a.place` of system_variables.def
  WriteSystem,  ///< the last argument is the value
  Procedure,    ///< row `detail` of procedures.def
  Fill,         ///< variable a from element `result` on: the arguments in turn
  Repeat,       ///< variable a from element `result` on: argument 0, argument 1 times
  // blocks and levels
  Block,          ///< a block begins; `detail` is 1 + its skip level
  Word,           ///< address `detail`, modification `count`, value a
  TextWord,       ///< the same with text a
  AxisWord,       ///< row `detail` of axis_words.def of axis a, value b, modification `count`
  AxisMeasuring,  ///< axis a, trigger b, mode in the number `result`; `detail` 1: MEAWA
  CheckSpindle,   ///< there is a spindle of number a
  SkipAction,     ///< the next move ends when the signal of probe a is at level b
  Execute,        ///< the NC block nc_blocks[b.place]
  NcBlock,        ///< Block and Execute in one: nothing is to be computed
  Call,           ///< calls[a.place]
  Return,         ///< behind the call; arguments: target, ...
  EndProgram,     ///< M2, M30, and the end of a main program
  EndText,        ///< behind EXECSTRING, or of the command line
  EndWindow,      ///< on to what follows in a long program (ProgramWindows)
  JumpText,       ///< to the label that text a names; `detail` is a Direction
  RepeatPart,     ///< repeats[a.place], b times
  Raise,          ///< errors[a.place]
};

}  // namespace g31::sinumerik
