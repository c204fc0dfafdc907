#pragma once

#include <cstdint>
#include <vector>

#include "interpreter/dialects/sinumerik/code/operations.h"
#include "interpreter/dialects/sinumerik/vocabulary/system_variables.h"

namespace g31::sinumerik {

class Expressions;

/// Variables and what of them a program names: elements, characters, components.
class Accesses : private BlockPart {
 public:
  /// All outlive them.
  Accesses(const BlockWork& work, Operations& operations, Expressions& expressions)
      : BlockPart(work), operations_(operations), expressions_(expressions) {}

  /// What an index list in brackets says.
  struct Element {
    Operand number;
    bool is_fixed = false;  ///< `number` is a constant, `offset` its value
    std::int32_t offset = 0;
    bool is_open = false;  ///< the brackets go on: a character or component of it follows
  };
  /// What stands behind the name of a variable: an element, or at once a part of the only one.
  Element element_or_part(std::int32_t variable);
  /// Makes a variable the element of it that an index list says.
  void place(Expr& target, const Element& element) const;
  /// The value of an element: where it stands, or fetched from there.
  Expr loaded(const Expr& target);
  /// The value of a variable, of its element or component; a whole array where no index follows.
  Expr variable_access(std::int32_t variable, ShortSpan where);

  Expr system_access(const SystemName& name, ShortSpan where);
  /// The indices of a system variable; a frame may have axis and component behind them.  Fails
  /// where a run would have to know what g31 does not simulate.
  /// @param where  the name
  std::vector<Argument> system_indices(const SystemName& name, ShortSpan where);
  Expr axis_operand();
  Expr component_operand();

 private:
  void add_index(Element& element, std::int32_t variable, const Expr& index, int dimension);
  Element element_of(std::int32_t variable);
  Expr component_access(Expr frame);
  Expr character_access(const Expr& string);

  Operations& operations_;
  Expressions& expressions_;
};

/// The memory of a variable that is none of the caller's.
constexpr Bank bank_of(Storage storage) {
  return storage == Storage::Global ? Bank::Globals : Bank::Locals;
}

/// How steps name a variable of the program.
inline Operand variable_number(std::int32_t variable) {
  return {Bank::Constants, variable};
}

}  // namespace g31::sinumerik
