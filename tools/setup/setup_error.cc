#include "tools/setup/setup_error.h"

#include <algorithm>
#include <array>
#include <span>
#include <tuple>
#include <utility>

#include <fmt/args.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "interpreter/source/printable.h"
#include "machine/base/utf_8.h"

namespace g31::setup {
namespace {

constexpr auto kSetupErrorRows = std::to_array<SetupErrorRow>({
#define SETUP_ERROR(name, code, text, about) {code, text, about},
#include "tools/setup/setup_errors.def"
#undef SETUP_ERROR
});

/// Longest piece of a source line that is shown, in characters.
constexpr std::size_t kShownColumns = 120;

/// Longest detail of a message, in bytes.
constexpr std::size_t kLongestDetail = 400;

const SetupErrorRow& row_of(SetupErrorId id) {
  return kSetupErrorRows.at(static_cast<std::size_t>(id));
}

/// The characters of a line, fit to be shown.
std::vector<std::string> shown_characters(std::string_view line) {
  std::vector<std::string> characters;
  while (!line.empty()) {
    const std::size_t bytes = bytes_of_characters(line, 1);
    characters.push_back(source::printable(line.substr(0, bytes)));
    line.remove_prefix(bytes);
  }
  return characters;
}

/// A detail of a message: one line of bounded length, whatever a sheet put into it.
std::string shortened(std::string_view detail) {
  const std::string text = source::printable(detail.substr(0, kLongestDetail));
  return detail.size() > kLongestDetail ? text + "..." : text;
}

/// The source line and the caret under it.
std::string excerpt(const SetupError& error) {
  const std::vector<std::string> characters = shown_characters(error.source_line);
  const auto column = static_cast<std::size_t>(std::max(error.column, 1)) - 1;
  const std::size_t before = std::min(column, characters.size());
  const bool cut = characters.size() > kShownColumns && before > kShownColumns / 2;
  const std::size_t from = cut ? before - kShownColumns / 2 : 0;
  const std::size_t until = std::min(characters.size(), from + kShownColumns);
  const auto shown = [&characters](std::size_t first, std::size_t end) {
    return fmt::format("{}", fmt::join(std::span(characters).subspan(first, end - first), ""));
  };
  return fmt::format("{:5} | {}\n{:5} | {}^\n", error.line, shown(from, until), "",
                     std::string(source::cell_count(shown(from, before)), ' '));
}

}  // namespace

std::span<const SetupErrorRow> setup_error_rows() {
  return kSetupErrorRows;
}

std::string_view code_of(SetupErrorId id) {
  return row_of(id).code;
}

std::string message_of(SetupErrorId id, std::initializer_list<std::string_view> details) {
  fmt::dynamic_format_arg_store<fmt::format_context> store;
  for (const std::string_view detail : details) {
    store.push_back(shortened(detail));
  }
  return fmt::vformat(row_of(id).text, store);
}

std::string render(const SetupError& error) {
  const std::string file = source::printable(error.file);
  if (error.line <= 0) {
    return fmt::format("{}: error: {} [{}]\n", file, error.message, error.code);
  }
  std::string text = fmt::format("{}:{}:{}: error: {} [{}]\n{}", file, error.line, error.column,
                                 error.message, error.code, excerpt(error));
  if (!error.remedy.empty()) {
    text += fmt::format("{:5} = {}\n", "", error.remedy);
  }
  return text;
}

source::ShownPlace place_of(const Location& where) {
  return {where.document->path, where.line, where.column,
          std::string(where.document->line(where.line))};
}

SetupError error_at(source::ShownPlace place, SetupErrorId id,
                    std::initializer_list<std::string_view> details, std::string remedy) {
  return {std::move(place.file),
          place.line,
          place.column,
          message_of(id, details),
          std::string(code_of(id)),
          std::move(place.text),
          std::move(remedy)};
}

void ErrorList::add(SetupErrorId id, const Location& where,
                    std::initializer_list<std::string_view> details, std::string remedy) {
  add(where.document->order, error_at(place_of(where), id, details, std::move(remedy)));
}

void ErrorList::add(std::size_t order, SetupError error) {
  items_.push_back({order, std::move(error)});
}

SetupErrors ErrorList::in_file_order() const {
  std::vector<Item> sorted = items_;
  std::ranges::stable_sort(sorted, {}, [](const Item& item) {
    return std::tuple(item.order, item.error.line, item.error.column);
  });
  SetupErrors errors;
  errors.reserve(sorted.size());
  for (Item& item : sorted) {
    errors.push_back(std::move(item.error));
  }
  return errors;
}

}  // namespace g31::setup
