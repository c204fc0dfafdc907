#include "interpreter/dialects/fanuc/code/lathe.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <span>
#include <string_view>

#include <fmt/format.h>

namespace g31::fanuc {
namespace {

using syntax::ValueForm;
using syntax::Word;
using Words = std::span<const Word>;

bool is_plain(const Word& word) {
  return word.form == ValueForm::Integer || word.form == ValueForm::Decimal;
}

const Word* find(Words words, char letter) {
  const auto found = std::ranges::find(words, letter, &Word::letter);
  return found != words.end() ? &*found : nullptr;
}

bool has(Words words, char letter) {
  return find(words, letter) != nullptr;
}

bool has_one(Words words, char letter) {
  return std::ranges::count(words, letter, &Word::letter) == 1;
}

const Word* find_code(Words words, char letter, std::initializer_list<double> codes) {
  const auto found = std::ranges::find_if(words, [&](const Word& word) {
    return word.letter == letter && is_plain(word) &&
           std::ranges::find(codes, word.number) != codes.end();
  });
  return found != words.end() ? &*found : nullptr;
}

constexpr int kStation = 100;

/// T0101: station and offset, two digits each.
bool is_tool_with_offset(const Word& word) {
  return word.letter == 'T' && word.form == ValueForm::Integer && word.digits == 4 &&
         word.number >= kStation;
}

/// A station with its own offset: what training lathes change by M06.
bool is_station_with_its_offset(const Word& word) {
  const auto number = static_cast<int>(is_tool_with_offset(word) ? word.number : 0.0);
  return number != 0 && number / kStation == number % kStation;
}

/// Whether a block may call a macro where the control is set up so, or makes later ones call: its
/// words are arguments.
bool may_call(Words words) {
  return std::ranges::any_of(words, [](const Word& word) {
    return word.letter == 'G' && (!is_plain(word) || word.number >= kFirstCallingCode ||
                                  word.number == 66.0 || word.number == 66.1);
  });
}

/// G04 U is a time, and an M code may be set up to call a macro.
bool takes_any_letter(Words words) {
  return may_call(words) || find_code(words, 'G', {4.0}) != nullptr || has(words, 'M');
}

const Word* speed_limit(Words words) {
  return has(words, 'S') ? find_code(words, 'G', {50.0}) : nullptr;
}

const Word* tool_with_offset(Words words) {
  const auto found = std::ranges::find_if(words, is_tool_with_offset);
  return found != words.end() && !may_call(words) ? &*found : nullptr;
}

const Word* surface_speed(Words words) {
  return has(words, 'S') ? find_code(words, 'G', {96.0}) : nullptr;
}

const Word* increments(Words words) {
  const Word* const u = find(words, 'U');
  const Word* const word = u != nullptr ? u : find(words, 'W');
  return word != nullptr && !takes_any_letter(words) ? word : nullptr;
}

/// G92 of system A cuts a thread; a preset has no feed.
const Word* thread(Words words) {
  const bool is_of_a_lathe = has(words, 'F') && !has(words, 'Y') && has(words, 'Z');
  return is_of_a_lathe ? find_code(words, 'G', {92.0}) : nullptr;
}

/// G90 and G94 of system A turn; a mill says so of its points, and mostly that it cuts, too.
const Word* turning_cycle(Words words) {
  const bool is_of_a_lathe =
      has(words, 'F') && has(words, 'X') && has(words, 'Z') && !has(words, 'Y') && !has(words, 'R');
  return is_of_a_lathe && has_one(words, 'G') ? find_code(words, 'G', {90.0, 94.0}) : nullptr;
}

/// G50 X Z of system A sets coordinates; on a mill G50 ends scaling, in a line that makes all safe.
const Word* coordinates_set(Words words) {
  const auto is_other = [](const Word& word) {
    return word.letter != 'G' && word.letter != 'N' && word.letter != 'X' && word.letter != 'Z';
  };
  const bool is_of_a_lathe = has(words, 'X') && has(words, 'Z') &&
                             std::ranges::none_of(words, is_other) && has_one(words, 'G');
  return is_of_a_lathe ? find_code(words, 'G', {50.0}) : nullptr;
}

/// G97 S M3: a mill without constant cutting speed has no need of it.
const Word* speed_kept(Words words) {
  return has(words, 'S') ? find_code(words, 'G', {97.0}) : nullptr;
}

/// G70 to G73 with the first and the last block of a contour.
const Word* contour_cycle(Words words) {
  return has(words, 'P') && has(words, 'Q') && !has(words, 'R')
             ? find_code(words, 'G', {70.0, 71.0, 72.0, 73.0})
             : nullptr;
}

/// G10 P X Z: an offset for each axis; a mill has one number for a tool, its P says of what with L.
const Word* offset_of_axes(Words words) {
  const bool has_axis = has(words, 'X') || has(words, 'Z');
  return has(words, 'P') && has_axis && !has(words, 'L') ? find_code(words, 'G', {10.0}) : nullptr;
}

/// An arc with the centre that it has in ZX.
const Word* turned_arc(Words words) {
  const bool is_in_zx = has(words, 'Z') && has(words, 'K') && !has(words, 'Y') && !has(words, 'J');
  return is_in_zx ? find_code(words, 'G', {2.0, 3.0}) : nullptr;
}

/// Feed per minute and per revolution of system A; a mill has them beside its canned cycles.
const Word* kind_of_feed(Words words) {
  return find_code(words, 'G', {98.0, 99.0});
}

enum class Weight {
  Alone,  ///< is enough where nothing speaks for a mill
  Strong,
  Weak
};

struct Sign {
  std::string_view name;
  Weight weight;
  const Word* (*find)(Words words);
};

constexpr Sign kSigns[] = {
    {"G50 S", Weight::Alone, speed_limit},
    {"T of four digits", Weight::Strong, tool_with_offset},
    {"G96 S", Weight::Strong, surface_speed},
    {"U or W", Weight::Strong, increments},
    {"G92 X Z F", Weight::Strong, thread},
    {"G70 to G73 P Q", Weight::Strong, contour_cycle},
    {"G10 P X Z without L", Weight::Strong, offset_of_axes},
    {"G50 X Z", Weight::Strong, coordinates_set},
    {"G90 or G94 X Z F", Weight::Weak, turning_cycle},
    {"G97 S", Weight::Weak, speed_kept},
    {"an arc in ZX without G18", Weight::Weak, turned_arc},
    {"G98 or G99 as kind of feed", Weight::Weak, kind_of_feed},
};

/// What of a program speaks for a mill.
struct MillSigns {
  bool changes_tool_by_t = false;  ///< T10 M6 in one block: no turret is told so
  bool changes_tool = false;       ///< M6
  bool changes_station = false;    ///< T0101 M6, which is no sign where nothing is milled
  bool is_milled = false;          ///< Y, a length offset or a plane that no turning is in
  bool selects_zx = false;         ///< G18
  bool has_surface_speed = false;  ///< G96, of which G97 is the end on any machine

