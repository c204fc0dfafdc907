#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/code/definitions.h"
#include "interpreter/dialects/sinumerik/vocabulary/constants.h"
#include "interpreter/dialects/sinumerik/vocabulary/g_codes.h"
#include "interpreter/dialects/sinumerik/vocabulary/operators.h"

namespace g31::sinumerik {
namespace {

/// A word that no variable can be called by; addresses are no such words: DEF INT I, F.
bool is_of_the_language(std::string_view name) {
  const bool is_operator =
      name == "NOT" || name == "B_NOT" ||
      std::ranges::any_of(operators(), [&](const OperatorInfo& row) { return row.name == name; });
  return is_operator || is_keyword(name) || find_function(name) || find_g_code(name) ||
         find_constant(name) != nullptr;
}

constexpr std::size_t kLongestName = 31;
constexpr std::int32_t kLongestString = 200;
constexpr int kLargestArray = 100'000;  // elements
/// MB for all variables of a program together, or of all definition files; a bound of g31.
constexpr std::size_t kMostMemory = 32;

/// The definition file of the control whose data programs of earlier software write and nothing
/// reads: writing anything but 0 is told.
constexpr std::string_view kKeptData = "GUD7_MC";

/// Access rights and the physical unit.
constexpr std::string_view kNumbered[] = {"APR", "APW", "APRP", "APWP", "APRB", "APWB", "PHU"};
constexpr std::string_view kDataClasses[] = {"DCM", "DCI", "DCU"};
constexpr std::string_view kAttributes[] = {"SAVE",   "DISPLOF",   "DISPLON", "SBLOF",
                                            "SBLON",  "ACTBLOCNO", "ICYCOF",  "ICYCON",
                                            "PREPRO", "IPTRLOCK"};
constexpr std::string_view kReadingAhead[] = {"SYNR", "SYNW", "SYNRW"};
/// When a variable takes its first value again.
constexpr std::string_view kInitialTimes[] = {"INIPO", "INIRE", "INICF", "PRLOC"};

bool contains(auto& list, std::string_view name) {
  for (const std::string_view known : list) {
    if (known == name) {
      return true;
    }
  }
  return false;
}

}  // namespace

/// A whole number that is known when compiling.
std::optional<std::int32_t> Definitions::whole_constant() {
  const Expr value = expressions_.expression();
  const double number = value.is_constant && is_number(value.type) ? number_of(value) : -1.0;
  if (!failed() && (number < 0.0 || number > kLargestArray || number != rounded(number))) {
    fail(AlarmId::BadArguments, value.where, text_of(value.where));
  }
  return failed() ? std::nullopt : std::optional(static_cast<std::int32_t>(number));
}

/// [n] behind STRING.
std::optional<std::int32_t> Definitions::string_length() {
  if (!cursor_.accept(Symbol::LeftBracket)) {
    return 1;
  }
  const auto length = whole_constant();
  expect(Symbol::RightBracket);
  if (length && *length > kLongestString) {
    fail(AlarmId::StringTooLong, block(), std::to_string(*length));
  }
  return length;
}

/// [a,b,c] behind a name; sizes may be left out where a parameter takes any array.
Shape Definitions::dimensions() {
  Shape shape;
  if (!cursor_.accept(Symbol::LeftBracket)) {
    return shape;
  }
  do {
    if (shape.dimensions == Shape::kMostDimensions) {
      fail(AlarmId::TooManyDimensions, cursor_.peek().where, text_of(cursor_.peek().where));
      return shape;
    }
    const auto at = static_cast<std::size_t>(shape.dimensions++);
    if (!cursor_.peek().is(Symbol::Comma) && !cursor_.peek().is(Symbol::RightBracket)) {
      shape.size[at] = whole_constant().value_or(1);
    }
  } while (!failed() && cursor_.accept(Symbol::Comma));
  expect(Symbol::RightBracket);
  const double elements = 1.0 * shape.size[0] * shape.size[1] * shape.size[2];
  if (elements > kLargestArray || elements < 1.0) {
    fail(AlarmId::ValueOutOfLimits, block(), "size of the array");
    shape = {};
  }
  return shape;
}

/// A type and, behind STRING, its length.
std::optional<Definitions::DeclaredType> Definitions::declared_type() {
  const Token word = cursor_.next();
  const auto type = word.kind == TokenKind::Name ? type_named(word.text) : std::nullopt;
  if (!type) {
    fail(AlarmId::SyntaxInText, word.where, text_of(word.where));
    return std::nullopt;
  }
  return DeclaredType{*type, *type == Type::String ? string_length().value_or(1) : 0};
}

/// Whether letters follow what has been read at once: D0_FAST begins with an address and its value.
bool Definitions::name_goes_on() const {
  const Token& next = cursor_.peek();
  return (next.kind == TokenKind::Name || next.kind == TokenKind::Letter) &&
         next.where.begin == cursor_.previous().where.end;
}

std::optional<Variable> Definitions::declared_variable(const DeclaredType& declared) {
  const Token name = cursor_.next();
  const bool is_letter = name.kind == TokenKind::Letter && !name.is_letter('R') &&
                         cursor_.peek().kind != TokenKind::Integer;
  // One letter and a number, such as L1: what is written elsewhere as L1 means the variable.
  const bool is_numbered = name.kind == TokenKind::Letter && !name.is_letter('R') && !is_letter;
  const std::string number(is_numbered ? cursor_.next().text : std::string_view());
  has_letter_names_ = has_letter_names_ || is_letter || is_numbered;
  if (name.kind != TokenKind::Name && !is_letter && !is_numbered) {
    fail(AlarmId::SyntaxInText, name.where, text_of(name.where));
  } else if (name.text.size() > kLongestName) {
    fail(AlarmId::NameTooLong, name.where, name.text);
  } else if (is_of_the_language(name.text) ||
             (is_numbered && (name.is_letter('G') || name.is_letter('M')))) {
    fail(AlarmId::DefinedTwice, name.where, std::string(name.text) + number);
  } else if (is_numbered && name_goes_on()) {
    const ShortSpan whole{name.where.begin, cursor_.peek().where.end};
    fail(AlarmId::SyntaxInText, whole,
         text_of(whole) + ", a name begins with two letters or underscores");
  }
  Variable variable;
  variable.name = std::string(name.text) + number;
  variable.type = declared.type;
  variable.longest = declared.longest;
  variable.shape = dimensions();
  return failed() ? std::nullopt : std::optional(variable);
}

/// What another definition file has defined in the same way: one's own archive holds what is
/// shipped with the cycles, too.  -1: nothing of the kind.
std::int32_t Definitions::defined_alike(const Variable& variable) {
  const Variable* const known = globals_.find(variable.name);
  const bool is_alike = known != nullptr && !variables_.is_imported(variable.name) &&
                        known->type == variable.type && known->shape == variable.shape &&
                        known->longest == variable.longest && !cursor_.peek().is(Symbol::Assign);
  return is_alike ? variables_.import(*known) : -1;
}

/// Alarm 12560 where a variable takes all of them together past their memory.
void Definitions::limit_memory(const Layout& layout, const Variable& variable) {
  if (layout.bytes() + Layout::bytes_of(variable.type, variable.shape.count()) >
      kMostMemory * 1'000'000) {
    fail(AlarmId::ValueOutOfLimits, block(),
         fmt::format("size of all variables together: {} MB at most", kMostMemory));
  }
}

std::int32_t Definitions::define(const Variable& variable) {
  const bool is_global = purpose_ == Purpose::Definitions;
  if (const std::int32_t known = is_global ? defined_alike(variable) : -1; known >= 0) {
    return known;
  }
  limit_memory(is_global ? defined_->layout() : program_.layout, variable);
  if (failed()) {
    return -1;
  }
  if (!is_global) {
    return variables_.define_local(variable);
  }
  const Variable* const global = defined_->define(variable);
  if (global == nullptr) {
    fail(AlarmId::DefinedTwice, block(), variable.name);
    return -1;
  }
  return variables_.import(*global);
}

/// Whether a file that comes with the control finds a name taken by one of the user, which counts:
/// a shop's own data, and archives of earlier software, have names that the cycles have, too.
bool Definitions::is_of_user(const std::string& name) const {
  return purpose_ == Purpose::Definitions && is_shipped_ && globals_.find(name) != nullptr &&
         !variables_.is_imported(name);
}

/// = value or = (list), up to the next variable.
void Definitions::pass_over_value() {
  for (int open = 0; cursor_.peek().kind != TokenKind::End; cursor_.next()) {
    if (open == 0 && cursor_.peek().is(Symbol::Comma)) {
      return;
    }
    open += cursor_.peek().is(Symbol::LeftParen)    ? 1
            : cursor_.peek().is(Symbol::RightParen) ? -1
                                                    : 0;
  }
}

void Definitions::define_with_value(const Variable& variable) {
  const std::int32_t index = define(variable);
  if (index < 0 || !cursor_.accept(Symbol::Assign)) {
    return;
  }
  const Variable& known = program_.variables[static_cast<std::size_t>(index)];
  Expr target = assignments_.target_of(index, block());
  target.element = code_.number_constant(0.0);
  target.is_constant = true;
  const bool is_list = known.shape.dimensions > 0 && cursor_.peek().is(Symbol::LeftParen);
  is_list ? assignments_.assign_list(target) : assignments_.assign_element(target);
}

/// A number, perhaps with a sign, that is known when compiling.
std::optional<double> Definitions::signed_constant() {
  const Expr value = expressions_.unary();
  if (!failed() && (!value.is_constant || !is_number(value.type))) {
    fail(AlarmId::BadArguments, value.where, text_of(value.where));
  }
  return failed() ? std::nullopt : std::optional(number_of(value));
}

/// What stands about the type.  Rights, classes and units change nothing at a desk.
Limits Definitions::definition_attributes() {
  Limits limits;
  while (!failed() && cursor_.peek().kind == TokenKind::Name) {
    if (contains(kReadingAhead, cursor_.peek().text) ||
        contains(kDataClasses, cursor_.peek().text) ||
        contains(kInitialTimes, cursor_.peek().text)) {
      cursor_.next();
    } else if (contains(kNumbered, cursor_.peek().text)) {
      cursor_.next();
      whole_constant();
    } else if (cursor_.accept_name("LLI")) {
      limits.low = signed_constant();
    } else if (cursor_.accept_name("ULI")) {
      limits.high = signed_constant();
    } else {
      break;
    }
  }
  return limits;
}

/// Definitions stand before the first block that does something.  @returns whether this one does
bool Definitions::begins_definition(std::string_view what) {
  ++in_block_;
  if (in_program_part_ && purpose_ != Purpose::Definitions) {
    fail(AlarmId::BadDefinition, block(), what);
  }
  return !failed();
}

void Definitions::def_statement() {
  if (!begins_definition("DEF")) {
    return;
  }
  const bool scoped = cursor_.accept_name("NCK") || cursor_.accept_name("CHAN");
  if (scoped && purpose_ != Purpose::Definitions) {
    fail(AlarmId::BadDefinition, block(), "NCK and CHAN are for definition files only");
  } else if (!scoped && purpose_ == Purpose::Definitions) {
    fail(AlarmId::BadDefinition, block(), "in a definition file NCK or CHAN stands behind DEF");
  }
  definition_attributes();
  const auto declared = declared_type();
  if (!declared) {
    return;
  }
  const Limits limits = definition_attributes();
  do {
    auto variable = declared_variable(*declared);
    if (variable && is_of_user(variable->name)) {
      pass_over_value();
    } else if (variable) {
      variable->limits = limits;
      if (is_shipped_ && program_.name == kKeptData && is_number(variable->type)) {
        variable->fixed = 0.0;
      }
      define_with_value(*variable);
    }
  } while (!failed() && cursor_.accept(Symbol::Comma));
  expect_end();
}

void Definitions::rights_statement() {
  ++in_block_;
  if (purpose_ != Purpose::Definitions) {
    fail(AlarmId::BadDefinition, block(), "access levels are for definition files only");
    return;
  }
  whole_constant();
}

void Definitions::define_statement() {
  ++in_block_;
  const Token& first = cursor_.next();
  const bool is_name = first.kind == TokenKind::Name || first.kind == TokenKind::Letter;
  std::string name(first.text);
  if (first.kind == TokenKind::Letter && cursor_.peek().kind == TokenKind::Integer) {
    name += cursor_.next().text;
  }
  if (!is_name || !cursor_.accept_name("AS")) {
    fail(AlarmId::SyntaxInText, cursor_.peek().where, text_of(cursor_.peek().where));
    return;
  }
  auto macro = std::make_shared<Macro>();
  while (cursor_.peek().kind != TokenKind::End) {
    Token token = cursor_.next();
    token.text = macro->spellings.emplace_back(token.text);
    macro->tokens.push_back(token);
  }
  if (!macros_behind().define(name, macro)) {
    fail(AlarmId::MacroTwice, block(), name);
  } else if (is_shipped_ && !is_of_user(name)) {
    defined_->offered_macros.define(name, std::move(macro));
  }
}

/// Where a DEFINE goes.
Macros& Definitions::macros_behind() {
  return purpose_ != Purpose::Definitions ? macros_
         : is_shipped_                    ? defined_->shipped_macros
                                          : defined_->macros;
}

void Definitions::proc_statement() {
  ++in_block_;
  if (!is_first_block_ || program_.has_proc || purpose_ == Purpose::Definitions) {
    fail(AlarmId::BadDefinition, block(), "PROC");
    return;
  }
  program_.has_proc = true;
  const Token name = cursor_.next();
  const bool is_l_number = name.is_letter('L') && cursor_.peek().kind == TokenKind::Integer;
  if (is_l_number) {
    cursor_.next();
  } else if (name.kind != TokenKind::Name) {
    fail(AlarmId::SyntaxInText, block(), "PROC and a name");
    return;
  }
  if (cursor_.accept(Symbol::LeftParen) && !cursor_.accept(Symbol::RightParen)) {
    do {
      proc_parameter();
    } while (!failed() && cursor_.accept(Symbol::Comma));
    expect(Symbol::RightParen);
  }
  proc_attributes();
}

void Definitions::proc_parameter() {
  Parameter parameter;
  parameter.by_reference = cursor_.accept_name("VAR");
  const auto declared = declared_type();
  if (!declared) {
    return;
  }
  auto variable = declared_variable(*declared);
  if (!variable) {
    return;
  }
  // An array is never copied: its parameter is the caller's array.
  const bool refers = parameter.by_reference || variable->shape.dimensions > 0;
  if (refers) {
    std::int32_t references = 0;
    for (const Parameter& known : program_.parameters) {
      references +=
          program_.variables[static_cast<std::size_t>(known.variable)].storage == Storage::Reference
              ? 1
              : 0;
    }
    variable->storage = Storage::Reference;
    variable->place = references;
    parameter.by_reference = true;
    parameter.variable = static_cast<std::int32_t>(program_.variables.size());
    if (!program_.locals.emplace(variable->name, parameter.variable).second) {
      fail(AlarmId::DefinedTwice, block(), variable->name);
    }
    program_.variables.push_back(*variable);
  } else {
    parameter.variable = variables_.define_local(*variable);
    if (cursor_.accept(Symbol::Assign)) {
      preset(parameter);
    }
  }
  if (!failed()) {
    program_.parameters.push_back(std::move(parameter));
  }
}

/// The value of a parameter that a call leaves out.
void Definitions::preset(Parameter& parameter) {
  if (failed()) {
    return;
  }
  // The value may name variables that the program has not had yet: they move the others.
  const Type type = program_.variables[static_cast<std::size_t>(parameter.variable)].type;
  Expr value = expressions_.unary();
  const bool is_text = value.is_constant && value.type == Type::String;
  if (is_text && type == Type::Char) {
    const std::string& text = program_.text_constants[static_cast<std::size_t>(value.value.place)];
    value = text.size() == 1
                ? expressions_.operations().constant(
                      Type::Char, static_cast<unsigned char>(text.front()), value.where)
                : value;
  }
  const bool same_kind = (value.type == Type::String) == (type == Type::String);
  if (!failed() && (!value.is_constant || !same_kind)) {
    fail(AlarmId::InitialValueType, value.where, text_of(value.where));
  }
  if (failed()) {
    return;
  }
  parameter.has_preset = true;
  if (value.type == Type::String) {
    parameter.text = program_.text_constants[static_cast<std::size_t>(value.value.place)];
  } else {
    parameter.number = number_of(value);
  }
}

void Definitions::proc_attributes() {
  while (!failed() && cursor_.peek().kind != TokenKind::End) {
    const Token attribute = cursor_.next();
    if (attribute.kind != TokenKind::Name || !contains(kAttributes, attribute.text)) {
      fail(AlarmId::AttributeNotAllowed, attribute.where, text_of(attribute.where));
    }
    program_.saves_codes = program_.saves_codes || attribute.text == "SAVE";
    program_.hides_blocks = program_.hides_blocks || attribute.text == "DISPLOF";
    program_.shows_actual_block = program_.shows_actual_block || attribute.text == "ACTBLOCNO";
  }
}

void Definitions::redef_statement() {
  while (!failed() && cursor_.peek().kind != TokenKind::End) {
    if (cursor_.peek().is_name("LLI") || cursor_.peek().is_name("ULI") ||
        cursor_.peek().is(Symbol::Assign)) {
      fail(AlarmId::NotImplemented, cursor_.peek().where, "REDEF with limits or a value");
    }
    cursor_.next();
  }
}

void Definitions::extern_statement() {
  if (!begins_definition("EXTERN")) {
    return;
  }
  while (cursor_.peek().kind != TokenKind::End) {
    cursor_.next();
  }
}

}  // namespace g31::sinumerik
