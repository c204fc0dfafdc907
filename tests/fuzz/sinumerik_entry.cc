#include <cmath>
#include <string>
#include <variant>

#include "interpreter/dialects/sinumerik/code/compile.h"
#include "interpreter/dialects/sinumerik/run/session.h"
#include "machine/base/contract.h"
#include "tests/fuzz/entry.h"
#include "tests/fuzz/tape_choices.h"
#include "tests/fuzz/world.h"

namespace g31::fuzz {
namespace {

constexpr const char* kPath = "fuzz.mpf";

/// Every step has a place in the text, every jump a step to go to.
void judge_program(const sinumerik::CompiledProgram& program, std::size_t text_size) {
  G31_EXPECTS(program.ops.size() == program.spans.size() && !program.ops.empty());
  const auto count = static_cast<std::int32_t>(program.ops.size());
  for (std::size_t i = 0; i < program.ops.size(); ++i) {
    const syntax::ShortSpan where = program.spans[i];
    G31_EXPECTS(where.begin <= where.end && where.end <= text_size);
    const sinumerik::Op& op = program.ops[i];
    if (op.code == sinumerik::OpCode::Jump || op.code == sinumerik::OpCode::JumpInto ||
        op.code == sinumerik::OpCode::Block || op.code == sinumerik::OpCode::NcBlock) {
      G31_EXPECTS(op.a.place >= 0 && op.a.place < count);
    } else if (op.code == sinumerik::OpCode::JumpIfNot) {
      G31_EXPECTS(op.b.place >= 0 && op.b.place < count);
    }
  }
}

}  // namespace

void read_sinumerik_text(std::string_view bytes) {
  const source::SourceFile file(kPath, std::string(bytes));
  const auto size = static_cast<std::uint32_t>(bytes.size());
  const sinumerik::ProgramSource source{"FUZZ", &file, {0, size}};
  sinumerik::Globals globals;
  judge_program(*compile_definitions(source, globals), size);
  const auto program = compile(source, globals);
  judge_program(*program, size);
  judge_program(*compile_data(source, globals), size);
  judge_program(*compile_among(source, globals, *program), size);
  judge_program(*compile_expression(source, globals, *program), size);
}

void run_sinumerik_text(std::string_view bytes) {
  const TapeChoices choices(bytes);
  OneFile files(kPath, bytes);
  source::SourceMap sources(files);
  sinumerik::ProgramLibrary library(sources);
  library.add_file(kPath);
  const auto surroundings = choices.surroundings();
  machine::MachiningCentre machine(choices.machine_setup(), surroundings.get());
  Listener listener;
  sinumerik::Session session(library, machine, listener);
  // A name of the set-up may be a macro of the text: it need not be understood.
  session.configure(choices.sinumerik_setup());
  judge(session.run({kBlocks, kWallSeconds}), sources, machine);
  for (const char* name : {"R1", "R2+R3", "$P_EP[X]", "$AA_IW[Z]", "$AA_MW[X]", "$P_UIFR[1,X,TR]",
                           "$P_ACTFRAME[Y,RT]", "$TC_DP3[1,1]", "\"R1=\"<<R1"}) {
    const auto value = session.variable(name);
    const auto* const number = value ? std::get_if<runtime::Cell>(&value.value()) : nullptr;
    G31_EXPECTS(number == nullptr || number->is_vacant() || std::isfinite(number->raw()));
  }
}

}  // namespace g31::fuzz
