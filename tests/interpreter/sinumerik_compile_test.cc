// What the compiler makes of texts that no conformance case can hold.

#include <memory>
#include <string>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "interpreter/dialects/sinumerik/code/compile.h"

namespace g31::sinumerik_compile_test {
namespace {

using sinumerik::AlarmId;
using sinumerik::CompiledProgram;
using sinumerik::OpCode;

struct Compiled {
  explicit Compiled(std::string text, const sinumerik::Globals& globals = sinumerik::Globals())
      : file("deep.mpf", std::move(text)),
        program(compile({"DEEP", &file, {0, static_cast<std::uint32_t>(file.text().size())}},
                        globals)) {}

  source::SourceFile file;
  std::unique_ptr<CompiledProgram> program;
};

TEST(SinumerikCompile, NestingOfAnyDepthIsAnAlarmOfItsBlock) {
  for (const std::string opening : {"(", "-", "SIN(", "R["}) {
    std::string text = "R1=";
    for (int i = 0; i < 200'000; ++i) {
      text += opening;
    }
    const Compiled compiled(text);
    ASSERT_EQ(compiled.program->errors.size(), 1U) << opening;
    EXPECT_EQ(compiled.program->errors.front().id, AlarmId::NestedTooDeep) << opening;
  }
}

// A variable that is new to the program moves those it has: nothing may hold on to one meanwhile.
TEST(SinumerikCompile, APresetThatNamesAVariableIsRefusedHoweverManyTheProgramHas) {
  for (int parameters = 0; parameters < 40; ++parameters) {
    for (const std::string value : {"R1", "-R[2]"}) {
      std::string text = "PROC DEEP(";
      for (int i = 0; i < parameters; ++i) {
        text += fmt::format("REAL A{},", i);
      }
      const Compiled compiled(text + "CHAR LAST=" + value + ")\nM17\n");
      ASSERT_FALSE(compiled.program->errors.empty()) << parameters << value;
      EXPECT_EQ(compiled.program->errors.front().id, AlarmId::InitialValueType)
          << parameters << value;
    }
  }
}

// A long program is NC blocks of numbers: each is one step, whatever else stands before and behind.
TEST(SinumerikCompile, ABlockOfNumbersIsOneStep) {
  const Compiled compiled("N10 G1 X1.5 Y-2 F100 M3\nX=R1 Y3\n");
  const auto& ops = compiled.program->ops;
  ASSERT_GE(ops.size(), 3U);
  EXPECT_EQ(ops[0].code, OpCode::NcBlock);
  EXPECT_EQ(ops[0].a.place, 1);
  EXPECT_EQ(ops[1].code, OpCode::Block);
}

/// Every letter may begin a macro's name, so no block can be taken as one of plain words.
sinumerik::Globals macros_of_all_letters() {
  sinumerik::Globals globals;
  for (char letter = 'A'; letter <= 'Z'; ++letter) {
    globals.macros.define(fmt::format("{}_NAME_OF_NO_PROGRAM", letter), {});
  }
  return globals;
}

std::string shown(sinumerik::Operand operand) {
  return fmt::format("{}:{}", static_cast<int>(operand.bank), operand.place);
}

/// All that a program of NC blocks does.
std::string shown(const CompiledProgram& program) {
  std::string all;
  for (std::size_t i = 0; i < program.ops.size(); ++i) {
    const sinumerik::Op& op = program.ops[i];
    all += fmt::format("{} {} {} {} {} {} at {}-{}\n", static_cast<int>(op.code), op.detail,
                       op.count, shown(op.result), shown(op.a), shown(op.b), program.spans[i].begin,
                       program.spans[i].end);
  }
  for (const sinumerik::NcBlock& block : program.nc_blocks) {
    all += fmt::format("codes {}, words", fmt::join(block.codes_of(program), " "));
    for (const sinumerik::ConstantWord& word : block.words_of(program)) {
      all += fmt::format(" {}={}", static_cast<int>(word.address), word.value);
    }
    all += "\n";
  }
  for (const sinumerik::BlockNumber& block : program.block_numbers) {
    all += fmt::format("N{} at {}\n", block.number, block.step);
  }
  for (const sinumerik::BlockError& error : program.errors) {
    all += fmt::format("{} {}\n", static_cast<int>(error.id), error.detail);
  }
  return all;
}

const char* const kBlocks[] = {
    "N10 G1 X1.5 Y-2 F100 M3",
    "n10g01x1.5y-.25z+3.f1e",
    " \t N5 ; only a comment",
    "",
    "   ; nothing",
    "N20",
    "N-20 X1",
    "N1.5",
    "G1 N20",
    "X 10 Y\t-3\r",
    "X- 10",
    "X--1",
    "X1EX3",
    "X1E5",
    "X10EX",
    "X1.2.3",
    "X.",
    "X",
    "X1X2",
    "G0 G1",
    "G1.5",
    "G-1",
    "G999",
    "G505 G1",
    "G2147483648",
    "X123456789012345678",
    "X0.1234567890123456",
    "X000000000000001.5",
    "N999999999 X1",
    "N9999999999 X1",
    "M3 M4 M5 M6 M7",
    "M3 M4 M5 M6 M7 M8",
    "M3.5",
    "M-3",
    "M30",
    "G1 X1 M17",
    "M2 X5",
    "L10 P2",
    "L1 X1",
    "R1=5",
    "R1 X1",
    "X1=5",
    "X=5 Y3",
    "Y3 X=5",
    "T1 D1 H2 S100",
    "T1.5",
    "E5",
    "X5 SUPA",
    "SUPA X5",
    "X5Y",
    "A10 B-5 C1 I1 J2 K3 P4 Q1 U1 V2 W3",
    "I1=5 X3",
    "/N10 X1",
    "N10 /2 X1",
    ":10 X1",
    "X1:",
    "LABEL: X1",
    "N10 LABEL: G1 X1 F1",
    "X1 \"text\"",
    "X'HFF'",
    "X1 $P_EP",
    "X$AA_IM[X]",
    "X1 _A",
    "X1\x80",
    "X1;Y\"",
};

TEST(SinumerikCompile, BlocksOfPlainWordsMeanWhatTheirTokensMean) {
  const sinumerik::Globals through_tokens = macros_of_all_letters();
  for (const std::string text : kBlocks) {
    SCOPED_TRACE(text);
    const Compiled plain(text + "\nDEF INT NEW\nG1 X1");
    const Compiled compared(text + "\nDEF INT NEW\nG1 X1", through_tokens);
    EXPECT_EQ(shown(*plain.program), shown(*compared.program));
  }
}

}  // namespace
}  // namespace g31::sinumerik_compile_test
