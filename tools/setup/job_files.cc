#include "tools/setup/job_files.h"

#include <variant>

namespace g31::setup {

std::vector<std::string> files_of(const Job& job) {
  std::vector<std::string> files = job.sheets;
  files.push_back(job.control.variables_file);
  for (const parts::PartSetup& part : job.parts) {
    files.push_back(part.file);
  }
  for (const expect::Expectation& row : job.expectations.rows) {
    if (const auto* const file = std::get_if<expect::OutputFile>(&row.what)) {
      files.push_back(file->path);
    }
  }
  std::erase(files, "");
  return files;
}

}  // namespace g31::setup
