// Where programs begin in a file, wherever the pieces that are read of it end.
#include <cstddef>
#include <string>

#include <gtest/gtest.h>

#include "interpreter/dialects/fanuc/code/program_windows.h"
#include "tests/support/control_run.h"

namespace g31::program_beginnings_test {
namespace {

constexpr const char* kEnd = "\n o 12 34\nX1. O5 % x\n:7\r\n  \nO0003 (O9:)\n%\n";

/// A file that has so many characters behind its first piece.
std::string file_with(std::size_t behind) {
  const std::string head = "%\nO0001(%O2)\n(";
  const std::size_t size = fanuc::kPieceBytes - std::string(kEnd).size() + behind;
  return head + std::string(size - head.size() - 1, 'O') + ")" + kEnd;
}

TEST(ProgramBeginnings, AreFoundWhereverAPieceEnds) {
  for (std::size_t behind = 0; behind <= std::string(kEnd).size(); ++behind) {
    const std::string text = file_with(behind);
    testing::FilesInMemory files({{"long.nc", text}});
    const auto found = fanuc::program_beginnings(files, "long.nc", text.size());
    ASSERT_EQ(found.size(), 4U) << behind;
    const int numbers[] = {1, 1234, 7, 3};
    const int lines[] = {2, 4, 6, 8};
    const char* const begins[] = {"O0001", " o 12", ":7", "O0003"};
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].key.number, numbers[i]) << behind;
      EXPECT_EQ(found[i].line, lines[i]) << behind;
      EXPECT_EQ(found[i].offset, text.find(begins[i])) << behind;
      // There is one in the comment behind O0001 already.
      EXPECT_EQ(found[i].is_behind_percent_sign, i > 0) << behind;
    }
  }
}

TEST(ProgramBeginnings, APercentSignBeforeAllProgramsEndsNothing) {
  const std::string text = "%\n% (LEADER)\nO0001\nX1.\nO0002\n%\nO0003\n";
  testing::FilesInMemory files({{"short.nc", text}});
  const auto found = fanuc::program_beginnings(files, "short.nc", text.size());
  ASSERT_EQ(found.size(), 3U);
  EXPECT_FALSE(found[0].is_behind_percent_sign);
  EXPECT_FALSE(found[1].is_behind_percent_sign);
  EXPECT_TRUE(found[2].is_behind_percent_sign);
}

}  // namespace
}  // namespace g31::program_beginnings_test
