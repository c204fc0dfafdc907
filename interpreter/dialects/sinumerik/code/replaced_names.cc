#include "interpreter/dialects/sinumerik/code/replaced_names.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace g31::sinumerik {
namespace {

/// How many tokens macros may add to a block: a block of a control has 512 characters.
constexpr std::size_t kMostAdded = 1024;

using SeenMacros = std::span<const Macros* const>;

bool may_be_macro(const Token& token, SeenMacros seen) {
  return (token.kind == TokenKind::Name || token.kind == TokenKind::Letter) &&
         std::ranges::any_of(
             seen, [&](const Macros* macros) { return macros->have_initial(token.text.front()); });
}

const Macro* find_macro(std::string_view name, SeenMacros seen) {
  for (const Macros* const macros : seen) {
    if (const Macro* const macro = macros->find(name)) {
      return macro;
    }
  }
  return nullptr;
}

}  // namespace

bool expand_macros(std::vector<Token>& tokens, SeenMacros seen) {
  if (std::ranges::none_of(tokens, [&](const Token& token) { return may_be_macro(token, seen); })) {
    return true;
  }
  std::vector<Token> all;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    std::string name(tokens[i].text);
    std::size_t used = 1;
    if (tokens[i].kind == TokenKind::Letter && tokens[i + 1].kind == TokenKind::Integer) {
      name += tokens[i + 1].text;
      used = 2;
    }
    const bool is_name = tokens[i].kind == TokenKind::Name || used == 2;
    const bool is_being_defined = i > 0 && tokens[i - 1].is_name("DEFINE");
    const Macro* const macro = find_macro(name, seen);
    if (!is_name || is_being_defined || macro == nullptr) {
      all.push_back(tokens[i]);
      continue;
    }
    if (all.size() + macro->tokens.size() > tokens.size() + kMostAdded) {
      return false;
    }
    const syntax::ShortSpan where = tokens[i].where;
    for (Token token : macro->tokens) {
      token.where = where;
      all.push_back(token);
    }
    i += used - 1;
  }
  tokens = std::move(all);
  return true;
}

void find_letter_names(std::vector<Token>& tokens, const NameMap<std::int32_t>& locals) {
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    const bool numbered =
        tokens[i + 1].kind == TokenKind::Integer || tokens[i + 1].kind == TokenKind::Real;
    if (tokens[i].kind == TokenKind::Letter && tokens[i + 1].kind == TokenKind::Integer) {
      const auto known = locals.find(std::string(tokens[i].text) + std::string(tokens[i + 1].text));
      if (known != locals.end()) {
        tokens[i].kind = TokenKind::Name;
        tokens[i].text = known->first;
        tokens[i].where.end = tokens[i + 1].where.end;
        tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(i) + 1);
        continue;
      }
    }
    if (tokens[i].kind == TokenKind::Letter && !numbered && locals.contains(tokens[i].text)) {
      tokens[i].kind = TokenKind::Name;
    }
  }
}

}  // namespace g31::sinumerik
