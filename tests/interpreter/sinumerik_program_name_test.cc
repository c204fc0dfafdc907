// Names of programs and files in all their forms.

#include <utility>

#include <gtest/gtest.h>

#include "interpreter/dialects/sinumerik/code/program_name.h"

namespace g31::sinumerik_program_name_test {
namespace {

TEST(SinumerikProgramName, HasManyForms) {
  struct Case {
    const char* written;
    const char* stem;
    const char* suffix;
  };
  const Case kCases[] = {
      {"part", "PART", ""},
      {"PART.SPF", "PART", "SPF"},
      {"_N_PART_SPF", "PART", "SPF"},
      {"/_N_SPF_DIR/_N_PART_SPF", "PART", "SPF"},
      {"//NC:/SPF.DIR/Part_1.spf", "PART_1", "SPF"},
      {"MPF_1", "MPF_1", ""},
      {" L0100 ", "L0100", ""},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.written);
    EXPECT_EQ(sinumerik::program_name(c.written).stem, c.stem);
    EXPECT_EQ(sinumerik::program_name(c.written).suffix, c.suffix);
  }
}

TEST(SinumerikProgramName, IsThatOfAFileInManyFormsToo) {
  const std::pair<const char*, const char*> kCases[] = {
      {"LOG", "LOG_MPF"},     {"log.mpf", "LOG_MPF"},    {"_N_LOG_MPF", "LOG_MPF"},
      {"LOG_SPF", "LOG_SPF"}, {"LOG.TXT", "LOG_TXT"},    {"_N_LOG_TXT", "LOG_TXT"},
      {"A.B", "A.B_MPF"},     {"PART_12", "PART_12_MPF"}};
  for (const auto& [written, meant] : kCases) {
    EXPECT_EQ(sinumerik::file_name_on_control(written), meant) << written;
  }
}

}  // namespace
}  // namespace g31::sinumerik_program_name_test
