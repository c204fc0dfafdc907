#include "tools/plan/printed_results.h"

#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "machine/base/utf_8.h"
#include "tools/plan/json_document.h"

namespace g31::plan {
namespace {

using RunJson = nlohmann::json;

/// No line of names and values begins so.
bool is_document(std::string_view text) {
  text.remove_prefix(text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin != text.npos && text[begin] == '{';
}

std::string names_of(const RunJson& files) {
  std::string names;
  for (const auto& [name, text] : files.items()) {
    names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

}  // namespace

Result<PrintedResults, std::string> printed_results(const std::string& name, std::string text) {
  if (!is_document(text)) {
    return PrintedResults{name, std::move(text)};
  }
  auto read = json_document(name, text, "lines of names and values, or the document of a run");
  if (!read) {
    return read.error();
  }
  const RunJson& run = read.value();
  if (run.value("schema", RunJson()) != "g31.run/1") {
    return fmt::format(
        "{}: expected a document with \"schema\": \"g31.run/1\", as g31 run --json "
        "writes it",
        name);
  }
  const RunJson output = run.value("output", RunJson());
  if (output.is_string() && !output.get<std::string>().empty()) {
    return PrintedResults{name + ": output", output.get<std::string>()};
  }
  const RunJson files = run.value("files", RunJson::object());
  if (!files.is_object() || files.size() != 1 || !files.begin()->is_string()) {
    return fmt::format("{}: its program printed nothing and wrote {}; expected one file of results",
                       name, files.size() > 1 ? "several files: " + names_of(files) : "no file");
  }
  return PrintedResults{fmt::format("{}: {}", name, files.begin().key()),
                        files.begin()->get<std::string>()};
}

}  // namespace g31::plan
