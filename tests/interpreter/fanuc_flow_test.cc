// The picture of a Fanuc program, held against expectations written by hand.

#include "interpreter/analysis/fanuc_flow.h"

#include <memory>

#include <gtest/gtest.h>

#include "interpreter/dialects/fanuc/text/parse.h"
#include "tests/support/drawn_flow.h"

namespace g31::fanuc_flow_test {
namespace {

using analysis::Flow;
using testing::drawn;

/// A program with what its flow points into.
struct Pictured {
  explicit Pictured(const std::string& program, const char* control = "fanuc-16i")
      : file("case.nc", program), tree(fanuc::parse(file.text())) {
    const fanuc::Profile& profile = *fanuc::find_profile(control);
    compiled = fanuc::compile(file, tree, 0, profile);
    flow = analysis::flow_of(compiled, profile);
  }

  source::SourceFile file;
  syntax::Tree tree;
  fanuc::CompiledProgram compiled;
  Flow flow;
};

TEST(FanucFlow, BlocksFollowOneAnotherUpToTheEnd) {
  EXPECT_EQ(drawn(Pictured("O1\nG00X1.\n#1=2\nM30\n").flow),
            "0 O1 > 1\n"
            "1 G00X1. > 2\n"
            "2 #1=2 > 3\n"
            "3 M30 end\n");
}

TEST(FanucFlow, JumpsLeadToTheirBlocks) {
  EXPECT_EQ(drawn(Pictured("O1\nIF[#1EQ1]GOTO9\nGOTO5\nN9M99\nN5GOTO#2\n").flow),
            "0 O1 > 1\n"
            "1 IF[#1EQ1]GOTO9 > 2 ~3\n"
            "2 GOTO5 > ~4\n"
            "3 N9M99 return\n"
            "4 N5GOTO#2 any\n"
            "labels N9=3 N5=4\n");
}

TEST(FanucFlow, AJumpLooksForwardFirst) {
  EXPECT_EQ(drawn(Pictured("O1\nN1#1=1\nGOTO1\nN1M30\n").flow),
            "0 O1 > 1\n"
            "1 N1#1=1 > 2\n"
            "2 GOTO1 > ~3\n"
            "3 N1M30 end\n"
            "labels N1=1 N1=3\n");
}

// The tree gives the statement the text of its whole line.
TEST(FanucFlow, TheStatementOfThenIsABlockOfItsOwn) {
  EXPECT_EQ(drawn(Pictured("O1\nIF[#1EQ1]THEN#2=1\nM30\n").flow),
            "0 O1 > 1\n"
            "1 IF[#1EQ1]THEN > 2 ~3\n"
            "2 IF[#1EQ1]THEN#2=1 > 3\n"
            "3 M30 end\n");
}

TEST(FanucFlow, LoopsGoBackToTheirBeginning) {
  EXPECT_EQ(drawn(Pictured("O1\nWHILE[#1LT3]DO1\n#1=#1+1\nEND1\nM30\n").flow),
            "0 O1 > 1\n"
            "1 WHILE[#1LT3]DO1 > 2 ~4\n"
            "2 #1=#1+1 > 3\n"
            "3 END1 > ~1\n"
            "4 M30 end\n");
}

TEST(FanucFlow, ConditionsOfNumbersGoOneWayOnly) {
  EXPECT_EQ(drawn(Pictured("O1\nWHILE[1EQ1]DO1\nEND1\nM30\n").flow),
            "0 O1 > 1\n"
            "1 WHILE[1EQ1]DO1 > 2\n"
            "2 END1 > ~1\n"
            "3 M30 end\n");
  EXPECT_EQ(drawn(Pictured("O1\nIF[1GT2]GOTO9\nIF[2GE2]GOTO9\nM99\nN9M30\n").flow),
            "0 O1 > 1\n"
            "1 IF[1GT2]GOTO9 > 2\n"
            "2 IF[2GE2]GOTO9 > ~4\n"
            "3 M99 return\n"
            "4 N9M30 end\n"
            "labels N9=4\n");
}

TEST(FanucFlow, ASkippedBlockMayBePassed) {
  EXPECT_EQ(drawn(Pictured("O1\n/M30\n/2GOTO9\nG00/M99\nN9M30\n").flow),
            "0 O1 > 1\n"
            "1 /M30 > 2 end\n"
            "2 /2GOTO9 > 3 ~4\n"
            "3 G00/M99 > 4 return\n"
            "4 N9M30 end\n"
            "labels N9=4\n");
}

TEST(FanucFlow, AlarmsOfTheProgramEndIt) {
  EXPECT_EQ(drawn(Pictured("O1\nIF[#1EQ#0]GOTO9\nM99\nN9#3000=1(NO A)\n").flow),
            "0 O1 > 1\n"
            "1 IF[#1EQ#0]GOTO9 > 2 ~3\n"
            "2 M99 return\n"
            "3 N9#3000=1(NO A) alarm\n"
            "labels N9=3\n");
}

TEST(FanucFlow, NothingBehindTheLastBlockIsAFault) {
  EXPECT_EQ(drawn(Pictured("O1\nG00X1.\n").flow),
            "0 O1 > 1\n"
            "1 G00X1. out\n"
            "  fault 5010 'G00X1.' END OF RECORD: O0001 ends without M30, M02 or M99\n");
  // Whether what is called ends the run is asked where its program is known.
  EXPECT_EQ(drawn(Pictured("O1\nM98P9\n").flow),
            "0 O1 > 1\n"
            "1 M98P9 out\n"
            "  call O0009 'P9'\n"
            "  fault 5010 'M98P9' END OF RECORD: O0001 ends without M30, M02 or M99\n");
}

TEST(FanucFlow, CallsNameTheirPrograms) {
  EXPECT_EQ(drawn(Pictured("O1\nG65P9010A1.\nG66P9011\nM98P#1\nM198P52000\nG65P#901\nM98Q20\n"
                           "N20M99\n")
                      .flow),
            "0 O1 > 1\n"
            "1 G65P9010A1. > 2\n"
            "  macro O9010 'P9010'\n"
            "2 G66P9011 > 3\n"
            "  modal O9011 'P9011'\n"
            "3 M98P#1 > 4\n"
            "  call ? 'P#1'\n"
            "4 M198P52000 > 5\n"
            "  call O52000 'P52000'\n"
            "5 G65P#901 > 6\n"
            "  macro ? 'P#901'\n"
            "6 M98Q20 > 7\n"
            "  call O0001 'M98'\n"
            "7 N20M99 return\n"
            "labels N20=7\n");
}

TEST(FanucFlow, WhatIsWrongStandsInItsBlock) {
  EXPECT_EQ(drawn(Pictured("O1\n#1=[2+\nGOTO7\nG65\nM30\n").flow),
            "0 O1 > 1\n"
            "1 #1=[2+ alarm\n"
            "  fault 114 '\n' FORMAT ERROR IN MACRO: the block ends where a value is expected\n"
            "2 GOTO7 alarm\n"
            "  target 128 '7' ILLEGAL MACRO SEQUENCE NUMBER: O0001 has no N7\n"
            "3 G65 alarm\n"
            "  fault 76 'G65' PROGRAM NOT SPECIFIED: G65 without P\n"
            "4 M30 end\n");
}

TEST(FanucFlow, WhatAControlLacksIsAFaultThereOnly) {
  const std::string program = "O1\nIF[#1EQ1]THEN#2=1\nM30\n";
  EXPECT_TRUE(Pictured(program, "fanuc-16i").flow.faults.empty());
  EXPECT_EQ(Pictured(program, "brother").flow.faults.size(), 1U);
}

TEST(FanucFlow, ReachedIsWhatAWayLeadsTo) {
  const Flow flow = Pictured("O1\nGOTO9\n#1=1\nN9GOTO#2\n#2=1\nN8M30\n").flow;
  EXPECT_EQ(analysis::reached_blocks(flow),
            (std::vector<bool>{true, true, false, true, false, true}));
}

TEST(FanucFlow, BehindAWrongBlockTheWayGoesOn) {
  const Flow flow = Pictured("O1\n#1=[2+\n#1=1\nM30\n#1=1\n").flow;
  EXPECT_EQ(analysis::reached_blocks(flow), (std::vector<bool>{true, true, true, true, false}));
}

TEST(FanucFlow, VariablesAreReadAndWritten) {
  const Flow flow = Pictured(
                        "O1\n#3=#1+#[#2+1]*#100\nG65P#5A#6\nIF[#5061GT#0]GOTO#7\n"
                        "G1X#8Y[-#9]F100.\n#[#10]=#5041\nWHILE[#1LT#2]DO1\nEND1\nM30\n")
                        .flow;
  EXPECT_EQ(testing::drawn_accesses(flow),
            "1: r#1 r#[] r#2 r#100 w#3\n"
            "2: r#5 r#6\n"
            "3: r#5061 r#7\n"
            "4: r#8 r#9\n"
            "5: r#10 r#5041 w#[]\n"
            "6: r#1 r#2\n");
  using Scope = analysis::Variable::Scope;
  EXPECT_EQ(flow.variables[0], (analysis::Variable{Scope::Local, "#1"}));
  EXPECT_EQ(flow.variables[1], (analysis::Variable{Scope::Computed, "#[]"}));
  EXPECT_EQ(flow.variables[3], (analysis::Variable{Scope::Global, "#100"}));
  EXPECT_EQ(flow.variables[7], (analysis::Variable{Scope::System, "#5061"}));
}

TEST(FanucFlow, WordsOfABlockCommandItsMove) {
  EXPECT_EQ(testing::drawn_moves(Pictured("O1\nG91G0X1.Y-2.\nX#1\nG31Z-10.F50\nG10L2P1X5.\n"
                                          "G28Z0\nG81X3Z-5.R1.\nG65P1X1.\nG4X1.\nG2X1.I2.\n"
                                          "G100X1.\nM98P5X1.\nG54\nM30\n")
                                     .flow),
            "1: rapid X1 Y-2\n"
            "2: as before X?\n"
            "3: measuring Z-10\n"
            "5: reference Z0\n"
            "6: cycle X3 Z-5\n"
            "9: arc X1\n"
            "11: as before X1\n");
}

}  // namespace
}  // namespace g31::fanuc_flow_test
