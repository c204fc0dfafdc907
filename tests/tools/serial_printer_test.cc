// A printer at a serial line, played at the far end of a pseudo-terminal.  The same tests run once
// more with modem lines pretended, so that libserialport opens the line (libserialport/).

#include <bit>
#include <chrono>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/played_printer.h"
#include "tests/support/run_program.h"

namespace g31::serial_printer_test {
namespace {

using namespace std::chrono_literals;
using testing::PlayedPrinter;
using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;
using testing::text_of;

constexpr char kDC1 = '\x11';
constexpr char kDC2 = '\x12';
constexpr char kDC3 = '\x13';
constexpr char kDC4 = '\x14';

/// What a reader of ISO code makes of the bytes: bit 8 is a parity bit and must be right.
std::string decoded_iso(std::string bytes) {
  for (char& c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    EXPECT_EQ(std::popcount(byte) % 2, 0) << "byte " << static_cast<int>(byte);
    c = static_cast<char>(byte & 0x7FU);
  }
  return bytes;
}

std::string line_of(const PlayedPrinter& printer, const char* settings) {
  return printer.device() + "," + settings;
}

/// Runs blocks between O1 and M30 with the printer at the line.
RunOutput run_blocks(PlayedPrinter& printer, const std::string& blocks,
                     const char* settings = "19200,e,7,2", cli::RunOptions options = {}) {
  const TemporaryFolder folder;
  options.programs = {folder.write("main.nc", "%\nO1\n" + blocks + "M30\n%\n")};
  options.printer = line_of(printer, settings);
  printer.start();
  return run_program(options);
}

/// A printout of 40 lines of 25 characters.
std::string long_printout() {
  return "#1=0\nPOPEN\nWHILE[#1LT40]DO1\n#1=#1+1\nDPRNT[ABCDEFGHIJKLMNOPQRSTUVW#1[20]]\n"
         "END1\nPCLOS\n";
}

/// The figure of the program and that of its printout.
using Figure = std::pair<int, int>;

class PrintedFigures : public ::testing::TestWithParam<Figure> {};

TEST_P(PrintedFigures, ComeInIsoCodeWithEvenParity) {
  PlayedPrinter printer;
  const std::string folder = "parts/library/hirose_figures/";
  const std::string figure = folder + fmt::format("figure_{:02}", GetParam().first);
  cli::RunOptions options;
  options.programs = {figure + ".nc"};
  options.setups = {folder + "machine.toml", figure + ".toml"};
  options.printer = line_of(printer, "19200,e,7,2");
  printer.start();
  const RunOutput output = run_program(options);
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  const std::string bytes = decoded_iso(printer.heard());
  const std::string golden =
      text_of(fmt::format("tests/tools/golden/figure_{:02}.txt", GetParam().second));
  const std::string framed = kDC2 + golden + kDC4;
  // Figure 15 prints two distances, each with its POPEN and PCLOS; the paper shows the second.
  ASSERT_GE(bytes.size(), framed.size());
  EXPECT_EQ(bytes.substr(bytes.size() - framed.size()), framed);
  std::string text;
  for (const char c : bytes) {
    if (c != kDC2 && c != kDC4) {
      text += c;
    }
  }
  EXPECT_EQ(output.document.at("output"), text) << "the document holds the text alone";
}

INSTANTIATE_TEST_SUITE_P(Paper, PrintedFigures,
                         ::testing::Values(Figure{6, 7}, Figure{9, 10}, Figure{12, 13},
                                           Figure{15, 16}, Figure{18, 19}),
                         [](const auto& figure) {
                           return fmt::format("figure_{:02}", figure.param.second);
                         });

TEST(SerialPrinter, PrintsAtTheSpeedOfTheLine) {
  PlayedPrinter printer;
  const auto begin = std::chrono::steady_clock::now();
  const RunOutput output =
      run_blocks(printer, "POPEN\nDPRNT[ABCDEFGHIJKLMNOPQRSTUVWXYZ]\nPCLOS\n", "600,e,7,2");
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  // DC2, 26 letters, LF and DC4 of 11 bits.
  EXPECT_GE(took.count(), 29.0 * 11.0 / 600.0);
  EXPECT_EQ(printer.heard().size(), 29U);
}

TEST(SerialPrinter, SendsTheNumbersOfBprntWithoutParity) {
  // 0.40596 and -1638.4 with three decimals, from MB-248.
  const std::string blocks = "#1=.40596\n#2=-1638.4\nPOPEN\nBPRNT[X*#1[3]#2[3]]\nPCLOS\n";
  PlayedPrinter printer;
  EXPECT_EQ(run_blocks(printer, blocks).exit_code, 0);
  EXPECT_EQ(printer.heard(),
            std::string("\x12\xD8\xA0\x00\x00\x01\x96\xFF\xE7\x00\x00\x0A\x14", 13));
}

TEST(SerialPrinter, OnEightBitsTheSettingOfThePunchCodeDecides) {
  const TemporaryFolder folder;
  cli::RunOptions iso;
  iso.setups = {folder.write("iso.toml", "[parameters]\n\"0.1\" = 1\n")};
  PlayedPrinter with_parity;
  EXPECT_EQ(run_blocks(with_parity, "POPEN\nDPRNT[X]\nPCLOS\n", "19200,n,8,1", iso).exit_code, 0);
  EXPECT_EQ(with_parity.heard(), "\x12\xD8\x0A\x14");
  PlayedPrinter plain;
  EXPECT_EQ(run_blocks(plain, "POPEN\nDPRNT[X]\nPCLOS\n", "19200,n,8,1").exit_code, 0);
  EXPECT_EQ(plain.heard(), "\x12X\x0A\x14");
}

TEST(SerialPrinter, IsSelectedAndReleasedByPopenAndPclosAlone) {
  const std::pair<const char*, std::string> kCases[] = {
      {"POPEN\nPOPEN\nPCLOS\nPCLOS\n", {kDC2, kDC4}},
      {"POPEN\nPCLOS\nPOPEN\nPCLOS\n", {kDC2, kDC4, kDC2, kDC4}},
      {"POPEN\nDPRNT[AA]\n",
       {kDC2, 'A', 'A', '\n'}},  // the end of the program sends no DC4 (MB-252)
      {"DPRNT[AA]\n", {'A', 'A', '\n'}},
      {"PCLOS\n", ""},
  };
  for (const auto& [blocks, bytes] : kCases) {
    PlayedPrinter printer;
    const RunOutput output = run_blocks(printer, blocks);
    EXPECT_EQ(output.exit_code, 0) << output.errors;
    EXPECT_EQ(printer.heard(), bytes) << blocks;
  }
}

TEST(SerialPrinter, StopsWithinTenCharactersAtDC3AndGoesOnWithDC1) {
  for (const unsigned parity : {0x80U, 0U}) {
    std::size_t overrun = 0;
    std::size_t in_silence = 0;
    int stops = 0;
    PlayedPrinter printer([&](PlayedPrinter& self, const std::string& received) {
      if (received.size() < 300 || stops > 0) {
        return;
      }
      ++stops;
      self.say(static_cast<char>(static_cast<unsigned>(kDC3) | parity));
      overrun = self.listen_for(100ms);
      in_silence = self.listen_for(300ms);
      self.say(kDC1);
    });
    const RunOutput output = run_blocks(printer, long_printout());
    EXPECT_EQ(output.exit_code, 0) << output.errors;
    const std::string bytes = decoded_iso(printer.heard());
    EXPECT_EQ(stops, 1);
    EXPECT_LE(overrun, 10U);
    EXPECT_EQ(in_silence, 0U);
    EXPECT_EQ(bytes, kDC2 + output.document.at("output").get<std::string>() + kDC4);
    EXPECT_EQ(bytes.size(), 2U + 40U * 27U);
  }
}

void expect_not_ready(const RunOutput& output, const std::string& why) {
  EXPECT_EQ(output.exit_code, 3);
  EXPECT_EQ(output.document.at("status"), "alarm");
  EXPECT_EQ(output.document.at("alarm").at("number"), 86);
  EXPECT_EQ(output.document.at("alarm").at("text"), "DR SIGNAL OFF");
  EXPECT_EQ(output.document.at("alarm").at("file"), "main.nc");
  EXPECT_NE(output.errors.find("main.nc:"), std::string::npos) << output.errors;
  EXPECT_NE(output.errors.find(why), std::string::npos) << output.errors;
  EXPECT_NE(output.errors.find("the printer must be on"), std::string::npos) << output.errors;
}

TEST(SerialPrinter, ThatNeverGoesOnEndsInAnAlarm) {
  PlayedPrinter printer([](PlayedPrinter& self, const std::string& received) {
    if (received.size() < 100) {
      self.say(kDC3);
    }
  });
  cli::RunOptions options;
  options.printer_wait_s = 0.3;
  const auto begin = std::chrono::steady_clock::now();
  expect_not_ready(run_blocks(printer, long_printout(), "19200,e,7,2", options),
                   "the printer sent DC3 (stop) and no DC1 (resume) for 0.3 s");
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 5s);
}

TEST(SerialPrinter, ThatNeverGoesOnLetsTheRunBeInterrupted) {
  runtime::Interruption interruption{false};
  PlayedPrinter printer([&](PlayedPrinter& self, const std::string& received) {
    if (received.size() < 100) {
      self.say(kDC3);
      interruption = true;
    }
  });
  cli::RunOptions options;
  options.budget.interruption = &interruption;
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(run_blocks(printer, long_printout(), "19200,e,7,2", options).exit_code, 130);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 10s) << "not the 30 s of the printer";
}

