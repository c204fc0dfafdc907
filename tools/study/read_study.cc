#include "tools/study/read_study.h"

#include "tools/setup/document.h"
#include "tools/study/check_study.h"
#include "tools/study/fill_study.h"

namespace g31::study {

Result<Study, setup::SetupErrors> read_study(const std::string& path) {
  const auto document = setup::read_document(path, 0);
  if (!document) {
    return setup::SetupErrors{document.error()};
  }
  setup::ErrorList errors;
  const CheckedStudy checked = check_study(*document.value(), errors);
  if (!errors.empty()) {
    return errors.in_file_order();
  }
  Study study = fill_study(checked, *document.value(), errors);
  if (!errors.empty()) {
    return errors.in_file_order();
  }
  study.document = document.value();
  return study;
}

}  // namespace g31::study
