#include "interpreter/dialects/sinumerik/text/plain_words.h"

#include "interpreter/dialects/sinumerik/text/digits.h"
#include "interpreter/dialects/sinumerik/vocabulary/names.h"

namespace g31::sinumerik {
namespace {

constexpr std::size_t kCodeDigits = 9;  // fit into 32 bits

}  // namespace

void PlainWords::skip_blanks() {
  while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\r')) {
    ++at_;
  }
}

PlainWords::Read PlainWords::next() {
  skip_blanks();
  if (at_ == text_.size() || text_[at_] == ';') {
    return Read::End;
  }
  const std::size_t first = at_;
  word_.letter = upper(text_[at_]);
  if (word_.letter < 'A' || word_.letter > 'Z') {
    return Read::Other;
  }
  ++at_;
  skip_blanks();
  const char sign = at_ < text_.size() ? text_[at_] : ' ';
  const bool is_signed = sign == '-' || sign == '+';
  const std::size_t begin = is_signed ? at_ + 1 : at_;
  const Digits digits = digits_at(text_, begin);
  const std::size_t count = digits.end - begin - digits.points;
  const char behind = digits.end < text_.size() ? upper(text_[digits.end]) : ' ';
  if (count == 0 || !digits.are_exact(begin) || behind == 'E') {  // 1EX3
    return Read::Other;
  }
  word_.value = sign == '-' ? -digits.value() : digits.value();
  word_.is_code = !is_signed && digits.points == 0 && count <= kCodeDigits;
  at_ = digits.end;
  where_ = {where_.end == 0 ? static_cast<std::uint32_t>(first) : where_.begin,
            static_cast<std::uint32_t>(at_)};
  return Read::Word;
}

}  // namespace g31::sinumerik
