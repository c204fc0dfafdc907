// Codes of the Fanuc family that are others on a Haas.

#include <string>

#include <gtest/gtest.h>

#include "tests/support/captured.h"
#include "tests/support/temporary_folder.h"

namespace g31::own_g_codes_test {
namespace {

TEST(OwnGCodes, CountBeforeThoseOfTheFamily) {
  const testing::TemporaryFolder folder;
  const std::string file =
      folder.write("case.nc", "O1\nG47 X1. D1\nG48 X1. D1\nG39 X1. Y1.\nM30\n");
  const auto said_on = [&](const char* control) {
    return testing::g31({"check", "--control", control, file}).out;
  };
  const std::string meldas = said_on("meldas");
  for (const char* const said :
       {"2:1: warning: alarm 34, G47, moves by twice the tool offset D farther: not simulated: a "
        "run ends here [NC007]",
        "3:1: warning: alarm 34, G48, moves by twice the tool offset D less far: not simulated: a "
        "run ends here [NC007]",
        "4:1: warning: alarm 34, G39, cutter compensation, arc around a corner: not simulated: a "
        "run ends here [NC007]"}) {
    EXPECT_NE(meldas.find(said), std::string::npos) << meldas;
  }
  const std::string haas = said_on("haas");
  EXPECT_NE(haas.find("2:1: warning: G47, text engraving: not simulated: a run passes over it"),
            std::string::npos)
      << haas;
  EXPECT_NE(haas.find("3:1: warning: alarm 10, G48, which this control has not: a run ends here"),
            std::string::npos)
      << haas;
}

TEST(OwnGCodes, AreExplainedByTheirControl) {
  const auto explained = [](const char* control) {
    return testing::g31({"explain", "--control", control, "G47"}).out;
  };
  EXPECT_NE(explained("haas").find("text engraving"), std::string::npos);
  EXPECT_NE(explained("fanuc-16i").find("twice the tool offset"), std::string::npos);
}

}  // namespace
}  // namespace g31::own_g_codes_test
