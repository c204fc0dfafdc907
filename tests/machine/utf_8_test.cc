#include "machine/base/utf_8.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

// The same against every beginning of four bytes is in tests/tools/output_bytes_test.cc.

namespace g31::utf_8_test {
namespace {

/// U+FFFD so many times.
std::string replaced(int times) {
  std::string text;
  for (int i = 0; i < times; ++i) {
    text += "\xEF\xBF\xBD";
  }
  return text;
}

// The Unicode Standard 15.0, section 3.9, tables 3-8 to 3-11.
TEST(Utf8, WhatIsNoneIsReplacedAsTheStandardPrintsIt) {
  EXPECT_EQ(as_valid_utf_8("\xC0\xAF\xE0\x80\xBF\xF0\x81\x82\x41"), replaced(8) + "A");
  EXPECT_EQ(as_valid_utf_8("\xED\xA0\x80\xED\xBF\xBF\xED\xAF\x41"), replaced(8) + "A");
  EXPECT_EQ(as_valid_utf_8("\xF4\x91\x92\x93\xFF\x41\x80\xBF\x42"),
            replaced(5) + "A" + replaced(2) + "B");
  EXPECT_EQ(as_valid_utf_8("\xE1\x80\xE2\xF0\x91\x92\xF1\xBF\x41"), replaced(4) + "A");
}

TEST(Utf8, PiecesAreWholeCharactersOrWhatNothingCompletes) {
  for (const std::string character : {"a", "\xC3\xBC", "\xE2\x82\xAC", "\xF0\x9F\x98\x80"}) {
    const Utf8Piece whole = utf_8_piece(character + "a");
    EXPECT_TRUE(whole.is_character);
    EXPECT_EQ(whole.length, character.size());
    EXPECT_EQ(as_valid_utf_8(character), character);
    if (character.size() > 1) {
      const Utf8Piece cut = utf_8_piece(character.substr(0, character.size() - 1));
      EXPECT_FALSE(cut.is_character);
      EXPECT_EQ(cut.length, character.size() - 1);
    }
  }
  EXPECT_EQ(as_valid_utf_8(""), "");
}

TEST(Utf8, CharactersAreCountedAndEachByteOfWhatIsNone) {
  struct Case {
    std::string text;
    std::vector<std::size_t> begins;  // of each character, and the end
  };
  for (const Case& c : {Case{"", {0}}, Case{"ab", {0, 1, 2}}, Case{"a\xC3\xA4z", {0, 1, 3, 4}},
                        Case{"\xE6\x97\xA5\xF0\x9F\x94\xA7", {0, 3, 7}},
                        Case{"\xFF\xE6\x97Z", {0, 1, 2, 3, 4}}, Case{"a\xE6\x97", {0, 1, 2, 3}}}) {
    EXPECT_EQ(character_count(c.text), c.begins.size() - 1) << c.text;
    for (std::size_t i = 0; i < c.begins.size() + 2; ++i) {
      EXPECT_EQ(bytes_of_characters(c.text, i), c.begins[std::min(i, c.begins.size() - 1)])
          << c.text;
    }
  }
}

}  // namespace
}  // namespace g31::utf_8_test
