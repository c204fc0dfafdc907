// Pseudo-terminals have no modem lines, and libserialport opens nothing without.  This program
// gives them some, by standing between libserialport and the kernel, and runs the tests of
// serial_printer_test.cc once more: with a line that libserialport opens and sets.

#include <atomic>
#include <cstdarg>
#include <string>

#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <termios.h>
#include <unistd.h>

#include "tests/support/played_printer.h"
#include "tests/support/run_program.h"

namespace {
std::atomic<int> g_modem_lines = 0;
std::atomic<int> g_times_set = 0;
}  // namespace

extern "C" int ioctl(int fd, unsigned long request, ...) noexcept {
  std::va_list rest;
  va_start(rest, request);
  void* const argument = va_arg(rest, void*);
  va_end(rest);
  if (::isatty(fd) != 0) {
    auto* const lines = static_cast<int*>(argument);
    switch (request) {
      case TIOCMGET:
        *lines = g_modem_lines;
        return 0;
      case TIOCMSET:
        g_modem_lines = *lines;
        ++g_times_set;
        return 0;
      case TIOCMBIS:
        g_modem_lines |= *lines;
        ++g_times_set;
        return 0;
      case TIOCMBIC:
        g_modem_lines &= ~*lines;
        ++g_times_set;
        return 0;
      default:
        break;
    }
  }
  return static_cast<int>(::syscall(SYS_ioctl, fd, request, argument));
}

namespace g31 {
namespace {

using testing::PlayedPrinter;

TEST(Libserialport, SetsRateStopBitsAndNoFlowControlOfTheDriver) {
  termios during = {};
  int lines = 0;
  PlayedPrinter printer([&](PlayedPrinter& self, const std::string&) {
    during = self.settings();
    lines = g_modem_lines;
  });
  g_times_set = 0;
  const testing::TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("main.nc", "%\nO1\nPOPEN\nPCLOS\nM30\n%\n")};
  options.printer = printer.device() + ",4800,e,7,2";
  printer.start();
  EXPECT_EQ(testing::run_program(options).exit_code, 0);
  EXPECT_EQ(printer.heard(), "\x12\x14");
  EXPECT_GT(g_times_set, 0) << "the line was not opened by libserialport";
  EXPECT_EQ(::cfgetospeed(&during), static_cast<speed_t>(B4800));
  EXPECT_NE(during.c_cflag & CSTOPB, 0U) << "two stop bits";
  EXPECT_EQ(during.c_cflag & PARENB, 0U) << "the parity is made by us";
  EXPECT_EQ(during.c_iflag & (IXON | IXOFF), 0U) << "DC1 and DC3 are for us";
  EXPECT_NE(lines & TIOCM_RTS, 0) << "request to send";
  EXPECT_NE(lines & TIOCM_DTR, 0) << "terminal ready";
}

}  // namespace
}  // namespace g31
