#include "tools/manual/manual.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <variant>

#include "machine/base/letters.h"
#include "machine/base/nearest_name.h"
#include "parts/artefacts/artefact.h"
#include "tools/evaluate/manual.h"
#include "tools/manual/entries.h"
#include "tools/session/manual.h"
#include "tools/setup/keys.h"
#include "tools/setup/variable_name.h"

namespace g31::manual {
namespace {

using runtime::Entries;
using runtime::Entry;

void append(Entries& all, Entries more) {
  std::ranges::move(more, std::back_inserter(all));
}

std::vector<std::string> words_in(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = text.find_first_not_of(' ', at);
    if (begin == std::string_view::npos) {
      break;
    }
    at = std::min(text.find(' ', begin), text.size());
    words.push_back(in_small_letters(text.substr(begin, at - begin)));
  }
  return words;
}

/// Whether a word of the text begins with `word`; both in small letters.  Decimals are none: 9999
/// is not in 9.9999.
bool has_word(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos;
       at = text.find(word, at + 1)) {
    const char before = at > 0 ? text[at - 1] : ' ';
    const bool goes_on = std::isalnum(static_cast<unsigned char>(before)) != 0 ||
                         (before == '.' && setup::is_digit(word.front()));
    if (!goes_on) {
      return true;
    }
  }
  return false;
}

bool has_words(const std::string& text, const std::vector<std::string>& words) {
  const std::string small = in_small_letters(text);
  return std::ranges::all_of(words, [&](const std::string& word) { return has_word(small, word); });
}

bool has_measuring_cycles(const session::Control& control) {
  return std::holds_alternative<session::SinumerikControl>(control);
}

}  // namespace

Entries explain(const std::string& topic, const session::Control& control) {
  Entries found = session::explain(topic, control);
  if (has_measuring_cycles(control)) {
    append(found, parameter_entries(topic));
  }
  append(found, sheet_entries(topic));
  append(found, shape_entries(topic));
  append(found, study_entries(topic));
  append(found, evaluate::explain(topic));
  append(found, code_entries(topic));
  return found;
}

Entries everything(const session::Control& control) {
  Entries all = session::everything(control);
  if (has_measuring_cycles(control)) {
    append(all, all_parameter_entries());
  }
  append(all, all_sheet_entries());
  append(all, all_shape_entries());
  append(all, all_study_entries());
  append(all, evaluate::everything());
  append(all, all_code_entries());
  return all;
}

Entries search(const Entries& entries, std::string_view words) {
  const std::vector<std::string> wanted = words_in(words);
  Entries by_name;
  Entries by_text;
  if (wanted.empty()) {
    return by_name;
  }
  for (const Entry& entry : entries) {
    if (has_words(entry.name, wanted)) {
      by_name.push_back(entry);
    } else if (has_words(entry.name + ' ' + entry.kind + ' ' + entry.text, wanted)) {
      by_text.push_back(entry);
    }
  }
  append(by_name, std::move(by_text));
  return by_name;
}

std::optional<std::string> nearest_name_of(const std::string& topic) {
  std::vector<std::string_view> known;
  for (const setup::SectionRow& row : setup::section_rows()) {
    known.push_back(row.path);
  }
  for (const setup::KeyRow& row : setup::key_rows()) {
    if (row.name_form == setup::NameForm::Exact) {
      known.push_back(row.name);
    }
  }
  for (const parts::Shape& shape : parts::shapes()) {
    known.push_back(shape.name);
  }
  std::vector<std::string> codes;
  for (const Entry& entry : all_code_entries()) {
    codes.push_back(entry.name);
  }
  known.insert(known.end(), codes.begin(), codes.end());
  const auto nearest = nearest_name(topic, known);
  return nearest ? std::optional(std::string(*nearest)) : std::nullopt;
}

}  // namespace g31::manual
