#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "machine/base/result.h"
#include "tools/setup/document.h"
#include "tools/setup/job.h"
#include "tools/setup/setup_error.h"
#include "tools/setup/sheet.h"
#include "tools/setup/varied_key.h"

namespace g31::setup {

/// A value laid over the sheets, as if the last of them said so.
struct Override {
  VariedKey key;
  SheetValue value;
  Location where;  ///< its document outlives the override
};

/// The sheets of a job, read and checked once; jobs with other values are made from it without
/// opening a sheet again.
class SheetStack {
 public:
  /// Reads as read_job does.
  static Result<SheetStack, SetupErrors> read(std::span<const std::string> sheet_paths,
                                              const std::string& machines_folder);

  /// The job with these values.  Many threads may ask at once.
  [[nodiscard]] Result<Job, SetupErrors> job(std::span<const Override> overrides) const;

  /// What was read, sheets and machine file, in the order of reading.
  [[nodiscard]] const std::vector<std::shared_ptr<const Document>>& documents() const {
    return documents_;
  }

 private:
  friend class SheetReader;
  SheetStack() = default;

  std::vector<std::shared_ptr<const Document>> documents_;  ///< what places in sheet_ point to
  Sheet sheet_;
};

}  // namespace g31::setup
