#include "interpreter/dialects/sinumerik/code/code_writer.h"

namespace g31::sinumerik {
namespace {

/// The constant that was added last.
Operand last_of(const auto& list) {
  return {Bank::Constants, static_cast<std::int32_t>(list.size()) - 1};
}

}  // namespace

void CodeWriter::begin_block(ShortSpan block) {
  numbers_used_ = texts_used_ = frames_used_ = 0;
  first_step_ = program_.ops.size();
  emit(OpCode::Block, {}, {}, {}, block);
}

std::int32_t CodeWriter::emit(OpCode code, Operand result, Operand a, Operand b, ShortSpan where) {
  program_.ops.push_back({code, 0, 0, result, a, b});
  program_.spans.push_back(where);
  return here() - 1;
}

void CodeWriter::cut(std::size_t first_step) {
  program_.ops.resize(first_step);
  program_.spans.resize(first_step);
}

Operand CodeWriter::number_constant(double value) {
  program_.constants.push_back(value);
  return last_of(program_.constants);
}

Operand CodeWriter::text_constant(std::string value) {
  program_.text_constants.push_back(std::move(value));
  return last_of(program_.text_constants);
}

Operand CodeWriter::error_constant(BlockError error) {
  program_.errors.push_back(std::move(error));
  return last_of(program_.errors);
}

std::optional<Operand> CodeWriter::temporary(Type type) {
  std::int32_t& used = type == Type::String  ? texts_used_
                       : type == Type::Frame ? frames_used_
                                             : numbers_used_;
  return used < kTemporaryCount ? std::optional(Operand{Bank::Temporaries, used++}) : std::nullopt;
}

}  // namespace g31::sinumerik
