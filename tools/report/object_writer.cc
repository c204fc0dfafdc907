#include "tools/report/object_writer.h"

#include <algorithm>

namespace g31::report {
namespace {

std::string dumped(const ObjectWriter::Json& value) {
  return value.dump(1, ' ', false, ObjectWriter::Json::error_handler_t::replace);
}

}  // namespace

ObjectWriter::ObjectWriter(const TextSink& sink) : sink_(sink) {
  sink_("{");
}

void ObjectWriter::finish() {
  sink_(is_empty_ ? "}\n" : "\n}\n");
}

void ObjectWriter::begin_member(std::string_view name) {
  sink_(is_empty_ ? "\n " : ",\n ");
  is_empty_ = false;
  sink_(dumped(name));
  sink_(": ");
}

void ObjectWriter::add(std::string_view name, const Json& value) {
  begin_member(name);
  write(value, 1);
}

/// Line breaks in strings are escaped: those of the text stand between lines.
void ObjectWriter::write(const Json& value, int depth) {
  const std::string text = dumped(value);
  const std::string deeper(static_cast<std::size_t>(depth), ' ');
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    sink_(std::string_view(text).substr(begin, end - begin));
    if (text[end - 1] == '\n') {
      sink_(deeper);
    }
    begin = end;
  }
}

void ObjectWriter::write_text(std::string_view text, source::AsUtf8 as_utf8) {
  constexpr std::size_t kPiece = 65536;
  sink_("\"");
  while (!text.empty()) {
    std::size_t size = std::min(kPiece, text.size());
    while (size < text.size() && (static_cast<unsigned char>(text[size]) & 0xC0U) == 0x80U) {
      ++size;  // no character is cut
    }
    const std::string quoted = dumped(as_utf8(text.substr(0, size)));
    sink_(std::string_view(quoted).substr(1, quoted.size() - 2));
    text.remove_prefix(size);
  }
  sink_("\"");
}

void ObjectWriter::add_text(std::string_view name, std::string_view text) {
  begin_member(name);
  write_text(text, [](std::string_view piece) { return std::string(piece); });
}

void ObjectWriter::add_latin_1(std::string_view name,
                               const std::map<std::string, std::string_view>& texts) {
  begin_member(name);
  bool is_first = true;
  for (const auto& [key, text] : texts) {
    sink_(is_first ? "{\n  " : ",\n  ");
    sink_(dumped(key));
    sink_(": ");
    write_text(text, &source::text_as_utf8);
    is_first = false;
  }
  sink_(is_first ? "{}" : "\n }");
}

}  // namespace g31::report
