// What the fuzzers do for hours, for a second and always alike: the corpus and counted changes of
// it through the same entries.  A failure stops the process, as it stops a fuzzer; with
// G31_FUZZ_TRACE=1 the number of the last mutation stands above it.  G31_FUZZ_EFFORT=85 tries 85
// times as many changes, G31_FUZZ_SHARE=1/2 the first half of them, for two processes side by side.

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "interpreter/dialects/fanuc/text/output_format.h"
#include "interpreter/dialects/fanuc/vocabulary/functions.h"
#include "interpreter/dialects/fanuc/vocabulary/g_codes.h"
#include "interpreter/dialects/sinumerik/vocabulary/functions.h"
#include "interpreter/dialects/sinumerik/vocabulary/g_codes.h"
#include "interpreter/dialects/sinumerik/vocabulary/words.h"
#include "tests/fuzz/entry.h"
#include "tests/fuzz/fuzz_effort.h"
#include "tests/fuzz/mutation.h"
#include "tests/fuzz/sinumerik_grammar.h"
#include "tests/support/effort.h"
#include "tools/setup/keys.h"
#include "tools/study/study_keys.h"

namespace g31::fuzz::fuzz_test {
namespace {

const std::uint64_t kMutations = testing::of_many(5000U);
const std::uint64_t kFileMutations = testing::of_many(1000U);  // each a file on the disk

std::string content(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  EXPECT_TRUE(in) << path;
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The seeds of a dialect, by name: the order in which folders list files is not the same
/// everywhere.
std::vector<std::string> corpus(const std::string& dialect) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator("tests/fuzz/corpus/" + dialect)) {
    paths.push_back(entry.path());
  }
  std::ranges::sort(paths);
  std::vector<std::string> texts;
  for (const auto& path : paths) {
    texts.push_back(content(path));
  }
  return texts;
}

/// "\x0a" of a dictionary line is one byte.
std::string unescaped(std::string_view quoted) {
  std::string word;
  for (std::size_t i = 0; i < quoted.size(); ++i) {
    if (quoted.substr(i, 2) == "\\x") {
      unsigned byte = 0;
      std::from_chars(quoted.data() + i + 2, quoted.data() + i + 4, byte, 16);
      word.push_back(static_cast<char>(byte));
      i += 3;
    } else {
      word.push_back(quoted[i]);
    }
  }
  return word;
}

std::vector<std::string> dictionary(const std::string& dialect) {
  std::vector<std::string> words;
  std::ifstream in("tests/fuzz/" + dialect + ".dict");
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('"')) {
      words.push_back(unescaped(line.substr(1, line.size() - 2)));
    }
  }
  return words;
}

/// Whether the word stands in the text: G5 is not in G53 or G5.1.
bool contains(std::string_view text, std::string_view word) {
  constexpr std::string_view kNumber = "0123456789.";
  const bool ends_in_digit = kNumber.find(word.back()) != kNumber.npos;
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
    const std::string_view next = text.substr(at + word.size(), 1);
    if (!ends_in_digit || next.empty() || kNumber.find(next) == kNumber.npos) {
      return true;
    }
  }
  return false;
}

template <typename Entry>
void feed(Entry entry, const std::string& dialect, std::uint64_t mutations = kMutations) {
  const std::vector<std::string> texts = corpus(dialect);
  ASSERT_FALSE(texts.empty());
  for (const std::string& text : texts) {
    entry(text);
  }
  const std::vector<std::string> words = dictionary(dialect);
  ASSERT_FALSE(words.empty());
  const bool traced = std::getenv("G31_FUZZ_TRACE") != nullptr;
  const auto effort = fuzz::effort();
  ASSERT_TRUE(effort) << "G31_FUZZ_EFFORT=85, G31_FUZZ_SHARE=1/2";
  const std::uint64_t all = effort->times * mutations;
  for (std::uint64_t number = effort->first; number < all; number += effort->apart) {
    const std::string text = mutation(number, texts, words);
    if (traced) {
      fmt::print(stderr, "mutation {}\n{}\n", number, text);
    }
    entry(text);
  }
}

/// A word that the fuzzers do not know is one that they hardly ever try.
void expect_known(const std::vector<std::string>& words, const std::string& dialect) {
  const std::vector<std::string> known = dictionary(dialect);
  std::string programs;
  for (const std::string& text : corpus(dialect)) {
    programs += text;
  }
  for (const std::string& word : words) {
    EXPECT_TRUE(std::ranges::find(known, word) != known.end())
        << word << " in " << dialect << ".dict";
    EXPECT_TRUE(contains(programs, word)) << word << " in the corpus";
  }
}

