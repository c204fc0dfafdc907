#include <fmt/format.h>

#include "tools/manual/entries.h"
#include "tools/study/study_keys.h"

namespace g31::manual {
namespace {

using runtime::Entries;
using runtime::Entry;
using study::StudyKeyRow;
using study::StudySectionRow;

Entry entry_of_study_section(const StudySectionRow& row) {
  Entry entry{"section of a study file", std::string(row.example), std::string(row.text), {}};
  for (const StudyKeyRow& key : study::study_keys()) {
    if (key.section == row.id) {
      entry.facts.push_back({std::string(key.name), std::string(key.text)});
    }
  }
  return entry;
}

Entry entry_of_study_key(const StudySectionRow& section, const StudyKeyRow& row) {
  return {"key of a study file",
          fmt::format("{} {}", section.example, row.name),
          std::string(row.text),
          {{"without it",
            row.default_text.empty() ? "it has to be given" : std::string(row.default_text)},
           {"for example", std::string(row.example)}}};
}

}  // namespace

Entries study_entries(std::string_view topic) {
  std::string path(topic);
  std::erase_if(path, [](char c) { return c == '[' || c == ']'; });
  Entries found;
  for (const StudySectionRow& section : study::study_sections()) {
    if (section.path == path) {
      found.push_back(entry_of_study_section(section));
    }
    for (const StudyKeyRow& key : study::study_keys()) {
      const bool is_asked =
          path == key.name || path == fmt::format("{}.{}", section.path, key.name);
      if (key.section == section.id && is_asked) {
        found.push_back(entry_of_study_key(section, key));
      }
    }
  }
  return found;
}

Entries all_study_entries() {
  Entries all;
  for (const StudySectionRow& section : study::study_sections()) {
    all.push_back(entry_of_study_section(section));
    for (const StudyKeyRow& key : study::study_keys()) {
      if (key.section == section.id) {
        all.push_back(entry_of_study_key(section, key));
      }
    }
  }
  return all;
}

}  // namespace g31::manual
