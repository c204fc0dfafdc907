// Texts that a control keeps in one byte each, on their way from a file and back to people.

#include "interpreter/source/latin_1.h"

#include <string>

#include <gtest/gtest.h>

namespace g31::latin_1_test {
namespace {

using source::as_utf8;
using source::one_byte_each;
using source::text_as_utf8;

TEST(Latin1, ComesBackFromOneByteEach) {
  for (const char* const text : {"", "BORE", "Bohrung Ø20 größer ±0.1", "\u0080ÿ"}) {
    EXPECT_EQ(as_utf8(one_byte_each(text)), text);
    EXPECT_EQ(text_as_utf8(one_byte_each(text)), text);
  }
  EXPECT_EQ(one_byte_each("Ø ÿ"), "\xD8 \xFF");
}

TEST(Latin1, LeavesEveryByteOfWhatIsNoText) {
  std::string bytes;
  for (int byte = 0; byte < 256; ++byte) {
    bytes.push_back(static_cast<char>(byte));
  }
  for (const std::string& some : {bytes, std::string("\xC4\x8D\xE6\x97\xA5")}) {
    EXPECT_EQ(one_byte_each(as_utf8(some)), some);
  }
}

TEST(Latin1, ShowsTheCharactersOfATextThatItHasNot) {
  for (const char* const text :
       {"日本語 – Ø größe", "Średnica otworu źle", "Průměr díry je špatný", "Диаметр отверстия Ø20",
        "Διάμετρος", "İş parçası", "\U0001F527", "ä日ö本ü"}) {
    EXPECT_EQ(text_as_utf8(one_byte_each(text)), text);
  }
}

TEST(Latin1, TakesASignBehindADiameterForWhatItIs) {
  for (const char* const text : {"Ø±0.1", "Ø²", "Spaß«", "×½", "ä²"}) {
    EXPECT_EQ(text_as_utf8(one_byte_each(text)), text);
  }
  EXPECT_EQ(text_as_utf8("\xE6\x97"), "æ\xC2\x97") << "half a character";
  EXPECT_EQ(text_as_utf8("\xED\xA0\x80"), "í\xC2\xA0\xC2\x80") << "half a surrogate pair";
}

}  // namespace
}  // namespace g31::latin_1_test
