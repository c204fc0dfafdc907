#include "tools/setup/toml_reader.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
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
  void read_machine_file(const std::string& machines_folder) {
    const Entry* named = sheet_.find(KeyId::MachineFile);
    if (named == nullptr) {
      return;
    }
    std::string path = std::get<std::string>(named->value);
    std::error_code unreadable;
    if (!std::filesystem::exists(path, unreadable)) {
      const auto shipped = shipped_machine(*named, machines_folder);
      if (!shipped) {
        errors_.add(SetupErrorId::FileNotFound, named->where, {path},
                    "paths start at the folder of the sheet");
        return;
      }
      path = *shipped;
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
  /// A file of the same name, as the sheet gives it, among the machines that come along.
  static std::optional<std::string> shipped_machine(const Entry& named, const std::string& folder) {
    namespace fs = std::filesystem;
    const fs::path sheet_folder = fs::path(named.where.document->path).parent_path();
    const fs::path as_given =
        sheet_folder.empty()
            ? fs::path(std::get<std::string>(named.value))
            : fs::path(std::get<std::string>(named.value)).lexically_relative(sheet_folder);
    const fs::path path = fs::path(folder) / as_given;
    std::error_code unreadable;
    const bool found = !folder.empty() && as_given.is_relative() && fs::exists(path, unreadable);
    return found ? std::optional(path.string()) : std::nullopt;
  }

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

Result<Job, SetupErrors> read_job(std::span<const std::string> sheet_paths,
                                  const std::string& machines_folder) {
  Reader reader;
  for (const std::string& path : sheet_paths) {
    reader.read_sheet(path);
  }
  reader.read_machine_file(machines_folder);
  return reader.job();
}

}  // namespace g31::setup
