// What a place is shown as, by whoever it was made and whatever became of its file since.

#include "interpreter/source/source_map.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "interpreter/source/diagnostic.h"

namespace g31::source::source_map_test {
namespace {

/// Files that can be changed.
class ChangingFiles final : public FileSystem {
 public:
  std::optional<std::string> read(const std::string& path) override {
    const auto found = texts.find(path);
    return found != texts.end() ? std::optional(found->second) : std::nullopt;
  }
  std::vector<std::string> list(const std::string&) override { return {}; }

  std::map<std::string, std::string> texts;
};

/// Everything that line ends and characters can be: LF, CR LF, CR alone, empty lines, a byte order
/// mark, tabs, UTF-8 of two to four bytes, bytes that are no UTF-8, no line end at the end.
const std::string kText =
    "\xEF\xBB\xBFO1 (M\xC3\xA4rz)\r\n\nG1 X1.\rX2.\r\r\nN3\tG4 X\xFF\xFE\n"
    "(\xE2\x82\xAC \xF0\x9F\x94\xA7)\n\n\n  #1=#2\nM30";

bool continues(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// How many bytes of kText's character that begins so.
std::size_t length_of(char lead) {
  const auto byte = static_cast<unsigned char>(lead);
  return byte < 0xC0 || byte > 0xF4 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
}

/// The same, counted byte by byte; of a character that the place lies in, each byte before it.
ShownPlace counted(const std::string& name, std::string_view text, std::size_t offset) {
  ShownPlace place{name, 1, 1, {}};
  std::size_t begin = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  std::size_t character = begin;
  for (std::size_t i = begin; i < offset; ++i) {
    character = continues(text[i]) ? character : i;
    const bool is_cut = character + length_of(text[character]) > offset;
    place.column += continues(text[i]) && !is_cut ? 0 : 1;
    if (text[i] == '\n') {
      ++place.line;
      place.column = 1;
      begin = i + 1;
    }
  }
  for (std::size_t i = begin; i < text.size() && text[i] != '\n' && text[i] != '\r'; ++i) {
    place.text += text[i];
  }
  return place;
}

void expect_equal(const ShownPlace& shown, const ShownPlace& expected) {
  EXPECT_EQ(shown.file, expected.file);
  EXPECT_EQ(shown.line, expected.line);
  EXPECT_EQ(shown.column, expected.column);
  EXPECT_EQ(shown.text, expected.text);
}

/// Reads a file in windows of so many lines, as programs do.  @returns a place for each of its
/// bytes
std::vector<Location> places_of_windows(SourceMap& sources, const std::string& path,
                                        std::size_t lines) {
  const std::string text = sources.files().read(path).value_or("");
  std::vector<Location> places;
  int first_line = 1;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = begin;
    for (std::size_t i = 0; i < lines && end < text.size(); ++i) {
      end = std::min(text.find('\n', end), text.size() - 1) + 1;
    }
    const SourceFile window =
        sources.window(path, begin, first_line, text.substr(begin, end - begin));
    for (std::size_t i = 0; i < window.text().size(); ++i) {
      places.push_back(window.at({i, i + 1}));
    }
    first_line += static_cast<int>(std::ranges::count(window.text(), '\n'));
    begin = end;
  }
  return places;
}

TEST(SourceMap, ShowsEveryPlaceOfAText) {
  ChangingFiles files;
  SourceMap sources(files);
  const SourceFile& file = sources.whole("a/part.nc", kText);
  for (std::size_t i = 0; i <= kText.size(); ++i) {
    SCOPED_TRACE(i);
    expect_equal(sources.show(file.at({i, i})), counted("a/part.nc", kText, i));
  }
}

TEST(SourceMap, ShowsAPlaceAsAPersonWouldCountIt) {
  ChangingFiles files;
  SourceMap sources(files);
  const auto shown = [&](std::string text, std::string_view where) {
    const SourceFile& file = sources.whole("x", std::move(text));
    const std::size_t begin = file.text().find(where);
    return sources.show(file.at({begin, begin + where.size()}));
  };
  expect_equal(shown("O1\r\nG1 X1\r\n", "X1"), {"x", 2, 4, "G1 X1"});
  expect_equal(shown("O1\rG1 X1\rM30\n", "X1"), {"x", 1, 7, "O1"});
  expect_equal(shown("\xEF\xBB\xBFO1\n", "O1"), {"x", 1, 1, "O1"});
  expect_equal(shown("(\xC3\xA4)X1\n", "X1"), {"x", 1, 4, "(\xC3\xA4)X1"});
  expect_equal(shown("O1\n\n", ""), {"x", 1, 1, "O1"});
}

// A punched tape ends its lines with LF CR CR: the CRs stand before the next block.
TEST(SourceMap, ShowsLinesOfATapeWithoutTheirCarriageReturns) {
  ChangingFiles files;
  SourceMap sources(files);
  const std::string text = "%\n\r\rG0X1.\n\r\rG77\n\r\r";
  const SourceFile& file = sources.whole("punch.nc", text);
  const auto shown = [&](std::size_t offset) {
    return sources.show(file.at({offset, offset + 1}));
  };
  const ShownPlace first = shown(text.find("G0"));
  EXPECT_EQ(first.line, 2);
  EXPECT_EQ(first.column, 1);
  EXPECT_EQ(first.text, "G0X1.");
  const ShownPlace second = shown(text.find("77"));
  EXPECT_EQ(second.line, 3);
  EXPECT_EQ(second.column, 2);
  EXPECT_EQ(second.text, "G77");
  EXPECT_EQ(shown(text.size() - 1).text, "") << "a line of nothing else";
}

TEST(SourceMap, KnowsAFileByItsPathAndText) {
  ChangingFiles files;
  SourceMap sources(files);
  const SourceFile& a = sources.whole("a.nc", "O1\nM30\n");
  const SourceFile& b = sources.whole("b.nc", "O1\nM30\n");
  const SourceFile& changed = sources.whole("a.nc", "O1\n\nM99\n");
  EXPECT_EQ(&a, &sources.whole("a.nc", "O1\nM30\n"));
  EXPECT_EQ(&changed, &sources.whole("a.nc", "O1\n\nM99\n"));
  EXPECT_NE(a.id(), b.id());
  EXPECT_NE(a.id(), changed.id());
  EXPECT_NE(a.id(), FileId::None);
  expect_equal(sources.show(a.at({3, 6})), {"a.nc", 2, 1, "M30"});
  expect_equal(sources.show(changed.at({4, 7})), {"a.nc", 3, 1, "M99"});
}

TEST(SourceMap, ShowsNothingForNoPlace) {
  ChangingFiles files;
  const SourceMap sources(files);
  expect_equal(sources.show({}), {});
  expect_equal(sources.show(SourceFile("loose", "O1").at({0, 2})), {});
}

TEST(SourceMap, ShowsWindowsAsTheWholeFile) {
  for (const std::size_t lines : {1U, 2U, 3U, 100U}) {
    SCOPED_TRACE(lines);
    ChangingFiles files;
    files.texts["long.nc"] = kText;
    SourceMap sources(files);
    const std::vector<Location> places = places_of_windows(sources, "long.nc", lines);
    ASSERT_EQ(places.size(), kText.size());
    for (std::size_t i = 0; i < kText.size(); ++i) {
      SCOPED_TRACE(i);
      EXPECT_EQ(places[i], (Location{places[0].file, 1, i}));
      expect_equal(sources.show(places[i]), counted("long.nc", kText, i));
    }
    const SourceFile& whole = sources.whole("long.nc", kText);
    EXPECT_EQ(whole.id(), places[0].file) << "the same file, whole";
    EXPECT_EQ(places_of_windows(sources, "long.nc", 2)[0].file, whole.id()) << "and back";
  }
}

TEST(SourceMap, ReadsAWindowAgainForItsFirstPlaceOnly) {
  class Counting final : public FileSystem {
   public:
    std::optional<std::string> read(const std::string&) override {
      ++reads;
      return kText;
    }
    std::vector<std::string> list(const std::string&) override { return {}; }
    int reads = 0;
  };
  Counting files;
  SourceMap sources(files);
  const std::vector<Location> places = places_of_windows(sources, "long.nc", 100);
  files.reads = 0;
  for (const Location& where : places) {
    EXPECT_GT(sources.show(where).line, 0);
  }
  EXPECT_EQ(files.reads, 1);
}

TEST(SourceMap, ShowsNoLineOfAFileThatHasChanged) {
  const std::string kBefore = "O1\nG1 X1\nM30\n";
  for (const std::string& now :
       {std::string("O1\nG1 X2\nM30\n"), std::string("O1\nG1 X1\nM3"), std::string("")}) {
    SCOPED_TRACE(now);
    ChangingFiles files;
    files.texts["long.nc"] = kBefore;
    SourceMap sources(files);
    const std::vector<Location> places = places_of_windows(sources, "long.nc", 100);
    if (now.empty()) {
      files.texts.clear();  // the file has vanished
    } else {
      files.texts["long.nc"] = now;
    }
    expect_equal(sources.show(places[6]), {"long.nc", 0, 0, {}});
    const Diagnostic diagnostic{Severity::Warning,    "PRB1", places[6], "look", "do",
                                {{places[3], "here"}}};
    EXPECT_EQ(render_text(diagnostic, sources),
              "long.nc: warning: look [PRB1]\n      = do\nlong.nc: note: here\n");
    files.texts["long.nc"] = kBefore;
    EXPECT_EQ(render_text(diagnostic, sources),
              "long.nc:2:4: warning: look [PRB1]\n"
              "    2 | G1 X1\n"
              "      |    ^\n"
              "      = do\n"
              "long.nc:2:1: note: here\n");
  }
}

TEST(SourceMap, TellsTheWindowsOfAChangedFileApart) {
  ChangingFiles files;
  files.texts["long.nc"] = "O1\nG1 X1\nM30\n";
  SourceMap sources(files);
  const std::vector<Location> before = places_of_windows(sources, "long.nc", 1);
  files.texts["long.nc"] = "O1\nG0 X1 Y1\nM30\n";
  const std::vector<Location> now = places_of_windows(sources, "long.nc", 1);
  EXPECT_EQ(now[0].file, before[0].file) << "its first line is the same";
  EXPECT_NE(now[3].file, before[3].file);
  EXPECT_NE(now[12].file, before[9].file);
  expect_equal(sources.show(before[0]), {"long.nc", 1, 1, "O1"});
  expect_equal(sources.show(before[6]), {"long.nc", 0, 0, {}});
  expect_equal(sources.show(before[10]), {"long.nc", 0, 0, {}});
  expect_equal(sources.show(now[6]), {"long.nc", 2, 4, "G0 X1 Y1"});
  expect_equal(sources.show(now[12]), {"long.nc", 3, 1, "M30"});
  const SourceFile& whole = sources.whole("long.nc", files.texts["long.nc"]);
  EXPECT_NE(whole.id(), before[3].file);
  expect_equal(sources.show(before[6]), {"long.nc", 0, 0, {}});
}

TEST(SourceMap, ShowsATextThatARunMadeAsLongAsItLives) {
  ChangingFiles files;
  SourceMap sources(files);
  auto made = sources.passing("command line", "R1=1\nR2=X");
  const auto again = sources.passing("command line", "R1=1\nR2=X");
  const Location where = made->at({8, 9});
  EXPECT_NE(made->id(), again->id());
  expect_equal(sources.show(where), {"command line", 2, 4, "R2=X"});
  made.reset();
  expect_equal(sources.show(where), {});
  expect_equal(sources.show(again->at({8, 9})), {"command line", 2, 4, "R2=X"});
}

TEST(SourceMap, ServesThreads) {
  constexpr std::size_t kFiles = 40;
  ChangingFiles files;
  files.texts["long.nc"] = kText;
  SourceMap sources(files);
  const auto path = [](std::size_t i) { return "p" + std::to_string(i) + ".nc"; };
  std::vector<std::vector<FileId>> ids(4);
  std::vector<int> wrong(4, 0);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < ids.size(); ++t) {
    threads.emplace_back([&, t] {
      for (std::size_t i = 0; i < kFiles; ++i) {
        const std::size_t which = t % 2 == 0 ? i : kFiles - 1 - i;
        const SourceFile& file = sources.whole(path(which), std::string(which, '\n') + "M30");
        ids[t].push_back(file.id());
        const auto made = sources.passing("made", "\n\nR1=1");
        const std::size_t begin = file.text().size() - 3;
        wrong[t] +=
            sources.show(file.at({begin, begin + 3})).line == static_cast<int>(which) + 1 ? 0 : 1;
        wrong[t] += sources.show(made->at({2, 4})).line == 3 ? 0 : 1;
        const auto places = places_of_windows(sources, "long.nc", 2);
        wrong[t] += sources.show(places.back()).text == "M30" ? 0 : 1;
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_EQ(wrong, std::vector<int>(4, 0));
  EXPECT_EQ(ids[0], ids[2]);
  EXPECT_EQ(ids[1], ids[3]);
  std::ranges::reverse(ids[1]);
  EXPECT_EQ(ids[0], ids[1]);
}

}  // namespace
}  // namespace g31::source::source_map_test
