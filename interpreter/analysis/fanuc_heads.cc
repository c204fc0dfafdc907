#include "interpreter/analysis/fanuc_heads.h"

#include <string>

#include <fmt/format.h>

namespace g31::analysis {

std::vector<Finding> lost_heads(const source::SourceFile& file, const syntax::Tree& tree) {
  std::vector<Finding> found;
  for (const syntax::Word& word : tree.words) {
    if (word.letter == 'O') {
      const std::string written(
          file.text().substr(word.span.begin, word.span.end - word.span.begin));
      found.push_back({RuleId::LostHead, 0, file.at(word.span.widened()),
                       fmt::format("{} stands within a block, where no program begins", written),
                       fmt::format("write {} in a line of its own", written)});
    }
  }
  return found;
}

}  // namespace g31::analysis
