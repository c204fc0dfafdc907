#include "tools/evaluate/document_writer.h"

#include <utility>

#include "machine/base/contract.h"

namespace g31::evaluate {

void DocumentWriter::begin_line(std::size_t depth) {
  text_ += '\n';
  text_.append(depth, ' ');
}

void DocumentWriter::begin_value() {
  if (levels_.empty() || levels_.back().is_object) {
    return;
  }
  if (!std::exchange(levels_.back().is_empty, false)) {
    text_ += ',';
  }
  begin_line(levels_.size());
}

void DocumentWriter::begin(char bracket) {
  begin_value();
  text_ += bracket;
  levels_.push_back({bracket == '{'});
}

void DocumentWriter::end() {
  G31_EXPECTS(!levels_.empty());
  const Level ended = levels_.back();
  levels_.pop_back();
  if (!ended.is_empty) {
    begin_line(levels_.size());
  }
  text_ += ended.is_object ? '}' : ']';
  grown();
}

void DocumentWriter::name(std::string_view member) {
  G31_EXPECTS(!levels_.empty() && levels_.back().is_object);
  if (!std::exchange(levels_.back().is_empty, false)) {
    text_ += ',';
  }
  begin_line(levels_.size());
  text_ += Json(member).dump() + ": ";
}

void DocumentWriter::value(const Json& value) {
  begin_value();
  for (const char c : value.dump(1, ' ', false, Json::error_handler_t::replace)) {
    text_ += c;
    if (c == '\n') {
      text_.append(levels_.size(), ' ');
    }
  }
  grown();
}

std::string DocumentWriter::finish() {
  G31_EXPECTS(levels_.empty());
  text_ += '\n';
  return std::move(text_);
}

void DocumentWriter::grown() {
  if (growth_) {
    growth_(text_.size() - std::exchange(told_, text_.size()));
  }
}

}  // namespace g31::evaluate
