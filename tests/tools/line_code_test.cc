// Settings of a printer's line, and what goes over it bit by bit.

#include "tools/printer/line_code.h"

#include <bit>
#include <string>

#include <gtest/gtest.h>

#include "tools/printer/line_spec.h"

namespace g31::printer::line_code_test {
namespace {

using runtime::PrintCode;

TEST(LineSpec, IsReadFromFiveParts) {
  const auto line = parse_line_spec("/dev/ttyS0,4800,e,7,2");
  ASSERT_TRUE(line.ok());
  EXPECT_EQ(line.value().device, "/dev/ttyS0");
  EXPECT_EQ(line.value().baud, 4800);
  EXPECT_EQ(line.value().parity, Parity::Even);
  EXPECT_EQ(line.value().data_bits, 7);
  EXPECT_EQ(line.value().stop_bits, 2);
  const auto other = parse_line_spec("/dev/a,b,19200,N,8,1");
  ASSERT_TRUE(other.ok()) << "the device may have commas: the four last count";
  EXPECT_EQ(other.value().device, "/dev/a,b");
  EXPECT_EQ(other.value().parity, Parity::None);
}

TEST(LineSpec, SaysWhichPartIsWrong) {
  const std::pair<const char*, const char*> kCases[] = {
      {"/dev/ttyS0,", "2 parts instead of 5"},
      {"/dev/ttyS0,4800,e,7", "4 parts instead of 5"},
      {",4800,e,7,2", "the device is missing"},
      {"/dev/ttyS0,4801,e,7,2", "baud rate \"4801\": one of 50, 100, 110"},
      {"/dev/ttyS0,4800.0,e,7,2", "baud rate \"4800.0\""},
      {"/dev/ttyS0,-4800,e,7,2", "baud rate \"-4800\""},
      {"/dev/ttyS0,99999999999,e,7,2", "baud rate \"99999999999\""},
      {"/dev/ttyS0,,e,7,2", "baud rate \"\""},
      {"/dev/ttyS0,4800,even,7,2", "parity \"even\": e (even), o (odd) or n (none)"},
      {"/dev/ttyS0,4800,,7,2", "parity \"\""},
      {"/dev/ttyS0,4800,e,9,2", "data bits \"9\": 7 or 8"},
      {"/dev/ttyS0,4800,e,7,1.5", "stop bits \"1.5\": 1 or 2"},
      {"/dev/ttyS0,4800,e,7,2 ", "stop bits \"2 \": 1 or 2"},
  };
  for (const auto& [text, says] : kCases) {
    const auto line = parse_line_spec(text);
    ASSERT_FALSE(line.ok()) << text;
    EXPECT_NE(line.error().find(says), std::string::npos) << text << ": " << line.error();
  }
}

std::string bytes_on(const char* settings, std::string_view text, PrintCode code) {
  const auto line = parse_line_spec(std::string("/dev/x,4800,") + settings);
  EXPECT_TRUE(line.ok());
  return encoded(text, code, line.value()).value_or("refused");
}

TEST(LineCode, MakesTheParityThatTheLineOrTheControlWants) {
  // X = 1011000, space = 0100000, A = 1000001, LF = 0001010: three, one, two and two ones (MB-250).
  const std::string plain = "X A\n";
  const std::string even = "\xD8\xA0\x41\x0A";
  const std::string odd = "\x58\x20\xC1\x8A";
  struct Case {
    const char* settings;
    PrintCode code;
    std::string becomes;
  };
  const Case kCases[] = {
      {"e,7,2", PrintCode::Ascii, even},  {"e,7,2", PrintCode::Iso, even},
      {"o,7,2", PrintCode::Ascii, odd},   {"o,7,2", PrintCode::Iso, odd},
      {"n,7,2", PrintCode::Ascii, plain}, {"n,7,2", PrintCode::Iso, plain},
      {"n,8,1", PrintCode::Ascii, plain}, {"n,8,1", PrintCode::Iso, even},
      {"e,8,1", PrintCode::Ascii, plain}, {"e,8,1", PrintCode::Iso, even},
  };
  for (const Case& c : kCases) {
    EXPECT_EQ(bytes_on(c.settings, plain, c.code), c.becomes) << c.settings;
  }
}

TEST(LineCode, LeavesBinaryNumbersAsTheyAre) {
  const std::string numbers("\x00\x00\x01\x96\xFF\xE7", 6);
  for (const char* settings : {"e,7,2", "o,7,2", "n,8,1", "e,8,1"}) {
    EXPECT_EQ(bytes_on(settings, numbers, PrintCode::Binary), numbers) << settings;
  }
  EXPECT_EQ(bytes_on("n,7,1", numbers, PrintCode::Binary), "refused");
}

TEST(LineCode, DrivesSevenBitsAndParityAsEightBits) {
  const Frame iso = frame_of({"/dev/x", 4800, Parity::Even, 7, 2});
  EXPECT_EQ(iso.data_bits, 8);
  EXPECT_EQ(iso.parity, Parity::None);
  EXPECT_EQ(iso.stop_bits, 2);
  const Frame ascii = frame_of({"/dev/x", 4800, Parity::None, 7, 1});
  EXPECT_EQ(ascii.data_bits, 7);
  const Frame hardware = frame_of({"/dev/x", 4800, Parity::Odd, 8, 1});
  EXPECT_EQ(hardware.data_bits, 8);
  EXPECT_EQ(hardware.parity, Parity::Odd);
  // Start bit, 8 bits, 2 stop bits: 11 bits at 4800 baud.
  EXPECT_DOUBLE_EQ(character_time_s({"/dev/x", 4800, Parity::Even, 7, 2}), 11.0 / 4800.0);
}

TEST(LineCode, KnowsControlCodesWithAndWithoutParity) {
  const std::pair<char, ControlCode> kCodes[] = {
      {'\x11', ControlCode::DC1}, {'\x91', ControlCode::DC1}, {'\x12', ControlCode::DC2},
      {'\x13', ControlCode::DC3}, {'\x93', ControlCode::DC3}, {'\x14', ControlCode::DC4},
  };
  for (const auto& [byte, code] : kCodes) {
    EXPECT_EQ(control_code(byte), code);
  }
  for (const char other : {'\x10', '\x15', '\x00', 'S', '\xFF'}) {
    EXPECT_FALSE(control_code(other).has_value());
  }
}

}  // namespace
}  // namespace g31::printer::line_code_test
