#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/dialects/sinumerik/code/expressions.h"
#include "interpreter/dialects/sinumerik/code/nc_block_writer.h"

namespace g31::sinumerik {

/// Reads what blocks are made of, one after the other.
class BlockItems {
 public:
  /// One statement, assignment, word or call.
  virtual void item() = 0;

 protected:
  ~BlockItems() = default;
};

/// Synchronised actions: ID=n WHEN condition DO actions.  What they say is kept as text and
/// compiled when the block is done; here it is judged.
class ActionStatements : private BlockPart {
 public:
  /// All outlive them.
  ActionStatements(const BlockWork& work, KnownVariables& variables, Expressions& expressions,
                   NcBlockWriter& nc, BlockItems& items)
      : BlockPart(work),
        variables_(variables),
        expressions_(expressions),
        operations_(expressions.operations()),
        nc_(nc),
        items_(items) {}

  void numbered_action();
  void action_statement();
  Expr level_asked_for();
  void when_statement();
  /// SETINT
  void interrupt_statement();

 private:
  struct Actions {
    struct Range {
      std::size_t from;
      std::size_t to;
    };
    std::vector<Range> items;  ///< by their tokens
    bool deletes_distance = false;
  };
  void synchronised_action(std::string_view word, ActionScope scope, const Expr& number);
  bool judge_condition(std::size_t from);
  bool may_act(const Token& action);
  bool accept_unit();
  Actions action_list(ActionKind kind, bool is_timed);
  [[nodiscard]] bool is_read_at_once(std::size_t place);
  void add_text(std::vector<Argument>& pieces, std::string text);
  void add_pieces(std::vector<Argument>& pieces, std::size_t from, std::size_t to);
  void add_item(std::vector<Argument>& pieces, Actions::Range item);
  void judge_action(std::size_t from, ActionKind kind, bool is_timed);

  KnownVariables& variables_;
  Expressions& expressions_;
  Operations& operations_;
  NcBlockWriter& nc_;
  BlockItems& items_;
};

}  // namespace g31::sinumerik
