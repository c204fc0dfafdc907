#include "interpreter/dialects/sinumerik/code/nc_block_writer.h"

#include <algorithm>

namespace g31::sinumerik {

bool NcBlockWriter::add(FoundCode code) {
  const auto group = g_codes()[code.row].group;
  for (std::size_t i = nc_.first_code; i < program_.codes.size(); ++i) {
    if (g_codes()[unpacked(program_.codes[i]).row].group == group) {
      return false;
    }
  }
  program_.codes.push_back(packed(code));
  has_words_ = true;
  return true;
}

bool NcBlockWriter::add(Address address, double value) {
  std::vector<ConstantWord>& words = program_.words;
  const auto times =
      std::count_if(words.begin() + nc_.first_word, words.end(),
                    [address](const ConstantWord& word) { return word.address == address; });
  words.push_back({value, address});
  has_words_ = true;
  return times != most_in_block(address);
}

void NcBlockWriter::execute(ShortSpan block) {
  const Operand which = {Bank::Constants, static_cast<std::int32_t>(program_.nc_blocks.size())};
  // Counted in its place: a copy would wait for the counts.
  NcBlock& written = program_.nc_blocks.emplace_back(nc_);
  written.code_count = static_cast<std::uint16_t>(program_.codes.size() - nc_.first_code);
  written.word_count = static_cast<std::uint16_t>(program_.words.size() - nc_.first_word);
  nc_.first_code = static_cast<std::uint32_t>(program_.codes.size());
  nc_.first_word = static_cast<std::uint32_t>(program_.words.size());
  has_words_ = false;
  if (program_.ops.size() == code_.first_step() + 1) {
    code_.last().code = OpCode::NcBlock;
    code_.last().b = which;
  } else {
    code_.emit(OpCode::Execute, {}, {}, which, block);
  }
}

void NcBlockWriter::end(ShortSpan block) {
  if (ends_with_ != OpCode::Move) {
    code_.emit(ends_with_, {}, {}, {}, block);
    ends_with_ = OpCode::Move;
  }
}

void NcBlockWriter::take_back() {
  take_back_words();
  ends_with_ = OpCode::Move;
}

void NcBlockWriter::take_back_words() {
  program_.codes.resize(nc_.first_code);
  program_.words.resize(nc_.first_word);
  has_words_ = false;
}

}  // namespace g31::sinumerik
