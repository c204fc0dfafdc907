#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/code/word_compiler.h"
#include "interpreter/dialects/sinumerik/code/word_limits.h"

namespace g31::sinumerik {
namespace {

constexpr double kSpindle = 1.0;
/// What a word without a number is of: S, M3, SPOS, also S[0] and SPOS[0].
constexpr double kMasterSpindle = 0.0;

constexpr Address kPlaces[] = {Address::AxisU,   Address::AxisV,   Address::AxisW,
                               Address::CentreX, Address::CentreY, Address::CentreZ,
                               Address::MiddleX, Address::MiddleY, Address::MiddleZ};
constexpr Address kOtherPlaces[] = {Address::Spindle, Address::SpindleAsync, Address::PolarAngle,
                                    Address::PolarRadius, Address::ToolWay};

/// Whether the value of an address may stand in AC and the like: DAC and its kind say places of
/// axes and of centres only.
bool is_modifiable(Address address, Modification modification) {
  if (modification == Modification::Quick) {
    return false;
  }
  const bool is_place =
      index_of(address) < kAxisCount || std::ranges::find(kPlaces, address) != std::end(kPlaces);
  return is_place || (!says_across(modification) &&
                      std::ranges::find(kOtherPlaces, address) != std::end(kOtherPlaces));
}

}  // namespace

bool WordCompiler::is_assigned(std::size_t ahead) const {
  return cursor_.peek(ahead).is(Symbol::Assign);
}

/// S2=, M[n]=, T[1]=: what follows a letter that may name its spindle.
/// @returns false: it is the master spindle, as without a number
bool WordCompiler::word_of_another_spindle(const Token& letter, double extension) {
  const Expr spindle = extension != kMasterSpindle
                           ? operations_.constant(Type::Int, extension, letter.where)
                           : bracketed_spindle();
  if (is_master_spindle(spindle) || (letter.is_letter('T') && is_number(spindle, kSpindle))) {
    return false;
  }
  if (!letter.is_letter('T')) {
    spindle_word(letter.is_letter('M') ? Address::Machine : Address::Speed, spindle, letter.where);
    return true;
  }
  if (extension != kMasterSpindle) {
    fail(AlarmId::NoSuchAddress, letter.where, text_of(letter.where));
  }
  code_.emit(OpCode::CheckSpindle, {}, spindle.value, {}, letter.where);
  return false;
}

void WordCompiler::letter_word(const Token& letter) {
  const bool numbered =
      cursor_.peek().kind == TokenKind::Integer || cursor_.peek().kind == TokenKind::Real;
  if (letter.is_letter('G')) {
    if (cursor_.peek().kind == TokenKind::Real) {
      const ShortSpan whole{letter.where.begin, cursor_.peek().where.end};
      fail(AlarmId::UnknownGCode, whole, text_of(whole));
      return;
    }
    if (cursor_.accept(Symbol::LeftBracket)) {
      code_of_group(letter.where);
      return;
    }
    if (cursor_.peek().kind != TokenKind::Integer) {
      fail(AlarmId::NotImplemented, letter.where, "G with a computed number");
      return;
    }
    const Token& number = cursor_.next();
    g_code(find_g_code(number.number), {letter.where.begin, number.where.end});
    return;
  }
  std::string name(letter.text);
  double extension = kMasterSpindle;
  // I1=, C3=, S1=, M2=: a number belongs to the address where = follows.
  if (numbered && is_assigned(1)) {
    const Token number = cursor_.next();
    name += number.text;
    extension = number.number;
  }
  const bool of_spindle = letter.is_letter('M') || letter.is_letter('S') || letter.is_letter('T');
  if (of_spindle && (extension != kMasterSpindle || cursor_.peek().is(Symbol::LeftBracket)) &&
      word_of_another_spindle(letter, extension)) {
    return;
  }
  if (letter.is_letter('M')) {
    m_word(letter.where);
    return;
  }
  if (const int axis = globals_.axis(name); axis >= 0) {
    word(address_of_axis(axis), letter.where);
    return;
  }
  const bool is_plain = of_spindle || letter.is_letter('H');
  const auto address = find_address(is_plain ? letter.text : name);
  if (!address) {
    fail(AlarmId::NoSuchAddress, letter.where, name);
    return;
  }
  word(*address, letter.where);
}

/// G[group]=number: as $P_GG shows it.
void WordCompiler::code_of_group(ShortSpan where) {
  const Expr group = operations_.convert(expressions_.expression(), Type::Int, AlarmId::IndexType);
  expect(Symbol::RightBracket);
  expect(Symbol::Assign);
  const Expr number =
      operations_.convert(expressions_.expression(), Type::Int, AlarmId::BadArguments);
  if (failed()) {
    return;
  }
  if (group.is_constant && number.is_constant) {
    g_code(find_g_code(number_of(group), number_of(number)), where);
    return;
  }
  code_.emit(OpCode::GroupCode, {}, group.value, number.value, where);
  nc_.add_computed();
}

void WordCompiler::g_code(std::optional<FoundCode> code, ShortSpan where) {
  if (!code) {
    fail(AlarmId::UnknownGCode, where, text_of(where));
    return;
  }
  const GCode& row = g_codes()[code->row];
  if (row.action == GAction::Refused) {
    fail(AlarmId::NotImplemented, where, std::string(row.name) + ", " + std::string(row.text));
    return;
  }
  if (!nc_.add(*code)) {
    fail(AlarmId::SameGroup, where, text_of(where));
  }
}

/// M2, M17 and M30 end the program behind everything else in their block.
void WordCompiler::m_word(ShortSpan where) {
  if (cursor_.peek().kind == TokenKind::Integer) {
    m_number(cursor_.next().number, where);
    return;
  }
  Modification modification = Modification::None;
  const Expr value =
      operations_.convert(word_value(modification), Type::Int, AlarmId::BadArguments);
  if (modification != Modification::None && modification != Modification::Quick) {
    fail(AlarmId::BadModification, where, text_of(where));
  }
  if (failed()) {
    return;
  }
  if (value.is_constant) {
    m_number(number_of(value), where);
    return;
  }
  Expr number = value;
  number.where = where;
  emit_word(Address::Machine, Modification::None, number);
}

void WordCompiler::m_number(double number, ShortSpan where) {
  if (number == 2.0 || number == 17.0 || number == 30.0) {
    nc_.end_with(number == 17.0 ? OpCode::Return : OpCode::EndProgram);
  } else {
    constant_word(Address::Machine, number, where);
  }
}

/// A number at once behind an address, perhaps with a sign.
std::optional<double> WordCompiler::number_at_once() {
  const bool negative = cursor_.peek().is(Symbol::Minus);
  const bool is_signed = negative || cursor_.peek().is(Symbol::Plus);
  const Token& number = cursor_.peek(is_signed ? 1 : 0);
  if (number.kind != TokenKind::Integer && number.kind != TokenKind::Real) {
    return std::nullopt;
  }
  cursor_.skip_if(true, is_signed ? 2 : 1);
  return negative ? -number.number : number.number;
}

void WordCompiler::constant_word(Address address, double value, ShortSpan where) {
  if (!nc_.add(address, value)) {
    fail(most_in_block(address) > 1 ? AlarmId::AddressTooOften : AlarmId::AddressRepeated, where,
         name_of(address));
  }
}

/// What stands behind an address: a number at once, or = and an expression.
Expr WordCompiler::word_value(Modification& modification) {
  const bool assigned = cursor_.accept(Symbol::Assign);
  if (!assigned) {
    const bool signed_number = cursor_.peek().is(Symbol::Minus) || cursor_.peek().is(Symbol::Plus);
    const Token& number = cursor_.peek(signed_number ? 1 : 0);
    if (number.kind != TokenKind::Integer && number.kind != TokenKind::Real) {
      fail(AlarmId::SyntaxInText, cursor_.peek().where, text_of(cursor_.peek().where));
      return {};
    }
    return expressions_.unary();
  }
  const Token name = cursor_.peek();
  const auto found = name.kind == TokenKind::Name && cursor_.peek(1).is(Symbol::LeftParen)
                         ? find_modification(name.text)
                         : std::nullopt;
  if (!found) {
    return expressions_.expression();
  }
  cursor_.next();
  modification = *found;
  expect(Symbol::LeftParen);
  Expr value = expressions_.expression();
  expect(Symbol::RightParen);
  return value;
}

void WordCompiler::word(Address address, ShortSpan where) {
  if (const auto number = number_at_once()) {
    constant_word(address, *number, where);
    return;
  }
  Modification modification = Modification::None;
  Expr value = word_value(modification);
  if (failed()) {
    return;
  }
  const bool may_be_text = address == Address::Tool && value.type == Type::String;
  const bool is_quick = modification == Modification::Quick &&
                        (address == Address::Auxiliary || address == Address::Speed);
  modification = is_quick ? Modification::None : modification;
  if (modification != Modification::None && !is_modifiable(address, modification)) {
    fail(AlarmId::BadModification, where, text_of(where));
    return;
  }
  if (!may_be_text) {
    value = operations_.convert(std::move(value), Type::Real, AlarmId::BadArguments);
  }
  value.where = where;
  emit_word(address, modification, value);
}

void WordCompiler::emit_word(Address address, Modification modification, const Expr& value) {
  code_.emit(value.type == Type::String ? OpCode::TextWord : OpCode::Word, {}, value.value, {},
             value.where);
  code_.last().detail = detail_of(address);
  code_.last().count = static_cast<std::uint16_t>(modification);
  nc_.add_computed();
}

/// X, AX1, a variable of type AXIS; where a setting is of the spindle, too, S, S1 or SPI(1).
Expr WordCompiler::bracketed_axis(const AxisWordInfo& row) {
  expect(Symbol::LeftBracket);
  const Token name = cursor_.peek();
  const bool by_function = name.is_name("SPI");
  const bool of_spindle = takes_spindle(row.role) && (name.is_letter('S') || by_function);
  Expr axis;
  if (of_spindle) {
    cursor_.next();
    if (by_function) {
      expect(Symbol::LeftParen);
    }
    const double number =
        cursor_.peek().kind == TokenKind::Integer ? cursor_.next().number : kSpindle;
    if (number != kSpindle) {
      fail(AlarmId::NoSuchAddress, name.where, text_of(name.where));
    }
    if (by_function) {
      expect(Symbol::RightParen);
    }
    axis = operations_.constant(Type::Axis, kSpindleAxis, name.where);
  } else {
    axis = accesses_.axis_operand();
  }
  expect(Symbol::RightBracket);
  return axis;
}

/// AX[axis]=value, POS[axis]=value, FA[axis]=value, FINEA[axis]
void WordCompiler::axis_word(const AxisWordInfo& row) {
  const ShortSpan where = cursor_.next().where;
  if (row.role == AxisRole::Refused) {
    fail(AlarmId::NotImplemented, where, std::string(row.name) + ": " + std::string(row.text));
    return;
  }
  const Expr axis = bracketed_axis(row);
  if (row.role == AxisRole::Measuring) {
    axis_measuring(row, axis, where);
    return;
  }
  if (cursor_.peek().is(Symbol::Assign) == is_switch(row.role)) {
    fail(AlarmId::SyntaxInText, cursor_.peek().where, text_of(cursor_.peek().where));
    return;
  }
  Modification modification = Modification::None;
  const Expr value = is_switch(row.role) ? operations_.constant(Type::Real, row.least, where)
                                         : operations_.convert(word_value(modification), Type::Real,
                                                               AlarmId::BadArguments);
  const bool is_place = row.role == AxisRole::Path || row.role == AxisRole::Positioning;
  if (modification == Modification::Quick || (modification != Modification::None && !is_place)) {
    fail(AlarmId::BadModification, where, row.name);
  }
  code_.emit(OpCode::AxisWord, {}, axis.value, value.value, where);
  code_.last().detail = detail_of(row.id);
  code_.last().count = static_cast<std::uint16_t>(modification);
  nc_.add_computed();
}

/// One number of MEASA[axis]=(...).
Expr WordCompiler::measuring_number() {
  return operations_.convert(expressions_.expression(), Type::Int, AlarmId::BadArguments);
}

/// MEASA[axis]=(mode, trigger), MEAWA[axis]=(mode, trigger); MEASA with a second trigger, too.  A
/// mode alone breaks off: without a trigger nothing can be measured.
void WordCompiler::axis_measuring(const AxisWordInfo& row, const Expr& axis, ShortSpan where) {
  expect(Symbol::Assign);
  expect(Symbol::LeftParen);
  const Expr mode = measuring_number();
  const bool must_measure = mode.is_constant && measures(number_of(mode));
  const bool is_alone = !must_measure && cursor_.peek().is(Symbol::RightParen);
  if (!is_alone) {
    expect(Symbol::Comma);
  }
  const Expr trigger = is_alone ? operations_.constant(Type::Int, 0.0, where) : measuring_number();
  const bool goes_on = row.id == AxisWordId::MeasureAxesOn;
  code_.emit(OpCode::AxisMeasuring, mode.value, axis.value, trigger.value, where);
  code_.last().detail = goes_on ? 1 : 0;
  if (cursor_.peek().is(Symbol::Comma) && !goes_on) {
    expect(Symbol::Comma);
    const Expr second = measuring_number();
    code_.emit(OpCode::AxisMeasuring, mode.value, axis.value, second.value, where);
    code_.last().detail = kSecondTrigger;
  }
  if (cursor_.peek().is(Symbol::Comma)) {
    fail(AlarmId::NotImplemented, where,
         fmt::format("{} with more than {}", row.name, goes_on ? "one trigger" : "two triggers"));
  }
  expect(Symbol::RightParen);
  nc_.add_computed();
}

/// [n] behind M, S, T, SPOS, SPOSA or LIMS; = follows.
Expr WordCompiler::bracketed_spindle() {
  expect(Symbol::LeftBracket);
  Expr number = operations_.convert(expressions_.expression(), Type::Int, AlarmId::IndexType);
  expect(Symbol::RightBracket);
  if (!failed() && !is_assigned(0)) {
    fail(AlarmId::SyntaxInText, cursor_.peek().where, text_of(cursor_.peek().where));
  }
  return number;
}

/// Whether an expression is known to be a number.
bool WordCompiler::is_number(const Expr& spindle, double number) const {
  return spindle.is_constant && number_of(spindle) == number;
}

bool WordCompiler::is_master_spindle(const Expr& spindle) const {
  return is_number(spindle, kMasterSpindle);
}

/// S2=500, M[n]=3, SPOS[2]=90
void WordCompiler::spindle_word(Address address, const Expr& spindle, ShortSpan where) {
  Modification modification = Modification::None;
  const Expr value =
      operations_.convert(word_value(modification), Type::Real, AlarmId::BadArguments);
  code_.emit(OpCode::SpindleWord, {}, spindle.value, value.value, where);
  code_.last().detail = detail_of(address);
  code_.last().count = static_cast<std::uint16_t>(modification);
  nc_.add_computed();
}

bool WordCompiler::named_word() {
  const Token name = cursor_.peek();
  const AxisWordInfo* const of_axis =
      cursor_.peek(1).is(Symbol::LeftBracket) ? find_axis_word(name.text) : nullptr;
  if (of_axis != nullptr) {
    axis_word(*of_axis);
    return true;
  }
  if (const auto code = find_g_code(name.text)) {
    cursor_.next();
    g_code(code, name.where);
    return true;
  }
  if (const int axis = globals_.axis(name.text); axis >= 0 && is_assigned(1)) {
    cursor_.next();
    word(address_of_axis(axis), name.where);
    return true;
  }
  const auto address = find_address(name.text);
  const bool of_spindle =
      address && (*address == Address::Spindle || *address == Address::SpindleAsync ||
                  *address == Address::SpeedLimit);
  const bool indexed = of_spindle && cursor_.peek(1).is(Symbol::LeftBracket);
  if (!address || (!is_assigned(1) && !indexed && cursor_.peek(1).kind != TokenKind::End)) {
    return false;
  }
  cursor_.next();
  const Expr spindle =
      indexed ? bracketed_spindle() : operations_.constant(Type::Int, kMasterSpindle, name.where);
  if (is_master_spindle(spindle)) {
    word(*address, name.where);
  } else {
    spindle_word(*address, spindle, name.where);
  }
  return true;
}

void WordCompiler::finish_block() {
  if (nc_.has_words() && purpose_ == Purpose::Definitions) {
    fail(AlarmId::BadDefinition, block(), "a definition file may hold definitions only");
    return;
  }
  if (nc_.has_words()) {
    nc_.execute(block());
  }
  nc_.end(block());
}

}  // namespace g31::sinumerik
