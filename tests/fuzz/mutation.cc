#include "tests/fuzz/mutation.h"

#include <algorithm>
#include <string_view>

#include "machine/base/contract.h"
#include "tests/fuzz/draws.h"

namespace g31::fuzz {
namespace {

/// Longest piece that a change moves.
constexpr std::size_t kPiece = 40;

void change(std::string& text, Draws& draws, std::span<const std::string> texts,
            std::span<const std::string> words) {
  using namespace std::string_view_literals;
  constexpr auto kBytes = "0123456789.-+*/[]#=()%\n\r GXYZIJKRQPLNOMHDF,:;<>\"'$_\x00\xFF"sv;
  const std::size_t at = draws.below(text.size() + 1);
  const std::size_t length = std::min(draws.below(kPiece), text.size() - at);
  switch (draws.below(5)) {
    case 0:
      text.replace(at, at < text.size() ? 1 : 0, 1, kBytes[draws.below(kBytes.size())]);
      return;
    case 1:
      text.erase(at, length);
      return;
    case 2:
      text.insert(at, text.substr(at, length));
      return;
    case 3:
      text.insert(at, words[draws.below(words.size())]);
      return;
    default: {
      const std::string& other = texts[draws.below(texts.size())];
      text.insert(at, other.substr(draws.below(other.size() + 1), kPiece));
      return;
    }
  }
}

}  // namespace

std::string mutation(std::uint64_t number, std::span<const std::string> texts,
                     std::span<const std::string> words) {
  G31_EXPECTS(!texts.empty() && !words.empty());
  Draws draws(number);
  std::string text = texts[number % texts.size()];
  for (std::size_t changes = 1 + draws.below(4); changes > 0; --changes) {
    change(text, draws, texts, words);
  }
  return text;
}

}  // namespace g31::fuzz
