#pragma once

#include <bitset>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/dialects/sinumerik/text/scanner.h"
#include "interpreter/dialects/sinumerik/vocabulary/names.h"

namespace g31::sinumerik {

/// DEFINE name AS text: the tokens stand in the place of the name.
struct Macro {
  std::vector<Token> tokens;
  std::deque<std::string> spellings;  ///< what the tokens say
};

/// Macros by name, upper case; a letter and a number (M6) is a name, too.
class Macros {
 public:
  /// @returns whether the name was free
  bool define(const std::string& name, std::shared_ptr<const Macro> macro) {
    initials_.set(static_cast<unsigned char>(name.front()));
    return by_name_.emplace(name, std::move(macro)).second;
  }
  [[nodiscard]] bool empty() const { return by_name_.empty(); }
  /// nullptr: there is none.
  [[nodiscard]] const Macro* find(std::string_view name) const {
    const auto found = by_name_.find(name);
    return found != by_name_.end() ? found->second.get() : nullptr;
  }
  /// Whether a name begins so: most blocks have none that does.
  [[nodiscard]] bool have_initial(char c) const {
    return initials_.test(static_cast<unsigned char>(c));
  }

 private:
  NameMap<std::shared_ptr<const Macro>> by_name_;
  std::bitset<256> initials_;
};

}  // namespace g31::sinumerik
