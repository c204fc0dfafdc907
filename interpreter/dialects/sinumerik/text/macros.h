#pragma once

#include <bitset>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/dialects/sinumerik/text/scanner.h"
#include "interpreter/dialects/sinumerik/vocabulary/names.h"

namespace g31::sinumerik {

/// DEFINE name AS text: the tokens stand in the place of the name.
class Macro {
 public:
  /// Behind the others; what it says is kept.
  void add(Token token) {
    token.text = spellings_.emplace_back(token.text);
    tokens_.push_back(token);
  }
  [[nodiscard]] const std::vector<Token>& tokens() const { return tokens_; }

  Macro() = default;
  Macro(Macro&&) = default;
  Macro& operator=(Macro&&) = default;
  /// A copy by hand: tokens look at the spellings of their own macro.
  Macro(const Macro& other) {
    for (const Token& token : other.tokens_) {
      add(token);
    }
  }
  Macro& operator=(const Macro&) = delete;
  ~Macro() = default;

 private:
  std::vector<Token> tokens_;
  std::deque<std::string> spellings_;  ///< what the tokens say
};

/// Macros by name, upper case; a letter and a number (M6) is a name, too.
class Macros {
 public:
  /// @returns whether the name was free
  bool define(const std::string& name, Macro macro) {
    initials_.set(static_cast<unsigned char>(name.front()));
    return by_name_.emplace(name, std::move(macro)).second;
  }
  [[nodiscard]] bool empty() const { return by_name_.empty(); }
  /// nullptr: there is none.
  [[nodiscard]] const Macro* find(std::string_view name) const {
    const auto found = by_name_.find(name);
    return found != by_name_.end() ? &found->second : nullptr;
  }
  /// Whether a name begins so: most blocks have none that does.
  [[nodiscard]] bool have_initial(char c) const {
    return initials_.test(static_cast<unsigned char>(c));
  }

 private:
  NameMap<Macro> by_name_;
  std::bitset<256> initials_;
};

}  // namespace g31::sinumerik
