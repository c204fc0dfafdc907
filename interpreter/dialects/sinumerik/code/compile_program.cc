#include <algorithm>

#include "interpreter/dialects/sinumerik/code/compiler.h"
#include "interpreter/dialects/sinumerik/code/replaced_names.h"
#include "interpreter/source/line_starts.h"

namespace g31::sinumerik {
namespace {

constexpr std::uint32_t kWindowBytes = 1U << 18;
constexpr std::uint32_t kBytesOfLine = 32;  // roughly

/// Steps that need no other block, and no caller.
bool stands_alone(const Op& op) {
  const StepReach reach = reach_of(op.code);
  return reach == StepReach::Own ||
         (reach == StepReach::Row &&
          effect_of(static_cast<ProcedureId>(op.detail)) != ProcedureEffect::RunsText);
}

}  // namespace

Compiler::Compiler(const ProgramSource& source, const Globals& globals, Purpose purpose)
    : CompilerMemory(source),
      BlockPart({reader, *program, code}),
      is_shipped_(source.is_shipped),
      purpose_(purpose),
      text_(source.file->text()),
      scanner_(text_),
      whole_(source.text),
      nc_(program_, code_),
      variables_(work(), globals),
      expressions_(work(), variables_, globals, purpose),
      assignments_(work(), variables_, expressions_),
      words_(work(), globals, purpose, expressions_, nc_),
      definitions_(work(), globals, purpose, variables_, assignments_),
      jumps_(work(), variables_, expressions_),
      structures_(work(), variables_, assignments_, jumps_),
      calls_(work(), expressions_, words_, jumps_),
      actions_(work(), variables_, expressions_, nc_, *this),
      seen_macros_({&definitions_.macros()}) {
  if (!is_shipped_) {
    seen_macros_.push_back(&globals.macros);
  }
  seen_macros_.push_back(is_shipped_ ? &globals.shipped_macros : &globals.offered_macros);
  program_.name = source.name;
  program_.folder = source.folder;
  program_.type = source.type;
  program_.file = source.file;
  program_.leads = source.leads;
  program_.sees_main = purpose == Purpose::Program && !source.is_shipped && !source.leads;
}

void Compiler::know_locals_of(const CompiledProgram& home) {
  program_.name = home.name;
  program_.folder = home.folder;
  program_.type = home.type;
  program_.sees_main = home.sees_main;
  program_.saves_codes = home.saves_codes;
  program_.hides_blocks = home.hides_blocks;
  program_.shows_actual_block = home.shows_actual_block;
  program_.variables = home.variables;
  program_.locals = home.locals;
  program_.layout = home.layout;
  end_ = OpCode::EndText;
  definitions_.expect_letter_names();
  definitions_.begin_program_part();
}

/// Room for that many NC blocks of constant words: a long program has little else.
void Compiler::reserve(std::size_t lines) {
  program_.ops.reserve(lines);
  program_.spans.reserve(lines);
  program_.nc_blocks.reserve(lines);
  program_.words.reserve(4 * lines);
  program_.block_numbers.reserve(lines);
}

/// Without its line end.
ShortSpan Compiler::line_from(std::uint32_t begin) const {
  const std::size_t found = text_.find('\n', begin);
  return {begin, static_cast<std::uint32_t>(std::min<std::size_t>(found, whole_.end))};
}

std::unique_ptr<CompiledProgram> Compiler::run() {
  const std::string_view text = text_.substr(whole_.begin, whole_.end - whole_.begin);
  reserve(source::line_ends_in(text));
  for (std::uint32_t begin = whole_.begin; begin < whole_.end;) {
    const ShortSpan line = line_from(begin);
    if (!plain_block(line)) {
      read_block(line);
    }
    begin = line.end + 1;
  }
  end_of_text();
  return std::move(program);
}

std::vector<Variable> Compiler::run_head() {
  for (std::uint32_t begin = whole_.begin;
       begin < whole_.end && !definitions_.is_in_program_part();) {
    const ShortSpan line = line_from(begin);
    read_block(line);
    begin = line.end + 1;
  }
  std::vector<Variable> defined;
  for (const auto& [name, index] : program_.locals) {
    const auto is_it = [&](const Parameter& parameter) { return parameter.variable == index; };
    if (std::ranges::none_of(program_.parameters, is_it)) {
      defined.push_back(program_.variables[static_cast<std::size_t>(index)]);
    }
  }
  return defined;
}

void Compiler::end_of_text() {
  reader_.set_block({whole_.end, whole_.end});
  structures_.end();
  jumps_.resolve();
  code_.emit(end_, {}, {}, {}, block());
}

/// Compiles a block that says nothing of other blocks: no jump, label, call or definition.
/// @returns false: it is not such a one; its steps are taken back
bool Compiler::lone_block(ShortSpan line) {
  const std::size_t first_step = program_.ops.size();
  read_block(line);
  const bool is_lone = structures_.are_closed() && program_.labels.empty() &&
                       definitions_.count_in_block() == 0 &&
                       std::all_of(program_.ops.begin() + static_cast<std::ptrdiff_t>(first_step),
                                   program_.ops.end(), stands_alone);
  if (!is_lone) {
    take_back(first_step);
  }
  return is_lone;
}

CompiledWindow Compiler::run_window(std::uint32_t begin) {
  const std::uint32_t most = std::min(whole_.end - begin, kWindowBytes);
  reserve(most / kBytesOfLine);
  std::uint32_t at = begin;
  while (at < whole_.end && at - begin < most) {
    const ShortSpan line = line_from(at);
    if (!plain_block(line) && !lone_block(line)) {
      break;
    }
    at = line.end + 1;
  }
  if (at < whole_.end) {
    code_.emit(OpCode::EndWindow, {}, {}, {}, {at, at});
  } else {
    end_of_text();
  }
  return {std::move(program), at};
}

std::unique_ptr<CompiledProgram> Compiler::run_expression() {
  scanner_.scan(whole_, cursor_.tokens());
  find_letter_names(cursor_.tokens(), program_.locals);
  reader_.set_block(whole_);
  const Expr value = expressions_.expression();
  expressions_.operations().expect_value(value);
  expect_end();
  if (failed()) {
    raise_from(0);
  }
  program_.result = argument_of(value);
  code_.emit(OpCode::EndText, {}, {}, {}, block());
  return std::move(program);
}

std::unique_ptr<CompiledProgram> compile(const ProgramSource& source, const Globals& globals) {
  return Compiler(source, globals, Purpose::Program).run();
}

std::vector<Variable> variables_of_head(const ProgramSource& source, const Globals& globals) {
  return Compiler(source, globals, Purpose::Program).run_head();
}

CompiledWindow compile_window(const ProgramSource& source, const Globals& globals,
                              std::uint32_t begin) {
  return Compiler(source, globals, Purpose::Program).run_window(begin);
}

std::unique_ptr<CompiledProgram> compile_data(const ProgramSource& source, const Globals& globals) {
  return Compiler(source, globals, Purpose::Data).run();
}

std::unique_ptr<CompiledProgram> compile_among(const ProgramSource& source, const Globals& globals,
                                               const CompiledProgram& home) {
  Compiler compiler(source, globals, Purpose::Program);
  compiler.know_locals_of(home);
  return compiler.run();
}

std::unique_ptr<CompiledProgram> compile_expression(const ProgramSource& source,
                                                    const Globals& globals,
                                                    const CompiledProgram& home) {
  Compiler compiler(source, globals, Purpose::Program);
  compiler.know_locals_of(home);
  return compiler.run_expression();
}

std::unique_ptr<CompiledProgram> compile_definitions(const ProgramSource& source,
                                                     Globals& globals) {
  Compiler compiler(source, globals, Purpose::Definitions);
  compiler.define_in(globals);
  return compiler.run();
}

}  // namespace g31::sinumerik
