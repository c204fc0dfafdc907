#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace g31::study {

/// Rows STUDY_SECTION of study_keys.def.
enum class StudySection {
#define STUDY_SECTION(id, path, form, example, text) id,
#define STUDY_KEY(id, section, name, type, limit, default_text, example, text)
#include "tools/study/study_keys.def"
#undef STUDY_SECTION
#undef STUDY_KEY
};

/// Rows STUDY_KEY of study_keys.def.
enum class StudyKey {
#define STUDY_SECTION(id, path, form, example, text)
#define STUDY_KEY(id, section, name, type, limit, default_text, example, text) id,
#include "tools/study/study_keys.def"
#undef STUDY_SECTION
#undef STUDY_KEY
};

enum class StudySectionForm { One, Named, List };
enum class StudyType { Text, Texts, Values, Number, WholeNumber };
enum class StudyLimit {
  Any,
  Reading,  ///< as numbers of the sheet whose unit another key says
  NotEmpty,
  Positive,
  Resolution,
  NotNegative,
  Choice
};

struct StudySectionRow {
  StudySection id;
  std::string_view path;
  StudySectionForm form;
  std::string_view example;
  std::string_view text;
};

struct StudyKeyRow {
  StudyKey id;
  StudySection section;
  std::string_view name;
  StudyType type;
  StudyLimit limit;
  std::string_view default_text;  ///< "": the key has to be given
  std::string_view example;
  std::string_view text;
};

/// All rows in the order of study_keys.def.
std::span<const StudySectionRow> study_sections();
std::span<const StudyKeyRow> study_keys();

const StudyKeyRow& row_of(StudyKey key);

/// The names of a section's keys.
std::vector<std::string_view> key_names(StudySection section);

/// What a key with the limit Choice takes.
std::vector<std::string_view> choices_of(const StudyKeyRow& row);

}  // namespace g31::study
