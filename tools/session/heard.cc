#include "tools/session/heard.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "interpreter/source/diagnostic.h"

namespace g31::session {
namespace {

/// What one run asks of the comments: which files, and which of their comments have allowed
/// something.
struct Asked {
  ProgramComments& comments;
  std::set<std::string> files;
  std::set<const MessageComment*> used;
};

/// The comment that allows a message; it is used then.
const MessageComment* comment_for(const source::Diagnostic& message,
                                  const source::SourceMap& sources, Asked& asked) {
  if (!message.where.is_known()) {
    return nullptr;
  }
  const source::ShownPlace place = sources.show(message.where);
  asked.files.insert(place.file);
  const std::vector<MessageComment>& all = asked.comments.of(place.file);
  const auto comment = std::ranges::find_if(all, [&](const MessageComment& candidate) {
    return candidate.code == message.code && candidate.first_line <= place.line &&
           place.line <= candidate.last_line;
  });
  if (comment == all.end()) {
    return nullptr;
  }
  asked.used.insert(&*comment);
  return &*comment;
}

source::Diagnostic useless(const std::string& file, const MessageComment& comment) {
  source::Diagnostic note =
      source::make_diagnostic(source::DiagnosticId::AllowsNothing, {},
                              comment.code.empty() ? std::string("it names no code")
                                                   : fmt::format("no {} comes here", comment.code));
  note.in_sheet = {file, comment.line, comment.column, comment.text};
  return note;
}

}  // namespace

ProgramComments::ProgramComments(source::FileSystem& files, const Control& control)
    : files_(files), form_(comment_form(control)) {}

/// Looks at a file piece by piece, each with the beginning of the next, before it is read whole.
bool ProgramComments::may_have_comments(const std::string& file) {
  constexpr std::size_t kPiece = 1U << 16;
  const auto size = files_.size(file);
  if (!size || *size > kLongestFile) {
    return !size;
  }
  for (std::uint64_t offset = 0; offset < *size; offset += kPiece) {
    const auto piece = files_.read_part(file, offset, kPiece + kMessageCommentMark.size() - 1);
    if (!piece || has_message_comment_mark(*piece)) {
      return true;
    }
  }
  return false;
}

const std::vector<MessageComment>& ProgramComments::of(const std::string& file) {
  const std::lock_guard lock(mutex_);
  const auto [entry, is_new] = by_file_.try_emplace(file);
  if (is_new && may_have_comments(file)) {
    entry->second = message_comments(source::read_program(files_, file).value_or(""), form_);
    std::erase_if(entry->second, [](const MessageComment& comment) {
      return comment.verb != MessageComment::Verb::Allow;
    });
  }
  return entry->second;
}

Heard heard(runtime::Outcome outcome, ProgramComments& comments, const std::string& program,
            const std::vector<std::string>& codes, const source::SourceMap& sources) {
  Asked asked{comments, {program}, {}};
  const auto is_named = [&](const source::Diagnostic& message) {
    return std::ranges::find(codes, message.code) != codes.end();
  };
  Heard heard;
  std::vector<source::Diagnostic> messages = std::move(outcome.diagnostics);
  outcome.diagnostics.clear();
  for (source::Diagnostic& message : messages) {
    const bool may_be = message.severity != source::Severity::Error;
    const MessageComment* const comment = may_be ? comment_for(message, sources, asked) : nullptr;
    if (comment != nullptr || (may_be && is_named(message))) {
      heard.allowed.push_back({std::move(message), comment != nullptr ? comment->reason : ""});
    } else {
      outcome.diagnostics.push_back(std::move(message));
    }
  }
  for (const std::string& file : asked.files) {
    for (const MessageComment& comment : comments.of(file)) {
      source::Diagnostic note = useless(file, comment);
      if (!asked.used.contains(&comment) && outcome.status == runtime::Status::Completed &&
          !is_named(note)) {
        outcome.diagnostics.push_back(std::move(note));
      }
    }
  }
  heard.outcome = std::move(outcome);
  return heard;
}

}  // namespace g31::session
