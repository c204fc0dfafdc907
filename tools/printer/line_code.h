#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "interpreter/runtime/printer_port.h"
#include "tools/printer/line_spec.h"

namespace g31::printer {

/// Tells the printer that its data come (POPEN) and that they are over (PCLOS); the printer's own
/// two let the control wait and go on.  Of 7 bits, without parity.
enum class ControlCode : char {
  DC1 = 0x11,
  DC2 = 0x12,
  DC3 = 0x13,
  DC4 = 0x14,
};

/// Character frame that the port makes: its start bit, data, parity, stop bits.
struct Frame {
  int data_bits = 8;
  Parity parity = Parity::None;
  int stop_bits = 2;
};

/// The frame for a line.
///
/// A control's port always sends 8 data bits without parity; the ISO code that it sends has its own
/// even parity in bit 8.  On the wire that is the same as 7 data bits and a parity bit.  So a line
/// of 7 bits with parity is driven with 8 bits without, and the parity is made here; only so can
/// the numbers of BPRNT pass, which need all 8 bits.
Frame frame_of(const LineSpec& line);

/// The seconds that one character takes on the line.
double character_time_s(const LineSpec& line);

/// Bytes as they are given to the port: with the parity of a line of 7 bits, on lines of 8 bits
/// with that of the ISO code.  Binary bytes are left as they are.
/// @returns nullopt when the line cannot carry them: binary bytes on 7 bits without parity
std::optional<std::string> encoded(std::string_view bytes, runtime::PrintCode code,
                                   const LineSpec& line);

/// Stands where a byte came with the wrong parity: no name and no number holds it.
inline constexpr char kWrongByte = '?';

/// What `encoded` undone gives: the text that came over a line, without control codes and the NULs
/// of a leader.  On 7 bits the port has left the parity to us; of 8 bits see `printed_text`.
std::string decoded(std::string_view bytes, const LineSpec& line);

/// The same of a printout that was kept as its bytes came.  ISO code, which has even parity in bit
/// 8, is known by bytes beyond 127 where nine bytes of ten have even parity; any other keeps bit 8.
std::string printed_text(std::string_view bytes);

/// Which control code a received byte is, with or without parity; nullopt: another character.
std::optional<ControlCode> control_code(char received);

}  // namespace g31::printer
