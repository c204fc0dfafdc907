// What the run on the product says of a program, and how a part that is not measured ends.

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/tools/planned_case.h"

namespace g31::plan_proof_test {
namespace {

using nlohmann::json;
using testing::CommandOutput;

class PlanProof : public testing::PlannedCase {
 protected:
  CommandOutput plan_with(const std::string& probe, const std::string& tolerance) {
    const std::string sheet = folder_.write(
        "sheet.toml",
        "[work_offsets.G54]\nX = 100.0\nY = 50.0\nZ = -300.0\n[tools.1]\nlength = 120.0\n"
        "[probe]\n" +
            probe);
    return plan({testing::kInspected, "--stock", "box", "--control", "0i-MF", "--point-by-point",
                 "--setup", sheet, "--tolerance", tolerance});
  }
};

// At 100 mm/min a delay of 20 ms is 33.3 um of way behind 30 um of pre-travel: 63.3 um at either
// wall, twice that of an inner size, once of a depth whose upper face is touched as well: nothing.
TEST_F(PlanProof, FailsWhereThePartAsDrawnComesOutOfTolerance) {
  const std::string probe = "pre_travel_mm = 0.03\ntrigger_delay_s = 0.02\n";
  const CommandOutput output = plan_with(probe, "0.05");
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_NE(output.out.find("not proven on product.step"), std::string::npos) << output.out;
  EXPECT_NE(output.out.find("largest deviation 126.6667 um"), std::string::npos) << output.out;
  EXPECT_NE(output.out.find("F1.Y         12.00000      12.12667    +0.12667"), std::string::npos)
      << output.out;
  EXPECT_EQ(output.out.find("F1.Z "), std::string::npos) << output.out;
  const std::string page = testing::text_of(out("plan.html"));
  EXPECT_NE(page.find("Not proven"), std::string::npos);
  EXPECT_NE(page.find("<dt>Exit code</dt><dd>1</dd>"), std::string::npos);
  EXPECT_NE(page.find("F1.Y of the part as drawn is +126.7 µm off, allowed is"), std::string::npos);
  EXPECT_EQ(document().at("proof").at("out_of_tolerance").front(), "F1.Y");
  EXPECT_EQ(plan_with(probe, "0.13").exit_code, 0);
  EXPECT_TRUE(document().at("proof").at("out_of_tolerance").empty());
}

TEST_F(PlanProof, OfAPartThatIsNotMeasuredTellsWhy) {
  // A block without anything cut from it.
  const std::string block = folder_.write(
      "block.obj",
      "v 0 0 -40\nv 160 0 -40\nv 160 110 -40\nv 0 110 -40\nv 0 0 0\nv 160 0 0\nv 160 110 0\n"
      "v 0 110 0\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  const CommandOutput output =
      plan({testing::kInspected, "--stock", "box", "--as-machined", block});
  EXPECT_EQ(output.exit_code, 1) << output.errors;
  EXPECT_NE(output.errors.find("IN THE WAY TO P1"), std::string::npos) << output.errors;
  EXPECT_NE(output.out.find("0 of 29 good, 0 bad, 29 missing"), std::string::npos) << output.out;
}

}  // namespace
}  // namespace g31::plan_proof_test