TEST(Fuzz, AnyTextIsRead) {
  feed(read_fanuc_text, "fanuc");
}

TEST(Fuzz, AnyTextIsRun) {
  feed(run_fanuc_text, "fanuc");
}

TEST(Fuzz, AnySinumerikTextIsRead) {
  feed(read_sinumerik_text, "sinumerik");
}

TEST(Fuzz, AnySinumerikTextIsRun) {
  feed(run_sinumerik_text, "sinumerik");
}

TEST(Fuzz, AnyProgramOfTheSinumerikGrammarIsReadAndRun) {
  const auto effort = fuzz::effort();
  ASSERT_TRUE(effort);
  const bool traced = std::getenv("G31_FUZZ_TRACE") != nullptr;
  const std::uint64_t all = effort->times * kFileMutations;
  for (std::uint64_t number = effort->first; number < all; number += effort->apart) {
    const std::string text = sinumerik_program(number);
    if (traced) {
      fmt::print(stderr, "program {}\n{}\n", number, text);
    }
    read_sinumerik_text(text);
    run_sinumerik_text(text);
  }
}

TEST(Fuzz, AnySheetIsRead) {
  feed(read_sheet_text, "sheets", kFileMutations);
}

TEST(Fuzz, AnyStudyIsRead) {
  feed(read_study_text, "studies", kFileMutations);
}

TEST(Fuzz, AnyMeshIsRead) {
  feed(read_mesh_bytes, "meshes", kFileMutations);
}

TEST(Fuzz, AnyPrinterLineIsRead) {
  feed(read_printer_line, "printers");
}

TEST(FuzzEffort, IsCountedAndShared) {
  const auto usual = effort_of(nullptr, nullptr);
  ASSERT_TRUE(usual);
  EXPECT_EQ(usual->times, 1U);
  EXPECT_EQ(usual->first, 0U);
  EXPECT_EQ(usual->apart, 1U);
  const auto second = effort_of("85", "2/3");
  ASSERT_TRUE(second);
  EXPECT_EQ(second->times, 85U);
  EXPECT_EQ(second->first, 1U);
  EXPECT_EQ(second->apart, 3U);
  for (const char* const wrong : {"", "0", "x", "2x", "-1", "1.5", "100001"}) {
    EXPECT_FALSE(effort_of(wrong, nullptr)) << wrong;
  }
  for (const char* const wrong : {"", "1", "0/2", "3/2", "1/0", "1/2/3", "a/b"}) {
    EXPECT_FALSE(effort_of(nullptr, wrong)) << wrong;
  }
}

TEST(Fuzz, DictionariesOfSheetsAndStudiesKnowEveryKey) {
  const auto expect_example = [](std::string_view example, const std::string& name) {
    const std::vector<std::string> known = dictionary(name);
    EXPECT_TRUE(std::ranges::find(known, example) != known.end())
        << example << " in " << name << ".dict";
  };
  for (const setup::KeyRow& row : setup::key_rows()) {
    expect_example(row.example, "sheets");
  }
  for (const study::StudyKeyRow& row : study::study_keys()) {
    expect_example(row.example, "studies");
  }
}

TEST(Fuzz, DictionaryAndCorpusKnowEveryWord) {
  std::vector<std::string> words;
  for (const fanuc::FunctionInfo& row : fanuc::functions()) {
    words.push_back(fmt::format("{}[", row.name));
  }
  for (const fanuc::OutputStatementInfo& row : fanuc::output_statements()) {
    words.emplace_back(row.name);
  }
  for (const fanuc::GCode& row : fanuc::g_codes()) {
    words.push_back(fmt::format("G{}", row.number.value()));
  }
  expect_known(words, "fanuc");
}

TEST(Fuzz, SinumerikDictionaryAndCorpusKnowEveryWord) {
  std::vector<std::string> words;
  for (const sinumerik::FunctionInfo& row : sinumerik::functions()) {
    words.push_back(fmt::format("{}(", row.name));
  }
  for (const sinumerik::ProcedureInfo& row : sinumerik::procedures()) {
    words.emplace_back(row.name);
  }
  for (const sinumerik::AxisWordInfo& row : sinumerik::axis_words()) {
    if (row.role != sinumerik::AxisRole::Refused) {
      words.push_back(fmt::format("{}[", row.name));
    }
  }
  for (const sinumerik::GCode& row : sinumerik::g_codes()) {
    if (row.action != sinumerik::GAction::Refused) {
      words.emplace_back(row.name);
    }
  }
  expect_known(words, "sinumerik");
}

}  // namespace
}  // namespace g31::fuzz::fuzz_test