TEST(SerialPrinter, ThatNeverGoesOnTakesNoMoreTimeThanTheRunMay) {
  PlayedPrinter printer([&](PlayedPrinter& self, const std::string& received) {
    if (received.size() < 100) {
      self.say(kDC3);
    }
  });
  cli::RunOptions options;
  options.budget.wall_seconds = 0.3;
  const auto begin = std::chrono::steady_clock::now();
  const RunOutput output = run_blocks(printer, long_printout(), "19200,e,7,2", options);
  EXPECT_EQ(output.exit_code, 6);
  EXPECT_NE(output.errors.find("the limit of computing time is reached while /dev/"),
            std::string::npos)
      << output.errors;
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 10s) << "not the 30 s of the printer";
}

TEST(SerialPrinter, ALimitBeyondAllClocksIsNone) {
  PlayedPrinter printer;
  cli::RunOptions options;
  options.budget.wall_seconds = 1e300;
  options.printer_wait_s = 1e300;
  EXPECT_EQ(run_blocks(printer, "POPEN\nDPRNT[X]\nPCLOS\n", "19200,e,7,2", options).exit_code, 0);
}

/// 1,000 characters are 17 s on this line.
TEST(SerialPrinter, TakesNoMoreTimeThanTheRunMay) {
  PlayedPrinter printer;
  cli::RunOptions options;
  options.budget.wall_seconds = 0.2;
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(run_blocks(printer, long_printout(), "600,e,7,2", options).exit_code, 6);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 10s);
}

