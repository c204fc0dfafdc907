// A named pipe whose reader stops is given up, whole lines in it; one whose reader is slow is not.

#include "tools/disk/pipe_stream.h"

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <string>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/support/temporary_folder.h"
#include "tools/disk/part_file.h"

namespace g31::pipe_stream_test {
namespace {

using testing::TemporaryFolder;

/// Lines of 11 bytes, so that no number of them fills a page or a pipe.
std::string lines(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    text += std::to_string(1'000'000'000 + i) + '\n';
  }
  return text;
}

/// A pipe, open at both ends without waiting.
class PipeStream : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(::mkfifo(path_.c_str(), 0600), 0);
    reader_ = ::open(path_.c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_GE(reader_, 0);
  }
  void TearDown() override { ::close(reader_); }

  [[nodiscard]] int writer() const { return ::open(path_.c_str(), O_WRONLY | O_NONBLOCK); }

  /// What lies in the pipe, up to so many bytes.
  [[nodiscard]] std::string taken(std::size_t most) const {
    std::string bytes(most, '\0');
    const ssize_t count = ::read(reader_, bytes.data(), bytes.size());
    bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return bytes;
  }

  TemporaryFolder folder_;
  std::string path_ = folder_.path("pipe");
  int reader_ = -1;
};

TEST_F(PipeStream, IsGivenUpWithWholeLinesInIt) {
  const auto start = std::chrono::steady_clock::now();
  std::FILE* const file = disk::pipe_stream(writer(), 0.2);
  ASSERT_NE(file, nullptr);
  const std::string text = lines(100'000);
  for (int i = 0; i < 3; ++i) {
    (void)std::fwrite(text.data(), 1, text.size(), file);
  }
  EXPECT_NE(std::ferror(file), 0);
  EXPECT_NE(std::fclose(file), 0);
  EXPECT_EQ(errno, ETIMEDOUT);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  EXPECT_GE(took.count(), 0.2);
  EXPECT_LT(took.count(), 5.0) << "given up once, not at each write";
  const std::string there = taken(text.size());
  EXPECT_GT(there.size(), 4096U);
  EXPECT_EQ(there.size() % 11, 0U) << "half a line";
  EXPECT_EQ(there, text.substr(0, there.size()));
  EXPECT_EQ(disk::words_for(ETIMEDOUT), "whoever reads this pipe has taken nothing for 60 s");
  EXPECT_EQ(disk::words_for(ENOSPC), "No space left on device");
}

TEST_F(PipeStream, WaitsForAReaderThatTakesItsTime) {
  const std::string text = lines(30'000);
  std::string there;
  std::jthread reader([&] {
    while (there.size() < text.size()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(40));
      there += taken(40'000);
    }
  });
  std::FILE* const file = disk::pipe_stream(writer(), 5.0);
  ASSERT_NE(file, nullptr);
  EXPECT_EQ(std::fwrite(text.data(), 1, text.size(), file), text.size());
  EXPECT_EQ(std::fclose(file), 0);
  reader.join();
  EXPECT_TRUE(there == text);
}

TEST_F(PipeStream, TakesLongLinesAndALastOneWithoutEnd) {
  std::FILE* const file = disk::pipe_stream(writer(), 1.0);
  ASSERT_NE(file, nullptr);
  const std::string text = std::string(10'000, 'x') + "\nand the rest";
  EXPECT_EQ(std::fwrite(text.data(), 1, text.size(), file), text.size());
  EXPECT_EQ(std::fclose(file), 0);
  EXPECT_EQ(taken(20'000), text);
}

TEST_F(PipeStream, IsWhatAPartFileWritesInto) {
  const auto file = disk::PartFile::create(path_);
  ASSERT_TRUE(file.ok()) << file.error();
  file.value()->write("line\nhalf");
  file.value()->flush();
  EXPECT_EQ(taken(100), "line\n");
  EXPECT_EQ(file.value()->finish(), std::nullopt);
  EXPECT_EQ(taken(100), "half");
}

/// Not by a signal: what the run has done so far is still told.
TEST_F(PipeStream, WhoseReaderIsGoneFails) {
  std::FILE* const file = disk::pipe_stream(writer(), 5.0);
  ASSERT_NE(file, nullptr);
  ::close(std::exchange(reader_, -1));
  const std::string text = lines(10'000);
  (void)std::fwrite(text.data(), 1, text.size(), file);
  EXPECT_NE(std::ferror(file), 0);
  EXPECT_NE(std::fclose(file), 0);
  EXPECT_EQ(errno, EPIPE);
  EXPECT_EQ(disk::words_for(EPIPE), "nobody reads this pipe any more");
}

}  // namespace
}  // namespace g31::pipe_stream_test
