#include "tools/setup/sheet_stack.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/disk/disk.h"
#include "tools/setup/check_sheet.h"
#include "tools/setup/fill_job.h"

namespace g31::setup {

class SheetReader {
 public:
  void read_sheet(const std::string& path) {
    if (const Document* document = read(path)) {
      lay_over(stack_.sheet_, check_sheet(*document, errors_));
    }
  }

  /// The machine file goes under what is already read.
  void read_machine_file(const std::string& machines_folder) {
    const Entry* named = stack_.sheet_.find(KeyId::MachineFile);
    if (named == nullptr) {
      return;
    }
    std::string path = std::get<std::string>(named->value);
    std::error_code unreadable;
    if (!std::filesystem::exists(path, unreadable)) {
      const auto shipped = shipped_machine(*named, machines_folder);
      if (!shipped) {
        errors_.add(SetupErrorId::FileNotFound, named->where, {path},
                    "paths start at the folder of the sheet" + shipped_machines(machines_folder));
        return;
      }
      path = *shipped;
    }
    if (const Document* document = read(path)) {
      Sheet machine = check_machine_file(*document, errors_);
      if (const Entry* again = machine.find(KeyId::MachineFile)) {
        errors_.add(SetupErrorId::MachineFileInFile, again->where, {});
      }
      lay_over(machine, stack_.sheet_);
      stack_.sheet_ = std::move(machine);
    }
  }

  Result<SheetStack, SetupErrors> stack() {
    // What a job finds wrong belongs to the same list, so that all is said at once.
    fill_job(stack_.sheet_, errors_);
    return errors_.empty() ? Result<SheetStack, SetupErrors>(std::move(stack_))
                           : errors_.in_file_order();
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

  /// Behind a remedy: what comes along; "" where that folder is not there.
  static std::string shipped_machines(const std::string& folder) {
    std::vector<std::string> names = disk::Disk().list(folder);
    std::erase_if(names, [](const std::string& name) { return !name.ends_with(".toml"); });
    return names.empty() ? ""
                         : fmt::format("; machines that come with g31: {}", fmt::join(names, ", "));
  }

  const Document* read(const std::string& path) {
    const std::size_t order = order_++;
    const auto document = read_document(path, order);
    if (!document) {
      errors_.add(order, document.error());
      return nullptr;
    }
    stack_.documents_.push_back(document.value());
    return stack_.documents_.back().get();
  }

  std::size_t order_ = 0;
  ErrorList errors_;
  SheetStack stack_;
};

Result<SheetStack, SetupErrors> SheetStack::read(std::span<const std::string> sheet_paths,
                                                 const std::string& machines_folder) {
  SheetReader reader;
  for (const std::string& path : sheet_paths) {
    reader.read_sheet(path);
  }
  reader.read_machine_file(machines_folder);
  return reader.stack();
}

Result<Job, SetupErrors> SheetStack::job(std::span<const Override> overrides) const {
  ErrorList errors;
  Sheet sheet = sheet_;
  for (const Override& one : overrides) {
    if (const auto wrong = lay_value(sheet, one.key, Entry{one.value, one.where})) {
      errors.add(SetupErrorId::NothingToVary, one.where, {one.key.path, *wrong});
    }
  }
  Job job = fill_job(sheet, errors);
  for (const auto& document : documents_) {
    job.sheets.push_back(document->path);
  }
  return errors.empty() ? Result<Job, SetupErrors>(std::move(job)) : errors.in_file_order();
}

}  // namespace g31::setup
