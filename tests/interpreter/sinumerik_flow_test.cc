// The picture of a SINUMERIK program, held against expectations written by hand.

#include "interpreter/analysis/sinumerik_flow.h"

#include <memory>

#include <gtest/gtest.h>

#include "interpreter/dialects/sinumerik/code/compile.h"
#include "tests/support/drawn_flow.h"

namespace g31::sinumerik_flow_test {
namespace {

using testing::drawn;

/// A program with what its flow points into.  The last block of each is the end of its text.
struct PicturedText {
  explicit PicturedText(const std::string& program) : file("CASE.MPF", program) {
    compiled = sinumerik::compile(
        {"CASE", &file, {0, static_cast<std::uint32_t>(file.text().size())}}, globals);
    flow = analysis::flow_of(*compiled);
  }

  source::SourceFile file;
  sinumerik::Globals globals;
  std::unique_ptr<sinumerik::CompiledProgram> compiled;
  analysis::Flow flow;
};

TEST(SinumerikFlow, BlocksFollowOneAnotherUpToTheEnd) {
  EXPECT_EQ(drawn(PicturedText("N10 G0 X1\nR1=2\n\nM30\n").flow),
            "0 N10 G0 X1 > 1\n"
            "1 R1=2 > 2\n"
            "2 M30 end\n"
            "3  return\n"
            "labels N10=0\n");
}

TEST(SinumerikFlow, JumpsLeadToTheirLabels) {
  EXPECT_EQ(drawn(PicturedText("BACK: R1=R1+1\nIF R1<5 GOTOB BACK\nGOTOF N40\nR2=1\nN40 GOTO R2\n"
                               "GOTOS\n")
                      .flow),
            "0 BACK: R1=R1+1 > 1\n"
            "1 IF R1<5 GOTOB BACK > ~0 2\n"
            "2 GOTOF N40 > ~4\n"
            "3 R2=1 > 4\n"
            "4 N40 GOTO R2 alarm\n"
            "  target 14080 'R' jump destination not found: R2\n"
            "5 GOTOS > ~0\n"
            "6  return\n"
            "labels BACK=0 N40=4\n");
}

TEST(SinumerikFlow, BranchesMeetBehindTheirEnd) {
  EXPECT_EQ(drawn(PicturedText("IF R1==1\nR2=1\nELSE\nR2=2\nENDIF\nM30\n").flow),
            "0 IF R1==1 > 1 ~3\n"
            "1 R2=1 > 2\n"
            "2 ELSE > ~5\n"
            "3 R2=2 > 4\n"
            "4 ENDIF > 5\n"
            "5 M30 end\n"
            "6  return\n");
}

// LOOP and REPEAT ask for nothing: their ends lead behind them.
TEST(SinumerikFlow, LoopsGoBackToTheirBeginning) {
  EXPECT_EQ(drawn(PicturedText("WHILE R1<3\nR1=R1+1\nENDWHILE\nFOR R2=1 TO 3\nENDFOR\nREPEAT\n"
                               "R3=R3+1\nUNTIL R3>4\nLOOP\nENDLOOP\nM30\n")
                      .flow),
            "0 WHILE R1<3 > 1 ~3\n"
            "1 R1=R1+1 > 2\n"
            "2 ENDWHILE > ~0\n"
            "3 FOR R2=1 TO 3 > 4 ~5\n"
            "4 ENDFOR > ~3\n"
            "5 REPEAT > 6\n"
            "6 R3=R3+1 > 7\n"
            "7 UNTIL R3>4 > ~6 8\n"
            "8 LOOP > 9\n"
            "9 ENDLOOP > ~9\n"
            "10 M30 end\n"
            "11  return\n");
}

TEST(SinumerikFlow, CaseLeadsToEachOfItsLabels) {
  EXPECT_EQ(drawn(PicturedText("CASE R1 OF 1 GOTOF L1 2 GOTOF L2 DEFAULT GOTOF L3\nR1=1\nL1: M17\n"
                               "L2: M17\nL3: RET\n")
                      .flow),
            "0 CASE R1 OF 1 GOTOF L1 2 GOTOF L2 DEFAULT GOTOF L3 > ~2 ~3 ~4\n"
            "1 R1=1 > 2\n"
            "2 L1: M17 return\n"
            "3 L2: M17 return\n"
            "4 L3: RET return\n"
            "5  return\n"
            "labels L1=2 L2=3 L3=4\n");
}

TEST(SinumerikFlow, ARepeatedPartIsGoneThroughAgain) {
  EXPECT_EQ(drawn(PicturedText("PART: R1=R1+1\nDONE: R2=1\nR3=1\nREPEAT PART DONE P3\nM30\n").flow),
            "0 PART: R1=R1+1 > 1\n"
            "1 DONE: R2=1 > *0 2 *4\n"
            "2 R3=1 > 3\n"
            "3 REPEAT PART DONE P3 > *0 4\n"
            "4 M30 end\n"
            "5  return\n"
            "labels PART=0 DONE=1\n");
  // The REPEAT that stands behind its part is no block of a further pass.
  EXPECT_EQ(drawn(PicturedText("PART: R1=R1+1\nDONE: R2=1\nREPEAT PART DONE\nM30\n").flow),
            "0 PART: R1=R1+1 > 1\n"
            "1 DONE: R2=1 > *0 2 *3\n"
            "2 REPEAT PART DONE > *0 3\n"
            "3 M30 end\n"
            "4  return\n"
            "labels PART=0 DONE=1\n");
  // Without an end label it goes up to its REPEAT.
  EXPECT_EQ(drawn(PicturedText("PART: R1=R1+1\nREPEAT PART\nM30\n").flow),
            "0 PART: R1=R1+1 > 1\n"
            "1 REPEAT PART > *0 2\n"
            "2 M30 end\n"
            "3  return\n"
            "labels PART=0\n");
  // An end that stands behind it is that of another part.
  EXPECT_EQ(drawn(PicturedText("PART: R1=R1+1\nREPEAT PART\nENDLABEL: M30\n").flow),
            "0 PART: R1=R1+1 > 1\n"
            "1 REPEAT PART > *0 2\n"
            "2 ENDLABEL: M30 end\n"
            "3  return\n"
            "labels PART=0 ENDLABEL=2\n");
}

TEST(SinumerikFlow, ASkippedBlockMayBePassed) {
  EXPECT_EQ(drawn(PicturedText("/M30\n/2 GOTOF L1\nG0 X1\nL1: M30\n").flow),
            "0 /M30 > 1 end\n"
            "1 /2 GOTOF L1 > 2 ~3\n"
            "2 G0 X1 > 3\n"
            "3 L1: M30 end\n"
            "4  return\n"
            "labels L1=3\n");
}

TEST(SinumerikFlow, ComputedTargetsAreAnyLabel) {
  EXPECT_EQ(drawn(PicturedText("DEF STRING[20] WHERE\nWHERE=\"L1\"\nGOTO WHERE\nL1: M30\n").flow),
            "0 DEF STRING[20] WHERE > 1\n"
            "1 WHERE=\"L1\" > 2\n"
            "2 GOTO WHERE any\n"
            "3 L1: M30 end\n"
            "4  return\n"
            "labels L1=3\n");
  EXPECT_EQ(drawn(PicturedText("GOTOF \"L1\"\nGOTOC \"L9\"\nL1: GOTO \"L8\"\n").flow),
            "0 GOTOF \"L1\" > ~2\n"
            "1 GOTOC \"L9\" > 2\n"
            "2 L1: GOTO \"L8\" alarm\n"
            "  target 14080 '\"L8\"' jump destination not found: L8\n"
            "3  return\n"
            "labels L1=2\n");
}

TEST(SinumerikFlow, CallsNameTheirPrograms) {
  EXPECT_EQ(drawn(PicturedText("DEF STRING[20] WHICH\nSUB1(1,2)\nL77 P2\nCALL \"SUB2\"\n"
                               "CALL WHICH\nMCALL SUB3(1)\nX10\nMCALL\nPCALL /_N_SPF_DIR/SUB4\n")
                      .flow),
            "0 DEF STRING[20] WHICH > 1\n"
            "1 SUB1(1,2) > 2\n"
            "  call SUB1 'SUB1'\n"
            "2 L77 P2 > 3\n"
            "  call L77 'L'\n"
            "3 CALL \"SUB2\" > 4\n"
            "  call SUB2 '\"SUB2\"'\n"
            "4 CALL WHICH > 5\n"
            "  call ? 'WHICH'\n"
            "5 MCALL SUB3(1) > 6\n"
            "  modal SUB3 'SUB3'\n"
            "6 X10 > 7\n"
            "7 MCALL > 8\n"
            "8 PCALL /_N_SPF_DIR/SUB4 > 9\n"
            "  call /_N_SPF_DIR/SUB4 '/_N_SPF_DIR/SUB4'\n"
            "9  return\n");
}

TEST(SinumerikFlow, WhatIsWrongStandsInItsBlock) {
  EXPECT_EQ(drawn(PicturedText("GOTOF NOWHERE\nIF R1==1\nREPEAT GONE P2\nNAME=3\nR1=(2\n").flow),
            "0 GOTOF NOWHERE alarm\n"
            "  target 14080 'NOWHERE' jump destination not found: NOWHERE\n"
            "1 IF R1==1 alarm\n"
            "  fault 12640 'IF R1==1' invalid nesting with control structures: its end is missing\n"
            "2 REPEAT GONE P2 alarm\n"
            "  target 14082 'REPEAT GONE P2' label, program section not found: GONE\n"
            "3 NAME=3 alarm\n"
            "  fault 12550 'NAME' name not defined or option/function not available: NAME\n"
            "4 R1=(2 alarm\n"
            "  fault 12080 'R1=(2' syntax error in text: the end of the block\n"
            "5  return\n");
}

TEST(SinumerikFlow, ANameThatIsAskedForMayBeMissing) {
  const auto& flow = PicturedText("IF ISVAR(\"OWN\")\nR1=OWN\nENDIF\nR2=OTHER\n").flow;
  ASSERT_EQ(flow.faults.size(), 1U);
  EXPECT_EQ(flow.faults[0].message.substr(flow.faults[0].message.size() - 5), "OTHER");
}

TEST(SinumerikFlow, ATextThatIsRunMayEndTheProgram) {
  EXPECT_EQ(drawn(PicturedText("EXECSTRING(\"RET\")\nM30\n").flow),
            "0 EXECSTRING(\"RET\") > 1 end return\n"
            "1 M30 end\n"
            "2  return\n");
}

TEST(SinumerikFlow, VariablesAreReadAndWritten) {
  const auto flow = PicturedText(
                        "DEF REAL LEN,ROW[3]\nDEF STRING[9] WORD\nLEN=R1+ROW[1]*ROW[R2]\n"
                        "ROW[2]=LEN\nR[R3]=$AA_IM[X]\nSUB(LEN,R4,1)\nG1 X=LEN Y10\nIF LEN>R5\n"
                        "ENDIF\nWORD=\"A\"<<R6\nMSG(WORD)\nROW[0]=SET(R7,R8)\n$TC_DP3[1,1]=R9\n")
                        .flow;
  EXPECT_EQ(testing::drawn_accesses(flow),
            "2: rR[2] rROW rROW[1] rR[1] wLEN\n"
            "3: rLEN wROW[2]\n"
            "4: rR[3] r$AA_IM wR\n"
            "5: hLEN hR[4]\n"
            "6: rLEN\n"
            "7: rLEN rR[5]\n"
            "9: rR[6] wWORD\n"
            "10: hWORD\n"
            "11: rR[7] rR[8] wROW\n"
            "12: rR[9] w$TC_DP\n");
  using Scope = analysis::Variable::Scope;
  EXPECT_EQ(flow.variables[0], (analysis::Variable{Scope::Global, "R"}));
  EXPECT_EQ(flow.variables[1], (analysis::Variable{Scope::Local, "ROW"}));
}

TEST(SinumerikFlow, SynchronisedActionsReadAndWriteAtTheirOwnBlock) {
  const PicturedText text(
      "DEF REAL LIMIT=2\nID=1 WHENEVER ($A_IN[1]==1) AND (R3<LIMIT) DO $AC_MARKER[1]=R4 R5=LIMIT\n"
      "WHEN R6==1 DO R7=NOBODYS\nDO R8=R9\nDO R10=R[R11+1]\nM30\n");
  // The third block is wrong: what was tried of it is no action.
  EXPECT_EQ(testing::drawn_accesses(text.flow),
            "0: wLIMIT\n"
            "1: r$A_IN rR[3] rLIMIT rR[4] w$AC_MARKER[1] rLIMIT wR[5]\n"
            "3: rR[9] wR[8]\n"
            "4: rR[11] rR rR[11] rR wR[10]\n");
}

TEST(SinumerikFlow, WordsOfABlockCommandItsMove) {
  EXPECT_EQ(testing::drawn_moves(PicturedText("G0 X1 Y-2\nX=R1 Z=IC(2)\nMEAS=1 G1 Z-10\nTRANS X5\n"
                                              "G74 Z0\nG2 X1 I2\nG4 F1\nPOS[A]=3\nG1 AP=5 RP=R2\n"
                                              "SUB(1)\nG54\nM30\n")
                                     .flow),
            "0: rapid X1 Y-2\n"
            "1: as before X? Z2\n"
            "2: measuring Z-10\n"
            "4: reference Z0\n"
            "5: arc X1\n"
            "7: as before A3\n"
            "8: line\n");
}

}  // namespace
}  // namespace g31::sinumerik_flow_test
