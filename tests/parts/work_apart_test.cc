// Work in a process of its own comes back whole, or with the reason why not.

#include "parts/import/work_apart.h"

#include <atomic>
#include <csignal>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "parts/import/byte_stream.h"

namespace g31::parts::work_apart_test {
namespace {

TEST(WorkApart, BringsWhatItReturns) {
  // More than a pipe holds at once, and a byte that ends texts.
  std::string bytes(1'000'000, 'x');
  bytes[7] = '\0';
  const WorkApart done = done_apart([&] { return bytes; });
  EXPECT_EQ(done.why_not, "");
  EXPECT_TRUE(done.bytes == bytes);
}

TEST(WorkApart, NamesTheSignalThatItBreaksOffWith) {
  for (const int number : {SIGSEGV, SIGABRT, SIGFPE}) {
    const WorkApart done = done_apart([number]() -> std::string {
      std::raise(number);
      return "not reached";
    });
    EXPECT_NE(done.why_not.find("signal " + std::to_string(number)), std::string::npos)
        << done.why_not;
    EXPECT_EQ(done.bytes, "");
  }
}

/// Ctrl-C reaches every process of a terminal: the one that waits decides what comes of it.
TEST(WorkApart, GoesOnWhenATerminalInterruptsAll) {
  const WorkApart done = done_apart([]() -> std::string {
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
      std::raise(number);
    }
    return "done";
  });
  EXPECT_EQ(done.why_not, "");
  EXPECT_EQ(done.bytes, "done");
}

void take_no_notice(int /*number*/) {}

/// A signal is no byte: whether the work goes on is asked at once, not when it is done.
TEST(WorkApart, AsksWhetherItGoesOnWhenASignalComes) {
  struct sigaction before = {};
  struct sigaction heard = {};
  heard.sa_handler = take_no_notice;
  ASSERT_EQ(::sigaction(SIGUSR1, &heard, &before), 0);
  const pid_t waiting = ::getpid();
  int asked = 0;
  EXPECT_THROW((void)done_apart(
                   [waiting]() -> std::string {
                     ::usleep(150'000);
                     ::kill(waiting, SIGUSR1);
                     ::sleep(20);
                     return "nobody has ended it";
                   },
                   [&asked] { return ++asked < 6; }),
               BrokenOff);
  ::sigaction(SIGUSR1, &before, nullptr);
}

TEST(WorkApart, ThatThrowsBreaksOff) {
  const WorkApart done = done_apart([]() -> std::string { throw std::runtime_error("no"); });
  EXPECT_EQ(done.why_not, "it breaks off at this file");
  const WorkApart large = done_apart([]() -> std::string { throw std::bad_alloc(); });
  EXPECT_EQ(large.why_not, "it takes more memory than there is");
}

TEST(WorkApart, NamesTheExitCodeOfALibraryThatLeaves) {
  const WorkApart done = done_apart([]() -> std::string { ::_exit(1); });
  EXPECT_EQ(done.why_not, "its process ends with exit code 1");
}

/// Threads that take and leave memory all the time.
class BusyThreads {
 public:
  BusyThreads() {
    for (unsigned size = 1; size <= 4; ++size) {
      threads_.emplace_back([this, size] {
        while (!ended_) {
          std::vector<std::string> taken;
          for (unsigned i = 0; i < 100; ++i) {
            taken.emplace_back(size * 40 + i, 'x');
          }
        }
      });
    }
  }
  BusyThreads(const BusyThreads&) = delete;
  BusyThreads& operator=(const BusyThreads&) = delete;
  ~BusyThreads() {
    ended_ = true;
    for (std::thread& thread : threads_) {
      thread.join();
    }
  }

 private:
  std::atomic<bool> ended_ = false;
  std::vector<std::thread> threads_;
};

TEST(WorkApart, IsDoneBesideThreadsThatTakeMemory) {
  const BusyThreads busy;
  for (int i = 0; i < 200; ++i) {
    const WorkApart done = done_apart([] {
      std::string bytes;
      for (std::size_t size = 1; size < 2000; size += 10) {
        bytes += std::string(size, 'y').back();
      }
      return bytes;
    });
    ASSERT_EQ(done.why_not, "") << i;
    ASSERT_EQ(done.bytes, std::string(200, 'y'));
  }
}

TEST(ByteStream, ReadsWhatItWrote) {
  Mesh mesh{{{1.0, -2.5, 3.0}, {0.1, 0.2, 0.3}, {0, 0, 0}}, {{0, 1, 2}}};
  std::optional<double> there = 4.5;
  std::optional<double> none;
  ByteWriter writer;
  pass(writer, mesh);
  pass(writer, there);
  pass(writer, none);
  const std::string bytes = std::move(writer).take();
  Mesh read;
  std::optional<double> first;
  std::optional<double> second;
  ByteReader reader(bytes);
  pass(reader, read);
  pass(reader, first);
  pass(reader, second);
  EXPECT_TRUE(reader.is_whole());
  EXPECT_EQ(reader.left(), 0U);
  EXPECT_EQ(read.vertices, mesh.vertices);
  EXPECT_EQ(read.triangles, mesh.triangles);
  EXPECT_EQ(first, 4.5);
  EXPECT_FALSE(second);
}

TEST(ByteStream, BytesThatEndTooEarlyAreNotWhole) {
  Mesh mesh{{{1.0, -2.5, 3.0}}, {{0, 0, 0}}};
  ByteWriter writer;
  pass(writer, mesh);
  const std::string bytes = std::move(writer).take();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    ByteReader reader(std::string_view(bytes).substr(0, size));
    Mesh read;
    pass(reader, read);
    EXPECT_LE(read.vertices.size(), 32U);
  }
}

}  // namespace
}  // namespace g31::parts::work_apart_test
