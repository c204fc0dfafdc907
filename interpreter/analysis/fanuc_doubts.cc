#include "interpreter/analysis/fanuc_doubts.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/code/compile.h"
#include "interpreter/dialects/fanuc/code/word_limits.h"

namespace g31::analysis {
namespace {

using syntax::Word;
using Words = std::span<const Word>;

/// The number of an expression that is one; #0 is vacant, which no number is.
struct Constant {
  bool is_vacant = false;
  double number = 0.0;
  friend bool operator==(const Constant&, const Constant&) = default;
};

std::optional<Constant> constant_of(const syntax::Tree& tree, syntax::Index index) {
  const syntax::Expr& expr = tree.exprs[index];
  if (expr.kind == syntax::ExprKind::Number) {
    return Constant{false, expr.number};
  }
  const bool is_variable = expr.kind == syntax::ExprKind::Variable && expr.a != syntax::kNone;
  const auto number = is_variable ? constant_of(tree, expr.a) : std::nullopt;
  return number == Constant{false, 0.0} ? std::optional(Constant{true, 0.0}) : std::nullopt;
}

std::string_view written(const source::SourceFile& file, const Word& word) {
  return file.text().substr(word.span.begin, word.span.end - word.span.begin);
}

bool may_call(const Word& word, const fanuc::Profile& profile, const WordReading& reading) {
  const bool is_code = word.letter == 'G' || word.letter == 'M';
  const bool is_open = is_code && word.form == syntax::ValueForm::Computed;
  return word.letter == '/' || is_open || fanuc::calls_program(word) || fanuc::is_return(word) ||
         (word.letter == 'G' && g_code_may_call(word.number, profile, reading));
}

/// A first word M may call a macro, and the others are its arguments.
bool may_call(Words words, const fanuc::Profile& profile, const WordReading& reading) {
  constexpr double kStop = 1.0;
  const bool begins_with_m = !words.empty() && words.front().letter == 'M' &&
                             words.front().number > kStop && words.size() > 1;
  return begins_with_m || std::ranges::any_of(words, [&](const Word& word) {
           return may_call(word, profile, reading);
         });
}

/// The word before `word` that counts for nothing because of it; nullptr: there is none.
const Word* overridden(Words before, const Word& word, const fanuc::Profile& profile) {
  constexpr std::string_view kAddresses = "XYZABCIJKFSDHQ";
  if (word.letter == 'G') {
    const fanuc::GCode* const code = fanuc::find_g_code(word.number, profile);
    const auto found = std::ranges::find_if(before, [&](const Word& other) {
      const fanuc::GCode* const one =
          other.letter == 'G' ? fanuc::find_g_code(other.number, profile) : nullptr;
      return one != nullptr && one->group == code->group && one != code;
    });
    return code->group != fanuc::Group::OneShot && found != before.end() ? &*found : nullptr;
  }
  if (kAddresses.find(word.letter) == std::string_view::npos) {
    return nullptr;
  }
  const auto found = std::ranges::find(before, word.letter, &Word::letter);
  return found != before.end() ? &*found : nullptr;
}

}  // namespace

std::vector<Finding> lost_heads(const source::SourceFile& file, const syntax::Tree& tree) {
  std::vector<Finding> found;
  for (const Word& word : tree.words) {
    if (word.letter == 'O') {
      found.push_back(
          {RuleId::LostHead, 0, file.at(word.span.widened()),
           fmt::format("{} stands within a block, where no program begins", written(file, word)),
           fmt::format("write {} in a line of its own", written(file, word))});
    }
  }
  return found;
}

std::vector<Finding> constant_comparisons(const source::SourceFile& file,
                                          const syntax::Tree& tree) {
  std::vector<Finding> found;
  for (const syntax::Expr& expr : tree.exprs) {
    if (expr.kind != syntax::ExprKind::Binary ||
        !fanuc::is_comparison(fanuc::operation_of(expr.op))) {
      continue;
    }
    const auto left = constant_of(tree, expr.a);
    const auto right = constant_of(tree, expr.b);
    if (left && right && *left != *right) {
      found.push_back({RuleId::ConstantComparison, 0, file.at(expr.span.widened()),
                       "two constants are compared: it always comes out the same",
                       "write # before the number of a variable"});
    }
  }
  return found;
}

std::vector<Finding> doubled_words(const source::SourceFile& file, const syntax::Tree& tree,
                                   const fanuc::Profile& profile, const WordReading& reading) {
  std::vector<Finding> found;
  for (const syntax::Block& block : tree.blocks) {
    const Words words = Words(tree.words).subspan(block.first_word, block.word_count);
    if (block.kind != syntax::BlockKind::Nc || reading.every_block_calls ||
        may_call(words, profile, reading)) {
      continue;
    }
    for (std::size_t i = 1; i < words.size(); ++i) {
      const Word* const lost = overridden(words.first(i), words[i], profile);
      if (lost == nullptr) {
        continue;
      }
      found.push_back({RuleId::DoubledWord, 0, file.at(words[i].span.widened()),
                       fmt::format("{} counts, and not {} before it in the block",
                                   written(file, words[i]), written(file, *lost)),
                       "leave one of them out, or write two blocks"});
    }
  }
  return found;
}

}  // namespace g31::analysis
