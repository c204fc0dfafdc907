// What DPRNT and BPRNT send reaches standard output byte for byte; messages are text.

#include <cstddef>
#include <string>
#include <string_view>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "machine/base/utf_8.h"
#include "tests/support/run_program.h"

namespace g31::output_bytes_test {
namespace {

TEST(OutputBytes, ReachStandardOutputAsTheyAre) {
  const testing::TemporaryFolder folder;
  // The figures of MB-248: 0.40596 and -1638.4 with three decimals.
  const std::string program =
      "%\nO1\n#1=.40596\n#2=-1638.4\nPOPEN\nBPRNT[A*#1[3]#2[3]]\nDPRNT[Z#2[51]]\nPCLOS\nM30\n%\n";
  cli::RunOptions options;
  options.programs = {folder.write("main.nc", program)};
  options.control = "fanuc-16i";
  ::testing::internal::CaptureStdout();
  const auto code = cli::run_command(options);
  const std::string bytes = ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(static_cast<int>(code), 0);
  EXPECT_EQ(bytes, std::string("A \x00\x00\x01\x96\xFF\xE7\x00\x00\nZ- 1638.4\n", 21));
}

TEST(OutputBytes, OfMessagesAreLettersForATerminal) {
  const testing::TemporaryFolder folder;
  cli::RunOptions options;
  // MSG in Latin-1, as old archives have it.
  options.programs = {
      folder.write("main.mpf", "DEF STRING[9] TT=\"\xDF\"\nMSG(\"Gr\xFC\"<<TT<<\"e\")\nM30\n")};
  options.control = "sinumerik-828d";
  options.prints = {"TT"};
  ::testing::internal::CaptureStdout();
  const auto code = cli::run_command(options);
  const std::string text = ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(static_cast<int>(code), 0);
  EXPECT_EQ(text,
            "Gr\xC3\xBC\xC3\x9F"
            "e\nTT = \xC3\x9F\n");
}

// A device gets the bytes of the program's file; documents have the text, whatever wrote it.
TEST(OutputBytes, OfDprntAreTextInDocuments) {
  const testing::TemporaryFolder folder;
  const std::string text = "Gr\xC3\xB6\xC3\x9F";
  cli::RunOptions options;
  options.setups = {folder.write("sheet.toml", "[expect]\noutput = \"" + text + "\\n\"\n")};
  options.control = "fanuc-16i";
  for (const std::string& written : {text, std::string("Gr\xF6\xDF")}) {
    options.programs = {folder.write("main.nc", "O1\nPOPEN\nDPRNT[" + written + "]\nPCLOS\nM30\n")};
    const auto run = testing::run_program(options);
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_EQ(run.document.at("output"), text + "\n");
  }
}

// What a page or a picture shows in place of bytes that are no UTF-8 is what documents have there.
TEST(OutputBytes, ThatAreNoUtf8AreReplacedAlikeInPagesPicturesAndDocuments) {
  const auto in_document = [](const std::string& bytes) {
    using nlohmann::json;
    return json::parse(json(bytes).dump(-1, ' ', false, json::error_handler_t::replace))
        .get<std::string>();
  };
  const std::string kept = "T\xC3\xBC \xE2\x82\xAC \xF0\x9F\x98\x80";
  EXPECT_EQ(as_valid_utf_8(kept), kept);
  EXPECT_EQ(as_valid_utf_8("T\xFC.nc"), "T\xEF\xBF\xBD.nc");
  // Bytes at which something begins, ends or is forbidden in UTF-8.
  constexpr std::string_view kBytes =
      "a\x7F\x80\x8F\x90\x9F\xA0\xBF\xC1\xC2\xDF\xE0\xE1\xED\xEF\xF0\xF1\xF4\xF5\xFF";
  for (std::size_t number = 0; number < 20 * 20 * 20 * 20; ++number) {
    std::string bytes;
    for (std::size_t rest = number, i = 0; i < 4; rest /= kBytes.size(), ++i) {
      bytes += kBytes[rest % kBytes.size()];
    }
    ASSERT_EQ(as_valid_utf_8(bytes), in_document(bytes)) << number;
  }
}

TEST(RunDocument, KeepsTheFirstStopsAndCountsTheOthers) {
  const testing::TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {
      folder.write("main.mpf", "WHILE R1<10003\nR1=R1+1\nG0 X=R1/100 M0\nENDWHILE\nM30\n")};
  const testing::RunOutput many = testing::run_program(options);
  EXPECT_EQ(many.document.at("stops").size(), 10000U);
  EXPECT_EQ(many.document.at("stops_left_out"), 3);
  options.programs = {folder.write("main.mpf", "G0 X1 M0\nM30\n")};
  const testing::RunOutput few = testing::run_program(options);
  EXPECT_EQ(few.document.at("stops").size(), 1U);
  EXPECT_FALSE(few.document.contains("stops_left_out"));
}

}  // namespace
}  // namespace g31::output_bytes_test
