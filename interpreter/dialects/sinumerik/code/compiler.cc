#include "interpreter/dialects/sinumerik/code/compiler.h"

#include <algorithm>

#include "interpreter/source/printable.h"

namespace g31::sinumerik {
namespace {

constexpr std::int32_t kMostTemporaries = kTemporaryCount;

std::int32_t size_of(const auto& list) {
  return static_cast<std::int32_t>(list.size());
}

}  // namespace

void Compiler::block(ShortSpan span) {
  scanner_.scan(span, tokens_);
  if (tokens_.size() == 1) {
    return;
  }
  if (std::ranges::any_of(tokens_, [this](const Token& token) { return may_be_macro(token); })) {
    expand_macros();
    if (tokens_.size() == 1) {
      return;  // a macro that stands for nothing
    }
  }
  if (has_letter_names_) {
    find_letter_names();
  }
  begin_block({tokens_.front().where.begin, tokens_[tokens_.size() - 2].where.end});
  block_head();
  statement();
  if (failed()) {
    program_->has_wrong_proc = program_->has_wrong_proc || (is_first_block_ && program_->has_proc);
    program_->ops[first_step_].code = OpCode::Block;  // whatever words it had
    raise_from(first_step_ + 1);
  }
  end_block();
}

void Compiler::begin_block(ShortSpan block) {
  at_ = 0;
  definitions_in_block_ = 0;
  error_.reset();
  number_temporaries_ = text_temporaries_ = frame_temporaries_ = 0;
  block_ = block;
  first_step_ = program_->ops.size();
  emit(OpCode::Block, {}, {}, {}, block_);
}

void Compiler::end_block() {
  program_->ops[first_step_].a.place = here();
  is_first_block_ = false;
}

/// What the block has left so far is worth nothing.
void Compiler::take_back(std::size_t first_step) {
  program_->ops.resize(first_step);
  program_->spans.resize(first_step);
  std::erase_if(jumps_, [&](const JumpToLabel& jump) {
    return static_cast<std::size_t>(jump.step) >= first_step;
  });
  program_->codes.resize(nc_.first_code);
  program_->words.resize(nc_.first_word);
  has_words_ = false;
  ends_with_ = OpCode::Move;
}

/// The alarm takes the place of the block's steps.
void Compiler::raise_from(std::size_t first_step) {
  take_back(first_step);
  emit(OpCode::Raise, {}, error_constant(*error_), {}, error_where_);
}

void Compiler::block_head() {
  if (accept(Symbol::Slash)) {
    double level = 0.0;
    if (peek().kind == TokenKind::Integer) {
      level = next().number;
    }
    if (!(level >= 0.0 && level <= 9.0)) {
      fail(AlarmId::BadSkipLevel, block_);
      return;
    }
    last().detail = static_cast<std::uint8_t>(1.0 + level);
  }
  label_or_number();
}

void Compiler::label_or_number() {
  const bool numbered = peek().is_letter('N') && peek(1).kind == TokenKind::Integer;
  const bool main = peek().is(Symbol::Colon) && peek(1).kind == TokenKind::Integer;
  if (numbered || main) {
    next();
    program_->block_numbers.push_back({static_cast<std::int32_t>(next().number), here() - 1});
  }
  const bool is_label =
      peek(1).is(Symbol::Colon) || (peek().kind == TokenKind::Letter && peek(2).is(Symbol::Colon));
  if (is_label) {
    if (const auto name = label_name()) {
      program_->labels[*name].push_back(here() - 1);
    }
    expect(Symbol::Colon);
  }
}

void Compiler::statement() {
  while (!failed() && peek().kind != TokenKind::End) {
    const int before = definitions_in_block_;
    item();
    in_program_part_ = in_program_part_ || definitions_in_block_ == before;
  }
  if (!failed()) {
    finish_words();
  }
}

/// One statement, assignment, word or call; most blocks have one, or words only.
void Compiler::item() {
  const Token& token = peek();
  if (token.kind == TokenKind::Letter) {
    letter_item();
    return;
  }
  if (token.kind != TokenKind::Name) {
    fail(AlarmId::SyntaxInText, text_of(token.where));
    return;
  }
  if (purpose_ == Purpose::Data && (token.is_name("METRIC"))) {
    next();  // the lengths of the file, as those of the basic system
    return;
  }
  if (const Handler handler = find_keyword(token.text)) {
    next();
    (this->*handler)();
    return;
  }
  if (const auto id = find_procedure(token.text)) {
    procedure(*id, next().where);
    return;
  }
  if (!program_->locals.contains(token.text) && named_word()) {
    return;
  }
  const Token name = next();
  if (const std::int32_t variable = find_variable(name.text); variable >= 0) {
    assign_variable(variable, name.where);
  } else if (const auto system = find_system_variable(name.text)) {
    assign_system(*system, name.where);
  } else if (purpose_ == Purpose::Data && name.text.starts_with('$')) {
    pass_over(name);
  } else if (peek().is(Symbol::Assign) || peek().is(Symbol::LeftBracket)) {
    fail(AlarmId::NotDefined, name.where, name.text);
  } else {
    call_by_name(std::string(name.text), name.where);
  }
}

void Compiler::finish_words() {
  if (has_words_) {
    emit_nc_block();
  }
  if (ends_with_ != OpCode::Move) {
    emit(ends_with_, {}, {}, {}, block_);
    ends_with_ = OpCode::Move;
  }
}

void Compiler::emit_nc_block() {
  if (purpose_ == Purpose::Definitions) {
    fail(AlarmId::BadDefinition, block_, "a definition file may hold definitions only");
    return;
  }
  const Operand block = {Bank::Constants, size_of(program_->nc_blocks)};
  nc_.code_count = static_cast<std::uint16_t>(program_->codes.size() - nc_.first_code);
  nc_.word_count = static_cast<std::uint16_t>(program_->words.size() - nc_.first_word);
  program_->nc_blocks.push_back(nc_);
  nc_.first_code = static_cast<std::uint32_t>(program_->codes.size());
  nc_.first_word = static_cast<std::uint32_t>(program_->words.size());
  has_words_ = false;
  if (program_->ops.size() == first_step_ + 1) {
    last().code = OpCode::NcBlock;
    last().b = block;
  } else {
    emit(OpCode::Execute, {}, {}, block, block_);
  }
}

bool Compiler::may_be_macro(const Token& token) const {
  return (token.kind == TokenKind::Name || token.kind == TokenKind::Letter) &&
         (macros_.have_initial(token.text.front()) ||
          globals_.macros.have_initial(token.text.front()));
}

/// Names that DEFINE has made are replaced once: what stands in their place is taken as it is.
void Compiler::expand_macros() {
  std::vector<Token> all;
  for (std::size_t i = 0; i < tokens_.size(); ++i) {
    std::string name(tokens_[i].text);
    std::size_t used = 1;
    if (tokens_[i].kind == TokenKind::Letter && tokens_[i + 1].kind == TokenKind::Integer) {
      name += tokens_[i + 1].text;
      used = 2;
    }
    const bool is_name = tokens_[i].kind == TokenKind::Name || used == 2;
    const bool is_being_defined = i > 0 && tokens_[i - 1].is_name("DEFINE");
    const Macro* const own = macros_.find(name);
    const Macro* const macro = own != nullptr ? own : globals_.macros.find(name);
    if (!is_name || is_being_defined || macro == nullptr) {
      all.push_back(tokens_[i]);
      continue;
    }
    const ShortSpan where = tokens_[i].where;
    for (Token token : macro->tokens) {
      token.where = where;
      all.push_back(token);
    }
    i += used - 1;
  }
  tokens_ = std::move(all);
}

/// A letter that DEF or PROC took as a name is one, unless a number follows it; a letter and a
/// number are, where they are defined together.
void Compiler::find_letter_names() {
  for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) {
    const bool numbered =
        tokens_[i + 1].kind == TokenKind::Integer || tokens_[i + 1].kind == TokenKind::Real;
    if (tokens_[i].kind == TokenKind::Letter && tokens_[i + 1].kind == TokenKind::Integer) {
      const auto known =
          program_->locals.find(std::string(tokens_[i].text) + std::string(tokens_[i + 1].text));
      if (known != program_->locals.end()) {
        tokens_[i].kind = TokenKind::Name;
        tokens_[i].text = known->first;
        tokens_[i].where.end = tokens_[i + 1].where.end;
        tokens_.erase(tokens_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
        continue;
      }
    }
    if (tokens_[i].kind == TokenKind::Letter && !numbered &&
        program_->locals.contains(tokens_[i].text)) {
      tokens_[i].kind = TokenKind::Name;
    }
  }
}

const Token& Compiler::peek(std::size_t ahead) const {
  return tokens_[std::min(at_ + ahead, tokens_.size() - 1)];
}

const Token& Compiler::next() {
  const Token& token = peek();
  at_ = std::min(at_ + 1, tokens_.size() - 1);
  return token;
}

bool Compiler::accept(Symbol symbol) {
  const bool found = peek().is(symbol);
  at_ += found ? 1 : 0;
  return found;
}

bool Compiler::accept_name(std::string_view name) {
  const bool found = peek().is_name(name);
  at_ += found ? 1 : 0;
  return found;
}

void Compiler::expect(Symbol symbol) {
  if (!accept(symbol)) {
    fail(AlarmId::SyntaxInText, text_of(peek().where));
  }
}

void Compiler::expect_end() {
  if (peek().kind != TokenKind::End) {
    fail(AlarmId::SyntaxInText, text_of(peek().where));
  }
}

/// The first thing wrong in a block is the one that counts.
void Compiler::fail(AlarmId id, ShortSpan where, std::string_view detail) {
  if (!error_) {
    error_ = BlockError{id, std::string(detail)};
    error_where_ = where.end > where.begin ? where : block_;
  }
}

std::string Compiler::text_of(ShortSpan where) const {
  return where.end > where.begin
             ? source::printable(text_.substr(where.begin, where.end - where.begin))
             : std::string("the end of the block");
}

std::int32_t Compiler::emit(OpCode code, Operand result, Operand a, Operand b, ShortSpan where) {
  program_->ops.push_back({code, 0, 0, result, a, b});
  program_->spans.push_back(where);
  return here() - 1;
}

std::int32_t Compiler::here() const {
  return size_of(program_->ops);
}

Operand Compiler::number_constant(double value) {
  program_->constants.push_back(value);
  return {Bank::Constants, size_of(program_->constants) - 1};
}

Operand Compiler::error_constant(BlockError error) {
  program_->errors.push_back(std::move(error));
  return {Bank::Constants, size_of(program_->errors) - 1};
}

Operand Compiler::text_constant(std::string value) {
  program_->text_constants.push_back(std::move(value));
  return {Bank::Constants, size_of(program_->text_constants) - 1};
}

Operand Compiler::temporary(Type type) {
  std::int32_t& used = type == Type::String  ? text_temporaries_
                       : type == Type::Frame ? frame_temporaries_
                                             : number_temporaries_;
  if (used == kMostTemporaries) {
    fail(AlarmId::TooComplex, block_);
    return {Bank::Temporaries, 0};
  }
  return {Bank::Temporaries, used++};
}

void Compiler::set_target(std::int32_t jump, std::int32_t target) {
  if (jump >= 0) {
    Op& op = program_->ops[static_cast<std::size_t>(jump)];
    // Of a block that is wrong its alarm stays, behind its first step.
    const std::int32_t alarm = static_cast<std::int32_t>(first_step_) + 1;
    (op.code == OpCode::Jump ? op.a : op.b).place = failed() ? alarm : target;
  }
}

}  // namespace g31::sinumerik