TEST(SerialPrinter, ThatTakesNothingEndsInAnAlarm) {
  PlayedPrinter printer;
  printer.choke();
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("main.nc", "%\nO1\nPOPEN\nM30\n%\n")};
  options.printer = line_of(printer, "19200,e,7,2");
  options.printer_wait_s = 0.2;
  const RunOutput output = run_program(options);  // nobody reads
  expect_not_ready(output, "the line accepted no character for 0.2 s");
  EXPECT_NE(output.errors.find("main.nc:3:1: error: "), std::string::npos) << output.errors;
}

TEST(SerialPrinter, WhoseCableIsPulledOutEndsInAnAlarm) {
  PlayedPrinter printer([](PlayedPrinter& self, const std::string& received) {
    if (received.size() > 200) {
      self.hang_up();
    }
  });
  expect_not_ready(run_blocks(printer, long_printout()), "the line is broken: ");
}

TEST(SerialPrinter, WhoseCableIsPulledOutWhileItIsStoppedEndsInAnAlarm) {
  PlayedPrinter printer([](PlayedPrinter& self, const std::string& received) {
    if (received.size() > 200) {
      self.say(kDC3);
      self.listen_for(100ms);
      self.hang_up();
    }
  });
  expect_not_ready(run_blocks(printer, long_printout()), "the line is broken: ");
}

TEST(SerialPrinter, FindsTheLineAsItWasAfterwards) {
  PlayedPrinter printer;
  const termios before = printer.settings();
  EXPECT_EQ(run_blocks(printer, "POPEN\nPCLOS\n").exit_code, 0);
  const termios after = printer.settings();
  EXPECT_EQ(after.c_lflag, before.c_lflag);
  EXPECT_EQ(after.c_iflag, before.c_iflag);
  EXPECT_EQ(after.c_oflag, before.c_oflag);
  EXPECT_EQ(after.c_cflag, before.c_cflag);
}

}  // namespace
}  // namespace g31::serial_printer_test
