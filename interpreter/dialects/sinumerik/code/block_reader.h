#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "interpreter/dialects/sinumerik/code/code.h"
#include "interpreter/dialects/sinumerik/code/token_cursor.h"

namespace g31::sinumerik {

/// Reads one block after another of a text, and keeps what is wrong with the present one.
class BlockReader {
 public:
  explicit BlockReader(std::string_view text) : text_(text) {}

  TokenCursor cursor;

  /// A block begins, before its first token; nothing is wrong with it yet.
  void begin(ShortSpan block);
  [[nodiscard]] ShortSpan block() const { return block_; }
  /// As far as it is known now.
  void set_block(ShortSpan block) { block_ = block; }

  /// The first thing wrong in a block is the one that counts.
  void fail(AlarmId id, ShortSpan where, std::string_view detail = {});
  void fail(AlarmId id, std::string_view detail = {}) { fail(id, cursor.peek().where, detail); }
  /// The same of what is wrong only because a block before it is.
  void fail_by_earlier(AlarmId id, ShortSpan where, std::string_view detail);
  [[nodiscard]] bool failed() const { return error_.has_value(); }
  /// @pre failed()
  [[nodiscard]] const BlockError& error() const { return *error_; }
  [[nodiscard]] ShortSpan error_place() const { return error_where_; }

  void expect(Symbol symbol);
  void expect_end();
  /// What makes no difference at a desk: the rest of the block.
  void pass_over();
  /// What g31 knows the name of, and no more: fails with the row of the word that was read last.
  void refuse();
  /// As it stands in the text.
  [[nodiscard]] std::string_view source(ShortSpan where) const {
    return text_.substr(where.begin, where.end - where.begin);
  }
  /// As messages show it.
  [[nodiscard]] std::string text_of(ShortSpan where) const;

 private:
  std::string_view text_;
  ShortSpan block_;
  ShortSpan error_where_;
  std::optional<BlockError> error_;
};

/// Whether a word of keywords.def is one that BlockReader::refuse() refuses.
bool is_refused(std::string_view name);
/// Whether keywords.def has a word.
bool is_keyword(std::string_view name);

}  // namespace g31::sinumerik
