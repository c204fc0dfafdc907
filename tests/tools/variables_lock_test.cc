// Runs at the same time that keep variables in one file: each finds what the one before it saved.

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/captured.h"
#include "tests/support/run_program.h"
#include "tools/disk/file_lock.h"

namespace g31::variables_lock_test {
namespace {

namespace fs = std::filesystem;
using disk::FileLock;
using disk::LockRefusal;
using testing::TemporaryFolder;
using testing::text_of;

constexpr double kNoPatienceS = 0.05;

cli::RunOptions options_of(const TemporaryFolder& folder, const std::string& program,
                           const std::string& file) {
  cli::RunOptions options;
  options.programs = {folder.write("count.nc", program)};
  options.setups = {
      folder.write(file + ".toml", fmt::format("[control]\nvariables_file = \"{}\"\n", file))};
  return options;
}

/// In a child process, with its output nowhere.
template <typename Work>
pid_t in_child(const Work& work) {
  std::fflush(nullptr);  // or the child writes it, too
  const pid_t child = ::fork();
  if (child == 0) {
    (void)!std::freopen("/dev/null", "wb", stdout);
    (void)!std::freopen("/dev/null", "wb", stderr);
    ::_exit(work());
  }
  return child;
}

int exit_code_of(pid_t child) {
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(VariablesLock, LosesNoCountOfManyProcesses) {
  constexpr int kProcesses = 4;
  constexpr int kRuns = 8;
  const TemporaryFolder folder;
  const auto options = options_of(folder, "O1\n#500=#500+1\nM30\n", "kept.vars");
  // The same file by another name.
  fs::create_symlink("kept.vars", folder.path("link.vars"));
  folder.write("kept.vars", "#500=0\n");
  const auto by_link = options_of(folder, "O1\n#500=#500+1\nM30\n", "link.vars");
  std::vector<pid_t> children;
  for (int i = 0; i < kProcesses; ++i) {
    children.push_back(in_child([&] {
      for (int run = 0; run < kRuns; ++run) {
        if (static_cast<int>(cli::run_command(i % 2 == 0 ? options : by_link)) != 0) {
          return 1;
        }
      }
      return 0;
    }));
  }
  for (const pid_t child : children) {
    EXPECT_EQ(exit_code_of(child), 0);
  }
  EXPECT_EQ(text_of(folder.path("kept.vars")), fmt::format("#500={}\n", kProcesses * kRuns));
  EXPECT_TRUE(fs::is_symlink(folder.path("link.vars")));
  EXPECT_FALSE(fs::exists(folder.path("kept.vars.lock")));
}

TEST(VariablesLock, IsHeldByOneAndGoneWithIt) {
  const TemporaryFolder folder;
  const std::string file = folder.path("kept.vars");
  {
    const auto mine = FileLock::take(file, kNoPatienceS);
    ASSERT_TRUE(mine.ok());
    const auto second = FileLock::take(file, kNoPatienceS);
    ASSERT_FALSE(second.ok());
    EXPECT_EQ(second.error().kind, LockRefusal::Kind::Held);
    EXPECT_EQ(second.error().why, fmt::format("process {}", ::getpid()));
    EXPECT_TRUE(FileLock::take(folder.path("other.vars"), kNoPatienceS).ok());
  }
  EXPECT_TRUE(folder.names().empty());
  EXPECT_TRUE(FileLock::take(file, kNoPatienceS).ok());
}

/// A file of somebody is neither written over nor removed.
TEST(VariablesLock, TakesNoFileThatIsNone) {
  const TemporaryFolder folder;
  const std::string foreign = folder.write("kept.vars.lock", "O1\nM30\n");
  const auto lock = FileLock::take(folder.path("kept.vars"), kNoPatienceS);
  ASSERT_FALSE(lock.ok());
  EXPECT_EQ(lock.error().kind, LockRefusal::Kind::Foreign);
  EXPECT_EQ(text_of(foreign), "O1\nM30\n");
  const auto run = testing::run_program(options_of(folder, "O1\n#500=#500+1\nM30\n", "kept.vars"));
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(text_of(foreign), "O1\nM30\n");
}

/// What a killed run leaves is no lock, and what it kept is whole.
TEST(VariablesLock, IsNotLeftByAKilledRun) {
  const TemporaryFolder folder;
  folder.write("kept.vars", "#500=7\n");
  const auto endless = options_of(folder, "O1\nN1#500=8\nGOTO1\nM30\n", "kept.vars");
  const pid_t child = in_child([&] { return static_cast<int>(cli::run_command(endless)); });
  while (!fs::exists(folder.path("kept.vars.lock")) ||
         text_of(folder.path("kept.vars.lock")).empty()) {
    ::usleep(1000);
  }
  ::kill(child, SIGKILL);
  EXPECT_EQ(exit_code_of(child), -1);
  EXPECT_TRUE(fs::exists(folder.path("kept.vars.lock")));
  EXPECT_EQ(text_of(folder.path("kept.vars")), "#500=7\n");
  const auto next = options_of(folder, "O1\n#500=#500+1\nM30\n", "kept.vars");
  EXPECT_EQ(testing::run_program(next).exit_code, 0);
  EXPECT_EQ(text_of(folder.path("kept.vars")), "#500=8\n");
  EXPECT_FALSE(fs::exists(folder.path("kept.vars.lock")));
}

/// Killed at any moment: the file is the one before or the one after, and the next run goes on.
TEST(VariablesLock, LeavesAWholeFileWhereverItIsKilled) {
  const TemporaryFolder folder;
  const auto options = options_of(folder, "O1\n#500=#500+1\n#501=#500\nM30\n", "kept.vars");
  for (int i = 0; i < 40; ++i) {
    const pid_t child = in_child([&] {
      for (;;) {
        cli::run_command(options);
      }
      return 0;
    });
    ::usleep(static_cast<useconds_t>(1000 + 977 * i % 20'000));
    ::kill(child, SIGKILL);
    exit_code_of(child);
    const std::string text = text_of(folder.path("kept.vars"));
    const std::size_t value = text.find('=') + 1;
    const std::string count = text.substr(value, text.find('\n') - value);
    EXPECT_TRUE(text.empty() || text == fmt::format("#500={0}\n#501={0}\n", count)) << text;
  }
  EXPECT_EQ(testing::run_program(options).exit_code, 0);
  EXPECT_EQ(folder.names().size(), 3U);  // program, sheet, variables: nothing of killed runs
}

/// Found out before the run, whose results would be lost; the file stays what it was.
TEST(VariablesLock, AFolderThatNobodyMayWriteInIsRefused) {
  const TemporaryFolder folder;
  const std::string kept = folder.path("kept");
  fs::create_directory(kept);
  folder.write("kept/file.vars", "#500=7\n");
  fs::permissions(folder.path(""), fs::perms::all);
  fs::permissions(kept, fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read |
                            fs::perms::others_exec);
  const std::string program = folder.write("count.nc", "O1\n#500=#500+1\nM30\n");
  const std::string sheet =
      folder.write("sheet.toml", "[control]\nvariables_file = \"kept/file.vars\"\n");
  const std::string said = folder.write("said", "");
  fs::permissions(said, fs::perms::all);
  cli::RunOptions options;
  options.programs = {program};
  options.setups = {sheet};
  const pid_t child = in_child([&] {
    constexpr uid_t kNobody = 65534;
    if (::geteuid() == 0 && ::seteuid(kNobody) != 0) {
      return 99;
    }
    (void)!std::freopen(said.c_str(), "wb", stderr);
    const int code = static_cast<int>(cli::run_command(options));
    std::fflush(stderr);
    return code;
  });
  EXPECT_EQ(exit_code_of(child), 2);
  EXPECT_NE(text_of(said).find("kept/file.vars: the run could not save its variables here "
                               "(Permission denied): there must be a folder that can be written"),
            std::string::npos)
      << text_of(said);
  EXPECT_EQ(text_of(kept + "/file.vars"), "#500=7\n");
  fs::permissions(kept, fs::perms::owner_all);
}

TEST(VariablesFile, InAFolderThatIsNotThereEndsTheRunBeforeItBegins) {
  const TemporaryFolder folder;
  for (const std::string place : {"none/file.vars", "sheet.toml/file.vars"}) {
    const testing::CommandOutput output = testing::g31(
        {"run", folder.write("count.nc", "O1\nPOPEN\nDPRNT[RAN]\nM30\n"), "-s",
         folder.write("sheet.toml", "[control]\nvariables_file = \"" + place + "\"\n")});
    EXPECT_EQ(output.exit_code, 2);
    EXPECT_EQ(output.out, "") << "the program has run";
    EXPECT_NE(output.errors.find(place + ": the run could not save its variables here"),
              std::string::npos)
        << output.errors;
  }
}

TEST(VariablesLock, IsNotNeededWhereNothingIsReplaced) {
  const auto first = FileLock::take("/dev/null", kNoPatienceS);
  const auto second = FileLock::take("/dev/null", kNoPatienceS);
  EXPECT_TRUE(first.ok() && second.ok());
  EXPECT_FALSE(fs::exists("/dev/null.lock"));
  const auto nowhere = FileLock::take("/proc/kept.vars", kNoPatienceS);
  EXPECT_TRUE(nowhere.ok());
}

}  // namespace
}  // namespace g31::variables_lock_test
