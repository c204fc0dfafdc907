// Programs of a Fanuc in files whose names say no number.

#include <gtest/gtest.h>

#include "interpreter/dialects/fanuc/code/library.h"
#include "tests/support/files_in_memory.h"

namespace g31::fanuc_library_test {
namespace {

using fanuc::ProgramLibrary;
using fanuc::WrittenHeads;
using testing::FilesInMemory;

TEST(FanucFilesWithoutANumber, AreReadOnceForAllThatTheyDoNotWrite) {
  FilesInMemory files(
      {{"lib/bore.nc", "%\nO1001(BORE)\nM99\n%\n"}, {"lib/web.nc", "O1002\nM99\n"}});
  source::SourceMap sources(files);
  ProgramLibrary library(sources);
  library.add_folder("lib");
  for (int number = 2000; number < 2100; ++number) {
    EXPECT_EQ(library.find({number, {}}), nullptr) << number;
  }
  EXPECT_EQ(files.reads("lib/bore.nc"), 1);
  EXPECT_EQ(files.reads("lib/web.nc"), 1);
  ASSERT_NE(library.find({1002, {}}), nullptr);
  EXPECT_EQ(library.find({1002, {}})->key.number, 1002);
  EXPECT_EQ(files.reads("lib/bore.nc"), 1) << "it does not write O1002";
}

TEST(FanucFilesWithoutANumber, AreNotTakenForWhatTheyOnlyName) {
  FilesInMemory files({{"lib/a.nc", "O1(CALLS O7)\nM98P7\nM99\n"},
                       {"lib/b.nc", "O7\n#100=1\nM99\n"},
                       {"lib/run.json", "{\"program\": \"O8\"}"},
                       {"lib/page.html", "<!DOCTYPE html>\nO9\n"}});
  source::SourceMap sources(files);
  ProgramLibrary library(sources);
  library.add_folder("lib");
  const fanuc::CompiledProgram* const found = library.find({7, {}});
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->file->name(), "lib/b.nc");
  EXPECT_FALSE(library.has_reports()) << "O7 in a comment is no program";
  EXPECT_EQ(library.find({8, {}}), nullptr);
  EXPECT_EQ(library.find({9, {}}), nullptr);
}

TEST(FanucFilesWithoutANumber, AreSheetsAndTablesWhateverTheyAreCalled) {
  FilesInMemory files({{"lib/O11.TOML", "[probe]\n"},
                       {"lib/O11.nc", "#100=1\nM99\n"},
                       {"lib/12.csv", "axis,target\n"}});
  source::SourceMap sources(files);
  ProgramLibrary library(sources);
  library.add_folder("lib");
  const fanuc::CompiledProgram* const found = library.find({11, {}});
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->file->name(), "lib/O11.nc");
  EXPECT_EQ(library.find({12, {}}), nullptr);
}

TEST(WrittenHeads, AreNumbersBehindOAndColonAndNamesInAngles) {
  const WrittenHeads heads("%\n:0012(X)\no 3 4 5\nO99999999\nO100000000\n");
  EXPECT_TRUE(heads.may_have({12, {}}));
  EXPECT_TRUE(heads.may_have({345, {}})) << "spaces count for nothing";
  EXPECT_TRUE(heads.may_have({99'999'999, {}}));
  EXPECT_FALSE(heads.may_have({100'000'000, {}})) << "no number has nine digits";
  EXPECT_FALSE(heads.may_have({3, {}}));
  EXPECT_FALSE(heads.may_have({0, "BORE"}));
  EXPECT_TRUE(WrittenHeads("<BORE>\nM99\n").may_have({0, "BORE"}));
  EXPECT_FALSE(WrittenHeads("{\"a\": \"O5 <BORE>\"}").may_have({0, "BORE"}));
}

}  // namespace
}  // namespace g31::fanuc_library_test
