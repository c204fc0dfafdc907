#include "tools/check/disabled_findings.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "interpreter/source/diagnostic.h"
#include "tools/check/named_rule.h"

namespace g31::check {
namespace {

using analysis::Finding;
using analysis::RuleId;
using session::MessageComment;
using Comments = std::vector<const MessageComment*>;

std::string_view code_of(const Finding& finding) {
  return analysis::info(finding.rule).code;
}

/// Comments by the rule that they disable and the line they are for; line 0: the file.
using ByPlace = std::map<std::pair<std::string_view, int>, Comments>;

ByPlace by_place(const Comments& comments) {
  ByPlace places;
  for (const MessageComment* const comment : comments) {
    const bool is_of_line = comment->first_line == comment->last_line;
    places[{comment->code, is_of_line ? comment->first_line : 0}].push_back(comment);
  }
  return places;
}

/// Takes out what comments disable, and remembers who did.
void take_disabled(std::vector<Finding>& found, const Comments& comments,
                   const source::SourceMap& sources, std::set<const MessageComment*>& used) {
  if (comments.empty()) {
    return;
  }
  const ByPlace places = by_place(comments);
  std::set<std::pair<std::string_view, int>> used_places;
  std::erase_if(found, [&](const Finding& finding) {
    bool is_disabled = false;
    for (const int line : {0, sources.show(finding.where).line}) {
      const auto here = places.find({code_of(finding), line});
      if (here != places.end()) {
        is_disabled = true;
        if (used_places.insert(here->first).second) {
          used.insert(here->second.begin(), here->second.end());
        }
      }
    }
    return is_disabled;
  });
}

std::string why_useless(const MessageComment& comment) {
  if (comment.named.empty()) {
    return "it names no rule";
  }
  if (const auto wrong = why_no_rule(comment.named)) {
    return *wrong;
  }
  return fmt::format("no {} comes here", comment.code);
}

/// Without the comment and the blanks before it; a line that has nothing else goes, too.
analysis::Fix removal(const MessageComment& comment, const source::SourceFile& file) {
  const std::string_view text = file.text();
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  std::size_t begin = comment.begin;
  std::size_t end = comment.begin + comment.length;
  while (begin > 0 && is_blank(text[begin - 1])) {
    --begin;
  }
  std::size_t behind = end;
  while (behind < text.size() && (is_blank(text[behind]) || text[behind] == '\r')) {
    ++behind;
  }
  const bool is_first = begin == 0 || text[begin - 1] == '\n';
  const bool is_last = behind == text.size() || text[behind] == '\n';
  if (is_first && is_last) {
    end = std::min(behind + 1, text.size());
  }
  return {"remove the comment", {{file.at({begin, end}), ""}}};
}

Finding useless(const MessageComment& comment, const source::SourceFile& file, bool stands_alone) {
  Finding finding;
  finding.rule = RuleId::UselessComment;
  finding.where = file.at({comment.begin, comment.begin + comment.length});
  finding.message = fmt::format("the comment g31: disable has no use: {}", why_useless(comment));
  finding.remedy =
      "write the rule of a finding in its own line, alone on a line for the next block, before the "
      "first block for the whole file; else remove it";
  if (stands_alone) {
    finding.fix = removal(comment, file);
  }
  return finding;
}

}  // namespace

std::vector<Finding> without_disabled(std::vector<Finding> found, const source::SourceFile& file,
                                      std::span<const MessageComment> comments,
                                      const source::SourceMap& sources) {
  // What disables NC010 looks at the comments that are without use, so its turn comes behind them.
  Comments of_findings;
  Comments of_comments;
  for (const MessageComment& comment : comments) {
    if (comment.verb == MessageComment::Verb::Disable) {
      const bool is_last = comment.code == analysis::info(RuleId::UselessComment).code;
      (is_last ? of_comments : of_findings).push_back(&comment);
    }
  }
  std::set<const MessageComment*> used;
  take_disabled(found, of_findings, sources, used);
  // One that names several rules is several, side by side.
  const auto is_alone = [&](const MessageComment* comment) {
    const auto at = static_cast<std::size_t>(comment - comments.data());
    const bool is_first = at == 0 || comments[at - 1].begin != comment->begin;
    const bool is_last = at + 1 == comments.size() || comments[at + 1].begin != comment->begin;
    return is_first && is_last;
  };
  const auto tell_useless = [&](const Comments& all) {
    std::vector<Finding> told;
    for (const MessageComment* const comment : all) {
      if (!used.contains(comment)) {
        told.push_back(useless(*comment, file, is_alone(comment)));
      }
    }
    return told;
  };
  std::vector<Finding> told = tell_useless(of_findings);
  take_disabled(told, of_comments, sources, used);
  std::ranges::move(told, std::back_inserter(found));
  std::ranges::move(tell_useless(of_comments), std::back_inserter(found));
  std::ranges::stable_sort(found, {}, [](const Finding& f) { return f.where.begin; });
  return found;
}

}  // namespace g31::check
