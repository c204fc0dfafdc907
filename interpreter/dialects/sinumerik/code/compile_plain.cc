#include <algorithm>

#include "interpreter/dialects/sinumerik/code/compiler.h"

namespace g31::sinumerik {

/// Compiles a block that is made of plain words, as read_block() would.
///
/// @returns false: it is another one, or something is wrong with it; nothing of it is left
bool Compiler::plain_block(ShortSpan line) {
  if (definitions_.have_letter_names()) {
    return false;
  }
  PlainWords words(text_, line);
  PlainWords::Read read = words.next();
  if (read != PlainWords::Read::Word) {
    return read == PlainWords::Read::End;
  }
  begin_block(words.where());
  const std::size_t numbers_before = program_.block_numbers.size();
  if (words.word().letter == 'N' && words.word().is_code) {
    program_.block_numbers.push_back(
        {static_cast<std::int32_t>(words.word().value), code_.here() - 1});
    read = words.next();
  }
  const bool has_statement = read == PlainWords::Read::Word;
  while (read == PlainWords::Read::Word && plain_word(words.word())) {
    read = words.next();
  }
  reader_.set_block(words.where());
  program_.spans.back() = block();
  const bool is_plain = read == PlainWords::Read::End;
  if (is_plain && !failed()) {
    words_.finish_block();
  }
  if (!is_plain || failed()) {
    program_.block_numbers.resize(numbers_before);
    take_back(code_.first_step());
    return false;
  }
  if (has_statement) {
    definitions_.begin_program_part();
  }
  end_block();
  return true;
}

/// @returns whether it can stand in a plain block
bool Compiler::plain_word(const PlainWord& word) {
  if (std::ranges::any_of(
          seen_macros_, [&](const Macros* macros) { return macros->have_initial(word.letter); })) {
    return false;
  }
  switch (word.letter) {
    case 'L':  // a call
    case 'N':
    case 'R':
      return false;
    case 'G':
      if (word.is_code) {
        words_.g_code(find_g_code(word.value), block());
      }
      return word.is_code;
    case 'M':
      if (word.is_code) {
        words_.m_number(word.value, block());
      }
      return word.is_code;
    default:
      break;
  }
  const int axis = axis_index(word.letter);
  const auto address =
      axis >= 0 ? static_cast<Address>(axis) : find_address(std::string_view(&word.letter, 1));
  if (address) {
    words_.constant_word(*address, word.value, block());
  }
  return address.has_value();
}

}  // namespace g31::sinumerik
