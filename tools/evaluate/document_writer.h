#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "tools/plot/growth.h"

namespace g31::evaluate {

/// Writes a JSON document entry by entry, for lists that are as long as a record has rows: the text
/// is that of nlohmann's dump(1) of the whole, and a line break.
class DocumentWriter {
 public:
  using Json = nlohmann::ordered_json;

  /// @param growth  told of each entry; outlives the writer
  explicit DocumentWriter(const plot::Growth& growth) : growth_(growth) {}

  /// Begins an object, as a value.
  void begin_object() { begin('{'); }
  void begin_list() { begin('['); }
  /// Ends what was begun last.
  void end();
  /// The name of the value that comes next, in an object.
  void name(std::string_view member);
  void value(const Json& value);

  /// Everything that was begun has ended.
  std::string finish();

 private:
  /// What is begun and has not ended.
  struct Level {
    bool is_object = false;
    bool is_empty = true;
  };

  void begin(char bracket);
  void begin_line(std::size_t depth);
  /// Of a value in a list, or behind a name.
  void begin_value();
  void grown();

  const plot::Growth& growth_;
  std::vector<Level> levels_;
  std::string text_;
  std::size_t told_ = 0;
};

}  // namespace g31::evaluate
