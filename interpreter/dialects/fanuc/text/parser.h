#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "interpreter/dialects/fanuc/text/parse.h"
#include "interpreter/dialects/fanuc/text/parse_expression.h"

namespace g31::fanuc {

/// Reads the blocks of a tape one by one.
class Parser {
 public:
  explicit Parser(std::string_view text) : scanner_(text), expressions_(scanner_, tree_) {}

  syntax::Tree run(TextBegins begins) {
    reserve();
    if (begins == TextBegins::AtFile) {
      scanner_.skip_leader();
    } else {
      open_program(0, {});
    }
    while (!scanner_.at_end_of_text()) {
      if (!plain_block()) {
        if (scanner_.at_tape_end()) {
          break;
        }
        block();
      }
      scanner_.skip_block();
    }
    close_program();
    tree_.end = scanner_.position();
    return std::move(tree_);
  }

 private:
  /// How a control begins a variable when it punches them; people write blanks.
  static constexpr std::string_view kPunchedVariable = "G10L85P";

  /// Room for what a text of this size holds as a rule.
  void reserve() {
    tree_.blocks.reserve(scanner_.text().size() / 24);
    tree_.words.reserve(scanner_.text().size() / 5);
  }
  void block();
  bool plain_block();
  bool program_number(syntax::Block& block);
  bool program_name(syntax::Block& block);
  syntax::ShortSpan name_in_angles();
  bool called_name();
  void head(syntax::Block& block);
  std::uint8_t switch_number();
  void body(syntax::Block& block);
  void condition_alone(syntax::Block& block);
  void assignment(syntax::Block& block);
  bool is_bare_message(const syntax::Block& block);
  syntax::Index bare_message(syntax::Block& block);
  [[nodiscard]] bool at_folder() const;
  [[nodiscard]] bool at_punched_variable() const {
    const std::string_view text = scanner_.text();
    const std::size_t zero = scanner_.position() + 2U;
    // Nearly all blocks begin with G1 and no 0.
    return zero < text.size() && text[zero] == kPunchedVariable[2] &&
           text.substr(scanner_.position()).starts_with(kPunchedVariable);
  }
  void punched_variable(syntax::Block& block);
  void words(syntax::Block& block);
  [[gnu::cold]] void statement_behind_words(syntax::Block& block);
  [[gnu::cold]] void forgive_jump(std::uint32_t begin);
  bool word();
  void word_value(syntax::Word& word);
  syntax::Index computed_value();
  void keyword(syntax::Block& block);
  void if_statement(syntax::Block& block);
  bool jump_follows();
  void while_statement(syntax::Block& block);
  void then_statement(syntax::Block& block);
  void jump(syntax::Block& block);
  void set_names(syntax::Block& block);
  void output_statement(syntax::Block& block, OutputStatement statement);
  int loop_number();
  syntax::Index condition();
  std::int32_t integer(const char* what);
  void expect_end();
  void open_program(std::int32_t number, syntax::ShortSpan name);
  void close_program();
  void settle(syntax::Block& block, std::uint32_t begin);

  bool failed() const { return expressions_.error().has_value(); }
  void fail(AlarmId id, std::string message) { expressions_.fail(id, std::move(message)); }

  syntax::Tree tree_;
  Scanner scanner_;
  ExpressionParser expressions_;
  int then_depth_ = 0;
  bool goes_on_ = false;  // a statement stands behind the words of the block
};

}  // namespace g31::fanuc
