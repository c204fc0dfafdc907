#include "interpreter/dialects/fanuc/code/lathe.h"

#include <algorithm>
#include <array>
#include <span>

#include <fmt/format.h>

namespace g31::fanuc {
namespace {

using syntax::ValueForm;
using Words = std::span<const syntax::Word>;

/// Kinds of signs; SpeedLimit is enough by itself.
enum Sign : std::size_t { SpeedLimit, ToolWithOffset, SurfaceSpeed, Increments, kSigns };

bool is_plain(const syntax::Word& word) {
  return word.form == ValueForm::Integer || word.form == ValueForm::Decimal;
}

const syntax::Word* find(Words words, char letter) {
  for (const syntax::Word& word : words) {
    if (word.letter == letter) {
      return &word;
    }
  }
  return nullptr;
}

const syntax::Word* find_g(Words words, double code) {
  for (const syntax::Word& word : words) {
    if (word.letter == 'G' && is_plain(word) && word.number == code) {
      return &word;
    }
  }
  return nullptr;
}

/// T0101: station and offset, two digits each.
bool is_tool_with_offset(const syntax::Word& word) {
  constexpr int kStation = 100;
  return word.letter == 'T' && word.form == ValueForm::Integer && word.digits == 4 &&
         word.number >= kStation;
}

/// Whether a block may show a sign at all: hardly any of a long program does.
bool has_telling_letter(Words words) {
  return std::ranges::any_of(words, [](const syntax::Word& word) {
    return word.letter == 'S' || word.letter == 'T' || word.letter == 'U' || word.letter == 'W';
  });
}

/// G65 and the like take U and W as arguments, G04 U as a time, an M code may be set up to.
bool takes_any_letter(Words words) {
  return find_g(words, 4.0) != nullptr || find_g(words, 65.0) != nullptr ||
         find_g(words, 66.0) != nullptr || find(words, 'M') != nullptr;
}

/// The word of a block that is a sign of this kind.
const syntax::Word* sign_in(Words words, Sign sign) {
  const syntax::Word* const speed = find(words, 'S');
  switch (sign) {
    case SpeedLimit:
      return speed != nullptr ? find_g(words, 50.0) : nullptr;
    case SurfaceSpeed:
      return speed != nullptr ? find_g(words, 96.0) : nullptr;
    case ToolWithOffset:
      for (const syntax::Word& word : words) {
        if (is_tool_with_offset(word)) {
          return &word;
        }
      }
      return nullptr;
    case Increments:
      if (takes_any_letter(words)) {
        return nullptr;
      }
      return find(words, 'U') != nullptr ? find(words, 'U') : find(words, 'W');
    case kSigns:
      break;
  }
  return nullptr;
}

}  // namespace

std::optional<LatheSigns> lathe_signs(const CompiledProgram& program) {
  constexpr std::array<const char*, kSigns> kNames = {"G50 S", "T of four digits", "G96 S",
                                                      "U or W"};
  std::array<const syntax::Word*, kSigns> found{};
  for (const Step& step : program.steps) {
    if (step.kind != syntax::BlockKind::Nc) {
      continue;
    }
    const syntax::Block& block = program.tree->blocks[step.block];
    const Words words = Words(program.tree->words).subspan(block.first_word, block.word_count);
    if (!has_telling_letter(words)) {
      continue;
    }
    for (std::size_t sign = 0; sign < kSigns; ++sign) {
      if (found[sign] == nullptr) {
        found[sign] = sign_in(words, static_cast<Sign>(sign));
      }
    }
  }
  std::size_t kinds = 0;
  LatheSigns signs;
  for (std::size_t sign = 0; sign < kSigns; ++sign) {
    if (found[sign] != nullptr) {
      const bool is_first = ++kinds == 1 || found[sign]->span.begin < signs.where.begin;
      signs.where = is_first ? found[sign]->span : signs.where;
      signs.what += fmt::format("{}{}", kinds == 1 ? "" : ", ", kNames[sign]);
    }
  }
  const bool is_lathe = found[SpeedLimit] != nullptr || kinds >= 2;
  return is_lathe ? std::optional(std::move(signs)) : std::nullopt;
}

}  // namespace g31::fanuc
