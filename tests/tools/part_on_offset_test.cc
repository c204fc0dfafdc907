// A part that lies on a work offset, and lines of a sheet that look like variables.

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "parts/geometry/placement.h"
#include "tests/support/run_program.h"
#include "tests/tools/setup_sheets.h"

namespace g31::setup::part_on_offset_test {
namespace {

class PartOnOffset : public SetupSheets {
 protected:
  [[nodiscard]] parts::PartSetup part(const std::string& offsets, const std::string& keys) const {
    const auto job = read({offsets + "[[part]]\nshape = \"block\"\n" + keys});
    EXPECT_EQ(errors_of(job), "");
    return job ? job.value().parts.at(0) : parts::PartSetup();
  }
};

TEST_F(PartOnOffset, CountsFromItsOriginAndExt) {
  const parts::PartSetup read =
      part("[work_offsets.G54]\nX = 250.0\nY = -180.0\nZ = -300.0\n[work_offsets.EXT]\nZ = -2.0\n",
           "on = \"G54\"\nat = [1.0, 2.0, 3.0]\nrotate_deg = [0.0, 0.0, 5.0]\n");
  EXPECT_EQ(read.p_M_at, Point(251.0, -178.0, -299.0));
  EXPECT_EQ(read.rotate_deg, Point(0.0, 0.0, 5.0));
  EXPECT_EQ(part("[work_offsets.EXT]\nZ = -2.0\n", "on = \"EXT\"\n").p_M_at, Point(0.0, 0.0, -2.0));
}

/// x 30 degrees counter-clockwise: cos 30 (1, 2) - sin 30 (2, -1), by hand.
TEST_F(PartOnOffset, TurnsWithItsRotation) {
  const parts::PartSetup read =
      part("[work_offsets.G505]\nY = 8.0\nrotate_deg = [0.0, 0.0, 30.0]\nfine = [0.05, 0.0, 0.0]\n",
           "on = \"G505\"\nat = [1.0, 2.0, 3.0]\nrotate_deg = [0.0, 10.0, 5.0]\n");
  const double cosine = std::sqrt(0.75);
  EXPECT_NEAR(read.p_M_at.x(), 0.05 + cosine - 1.0, 1e-12);
  EXPECT_NEAR(read.p_M_at.y(), 8.0 + 0.5 + 2.0 * cosine, 1e-12);
  EXPECT_EQ(read.p_M_at.z(), 3.0);
  EXPECT_EQ(read.rotate_deg, Point(0.0, 10.0, 35.0)) << "about Z the degrees add";
}

/// The angles of the sheet come to the product of both rotations.
TEST_F(PartOnOffset, TurnsAboutEveryAxis) {
  const Point kOffsets[] = {
      {20.0, 0.0, 0.0}, {10.0, -35.0, 70.0}, {0.0, 90.0, 15.0}, {0.0, -90.0, 0.0}};
  const Point kParts[] = {{0.0, 0.0, 0.0}, {0.0, 0.0, 30.0}, {5.0, 40.0, -100.0}};
  for (const Point& offset : kOffsets) {
    for (const Point& own : kParts) {
      const auto list = [](const Point& p) {
        return fmt::format("rotate_deg = [{}, {}, {}]\n", p.x(), p.y(), p.z());
      };
      const parts::PartSetup read =
          part("[work_offsets.G54]\nX = 1.0\n" + list(offset), "on = \"G54\"\n" + list(own));
      const Eigen::Matrix3d expected = parts::rotation_to_machine({Point::Zero(), offset}) *
                                       parts::rotation_to_machine({Point::Zero(), own});
      const Eigen::Matrix3d is = parts::rotation_to_machine({Point::Zero(), read.rotate_deg});
      EXPECT_LT((is - expected).cwiseAbs().maxCoeff(), 1e-12) << offset << own;
    }
  }
}

TEST_F(PartOnOffset, WantsAnOffsetThatIsGiven) {
  const auto missing = read({"[[part]]\nshape = \"block\"\non = \"G55\"\n"});
  EXPECT_NE(errors_of(missing).find("sheet1.toml:3:6: error: part.on is G55, an offset that the "
                                    "sheet does not give [SET130]"),
            std::string::npos)
      << errors_of(missing);
  const auto wrong = read({"[[part]]\nshape = \"block\"\non = \"G60\"\n"});
  EXPECT_NE(
      errors_of(wrong).find("part.on is \"G60\", it should be a work offset: G54 to G59, EXT,"),
      std::string::npos)
      << errors_of(wrong);
}

/// What a run prints to standard error over a block below the ball.
std::string messages_of(const std::string& sheet, const std::string& program,
                        const std::string& name = "case.nc") {
  const testing::TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write(name, program)};
  options.setups = {
      folder.write("sheet.toml", "[start]\nZ = 300.0\n[probe]\nlength = 100.0\n" + sheet)};
  return testing::run_program(options).errors;
}

/// In both dialects the part is touched where the program's own coordinates say: its side is X30,
/// the ball's radius 3.
TEST(PartOnOffsetRun, IsTouchedWhereTheProgramSays) {
  const std::string part =
      "[machine]\nstopping = \"ideal\"\n[work_offsets.G54]\nX = 7.0\nY = 5.0\nZ = 20.0\n"
      "[tools.1]\nlength = 100.0\n[[part]]\nshape = \"block\"\non = \"G54\"\n";
  EXPECT_EQ(messages_of(part,
                        "O1\nG54 G90 G43 H1 G0 X50. Y0\nZ-10.\nG31 X0 F100.\n"
                        "IF [ABS[#5061-33.] GT 0.0001] THEN #3000=1 (WRONG)\nM30\n"),
            "");
  EXPECT_EQ(messages_of(part,
                        "T1 M6\nD1 G54 G90 G0 X50 Y0\nZ-10\nMEAS=1 G1 X0 F100\nSTOPRE\n"
                        "IF ABS($AA_MW[X] - 33) > 0.0001\nSETAL(65000)\nENDIF\nM30\n",
                        "case.mpf"),
            "");
}

TEST(LostVariables, AreReportedWithTheirPlace) {
  const std::string messages = messages_of(
      "[variables]\n#500 = 3.0   # the ball\n\"#501\" = 1.0\n  #502=\"\"\n"
      "# 503 = 4.0\n#504 is the feed\n#length = 5.0\n",
      "O1\nM30\n");
  EXPECT_NE(messages.find("sheet.toml:6:1: warning: a comment of the set-up sheet looks like a "
                          "variable: #500 = 3.0   # the ball [PRB519]\n"),
            std::string::npos)
      << messages;
  EXPECT_NE(messages.find("sheet.toml:8:3: warning"), std::string::npos) << messages;
  EXPECT_EQ(messages.find(":9:"), std::string::npos);
  EXPECT_EQ(messages.find(":10:"), std::string::npos);
  EXPECT_EQ(messages.find(":11:"), std::string::npos);
  EXPECT_EQ(messages_of("", "O1\nM30\n"), "");
}

/// The block's side X = 50, the ball of 6 mm stops at X = 40: 7 mm are left.
TEST(NearestPart, IsNamedWithASkipMoveThatMissed) {
  const std::string sheet =
      "[[part]]\nname = \"far\"\nshape = \"block\"\nat = [-500.0, 0.0, 0.0]\n"
      "[[part]]\nname = \"near\"\nshape = \"block\"\nat = [80.0, 0.0, 210.0]\n";
  const std::string program = "O1\nG90 G31 X40. F100.\n#500=#5061\nM30\n";
  EXPECT_NE(messages_of(sheet, program)
                .find("the skip move reached its end point without a signal; the nearest part, "
                      "'near', was 7.000 mm from the ball [PRB301]"),
            std::string::npos)
      << messages_of(sheet, program);
}

}  // namespace
}  // namespace g31::setup::part_on_offset_test
