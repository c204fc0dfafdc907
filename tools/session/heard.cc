#include "tools/session/heard.h"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "interpreter/source/diagnostic.h"
#include "tools/session/allow_comments.h"

namespace g31::session {
namespace {

/// The comments of the files that are asked for, and which of them have allowed something.
class ReadComments {
 public:
  ReadComments(source::FileSystem& files, CommentForm form) : files_(files), form_(form) {}

  struct Row {
    AllowComment comment;
    bool is_used = false;
  };
  using Rows = std::vector<Row>;

  /// Of a file that cannot be read there are none.
  Rows& of(const std::string& file) {
    const auto [entry, is_new] = by_file_.try_emplace(file);
    if (is_new && files_.size(file).value_or(0) <= kLongestFile) {
      for (AllowComment& comment : allow_comments(files_.read(file).value_or(""), form_)) {
        entry->second.push_back({std::move(comment)});
      }
    }
    return entry->second;
  }

  /// Of all files, by their names.
  [[nodiscard]] const std::map<std::string, Rows>& all() const { return by_file_; }

 private:
  source::FileSystem& files_;
  CommentForm form_;
  std::map<std::string, Rows> by_file_;
};

/// The comment that allows a message; it is used then.
const AllowComment* comment_for(const source::Diagnostic& message, const source::SourceMap& sources,
                                ReadComments& comments) {
  if (!message.where.is_known()) {
    return nullptr;
  }
  const source::ShownPlace place = sources.show(message.where);
  ReadComments::Rows& rows = comments.of(place.file);
  const auto row = std::ranges::find_if(rows, [&](const ReadComments::Row& candidate) {
    const AllowComment& comment = candidate.comment;
    return comment.code == message.code && comment.first_line <= place.line &&
           place.line <= comment.last_line;
  });
  if (row == rows.end()) {
    return nullptr;
  }
  row->is_used = true;
  return &row->comment;
}

source::Diagnostic useless(const std::string& file, const AllowComment& comment) {
  source::Diagnostic note =
      source::make_diagnostic(source::DiagnosticId::AllowsNothing, {},
                              comment.code.empty() ? std::string("it names no code")
                                                   : fmt::format("no {} comes here", comment.code));
  note.in_sheet = {file, comment.line, comment.column, comment.text};
  return note;
}

}  // namespace

Heard heard(runtime::Outcome outcome, const Control& control, const std::string& program,
            const std::vector<std::string>& codes, const source::SourceMap& sources) {
  const bool is_fanuc = std::holds_alternative<FanucControl>(control);
  ReadComments comments(sources.files(),
                        is_fanuc ? CommentForm::Parentheses : CommentForm::Semicolon);
  comments.of(program);
  const auto is_named = [&](const source::Diagnostic& message) {
    return std::ranges::find(codes, message.code) != codes.end();
  };
  Heard heard;
  std::vector<source::Diagnostic> messages = std::move(outcome.diagnostics);
  outcome.diagnostics.clear();
  for (source::Diagnostic& message : messages) {
    const bool may_be = message.severity != source::Severity::Error;
    const AllowComment* const comment = may_be ? comment_for(message, sources, comments) : nullptr;
    if (comment != nullptr || (may_be && is_named(message))) {
      heard.allowed.push_back({std::move(message), comment != nullptr ? comment->reason : ""});
    } else {
      outcome.diagnostics.push_back(std::move(message));
    }
  }
  for (const auto& [file, rows] : comments.all()) {
    for (const ReadComments::Row& row : rows) {
      source::Diagnostic note = useless(file, row.comment);
      if (!row.is_used && outcome.status == runtime::Status::Completed && !is_named(note)) {
        outcome.diagnostics.push_back(std::move(note));
      }
    }
  }
  heard.outcome = std::move(outcome);
  return heard;
}

}  // namespace g31::session
