#include "interpreter/analysis/fanuc_comments.h"

#include <algorithm>
#include <string_view>

namespace g31::analysis {

std::vector<Finding> open_comments(const source::SourceFile& file, const syntax::Tree& tree) {
  std::vector<Finding> found;
  const std::string_view text = file.text().substr(0, tree.end);
  std::size_t at = tree.blocks.empty() ? text.size() : tree.blocks.front().span.begin;
  while ((at = text.find('(', at)) != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(")\n", at), text.size());
    if (end == text.size() || text[end] == '\n') {
      found.push_back({RuleId::OpenComment, 0, file.at({at, at + 1}), "this comment has no )",
                       "close it on its line, where it ends: what stands behind it does not run"});
    }
    at = end;
  }
  return found;
}

}  // namespace g31::analysis
