#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/effort.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/setup_sheets.h"
#include "tools/setup/check_sheet.h"
#include "tools/setup/document.h"
#include "tools/setup/fill_job.h"

namespace g31::setup::setup_hostile_test {
namespace {

/// A small generator of our own: the same bytes on every machine.
class Bytes {
 public:
  explicit Bytes(std::uint32_t seed) : state_(seed) {}
  std::uint32_t below(std::uint32_t limit) {
    state_ = state_ * 1664525U + 1013904223U;
    return (state_ >> 8U) % limit;
  }

 private:
  std::uint32_t state_;
};

/// A job and its errors: either will do, as long as every error can be shown.
/// @returns how many errors there are
std::size_t read_hostile(std::string sheet) {
  ErrorList list;
  const auto document = parse_document("sheet.toml", std::move(sheet), 0);
  if (document) {
    static_cast<void>(fill_job(check_sheet(*document.value(), list), list));
    static_cast<void>(check_machine_file(*document.value(), list));
  } else {
    list.add(0, document.error());
  }
  const SetupErrors errors = list.in_file_order();
  for (const SetupError& error : errors) {
    const std::string text = render(error);
    EXPECT_NE(text.find(": error: "), std::string::npos);
    EXPECT_NE(text.find(" [SET1"), std::string::npos);
  }
  return errors.size();
}

TEST(SetupHostile, TruncatedSheetsAreErrorsOrJobs) {
  const std::string whole = kEveryKey;
  for (std::size_t length = 0; length < whole.size();
       length += static_cast<std::size_t>(testing::one_case_of())) {
    static_cast<void>(read_hostile(whole.substr(0, length)));
  }
}

TEST(SetupHostile, MangledSheetsAreErrorsOrJobs) {
  constexpr std::string_view kSpice = "[]{}=.,\"'#\n\r\t\\-+eE0987_ infnan\x80\xff\xc3";
  Bytes random(31);
  for (int round = 0; round < 1500; ++round) {
    std::string sheet = kEveryKey;
    for (std::uint32_t n = random.below(6); n != UINT32_MAX; --n) {
      const auto at = random.below(static_cast<std::uint32_t>(sheet.size()));
      sheet[at] = kSpice[random.below(static_cast<std::uint32_t>(kSpice.size()))];
    }
    static_cast<void>(read_hostile(sheet));
  }
}

TEST(SetupHostile, RandomBytesAreErrorsOrJobs) {
  Bytes random(7);
  for (int round = 0; round < 500; ++round) {
    std::string sheet(random.below(200), '\0');
    for (char& c : sheet) {
      c = static_cast<char>(random.below(256));
    }
    static_cast<void>(read_hostile(sheet));
  }
}

TEST(SetupHostile, Utf16IsToldAsSuch) {
  const testing::TemporaryFolder folder;
  for (const std::string mark : {"\xFF\xFE", "\xFE\xFF"}) {
    const auto document = read_document(folder.write("sheet.toml", mark + "[probe]"), 0);
    ASSERT_FALSE(document.ok());
    EXPECT_EQ(document.error().message,
              "cannot read the file: it is UTF-16 text, two bytes a character; save it as "
              "UTF-8");
  }
}

TEST(SetupHostile, PathsWithTheCharacter0AreRefused) {
  for (const std::string_view table : {"[control]\nvariables_file", "[control]\nfiles",
                                       "[machine]\nfile", "[[part]]\nname = \"p\"\nfile"}) {
    ErrorList list;
    const auto document =
        parse_document("sheet.toml", fmt::format("{} = \"a\\u0000b\"\n", table), 0);
    ASSERT_TRUE(document.ok()) << table;
    static_cast<void>(check_sheet(*document.value(), list));
    const SetupErrors errors = list.in_file_order();
    ASSERT_EQ(errors.size(), 1U) << table;
    EXPECT_NE(render(errors.front()).find("a path without the character 0"), std::string::npos)
        << render(errors.front());
  }
}

TEST(SetupHostile, DeepNestingIsRefused) {
  std::string dotted = "a";
  for (int i = 0; i < 200000; ++i) {
    dotted += ".a";
  }
  std::string tables = "x = ";
  for (int i = 0; i < 200; ++i) {
    tables += "{a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a = ";
  }
  tables += "1" + std::string(200, '}') + "\n";
  for (const std::string& sheet :
       {dotted + " = 1\n", "[" + dotted + "]\n", "x = " + std::string(200000, '['),
        "[[" + dotted + "]]", "\"\"\"\n" + dotted, tables}) {
    EXPECT_GT(read_hostile(sheet), 0U);
  }
}

}  // namespace
}  // namespace g31::setup::setup_hostile_test
