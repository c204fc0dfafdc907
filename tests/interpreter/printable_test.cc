#include "interpreter/source/printable.h"

#include <string>

#include <gtest/gtest.h>

#include "machine/base/utf_8.h"

namespace g31::source::printable_test {
namespace {

using namespace std::string_literals;

TEST(Printable, KeepsTextAndHidesTheRest) {
  struct Case {
    const char* name;
    std::string text;
    const char* shown;
    std::size_t characters;
  };
  const Case kCases[] = {
      {"ASCII", "G01 X1.~", "G01 X1.~", 8},
      {"tab", "G1\tX1", "G1 X1", 5},
      {"controls", "a\x1B[31m\0\x7F\r"s, "a?[31m???", 9},
      {"two bytes", "\u00F6", "\u00F6", 1},
      {"three bytes", "\u6E2C\u5B9A", "\u6E2C\u5B9A", 2},
      {"four bytes", "\U0001F600", "\U0001F600", 1},
      {"Latin-1", "gr\xF6\xDF\x65", "gr??e", 5},
      {"Shift-JIS", "\x83\x5C\x91\xAA", "?\\??", 4},
      {"a character cut at the end", "a\xE6\xB8", "a??", 3},
      {"longer than it need be", "\xC0\xAF\xE0\x80\xAF", "?????", 5},
      {"half of a UTF-16 pair", "\xED\xA0\x80", "???", 3},
      {"beyond Unicode", "\xF4\x90\x80\x80\xFF", "?????", 5},
      {"a control of Latin-1", "\xC2\x9B", "??", 2},
      {"a rest without its beginning", "\x80", "?", 1},
      {"nothing", "", "", 0},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(printable(c.text), c.shown);
    EXPECT_EQ(character_count(c.shown), c.characters);
  }
}

TEST(Printable, WideCharactersHaveTwoCells) {
  EXPECT_EQ(cell_count("G01 X1."), 7);
  EXPECT_EQ(cell_count("gr\u00F6\u00DFer"), 6);
  EXPECT_EQ(cell_count("(\u6E2C\u5B9A)"), 6);
  EXPECT_EQ(cell_count("\uFF8E\uFF9E\uFF71"), 3) << "katakana of half width";
  EXPECT_EQ(cell_count("\uFF27\uFF10\u3000"), 6) << "of full width";
  EXPECT_EQ(cell_count("\U0001F527\U00020000"), 4);
}

TEST(Printable, OneCharacterInWords) {
  EXPECT_EQ(quoted('A'), "'A'");
  EXPECT_EQ(quoted('\''), "'''");
  EXPECT_EQ(quoted('\x1B'), "the byte 0x1B");
  EXPECT_EQ(quoted('\xFB'), "the byte 0xFB");
}

TEST(Printable, KeepsTheEndsOfLines) {
  EXPECT_EQ(printable_lines("a\x1b[31m\nb\r\n"), "a?[31m\nb?\n");
  EXPECT_EQ(printable_lines(""), "");
  EXPECT_EQ(printable_lines("\n\n\x07"), "\n\n?");
}

}  // namespace
}  // namespace g31::source::printable_test
