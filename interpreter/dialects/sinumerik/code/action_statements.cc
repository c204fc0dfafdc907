#include "interpreter/dialects/sinumerik/code/action_statements.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "interpreter/dialects/sinumerik/vocabulary/words.h"

namespace g31::sinumerik {
namespace {

struct ActionWord {
  std::string_view name;
  ActionKind kind;
};
constexpr ActionWord kActionWords[] = {{"WHEN", ActionKind::Once},
                                       {"WHENEVER", ActionKind::While},
                                       {"FROM", ActionKind::From},
                                       {"EVERY", ActionKind::Edge},
                                       {"DO", ActionKind::Always}};

/// System variables that a condition may ask for although their kind changes within blocks.
constexpr auto kSteady = std::to_array<std::string_view>(
    {"$AC_MARKER", "$AC_PARAM", "$AC_TIMER", "$AC_MEA", "$AC_FIFO1"});

bool changes_within_blocks(std::string_view name) {
  const bool is_of_motion = name.starts_with("$AA_") || name.starts_with("$VA_") ||
                            name.starts_with("$AC_") || name == "$A_PROBE" || name == "$A_INA";
  return is_of_motion && std::ranges::find(kSteady, name) == kSteady.end();
}

/// What may be done beside assignments to variables, before or behind a block.
constexpr auto kActions = std::to_array<std::string_view>(
    {"SETAL", "LOCK", "UNLOCK", "RDISABLE", "POS", "FA", "$AC_TIMER", "$AC_OVR"});

constexpr std::string_view kWhatCan =
    "checked before and after each block: assignments, $AC_TIMER, $AC_OVR, M, H, S, SETAL, LOCK, "
    "UNLOCK, RDISABLE, POS, FA and DELDTG";

/// What makes a difference to the block itself, so that it matters when within it.
bool acts_on_motion(const Token& action) {
  return action.is_name("DELDTG") || action.is_name("POS") || action.is_name("$AC_OVR");
}

/// Keeps the steps from `first` on as those of the action that will stand there.
void keep_steps(CompiledProgram& program, std::size_t first) {
  const auto begin = static_cast<std::ptrdiff_t>(first);
  const auto step = static_cast<std::int32_t>(first);
  while (!program.actions.empty() && program.actions.back().step >= step) {
    program.actions.pop_back();  // of a block that was given up
  }
  program.actions.push_back({step,
                             {program.ops.begin() + begin, program.ops.end()},
                             {program.spans.begin() + begin, program.spans.end()}});
}

}  // namespace

/// Whether the condition of tokens `from` to the present one can be judged before and behind a
/// block.  @returns whether it waits for a time
bool ActionStatements::judge_condition(std::size_t from) {
  bool is_timed = false;
  for (std::size_t i = from; i < cursor_.place(); ++i) {
    const Token& token = cursor_.at(i);
    is_timed = is_timed || token.is_name("$AC_TIMER");
    if (token.kind == TokenKind::Name && changes_within_blocks(token.text)) {
      fail(AlarmId::NotImplemented, token.where,
           std::string(token.text) +
               ": it changes within blocks, where synchronised actions are not judged; MEAS, or "
               "WHEN $A_PROBE[n]==1 DO DELDTG, ends a move by a signal");
    }
  }
  return is_timed;
}

bool ActionStatements::may_act(const Token& action) {
  if (action.kind == TokenKind::Letter) {
    constexpr std::string_view kLetters = "RMHS";
    return kLetters.find(action.text.front()) != std::string_view::npos;
  }
  return std::ranges::find(kActions, action.text) != kActions.end() ||
         (action.kind == TokenKind::Name && !changes_within_blocks(action.text) &&
          (variables_.find(action.text) >= 0 || action.text.starts_with('$')));
}

/// G70, G71, G700 and G710 say what lengths count in: what may stand here has none but POS and FA.
bool ActionStatements::accept_unit() {
  constexpr double kUnits[] = {70.0, 71.0, 700.0, 710.0};
  const bool is_unit = cursor_.peek().is_letter('G') &&
                       cursor_.peek(1).kind == TokenKind::Integer &&
                       std::ranges::find(kUnits, cursor_.peek(1).number) != std::end(kUnits);
  cursor_.skip_if(is_unit, 2);
  return is_unit;
}

/// What stands behind DO, to the end of the block.
ActionStatements::ActionText ActionStatements::action_list(ActionKind kind, bool is_timed) {
  ActionText list;
  bool has_unit = false;
  while (!failed() && cursor_.peek().kind != TokenKind::End) {
    has_unit = accept_unit() || has_unit;
    const Token action = cursor_.peek();
    const std::size_t from = cursor_.place();
    if (has_unit && (action.is_name("POS") || action.is_name("FA"))) {
      fail(AlarmId::NotImplemented, action.where, "a unit of its own for POS and FA");
    } else if (is_timed && acts_on_motion(action)) {
      fail(AlarmId::NotImplemented, action.where,
           std::string(action.text) + " at a time within a block");
    } else if (action.is_name("DELDTG") && !cursor_.peek(1).is(Symbol::LeftParen)) {
      cursor_.next();
      list.deletes_distance = true;
      continue;
    } else if (action.is_name("DELDTG")) {
      fail(AlarmId::NotImplemented, action.where,
           "DELDTG of one axis: DELDTG alone ends the whole move");
    } else if (action.is_name("STOPREOF")) {
      cursor_.next();
      continue;
    } else if (!may_act(action)) {
      fail(AlarmId::NotImplemented, action.where,
           text_of(action.where) + " in a synchronised action, which is " + std::string(kWhatCan));
    } else {
      items_.item();
    }
    if (failed()) {
      break;
    }
    judge_action(from, kind, is_timed);
    list.text += text_of(cursor_.span_from(from)) + " ";
  }
  return list;
}

/// Each interpolation cycle is another time, which blocks do not see.
void ActionStatements::judge_action(std::size_t from, ActionKind kind, bool is_timed) {
  const bool is_repeated = kind != ActionKind::Once && kind != ActionKind::Edge;
  for (std::size_t i = from + 1; i < cursor_.place(); ++i) {
    const Token& token = cursor_.at(i);
    if (token.kind != TokenKind::Name) {
      continue;
    }
    if (is_repeated && token.text == cursor_.at(from).text) {
      fail(AlarmId::NotImplemented, token.where,
           std::string(token.text) + " counts interpolation cycles: WHEN or EVERY counts once");
    } else if (is_timed && changes_within_blocks(token.text)) {
      fail(AlarmId::NotImplemented, token.where,
           std::string(token.text) + " at a time within a block");
    }
  }
}

/// ID=n and IDS=n: the action holds beyond the next block.
void ActionStatements::numbered_action() {
  const bool is_static = cursor_.previous().text == "IDS";
  expect(Symbol::Assign);
  const Expr number = operations_.convert(expressions_.expression(), Type::Int);
  const Token word = cursor_.peek();
  if (!failed() && !number.is_constant) {
    fail(AlarmId::NotImplemented, block(), "ID= and IDS= with a computed number");
  }
  if (!failed()) {
    cursor_.next();
    synchronised_action(word.text, is_static ? ActionScope::Static : ActionScope::Modal, number);
  }
}

/// WHENEVER, FROM, EVERY and DO, in force for the next block.
void ActionStatements::action_statement() {
  synchronised_action(cursor_.previous().text, ActionScope::NextBlock, Expr());
}

/// The signal that ends a move: behind == or <>; without either 1.
Expr ActionStatements::level_asked_for() {
  const ShortSpan where = cursor_.peek().where;
  if (cursor_.accept(Symbol::Equal)) {
    return operations_.boolean(expressions_.expression());
  }
  if (!cursor_.accept(Symbol::NotEqual)) {
    return operations_.constant(Type::Bool, 1.0, where);
  }
  return operations_.compare(OpCode::Equal, operations_.boolean(expressions_.expression()),
                             operations_.constant(Type::Bool, 0.0, where), where);
}

/// WHEN $A_PROBE[n]==level DO DELDTG, the condition in brackets or not; another synchronised action
void ActionStatements::when_statement() {
  if (!cursor_.peek().is_name("$A_PROBE") && !cursor_.peek(1).is_name("$A_PROBE")) {
    action_statement();
    return;
  }
  const bool bracket = cursor_.accept(Symbol::LeftParen);
  const bool of_probe = cursor_.accept_name("$A_PROBE") && cursor_.accept(Symbol::LeftBracket);
  const Expr probe = of_probe ? operations_.convert(expressions_.expression(), Type::Int) : Expr();
  const bool is_named = of_probe && cursor_.accept(Symbol::RightBracket);
  const Expr level = is_named ? level_asked_for() : Expr();
  const bool closed = is_named && (!bracket || cursor_.accept(Symbol::RightParen));
  const bool deletes = closed && cursor_.accept_name("DO") && cursor_.accept_name("DELDTG") &&
                       cursor_.peek().kind == TokenKind::End;
  if (!deletes && !failed()) {
    reader_.refuse();
  }
  if (!failed()) {
    code_.emit(OpCode::SkipAction, {}, probe.value, level.value, block());
  }
}

/// A run tells what it does not do, for a program that asks for it counts on it.
void ActionStatements::interrupt_statement() {
  const auto row = std::ranges::find(keywords(), cursor_.previous().text, &KeywordInfo::name);
  reader_.pass_over();
  // The message says itself that it is not simulated.
  const std::string_view what = row->text.substr(0, row->text.find(", not simulated"));
  code_.emit(OpCode::TellNotSimulated, {},
             code_.text_constant(std::string(row->name) + ", " + std::string(what)), {}, block());
}

void ActionStatements::synchronised_action(std::string_view word, ActionScope scope,
                                           const Expr& number) {
  const auto row = std::ranges::find(kActionWords, word, &ActionWord::name);
  if (row == std::end(kActionWords)) {
    fail(AlarmId::SyntaxInText, word);
    return;
  }
  const std::size_t first = program_.ops.size();
  const bool has_condition = row->kind != ActionKind::Always;
  std::string condition = "TRUE";
  bool is_timed = false;
  if (has_condition) {
    (void)accept_unit();
    const std::size_t from = cursor_.place();
    (void)operations_.boolean(expressions_.expression());
    if (failed()) {
      return;
    }
    condition = text_of(cursor_.span_from(from));
    is_timed = judge_condition(from);
    if (!cursor_.accept_name("DO")) {
      fail(AlarmId::SyntaxInText, text_of(cursor_.peek().where));
    }
  }
  const ActionText actions = action_list(row->kind, is_timed);
  if (failed()) {
    return;
  }
  // The steps were only tried: what they do is done when the action is.
  keep_steps(program_, first);
  code_.cut(first);
  nc_.take_back_words();
  const auto text_argument = [&](std::string text) {
    Argument argument;
    argument.form = Argument::Form::Value;
    argument.type = Type::String;
    argument.value = code_.text_constant(std::move(text));
    return argument;
  };
  const std::uint32_t list =
      keep_arguments({text_argument(std::move(condition)), text_argument(actions.text)});
  code_.emit(OpCode::SynchronisedAction, {Bank::Constants, actions.deletes_distance ? 1 : 0},
             number.value, {Bank::Constants, static_cast<std::int32_t>(list)}, block());
  code_.last().detail = static_cast<std::uint8_t>(static_cast<int>(row->kind) * kActionScopes +
                                                  static_cast<int>(scope));
  code_.last().count = 2;
}

}  // namespace g31::sinumerik
