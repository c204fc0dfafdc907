#include "interpreter/dialects/sinumerik/code/compiler.h"

namespace g31::sinumerik {

/// Compiles a block that is made of plain words, as block() would.
///
/// @returns false: it is another one, or something is wrong with it; nothing of it is left
bool Compiler::plain_block(ShortSpan line) {
  if (has_letter_names_) {
    return false;
  }
  PlainWords words(text_, line);
  PlainWords::Read read = words.next();
  if (read != PlainWords::Read::Word) {
    return read == PlainWords::Read::End;
  }
  begin_block(words.where());
  const std::size_t numbers_before = program_->block_numbers.size();
  if (words.word().letter == 'N' && words.word().is_code) {
    program_->block_numbers.push_back(
        {static_cast<std::int32_t>(words.word().value), code_.here() - 1});
    read = words.next();
  }
  const bool has_statement = read == PlainWords::Read::Word;
  while (read == PlainWords::Read::Word && plain_word(words.word())) {
    read = words.next();
  }
  block_ = words.where();
  program_->spans.back() = block_;
  const bool is_plain = read == PlainWords::Read::End;
  if (is_plain && !failed()) {
    finish_words();
  }
  if (!is_plain || failed()) {
    program_->block_numbers.resize(numbers_before);
    take_back(code_.first_step());
    return false;
  }
  in_program_part_ = in_program_part_ || has_statement;
  end_block();
  return true;
}

/// @returns whether it can stand in a plain block
bool Compiler::plain_word(const PlainWord& word) {
  if (macros_.have_initial(word.letter) || globals_.macros.have_initial(word.letter)) {
    return false;
  }
  switch (word.letter) {
    case 'L':  // a call
    case 'N':
    case 'R':
      return false;
    case 'G':
      if (word.is_code) {
        g_code(find_g_code(word.value), block_);
      }
      return word.is_code;
    case 'M':
      if (word.is_code) {
        m_number(word.value, block_);
      }
      return word.is_code;
    default:
      break;
  }
  const int axis = axis_index(word.letter);
  const auto address =
      axis >= 0 ? static_cast<Address>(axis) : find_address(std::string_view(&word.letter, 1));
  if (address) {
    constant_word(*address, word.value, block_);
  }
  return address.has_value();
}

}  // namespace g31::sinumerik
