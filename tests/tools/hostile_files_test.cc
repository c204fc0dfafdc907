// Files, folders and numbers on the command line that are not what they should be.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/support/run_arguments.h"
#include "tests/support/run_program.h"
#include "tools/cli/run_command.h"
#include "tools/disk/disk.h"
#include "tools/disk/part_file.h"

namespace g31::hostile_files_test {
namespace {

namespace fs = std::filesystem;
using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;

TEST(HostileFiles, AreRefusedWithTheirName) {
  TemporaryFolder folder;
  const std::string program = folder.write("case.nc", "O1\nM98P5\nM30\n");
  fs::create_symlink("loop", folder.path("loop"));
  fs::create_directory(folder.path("folder"));
  fs::create_symlink("nothing", folder.path("dangling"));
  struct Case {
    const char* name;
    std::string program;
    std::vector<std::string> libraries;
    int exit_code;
    const char* says;
  };
  const Case kCases[] = {
      {"a folder as program", folder.path("folder"), {}, 2, "cannot read the program"},
      {"a link to itself as program", folder.path("loop"), {}, 2, "cannot read the program"},
      {"a link to nothing as program", folder.path("dangling"), {}, 2, "cannot read the program"},
      {"no such program", folder.path("none.nc"), {}, 2, "cannot read the program"},
      {"a file as library", program, {program}, 2, "case.nc: no such folder"},
      {"a link to itself as library", program, {folder.path("loop")}, 2, "loop: no such folder"},
      {"no such library", program, {folder.path("none")}, 2, "none: no such folder"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    cli::RunOptions options;
    options.programs = {c.program};
    options.libraries = c.libraries;
    const RunOutput output = run_program(options);
    EXPECT_EQ(output.exit_code, c.exit_code);
    EXPECT_NE(output.errors.find(c.says), std::string::npos) << output.errors;
    ASSERT_TRUE(output.document.is_object());
    EXPECT_EQ(output.document.at("status"), "usage");
  }
}

TEST(HostileFiles, LinksInALibraryThatLeadNowhereArePassedOver) {
  TemporaryFolder folder;
  fs::create_directory(folder.path("lib"));
  fs::create_symlink("../lib", folder.path("lib/again"));
  fs::create_symlink("O5.nc", folder.path("lib/O5.nc"));
  fs::create_symlink("nothing", folder.path("lib/O6.nc"));
  cli::RunOptions options;
  options.programs = {folder.write("case.nc", "O1\nM98P5\nM30\n")};
  options.libraries = {folder.path("lib")};
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 3);
  EXPECT_NE(output.errors.find("O0005 is in none of the files"), std::string::npos)
      << output.errors;
}

TEST(HostileFiles, UnreadableProgram) {
  TemporaryFolder folder;
  const std::string program = folder.write("case.nc", "O1\nM30\n");
  fs::permissions(program, fs::perms::none);
  if (::access(program.c_str(), R_OK) == 0) {
    GTEST_SKIP() << "this user may read everything";
  }
  cli::RunOptions options;
  options.programs = {program};
  EXPECT_EQ(run_program(options).exit_code, 2);
}

TEST(WriteWholeFile, SaysWhyItCannotAndLeavesNothing) {
  TemporaryFolder folder;
  fs::create_directory(folder.path("folder"));
  fs::create_symlink("loop", folder.path("loop"));
  fs::create_symlink("nowhere/file", folder.path("astray"));
  for (const auto& [path, why] :
       {std::pair{folder.path("none/result.json"), "No such file or directory"},
        std::pair{folder.path("astray"), "No such file or directory"},
        std::pair{folder.path("folder"), "Is a directory"},
        std::pair{folder.path("loop"), "Too many levels of symbolic links"}}) {
    SCOPED_TRACE(path);
    const auto problem = disk::write_whole_file(path, "text");
    ASSERT_TRUE(problem.has_value());
    EXPECT_EQ(*problem, "cannot write " + path + ": " + why);
    EXPECT_EQ(disk::why_not_begun(path), why);
  }
  EXPECT_EQ(folder.names().size(), 3U);
}

TEST(WriteWholeFile, LeavesLinksAndPipesWhatTheyAre) {
  TemporaryFolder folder;
  const std::string file = folder.write("file", "before");
  fs::create_symlink("file", folder.path("link"));
  EXPECT_EQ(disk::why_not_begun(folder.path("link")), std::nullopt);
  EXPECT_EQ(disk::Disk().read(file), "before") << "to ask changes nothing";
  EXPECT_EQ(folder.names().size(), 2U);
  EXPECT_EQ(disk::write_whole_file(folder.path("link"), "after"), std::nullopt);
  EXPECT_TRUE(fs::is_symlink(folder.path("link")));
  EXPECT_EQ(disk::Disk().read(file), "after");

  fs::create_directory(folder.path("sub"));
  fs::create_symlink("sub/next", folder.path("first"));
  fs::create_symlink("new", folder.path("sub/next"));
  EXPECT_EQ(disk::write_whole_file(folder.path("first"), "made"), std::nullopt);
  EXPECT_TRUE(fs::is_symlink(folder.path("first")));
  EXPECT_TRUE(fs::is_symlink(folder.path("sub/next")));
  EXPECT_EQ(disk::Disk().read(folder.path("sub/new")), "made");

  const std::string pipe = folder.path("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::fstream reader(pipe, std::ios::in | std::ios::out);
  EXPECT_EQ(disk::write_whole_file(pipe, "line\n"), std::nullopt);
  std::string line;
  std::getline(reader, line);
  EXPECT_EQ(line, "line");
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST(WriteWholeFile, WaitsForNobodyForEver) {
  TemporaryFolder folder;
  const std::string pipe = folder.path("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(disk::why_not_begun(pipe), std::nullopt) << "a reader may come";
  EXPECT_EQ(disk::write_whole_file(pipe, "line\n"),
            "cannot write " + pipe + ": nobody has read this pipe for 3 s");
}

TEST(HostileFiles, WithoutEndAreNotReadToTheEnd) {
  EXPECT_EQ(disk::Disk().read("/dev/zero"), std::nullopt);
}

TEST(WriteWholeFile, FollowsNoLinkThatSomebodyPlanted) {
  TemporaryFolder folder;
  const std::string victim = folder.write("victim", "untouched");
  const std::string planted = folder.path("file") + "." + std::to_string(::getpid()) + ".part";
  fs::create_symlink("victim", planted);
  EXPECT_EQ(disk::write_whole_file(folder.path("file"), "text"), std::nullopt);
  EXPECT_EQ(disk::Disk().read(victim), "untouched");
  EXPECT_EQ(disk::Disk().read(folder.path("file")), "text");
  EXPECT_EQ(folder.names().size(), 2U);
}

/// In every container g31 is process 1: the number does not tell whose a temporary file is.
TEST(WriteWholeFile, LeavesWhatAnotherProcessOfOurNumberWrites) {
  TemporaryFolder folder;
  const std::string file = folder.path("file");
  const std::string theirs = folder.write("file." + std::to_string(::getpid()) + ".part", "half");
  const int held = ::open(theirs.c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_EQ(::flock(held, LOCK_EX), 0);
  EXPECT_EQ(disk::write_whole_file(file, "ours"), std::nullopt);
  EXPECT_EQ(disk::Disk().read(file), "ours");
  EXPECT_EQ(disk::Disk().read(theirs), "half");
  ::close(held);
  // That process is gone now.
  EXPECT_EQ(disk::write_whole_file(file, "ours again"), std::nullopt);
  EXPECT_EQ(disk::Disk().read(file), "ours again");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"file"}));
}

TEST(WriteWholeFile, RemovesWhatKilledRunsLeftOfTheSameFile) {
  TemporaryFolder folder;
  // No process has a number beyond 2^22.
  folder.write("file.99999999.part", "half");
  folder.write("other.99999999.part", "half of another one");
  folder.write("file.1.part", "of a process that is there");
  folder.write("file.draft.part", "of a person");
  EXPECT_EQ(disk::write_whole_file(folder.path("file"), "text"), std::nullopt);
  std::vector<std::string> names = folder.names();
  std::ranges::sort(names);
  EXPECT_EQ(names, (std::vector<std::string>{"file", "file.1.part", "file.draft.part",
                                             "other.99999999.part"}));
}

TEST(WriteWholeFile, KeepsTheModeOfAFileThatItReplaces) {
  TemporaryFolder folder;
  const std::string file = folder.write("file", "before");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
  EXPECT_EQ(disk::write_whole_file(file, "after"), std::nullopt);
  EXPECT_EQ(fs::status(file).permissions(),
            fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read);
}

TEST(WriteWholeFile, KeepsTheModeOfADocumentThatANewRunReplaces) {
  TemporaryFolder folder;
  const std::string program = folder.write("case.nc", "G04 P1\nM30\n");
  const auto mode = fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read;
  for (const bool is_refused : {false, true}) {
    cli::RunOptions options;
    options.programs = {is_refused ? folder.path("none.nc") : program};
    options.json = folder.write("run.json", "{\"schema\": \"g31.run/1\"}\n");
    options.report = folder.write("run.html", "");
    for (const std::string& file : {options.json, options.report}) {
      fs::permissions(file, mode);
    }
    cli::run_command(options);
    EXPECT_NE(disk::Disk().read(options.json)->find("status"), std::string::npos);
    for (const std::string& file : {options.json, options.report}) {
      EXPECT_EQ(fs::status(file).permissions(), mode) << file;
    }
    EXPECT_EQ(folder.names().size(), 3U);
  }
}

TEST(WriteWholeFile, AMinusIsStandardOutput) {
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(disk::write_whole_file("-", "text\n"), std::nullopt);
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "text\n");
}

TEST(RunOptions, NumbersThatAreNoneAreRefused) {
  for (const auto& [option, value, says] :
       {std::tuple{"--max-time", "nan", "nan is not a number of seconds above 0"},
        std::tuple{"--max-time", "inf", "inf is not a number of seconds above 0"},
        std::tuple{"--max-time", "0", "0 is not a number of seconds above 0"},
        std::tuple{"--max-time=-1", "", "-1 is not a number of seconds above 0"},
        std::tuple{"--max-time", "1e999", "1e999 is not a number of seconds above 0"},
        std::tuple{"--max-blocks=-1", "",
                   "-1 is not a whole number from 0 to 18446744073709551615"},
        std::tuple{"--max-blocks", "1.5",
                   "1.5 is not a whole number from 0 to 18446744073709551615"},
        std::tuple{"--seed=-1", "", "-1 is not a whole number from 0 to 18446744073709551615"},
        std::tuple{"--seed", "x", "x is not a whole number from 0 to 18446744073709551615"}}) {
    SCOPED_TRACE(says);
    std::vector<std::string> words = {"case.nc", option};
    if (*value != '\0') {
      words.emplace_back(value);
    }
    const auto options = testing::parsed_run_options(words);
    ASSERT_FALSE(options);
    EXPECT_NE(options.error().find(says), std::string::npos) << options.error();
  }
}

}  // namespace
}  // namespace g31::hostile_files_test
