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

/// A CHAR has no form of its own, and is read when the action is judged.
bool has_written_form(Type type) {
  return type == Type::Int || type == Type::Real || type == Type::Bool || type == Type::Axis ||
         type == Type::String;
}

/// Those from `first` on, of which the action will be made that stands in their place.
ActionSteps steps_from(const CompiledProgram& program, std::size_t first) {
  const auto begin = static_cast<std::ptrdiff_t>(first);
  return {static_cast<std::int32_t>(first),
          {program.ops.begin() + begin, program.ops.end()},
          {program.spans.begin() + begin, program.spans.end()}};
}

/// @param step  SynchronisedAction
void keep_steps(CompiledProgram& program, ActionSteps steps, std::int32_t step) {
  while (!program.actions.empty() && program.actions.back().step >= steps.step) {
    program.actions.pop_back();  // of a block that was given up
  }
  steps.step = step;
  program.actions.push_back(std::move(steps));
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
ActionStatements::Actions ActionStatements::action_list(ActionKind kind, bool is_timed) {
  Actions list;
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
    list.items.push_back({from, cursor_.place()});
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

/// Whether the value of a variable counts that it has when the control comes to the block, whatever
/// becomes of it: R, variables of programs and data that the preparation of blocks knows.  $R,
/// $AC_, $AA_ and what $$ stands before count when the action is judged.  Source: job planning 828D
/// 07/2010, synchronised actions, 10.3.1; 840D 03/2006, 10.3.8; for variables of programs by the
/// same rule.
bool ActionStatements::is_read_at_once(std::size_t place) {
  const Token& token = cursor_.at(place);
  const std::uint32_t at = token.where.begin;
  if (at > 0 && text_of({at - 1, at}) == "$") {
    return false;
  }
  if (token.is_letter('R')) {
    const Token& behind = cursor_.at(place + 1);
    return behind.kind == TokenKind::Integer || behind.is(Symbol::LeftBracket);
  }
  constexpr auto kPrepared =
      std::to_array<std::string_view>({"$P_", "$M", "$SN", "$SC", "$SA", "$TC_", "$O"});
  const auto is_prepared = [&](std::string_view begin) { return token.text.starts_with(begin); };
  return token.kind == TokenKind::Name &&
         (std::ranges::any_of(kPrepared, is_prepared) ||
          (!token.text.starts_with('$') && variables_.find(token.text) >= 0));
}

/// What is text already.
void ActionStatements::add_text(std::vector<Argument>& pieces, std::string text) {
  Argument piece;
  piece.form = Argument::Form::Whole;
  piece.type = Type::String;
  piece.value = code_.text_constant(std::move(text));
  pieces.push_back(piece);
}

/// The text of tokens, with values in the place of what is read at once.
void ActionStatements::add_pieces(std::vector<Argument>& pieces, std::size_t from, std::size_t to) {
  const std::size_t here = cursor_.place();
  std::size_t written = cursor_.at(from).where.begin;
  const auto write_to = [&](std::size_t end) {
    if (written < end) {
      add_text(pieces,
               text_of({static_cast<std::uint32_t>(written), static_cast<std::uint32_t>(end)}));
    }
  };
  for (std::size_t i = from; i < to;) {
    // All symbols of a macro stand where its name does: no text lies between them.
    if (i > from && cursor_.at(i).where.begin < cursor_.at(i - 1).where.end) {
      fail(AlarmId::NotImplemented, cursor_.at(i).where,
           text_of(cursor_.at(i).where) + ", a macro, in a synchronised action");
      break;
    }
    if (!is_read_at_once(i)) {
      ++i;
      continue;
    }
    cursor_.go_back_to(i);
    const Expr value = expressions_.primary();
    const std::size_t behind = std::max(cursor_.place(), i + 1);
    if (has_written_form(value.type) && !value.is_whole_array) {
      write_to(cursor_.at(i).where.begin);
      pieces.push_back(argument_of(value));
      pieces.back().form = Argument::Form::Value;
      written = cursor_.at(behind - 1).where.end;
    }
    i = behind;
  }
  write_to(cursor_.at(to - 1).where.end);
  cursor_.go_back_to(here);
}

/// What an item sets is no value, but the index of it is.
void ActionStatements::add_item(std::vector<Argument>& pieces, Actions::Range item) {
  bool sets = false;
  int depth = 0;
  for (std::size_t i = item.from; i < item.to; ++i) {
    depth += cursor_.at(i).is(Symbol::LeftBracket) || cursor_.at(i).is(Symbol::LeftParen) ? 1 : 0;
    depth -= cursor_.at(i).is(Symbol::RightBracket) || cursor_.at(i).is(Symbol::RightParen) ? 1 : 0;
    sets = sets || (depth == 0 && cursor_.at(i).is(Symbol::Assign));
  }
  if (sets) {
    add_text(pieces, text_of(cursor_.at(item.from).where));
  }
  add_pieces(pieces, item.from + (sets ? 1U : 0U), item.to);
  add_text(pieces, " ");
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
  Actions::Range condition = {};
  bool is_timed = false;
  if (has_condition) {
    (void)accept_unit();
    condition.from = cursor_.place();
    (void)operations_.boolean(expressions_.expression());
    if (failed()) {
      return;
    }
    condition.to = cursor_.place();
    is_timed = judge_condition(condition.from);
    if (!cursor_.accept_name("DO")) {
      fail(AlarmId::SyntaxInText, text_of(cursor_.peek().where));
    }
  }
  const Actions actions = action_list(row->kind, is_timed);
  if (failed()) {
    return;
  }
  // The steps were only tried: what they do is done when the action is.
  ActionSteps steps = steps_from(program_, first);
  code_.cut(first);
  nc_.take_back_words();
  std::vector<Argument> pieces;
  if (has_condition) {
    add_pieces(pieces, condition.from, condition.to);
  } else {
    add_text(pieces, "TRUE");
  }
  pieces.emplace_back();  // between both texts
  for (const Actions::Range& item : actions.items) {
    add_item(pieces, item);
  }
  if (failed()) {
    return;
  }
  keep_steps(program_, std::move(steps), code_.here());
  const std::uint32_t list = keep_arguments(pieces);
  code_.emit(OpCode::SynchronisedAction, {Bank::Constants, actions.deletes_distance ? 1 : 0},
             number.value, {Bank::Constants, static_cast<std::int32_t>(list)}, block());
  code_.last().detail = static_cast<std::uint8_t>(static_cast<int>(row->kind) * kActionScopes +
                                                  static_cast<int>(scope));
  code_.last().count = static_cast<std::uint16_t>(pieces.size());
}

}  // namespace g31::sinumerik
