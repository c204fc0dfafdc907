#include "interpreter/analysis/sinumerik_accesses.h"

#include <algorithm>
#include <string>

#include "interpreter/dialects/sinumerik/vocabulary/system_variables.h"

namespace g31::analysis {

SinumerikAccesses::SinumerikAccesses(const sinumerik::CompiledProgram& program)
    : program_(program) {
  for (std::size_t i = 0; i < program.variables.size(); ++i) {
    const sinumerik::Variable& variable = program.variables[i];
    const bool is_global = variable.storage == sinumerik::Storage::Global;
    if (is_global || variable.storage == sinumerik::Storage::Local) {
      const auto bank = is_global ? sinumerik::Bank::Globals : sinumerik::Bank::Locals;
      by_place_.emplace(Place{list_of(variable.type), bank, variable.place}, i);
    }
  }
}

SinumerikAccesses::List SinumerikAccesses::list_of(sinumerik::Type type) {
  return type == sinumerik::Type::String  ? List::Texts
         : type == sinumerik::Type::Frame ? List::Frames
                                          : List::Numbers;
}

/// Where a step's own operands stand.  Most are numbers; what is none of the program's variables
/// stands among constants and temporaries, which nobody asks for.
SinumerikAccesses::Operands SinumerikAccesses::operands_of(sinumerik::OpCode code) {
  using sinumerik::OpCode;
  struct Row {
    OpCode code;
    Operands operands;
  };
  constexpr List kNo = List::None;
  constexpr List kNumber = List::Numbers;
  constexpr List kText = List::Texts;
  constexpr List kFrame = List::Frames;
  constexpr Row kRows[] = {
      {OpCode::MoveText, {kText, kText, kText}},
      {OpCode::Concatenate, {kText, kText, kText}},
      {OpCode::EqualText, {kNumber, kText, kText}},
      {OpCode::LessText, {kNumber, kText, kText}},
      {OpCode::NumberToText, {kText, kNumber, kNo}},
      {OpCode::TextToNumber, {kNumber, kText, kNo}},
      {OpCode::TextWord, {kNo, kText, kNo}},
      {OpCode::JumpText, {kNo, kText, kNo}},
      {OpCode::RepeatText, {kNo, kText, kText}},
      {OpCode::TellNotSimulated, {kNo, kText, kNo}},
      {OpCode::MoveFrame, {kFrame, kFrame, kFrame}},
      {OpCode::Chain, {kFrame, kFrame, kFrame}},
      {OpCode::EqualFrame, {kNumber, kFrame, kFrame}},
      {OpCode::LoadComponent, {kNumber, kFrame, kNo}},
      // These go to elements.
      {OpCode::Load, {}},
      {OpCode::LoadText, {}},
      {OpCode::LoadFrame, {}},
      {OpCode::Store, {}},
      {OpCode::StoreText, {}},
      {OpCode::StoreFrame, {}},
      {OpCode::Fill, {}},
      {OpCode::Repeat, {}},
  };
  for (const Row& row : kRows) {
    if (row.code == code) {
      return row.operands;
    }
  }
  return {kNumber, kNumber, kNumber};
}

Variable SinumerikAccesses::name_of(const sinumerik::Variable& variable) const {
  const bool is_global = variable.storage == sinumerik::Storage::Global ||
                         variable.storage == sinumerik::Storage::OfMain;
  return {is_global ? Variable::Scope::Global : Variable::Scope::Local, variable.name};
}

/// What stands in the bank of locals or globals is an element of a variable: of the last one that
/// begins at its place or before it.
void SinumerikAccesses::operand(const Step& step, List list, sinumerik::Operand operand,
                                Access::Kind kind) const {
  const bool is_variable =
      operand.bank == sinumerik::Bank::Locals || operand.bank == sinumerik::Bank::Globals;
  auto found = by_place_.upper_bound({list, operand.bank, operand.place});
  if (list == List::None || !is_variable || found == by_place_.begin()) {
    return;
  }
  --found;
  const sinumerik::Variable& variable = program_.variables[found->second];
  const std::int32_t number = operand.place - variable.place;
  if (found->first.list == list && found->first.bank == operand.bank &&
      number < variable.shape.count()) {
    const bool is_array = variable.shape.dimensions > 0;
    step.builder.access(name_of(variable),
                        {kind, 0, is_array ? number : kWholeVariable, step.where});
  }
}

/// Element `number` of a variable, by its own number among the program's variables.
void SinumerikAccesses::element(const Step& step, std::int32_t which, sinumerik::Operand number,
                                Access::Kind kind) const {
  const sinumerik::Variable& variable = program_.variables[static_cast<std::size_t>(which)];
  const bool is_known = variable.shape.dimensions > 0 && number.bank == sinumerik::Bank::Constants;
  const auto place = static_cast<std::size_t>(number.place);
  step.builder.access(
      name_of(variable),
      {kind, 0, is_known ? static_cast<std::int32_t>(program_.constants[place]) : kWholeVariable,
       step.where});
  operand(step, List::Numbers, number, Access::Kind::Read);
}

/// Steps that go to elements of a variable.
void SinumerikAccesses::elements(const Step& step) const {
  using sinumerik::OpCode;
  const sinumerik::Op& op = step.op;
  if (op.code == OpCode::Load || op.code == OpCode::LoadText || op.code == OpCode::LoadFrame) {
    element(step, op.b.place, op.a, Access::Kind::Read);
  }
  const bool stores =
      op.code == OpCode::Store || op.code == OpCode::StoreText || op.code == OpCode::StoreFrame;
  if (stores) {
    const List list = op.code == OpCode::Store       ? List::Numbers
                      : op.code == OpCode::StoreText ? List::Texts
                                                     : List::Frames;
    operand(step, list, op.result, Access::Kind::Read);
    element(step, op.b.place, op.a, Access::Kind::Write);
  }
  if (op.code == OpCode::Fill || op.code == OpCode::Repeat) {
    // From this element on: how many are filled stands in the list.
    element(step, op.a.place, {sinumerik::Bank::Temporaries, 0}, Access::Kind::Write);
  }
}

void SinumerikAccesses::argument(const Step& step, const sinumerik::Argument& argument,
                                 bool hands_over) const {
  using Form = sinumerik::Argument::Form;
  const Step here{step.op, argument.where, step.builder};
  const bool is_variable = argument.form == Form::Element || argument.form == Form::Whole;
  if (is_variable && (hands_over || argument.form == Form::Whole)) {
    element(here, argument.variable,
            argument.form == Form::Element ? argument.element
                                           : sinumerik::Operand{sinumerik::Bank::Temporaries, 0},
            hands_over ? Access::Kind::HandOver : Access::Kind::Read);
  } else if (argument.form != Form::Omitted) {
    operand(here, list_of(argument.type), argument.value, Access::Kind::Read);
  }
}

void SinumerikAccesses::arguments(const Step& step) const {
  using sinumerik::OpCode;
  const sinumerik::Op& op = step.op;
  const bool is_call = op.code == OpCode::Call;
  const bool has_list = op.code == OpCode::Function || op.code == OpCode::ReadSystem ||
                        op.code == OpCode::WriteSystem || op.code == OpCode::Procedure ||
                        op.code == OpCode::Return || op.code == OpCode::Fill ||
                        op.code == OpCode::Repeat;
  if (!has_list && !is_call) {
    return;
  }
  std::uint32_t first = static_cast<std::uint32_t>(op.b.place);
  std::uint32_t count = op.count;
  if (is_call) {
    const auto& site = program_.calls[static_cast<std::size_t>(op.a.place)];
    operand(step, List::Texts, site.text, Access::Kind::Read);
    operand(step, List::Texts, site.first_label, Access::Kind::Read);
    operand(step, List::Texts, site.last_label, Access::Kind::Read);
    operand(step, List::Numbers, site.passes, Access::Kind::Read);
    first = site.first_argument;
    count = site.argument_count;
  }
  for (std::uint32_t i = first; i < first + count; ++i) {
    argument(step, program_.arguments[i], is_call || op.code == OpCode::Procedure);
  }
}

void SinumerikAccesses::system(const Step& step) const {
  const bool writes = step.op.code == sinumerik::OpCode::WriteSystem;
  if (writes || step.op.code == sinumerik::OpCode::ReadSystem) {
    const auto& row = sinumerik::system_variables()[static_cast<std::size_t>(step.op.a.place)];
    step.builder.access(
        {Variable::Scope::System, std::string(row.name)},
        {writes ? Access::Kind::Write : Access::Kind::Read, 0, kWholeVariable, step.where});
  }
}

void SinumerikAccesses::add_step(const Step& step) const {
  const sinumerik::Op& op = step.op;
  const Operands operands = operands_of(op.code);
  operand(step, operands.a, op.a, Access::Kind::Read);
  operand(step, operands.b, op.b, Access::Kind::Read);
  arguments(step);
  elements(step);
  system(step);
  // The mode of measuring stands where other steps have their result.
  const bool reads = op.code == sinumerik::OpCode::AxisMeasuring;
  operand(step, operands.result, op.result, reads ? Access::Kind::Read : Access::Kind::Write);
}

/// Whenever the action is judged, be it in other blocks, its own block has asked for it.
void SinumerikAccesses::add_action(std::int32_t which, FlowBuilder& builder) const {
  const auto found =
      std::ranges::lower_bound(program_.actions, which, {}, &sinumerik::ActionSteps::step);
  if (found == program_.actions.end() || found->step != which) {
    return;
  }
  for (std::size_t i = 0; i < found->ops.size(); ++i) {
    add_step({found->ops[i], found->spans[i], builder});
  }
}

void SinumerikAccesses::add(std::int32_t first, std::int32_t end, FlowBuilder& builder) const {
  for (std::int32_t i = first; i < end; ++i) {
    const auto at = static_cast<std::size_t>(i);
    add_step({program_.ops[at], program_.spans[at], builder});
    if (program_.ops[at].code == sinumerik::OpCode::SynchronisedAction) {
      add_action(i, builder);
    }
  }
}

}  // namespace g31::analysis
