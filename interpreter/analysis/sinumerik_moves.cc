#include "interpreter/analysis/sinumerik_moves.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "interpreter/dialects/sinumerik/vocabulary/g_codes.h"
#include "interpreter/dialects/sinumerik/vocabulary/words.h"
#include "machine/units/axis_positions.h"

namespace g31::analysis {
namespace {

/// What the words of a SINUMERIK block say of its motion.
class SinumerikMove {
 public:
  explicit SinumerikMove(const sinumerik::CompiledProgram& program) : program_(program) {}

  void add_step(std::int32_t step) {
    using sinumerik::OpCode;
    const sinumerik::Op& op = program_.ops[static_cast<std::size_t>(step)];
    const syntax::ShortSpan where = program_.spans[static_cast<std::size_t>(step)];
    if (op.code == OpCode::NcBlock || op.code == OpCode::Execute) {
      constants(program_.nc_blocks[static_cast<std::size_t>(op.b.place)], where);
    } else if (op.code == OpCode::Word) {
      word(static_cast<sinumerik::Address>(op.detail), number(op.a), where);
    } else if (op.code == OpCode::AxisMeasuring) {
      measures_ = true;
    } else if (op.code == OpCode::AxisWord) {
      axis_word(op, where);
    }
  }

  void tell(FlowBuilder& builder) {
    std::ranges::stable_sort(targets_, {}, &AxisTarget::letter);
    if (!is_data_ && (!targets_.empty() || is_polar_)) {
      builder.move(measures_ ? Move::Kind::Measuring : kind_, targets_);
    }
  }

 private:
  [[nodiscard]] std::optional<double> number(sinumerik::Operand operand) const {
    const auto place = static_cast<std::size_t>(operand.place);
    return operand.bank == sinumerik::Bank::Constants ? std::optional(program_.constants[place])
                                                      : std::nullopt;
  }

  void constants(const sinumerik::NcBlock& block, syntax::ShortSpan where) {
    for (const std::uint16_t bits : block.codes_of(program_)) {
      g_code(sinumerik::g_codes()[sinumerik::unpacked(bits).row]);
    }
    for (const sinumerik::ConstantWord& constant : block.words_of(program_)) {
      word(constant.address, constant.value, where);
    }
  }

  void g_code(const sinumerik::GCode& code) {
    using sinumerik::GAction;
    const bool is_reference =
        code.action == GAction::Reference || code.action == GAction::FixedPoint;
    is_data_ = is_data_ ||
               (!is_reference && code.action != GAction::Modal && code.action != GAction::OneBlock);
    if (is_reference) {
      kind_ = Move::Kind::Reference;
    } else if (code.group == sinumerik::Group::Motion) {
      using sinumerik::number_in_group;
      kind_ = code.number == number_in_group("G0")   ? Move::Kind::Rapid
              : code.number == number_in_group("G1") ? Move::Kind::Line
              : sinumerik::is_circle(code.number)    ? Move::Kind::Arc
                                                     : Move::Kind::Cycle;
    }
  }

  void word(sinumerik::Address address, std::optional<double> value, syntax::ShortSpan where) {
    using sinumerik::Address;
    measures_ = measures_ || address == Address::Measure || address == Address::MeasureOn;
    is_polar_ = is_polar_ || address == Address::PolarAngle || address == Address::PolarRadius;
    if (address == Address::ToolWay) {
      for (const char axis : {'X', 'Y', 'Z'}) {
        targets_.push_back({axis, true, 0.0, where});
      }
    }
    const bool is_further =
        address == Address::AxisU || address == Address::AxisV || address == Address::AxisW;
    if (index_of(address) < kAxisCount || is_further) {
      targets_.push_back(
          {sinumerik::name_of(address).front(), !value.has_value(), value.value_or(0.0), where});
    }
  }

  void axis_word(const sinumerik::Op& op, syntax::ShortSpan where) {
    const auto id = static_cast<sinumerik::AxisWordId>(op.detail);
    const auto role = sinumerik::info(id).role;
    const auto axis = number(op.a);
    if (id == sinumerik::AxisWordId::CentreOfAxis) {
      return;
    }
    if (role == sinumerik::AxisRole::Path || role == sinumerik::AxisRole::Positioning) {
      const auto value = number(op.b);
      const bool is_known = axis && *axis >= 0.0;  // NO_AXIS: an alarm
      targets_.push_back({is_known ? sinumerik::letter_of_axis(static_cast<int>(*axis)) : '?',
                          !value.has_value(), value.value_or(0.0), where});
    }
  }

  const sinumerik::CompiledProgram& program_;
  Move::Kind kind_ = Move::Kind::AsBefore;
  std::vector<AxisTarget> targets_;
  bool is_data_ = false;
  bool is_polar_ = false;
  bool measures_ = false;
};

}  // namespace

void add_moves(const sinumerik::CompiledProgram& program, std::int32_t first, std::int32_t end,
               FlowBuilder& builder) {
  SinumerikMove move(program);
  for (std::int32_t step = first; step < end; ++step) {
    move.add_step(step);
  }
  move.tell(builder);
}

}  // namespace g31::analysis