  void look_at(Words words) {
    const bool has_change = find_code(words, 'M', {6.0}) != nullptr;
    const bool is_station = std::ranges::any_of(words, is_station_with_its_offset);
    changes_station |= has_change && is_station;
    changes_tool |= has_change && !is_station;
    changes_tool_by_t |= has_change && !is_station && has(words, 'T');
    has_surface_speed |= find_code(words, 'G', {96.0}) != nullptr;
    selects_zx |= find_code(words, 'G', {18.0}) != nullptr;
    is_milled |=
        has(words, 'Y') || find_code(words, 'G', {17.0, 19.0, 43.0, 44.0, 49.0}) != nullptr;
  }

  /// Whether one sign is not enough, whichever it is: G50 S in the line that makes all functions of
  /// a mill safe is the end of scaling and a speed.
  [[nodiscard]] bool speak() const { return is_milled || changes_tool; }

  [[nodiscard]] bool acquit(const Sign& sign) const {
    const bool changes_by_t = changes_tool_by_t || (changes_station && is_milled);
    return (sign.weight == Weight::Strong && changes_by_t) ||
           (sign.weight == Weight::Weak && speak()) ||
           (sign.find == tool_with_offset && changes_tool) ||
           (sign.find == turned_arc && selects_zx) ||
           (sign.find == speed_kept && has_surface_speed);
  }
};

/// Whether a word may be a sign or speak for a mill.
/// @param is_milled  is known already
bool may_tell(const Word& word, bool is_milled) {
  constexpr double kArc = 3.0;  // G00 to G03 are no signs; a centre K is
  switch (word.letter) {
    case 'G':
      return !is_plain(word) || word.number > kArc;
    case 'Y':
      return !is_milled;
    case 'K':
    case 'M':
    case 'T':
    case 'U':
    case 'W':
      return true;
    default:
      return false;
  }
}

/// The same of a block: lines and arcs of points and calls, of which long programs are made, do
/// not.
bool may_tell(Words words, bool is_milled) {
  constexpr double kMacroCall = 65.0;  // its words are arguments
  bool tells = false;
  for (const Word& word : words) {
    if (word.letter == 'G' && word.number == kMacroCall) {
      return false;
    }
    tells = tells || may_tell(word, is_milled);
  }
  return tells;
}

/// The first block of each kind of sign in a program.
struct Found {
  std::array<const Word*, std::size(kSigns)> words{};
  MillSigns mill;
};

Found look_through(const CompiledProgram& program) {
  Found found;
  bool calls_each_block = false;  // G66.1 until G67
  for (const Step& step : program.steps) {
    if (step.kind != syntax::BlockKind::Nc) {
      continue;
    }
    const syntax::Block& block = program.tree->blocks[step.block];
    const Words words = Words(program.tree->words).subspan(block.first_word, block.word_count);
    if (!may_tell(words, found.mill.is_milled)) {
      continue;
    }
    calls_each_block = (calls_each_block || find_code(words, 'G', {66.1}) != nullptr) &&
                       find_code(words, 'G', {67.0}) == nullptr;
    found.mill.look_at(words);
    for (std::size_t sign = 0; sign < std::size(kSigns) && !calls_each_block; ++sign) {
      if (found.words[sign] == nullptr) {
        found.words[sign] = kSigns[sign].find(words);
      }
    }
  }
  return found;
}

}  // namespace

std::optional<LatheSigns> lathe_signs(const CompiledProgram& program, bool has_y) {
  const Found found = look_through(program);
  std::size_t kinds = 0;
  bool is_lathe = false;
  LatheSigns signs;
  for (std::size_t i = 0; i < std::size(kSigns); ++i) {
    const Word* const word = found.words[i];
    if (word == nullptr || found.mill.acquit(kSigns[i])) {
      continue;
    }
    const bool is_first = ++kinds == 1 || word->span.begin < signs.where.begin;
    signs.where = is_first ? word->span : signs.where;
    signs.what += fmt::format("{}{}", kinds == 1 ? "" : ", ", kSigns[i].name);
    const bool is_enough = (kSigns[i].weight == Weight::Alone && !found.mill.speak()) ||
                           (kSigns[i].weight == Weight::Strong && !has_y);
    is_lathe = is_lathe || kinds >= 2 || is_enough;
  }
  return is_lathe ? std::optional(std::move(signs)) : std::nullopt;
}

}  // namespace g31::fanuc
