#include "machine/base/utf_8.h"

#include <string>

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

}  // namespace
}  // namespace g31::utf_8_test
