// A power loss leaves the file before or the file after, because of an order: the bytes go to the
// disk before the file gets its name, and the name after that.  This program stands between g31 and
// the system and writes down that order.

#include <cstdio>
#include <string>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "tests/support/temporary_folder.h"
#include "tools/disk/disk.h"
#include "tools/disk/part_file.h"

namespace {

std::vector<std::string> g_calls;

std::string path_of(int descriptor) {
  char path[4096];
  const ssize_t size =
      ::readlink(fmt::format("/proc/self/fd/{}", descriptor).c_str(), path, sizeof path);
  return {path, static_cast<std::size_t>(size > 0 ? size : 0)};
}

}  // namespace

extern "C" int fsync(int descriptor) {
  g_calls.push_back("fsync " + path_of(descriptor));
  return static_cast<int>(::syscall(SYS_fsync, descriptor));
}

extern "C" int rename(const char* from, const char* to) noexcept {
  g_calls.push_back(fmt::format("rename {} {}", from, to));
  return static_cast<int>(::syscall(SYS_renameat, AT_FDCWD, from, AT_FDCWD, to));
}

namespace g31::order_on_disk_test {
namespace {

TEST(OrderOnDisk, BytesThenNameThenFolder) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.write("kept.vars", "#500=1\n");
  const std::string temporary = fmt::format("{}.{}.part", path, ::getpid());
  g_calls.clear();
  EXPECT_EQ(disk::write_whole_file(path, "#500=2\n"), std::nullopt);
  EXPECT_EQ(g_calls, (std::vector<std::string>{"fsync " + temporary,
                                               fmt::format("rename {} {}", temporary, path),
                                               "fsync " + path.substr(0, path.rfind('/'))}));
}

// A new file as well, and one that grew piece by piece.
TEST(OrderOnDisk, OfPieces) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path("trace.csv");
  g_calls.clear();
  const auto file = disk::PartFile::create(path);
  ASSERT_TRUE(file.ok());
  for (int i = 0; i < 1000; ++i) {
    file.value()->write("0.001,1.0,2.0,3.0\n");
  }
  EXPECT_TRUE(g_calls.empty());
  EXPECT_EQ(file.value()->finish(), std::nullopt);
  ASSERT_EQ(g_calls.size(), 3U);
  EXPECT_TRUE(g_calls[0].starts_with("fsync " + path + '.')) << g_calls[0];
  EXPECT_TRUE(g_calls[1].starts_with("rename " + path + '.')) << g_calls[1];
  EXPECT_EQ(g_calls[2], "fsync " + path.substr(0, path.rfind('/')));
}

}  // namespace
}  // namespace g31::order_on_disk_test
