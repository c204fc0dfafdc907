#include "tools/setup/toml_reader.h"

#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

#include "tools/setup/check_sheet.h"
#include "tools/setup/document.h"
#include "tools/setup/fill_job.h"
#include "tools/setup/sheet.h"

namespace g31::setup {
namespace {

/// Keeps the documents of a job alive while places in them are in use.
class Reader {
 public:
  void read_sheet(const std::string& path) {
    if (const Document* document = read(path)) {
      lay_over(sheet_, check_sheet(*document, errors_));
    }
  }

  /// The machine file goes under what is already read.
  void read_machine_file() {
    const Entry* named = sheet_.find(KeyId::MachineFile);
    if (named == nullptr) {
      return;
    }
    const auto& path = std::get<std::string>(named->value);
    std::error_code unreadable;
    if (!std::filesystem::exists(path, unreadable)) {
      errors_.add(SetupErrorId::FileNotFound, named->where, {path},
                  "paths start at the folder of the sheet");
      return;
    }
    if (const Document* document = read(path)) {
      Sheet machine = check_machine_file(*document, errors_);
      if (const Entry* again = machine.find(KeyId::MachineFile)) {
        errors_.add(SetupErrorId::MachineFileInFile, again->where, {});
      }
      lay_over(machine, sheet_);
      sheet_ = std::move(machine);
    }
  }

  Result<Job, SetupErrors> job() {
    Job job = fill_job(sheet_, errors_);
    return errors_.empty() ? Result<Job, SetupErrors>(std::move(job)) : errors_.in_file_order();
  }

 private:
  const Document* read(const std::string& path) {
    const std::size_t order = order_++;
    const auto document = read_document(path, order);
    if (!document) {
      errors_.add(order, document.error());
      return nullptr;
    }
    documents_.push_back(document.value());
    return documents_.back().get();
  }

  std::size_t order_ = 0;
  std::vector<std::shared_ptr<const Document>> documents_;
  ErrorList errors_;
  Sheet sheet_;
};

}  // namespace

Result<Job, SetupErrors> read_job(std::span<const std::string> sheet_paths) {
  Reader reader;
  for (const std::string& path : sheet_paths) {
    reader.read_sheet(path);
  }
  reader.read_machine_file();
  return reader.job();
}

}  // namespace g31::setup
