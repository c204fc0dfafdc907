// What the compiler makes of texts that no conformance case can hold.

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "interpreter/dialects/sinumerik/compile.h"

namespace g31 {
namespace {

using sinumerik::AlarmId;
using sinumerik::CompiledProgram;
using sinumerik::OpCode;

struct Compiled {
  explicit Compiled(std::string text)
      : file("deep.mpf", std::move(text)),
        program(compile({"DEEP", &file, {0, static_cast<std::uint32_t>(file.text().size())}},
                        sinumerik::Globals())) {}

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

// A long program is NC blocks of numbers: each is one step, whatever else stands before and behind.
TEST(SinumerikCompile, ABlockOfNumbersIsOneStep) {
  const Compiled compiled("N10 G1 X1.5 Y-2 F100 M3\nX=R1 Y3\n");
  const auto& ops = compiled.program->ops;
  ASSERT_GE(ops.size(), 3U);
  EXPECT_EQ(ops[0].code, OpCode::NcBlock);
  EXPECT_EQ(ops[0].a.place, 1);
  EXPECT_EQ(ops[1].code, OpCode::Block);
}

}  // namespace
}  // namespace g31
