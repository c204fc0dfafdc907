#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/dialects/sinumerik/code/code.h"
#include "interpreter/dialects/sinumerik/text/macros.h"

namespace g31::sinumerik {

/// R0 to R999.
inline constexpr int kRParameters = 1000;

/// The names that every program of a control sees: R parameters, machine and setting data, GUD and
/// the macros of definition files.  Compilers ask it for places; a channel makes the memory.
class Globals {
 public:
  /// R parameters and the rows of machine_data.def and memory.def.
  Globals();

  [[nodiscard]] const Variable* find(std::string_view name) const;
  /// Of a name that is there: its place among the numbers.
  [[nodiscard]] std::size_t place(std::string_view name) const {
    return static_cast<std::size_t>(find(name)->place);
  }

  /// @returns nullptr when there is one of that name already
  const Variable* define(const Variable& variable);

  /// A variable of the main program is one of its subprograms, too (PUD).  Of several main programs
  /// the first one that has the name counts.
  void offer_of_main(Variable variable);
  /// nullptr: the main program has none of that name.
  [[nodiscard]] const Variable* find_of_main(std::string_view name) const;

  [[nodiscard]] std::span<const Variable> variables() const { return variables_; }
  [[nodiscard]] const Layout& layout() const { return layout_; }

  Macros macros;          ///< of the user's definition files; what is shipped does not see them
  Macros shipped_macros;  ///< of those that come with the control, as its programs see them
  /// Those of them that the programs of a user see: a user's data may have the name of one.
  Macros offered_macros;
  /// An array is shorter than this control could have it: indices from `count` on are alarms.
  void shorten(std::string_view name, int count);
  /// What the set-up sheet calls axes beside their letters, upper case.
  NameMap<int> axis_names;
  /// The axis of a name; -1: none.
  [[nodiscard]] int axis(std::string_view name) const;

 private:
  void number_axes(std::string_view name, std::int32_t place);

  std::vector<Variable> variables_;
  NameMap<std::size_t> by_name_;
  NameMap<Variable> of_main_;
  Layout layout_;
};

}  // namespace g31::sinumerik
