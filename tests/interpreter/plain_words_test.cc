// Words that are read in one go where they stand as usual come to the same as letter by letter.
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "interpreter/dialects/fanuc/text/parse.h"
#include "machine/base/random.h"
#include "tests/support/effort.h"

namespace g31::plain_words_test {
namespace {

/// Texts of words, each number as random as a programmer may write it.
class Texts {
 public:
  explicit Texts(std::uint64_t seed) : stream_{seed, 1} {}

  std::string next() {
    std::string text;
    for (std::size_t block = 0; block < 1 + below(4); ++block) {
      text += pick({"", "N10 ", "N", "/", "/2 N3", "n7", "N123456789 "});
      for (std::size_t word = 0; word < below(7); ++word) {
        text += pick({"X", "Y", "Z", "G", "F", "M", "x", "I", ",C", "S", "A", "N", "O"});
        text += pick({"", "", "", "-", "-", "+", "- ", " "});
        text += number();
        text += pick({"", " ", "  ", " ", "\t", "(c)", "\r", " \r"});
      }
      text += pick({"\n", "\n", "\r\n", ";", " ;\n", "%\n"});
    }
    return text;
  }

 private:
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(uniform(stream_, event_++) * static_cast<double>(count));
  }
  template <std::size_t count>
  std::string pick(const char* const (&choices)[count]) {
    return choices[below(count)];
  }
  std::string digits(std::size_t most) {
    std::string text;
    for (std::size_t i = below(most); i > 0; --i) {
      text += static_cast<char>('0' + below(10));
    }
    return text;
  }
  /// Mostly nothing.
  std::string rarely(const std::string& text) { return below(20) == 0 ? text : ""; }
  std::string number() {
    std::string text = below(30) == 0 ? "" : "7";
    text += digits(below(9) == 0 ? 20 : 6);
    text += rarely(" ");
    text += pick({"", ".", "."});
    text += rarely(".");
    text += rarely(" ");
    text += digits(6);
    text += rarely(" 5");
    text += rarely("#1");
    text += rarely("[2]");
    return text;
  }

  Stream stream_;
  std::uint64_t event_ = 0;
};

/// The same with what counts for nothing behind each letter, so that no word stands as usual.
std::string spread(const std::string& text) {
  std::string wide;
  bool is_comment = false;
  for (const char c : text) {
    wide += c;
    is_comment = c == '(' || (is_comment && c != ')');
    const bool is_letter = (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    wide += is_letter && !is_comment ? "\t" : "";
  }
  return wide;
}

/// What counts for something in a piece of a text.
std::string plain(const std::string& text, syntax::ShortSpan span) {
  std::string counts;
  for (const char c : text.substr(span.begin, span.end - span.begin)) {
    const bool is_blank = c == ' ' || c == '\t' || c == '\r';
    counts += is_blank ? "" : std::string(1, c);
  }
  return counts;
}

auto told(const syntax::Block& block) {
  return std::tuple(block.kind, block.sequence, block.number, block.skip_switch, block.first_word,
                    block.word_count);
}

auto told(const syntax::Word& word) {
  return std::tuple(word.letter, word.form, word.digits, word.decimals,
                    std::bit_cast<std::uint64_t>(word.number), word.expr);
}

void expect_alike(const syntax::Tree& tree, const syntax::Tree& wide, const std::string& text) {
  ASSERT_EQ(tree.blocks.size(), wide.blocks.size()) << text;
  for (std::size_t i = 0; i < tree.blocks.size(); ++i) {
    ASSERT_EQ(told(tree.blocks[i]), told(wide.blocks[i])) << text;
  }
  ASSERT_EQ(tree.words.size(), wide.words.size()) << text;
  for (std::size_t i = 0; i < tree.words.size(); ++i) {
    const syntax::Word& a = tree.words[i];
    const syntax::Word& b = wide.words[i];
    ASSERT_EQ(told(a), told(b)) << text;
    // Where a word ends: what counts for something up to there is the same.
    ASSERT_EQ(plain(text, a.span), plain(spread(text), b.span)) << text;
  }
  ASSERT_EQ(tree.errors.size(), wide.errors.size()) << text;
  for (std::size_t i = 0; i < tree.errors.size(); ++i) {
    ASSERT_EQ(tree.errors[i].error, wide.errors[i].error) << text;
    ASSERT_EQ(tree.errors[i].message, wide.errors[i].message) << text;
  }
}

/// What a block says of all its words at once.
void expect_summed_up(const syntax::Tree& tree, const std::string& text) {
  for (const syntax::Block& block : tree.blocks) {
    std::uint32_t letters = 0;
    for (std::size_t i = 0; block.is_plain && i < block.word_count; ++i) {
      const syntax::Word& word = tree.words[block.first_word + i];
      letters |= syntax::letter_bit(word.letter);
      ASSERT_LE(word.digits, block.digits) << text;
    }
    ASSERT_TRUE(!block.is_plain || block.kind == syntax::BlockKind::Bad || block.letters == letters)
        << text;
  }
}

TEST(PlainWords, AreReadAsThoseThatAreWrittenOtherwise) {
  Texts texts(31);
  std::size_t words = 0;
  std::size_t errors = 0;
  const int cases = testing::of_many(40'000);
  for (int i = 0; i < cases; ++i) {
    const std::string text = "O1\n" + texts.next();
    const syntax::Tree tree = fanuc::parse(text);
    ASSERT_NO_FATAL_FAILURE(expect_alike(tree, fanuc::parse(spread(text)), text));
    ASSERT_NO_FATAL_FAILURE(expect_summed_up(tree, text));
    words += tree.words.size();
    errors += tree.errors.size();
  }
  // Both kinds are among them.
  EXPECT_GT(words, static_cast<std::size_t>(cases));
  EXPECT_GT(errors, static_cast<std::size_t>(cases) / 4);
}

}  // namespace
}  // namespace g31::plain_words_test
