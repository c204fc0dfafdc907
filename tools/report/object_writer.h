#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "interpreter/source/latin_1.h"

namespace g31::report {

/// Takes a text piece by piece.
using TextSink = std::function<void(std::string_view)>;

/// Writes a JSON object member by member, with memory for one piece at a time; the text is that of
/// nlohmann's dump(1) of the whole, and a line break.
class ObjectWriter {
 public:
  using Json = nlohmann::ordered_json;

  /// @param sink  outlives the writer
  explicit ObjectWriter(const TextSink& sink);

  void add(std::string_view name, const Json& value);

  /// A long string in UTF-8.
  void add_text(std::string_view name, std::string_view text);
  /// An object of such strings, each of Latin-1 characters, one byte each.
  void add_latin_1(std::string_view name, const std::map<std::string, std::string_view>& texts);

  /// An array.
  /// @param convert  (event) -> Json
  template <typename Events, typename Convert>
  void add_list(std::string_view name, const Events& events, const Convert& convert) {
    begin_member(name);
    bool is_first = true;
    for (const auto& event : events) {
      sink_(is_first ? "[\n  " : ",\n  ");
      write(convert(event), 2);
      is_first = false;
    }
    sink_(is_first ? "[]" : "\n ]");
  }

  void finish();

 private:
  void begin_member(std::string_view name);
  /// @param depth  of the line that the value begins in
  void write(const Json& value, int depth);
  void write_text(std::string_view text, source::AsUtf8 as_utf8);

  const TextSink& sink_;
  bool is_empty_ = true;
};

}  // namespace g31::report
