// Texts from a tape: parity bits and block ends (MB-008, MB-009).

#include "interpreter/dialects/fanuc/text/tape_code.h"

#include <bit>
#include <string>

#include <gtest/gtest.h>

namespace g31::fanuc::tape_code_test {
namespace {

/// Bit 8 of each character makes the number of its bits even.
std::string with_parity(std::string text) {
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    c = static_cast<char>(std::popcount(byte) % 2 != 0 ? byte | 0x80U : byte);
  }
  return text;
}

TEST(TapeCode, TakesAndKeeps) {
  const std::string plain = "%\nO1\n#100=SQRT[16](HI)\nM30\n%\n";
  struct Case {
    const char* name;
    std::string text;
    std::string becomes;
  };
  const Case kCases[] = {
      {"plain text", plain, plain},
      {"even parity", with_parity(plain), plain},
      {"even parity and CR LF", with_parity("O1\r\nM30\r\n"), "O1\r\nM30\r\n"},
      {"a rubbed out character is none", with_parity("O1\x7F\nM30\n"),
       std::string("O1\0\nM30\n", 8)},
      {"CR alone ends a block", "O1\rM30\r", "O1\nM30\n"},
      {"CR before LF is a blank", "O1\r\nM30\r\n", "O1\r\nM30\r\n"},
      {"CR somewhere among LF", "O1\r#1=1\nM30\n", "O1\r#1=1\nM30\n"},
      {"letters beyond ASCII in comments", "O1(\xC3\xBC)\nM30\n", "O1(\xC3\xBC)\nM30\n"},
      {"nothing", "", ""},
  };
  for (const Case& c : kCases) {
    EXPECT_EQ(from_tape_code(c.text), c.becomes) << c.name;
    EXPECT_EQ(is_tape_code(c.text), c.text != c.becomes) << c.name;
  }
}

}  // namespace
}  // namespace g31::fanuc::tape_code_test
