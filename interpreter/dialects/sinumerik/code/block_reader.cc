#include "interpreter/dialects/sinumerik/code/block_reader.h"

#include <algorithm>
#include <string>

#include "interpreter/dialects/sinumerik/vocabulary/names.h"
#include "interpreter/dialects/sinumerik/vocabulary/words.h"
#include "interpreter/source/printable.h"

namespace g31::sinumerik {
namespace {

/// Whether words of keywords.def are refused.
const NameMap<bool>& keyword_kinds() {
  static const NameMap<bool> kRefused = [] {
    NameMap<bool> map;
    for (const KeywordInfo& row : keywords()) {
      map.emplace(std::string(row.name), row.is_refused);
    }
    return map;
  }();
  return kRefused;
}

}  // namespace

void BlockReader::begin(ShortSpan block) {
  cursor.rewind();
  error_.reset();
  block_ = block;
}

void BlockReader::expect(Symbol symbol) {
  if (!cursor.accept(symbol)) {
    fail(AlarmId::SyntaxInText, text_of(cursor.peek().where));
  }
}

void BlockReader::expect_end() {
  if (cursor.peek().kind != TokenKind::End) {
    fail(AlarmId::SyntaxInText, text_of(cursor.peek().where));
  }
}

void BlockReader::fail(AlarmId id, ShortSpan where, std::string_view detail) {
  if (!error_) {
    error_ = BlockError{id, std::string(detail)};
    error_where_ = where.end > where.begin ? where : block_;
  }
}

void BlockReader::fail_by_earlier(AlarmId id, ShortSpan where, std::string_view detail) {
  const bool is_first = !failed();
  fail(id, where, detail);
  error_->follows = is_first;
}

std::string BlockReader::text_of(ShortSpan where) const {
  return where.end > where.begin ? source::printable(source(where))
                                 : std::string("the end of the block");
}

void BlockReader::pass_over() {
  while (cursor.peek().kind != TokenKind::End) {
    cursor.next();
  }
}

void BlockReader::refuse() {
  const std::string_view name = cursor.previous().text;
  const auto row = std::ranges::find(keywords(), name, &KeywordInfo::name);
  const bool is_known = row != keywords().end();
  fail(AlarmId::NotImplemented, block_,
       is_known ? std::string(name) + ": " + std::string(row->text) : text_of(block_));
}

bool is_keyword(std::string_view name) {
  return keyword_kinds().contains(name);
}

bool is_refused(std::string_view name) {
  const auto found = keyword_kinds().find(name);
  return found != keyword_kinds().end() && found->second;
}

}  // namespace g31::sinumerik
