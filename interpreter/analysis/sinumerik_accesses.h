#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "interpreter/analysis/flow_builder.h"
#include "interpreter/dialects/sinumerik/code/code.h"

namespace g31::analysis {

/// Tells the variables that the steps of a program read, write and hand over.
class SinumerikAccesses {
 public:
  /// @param program  outlives the accesses
  explicit SinumerikAccesses(const sinumerik::CompiledProgram& program);

  /// Adds those of the steps [first, end) to the present block, in the order of the steps; those of
  /// a synchronised action, its condition first, stand at its own block.
  void add(std::int32_t first, std::int32_t end, FlowBuilder& builder) const;

 private:
  /// Which of the four lists of a bank an operand stands in.
  enum class List : std::uint8_t { None, Numbers, Texts, Frames };
  struct Operands {
    List result = List::None;
    List a = List::None;
    List b = List::None;
  };
  struct Place {
    List list;
    sinumerik::Bank bank;
    std::int32_t place;
    friend auto operator<=>(const Place&, const Place&) = default;
  };
  /// A step of the block that is being told.
  struct Step {
    const sinumerik::Op& op;
    syntax::ShortSpan where;
    FlowBuilder& builder;
  };

  static Operands operands_of(sinumerik::OpCode code);
  static List list_of(sinumerik::Type type);
  void add_step(const Step& step) const;
  void add_action(std::int32_t which, FlowBuilder& builder) const;
  void elements(const Step& step) const;
  void arguments(const Step& step) const;
  void argument(const Step& step, const sinumerik::Argument& argument, bool hands_over) const;
  void system(const Step& step) const;
  void operand(const Step& step, List list, sinumerik::Operand operand, Access::Kind kind) const;
  void element(const Step& step, std::int32_t variable, sinumerik::Operand number,
               Access::Kind kind) const;
  [[nodiscard]] Variable name_of(const sinumerik::Variable& variable) const;

  const sinumerik::CompiledProgram& program_;
  std::map<Place, std::size_t> by_place_;  ///< the first element of each variable
};

}  // namespace g31::analysis
