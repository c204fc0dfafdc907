#include "tools/study/study_keys.h"

#include <algorithm>
#include <array>

namespace g31::study {
namespace {

constexpr auto kSections = std::to_array<StudySectionRow>({
#define STUDY_SECTION(id, path, form, example, text) \
  {StudySection::id, path, StudySectionForm::form, example, text},
#define STUDY_KEY(id, section, name, type, limit, default_text, example, text)
#include "tools/study/study_keys.def"
#undef STUDY_SECTION
#undef STUDY_KEY
});

constexpr auto kKeys = std::to_array<StudyKeyRow>({
#define STUDY_SECTION(id, path, form, example, text)
#define STUDY_KEY(id, section, name, type, limit, default_text, example, text) \
  {StudyKey::id,      StudySection::section, name,    StudyType::type,         \
   StudyLimit::limit, default_text,          example, text},
#include "tools/study/study_keys.def"
#undef STUDY_SECTION
#undef STUDY_KEY
});

}  // namespace

std::span<const StudySectionRow> study_sections() {
  return kSections;
}

std::span<const StudyKeyRow> study_keys() {
  return kKeys;
}

const StudyKeyRow& row_of(StudyKey key) {
  return kKeys.at(static_cast<std::size_t>(key));
}

std::vector<std::string_view> key_names(StudySection section) {
  std::vector<std::string_view> names;
  for (const StudyKeyRow& row : kKeys) {
    if (row.section == section) {
      names.push_back(row.name);
    }
  }
  return names;
}

std::vector<std::string_view> choices_of(const StudyKeyRow& row) {
  constexpr std::string_view kOr = " or ";
  std::vector<std::string_view> choices;
  std::string_view rest = row.default_text;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(kOr), rest.size());
    choices.push_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + kOr.size(), rest.size()));
  }
  return choices;
}

}  // namespace g31::study
