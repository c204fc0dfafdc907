// What comments of programs are written in, and as whom people read them.

#include "interpreter/source/readable_text.h"

#include <string>

#include <gtest/gtest.h>

namespace g31::readable_text_test {
namespace {

using source::readable_text;

TEST(ReadableText, ThatIsUtf8Stays) {
  for (const char* const text :
       {"", "O1 (BORE)", "(Bohrung Ø20 größer)", "(測定 径)", "(\U0001F527)", "a\nb\n"}) {
    EXPECT_EQ(readable_text(text), text);
  }
}

TEST(ReadableText, OfShiftJisNeedsALeadByteOrTwoKatakana) {
  EXPECT_EQ(readable_text("(\x91\xAA\x92\xE8 \x8C\x61)"), "(測定 径)");
  EXPECT_EQ(readable_text("(\xCE\xDE\xB1)"), "(ﾎﾞｱ)");
  EXPECT_EQ(readable_text("(\x83\x7B\x83\x41 \xE8\xC0)"), "(ボア 霏)")
      << "E8 C0 alone would be none";
  EXPECT_EQ(readable_text("(\x81\x7E \x87\x40)"), "(× ①)") << "a row of Windows alone";
  EXPECT_EQ(readable_text("\x82\xA0\xB1"), "あｱ") << "the trail byte is no katakana";
}

TEST(ReadableText, ThatIsNeitherIsLatin1) {
  EXPECT_EQ(readable_text("(\xD8 20)"), "(Ø 20)") << "one half-width katakana alone";
  EXPECT_EQ(readable_text("(gr\xF6\xDF"
                          "er)"),
            "(größer)");
  EXPECT_EQ(readable_text("(\xE8\xC0)"), "(èÀ)") << "a lead byte beyond 9F alone";
  EXPECT_EQ(readable_text("(\x91)"), "(\xC2\x91)") << "cut off";
  EXPECT_EQ(readable_text("(\x91\x20)"), "(\xC2\x91 )") << "no trail byte";
  EXPECT_EQ(readable_text("\xE0\x80\x80"), "à\xC2\x80\xC2\x80") << "an overlong form";
  EXPECT_EQ(readable_text("\xED\xA0\x80"), "í\xC2\xA0\xC2\x80") << "half a surrogate pair";
}

TEST(ReadableText, IsJudgedLineByLine) {
  EXPECT_EQ(readable_text("(\xD8 20)\n(\x8C\x61)\n(径)\n\n"), "(Ø 20)\n(径)\n(径)\n\n");
}

TEST(ReadableText, OfAPieceIsReadAsItsLineIs) {
  const std::string line = "#1=2(\x8C\x61 \xE8\xC0)";
  ASSERT_EQ(source::writing_of(line), source::Writing::ShiftJis);
  EXPECT_EQ(source::read_as(source::Writing::ShiftJis, line.substr(8)), "霏)")
      << "alone it would be Latin-1";
  EXPECT_EQ(source::read_as(source::Writing::ShiftJis, line.substr(0, 6)), "#1=2(\uFFFD")
      << "cut in a character";
}

TEST(ReadableText, CountsItsCharactersWhateverTheyAreWrittenIn) {
  // "(測定) #1" and "(ｱｲ) #1" in Shift-JIS and in UTF-8, "(Ø) #1" in Latin-1.
  struct Row {
    std::string line;
    int column;  ///< of the #
  };
  for (const auto& [line, column] : {Row{"(\x91\xAA\x92\xE8) #1", 6}, Row{"(測定) #1", 6},
                                     Row{"(\xB1\xB2) #1", 6}, Row{"(\xD8) #1", 5}, Row{"#1", 1}}) {
    const std::size_t bytes = line.find('#');
    EXPECT_EQ(source::column_in(line, bytes), column) << line;
    EXPECT_EQ(source::bytes_in_front(line, column), bytes) << line;
    EXPECT_EQ(source::column_in(line, 99), column + 2) << line;
    EXPECT_EQ(source::bytes_in_front(line, 99), line.size()) << line;
  }
}

}  // namespace
}  // namespace g31::readable_text_test
