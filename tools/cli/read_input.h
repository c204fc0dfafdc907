#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "machine/base/result.h"
#include "tools/disk/disk.h"
#include "tools/session/refusal.h"

namespace g31::cli {

/// How large a file may be that is read in whole.
struct InputLimit {
  std::uint64_t bytes = 0;
  std::string_view advice;  ///< what to do about one that is larger
};

/// A file in whole, "-" standard input; its size is looked at before.
Result<std::string, session::Refusal> read_input(disk::Disk& disk, const std::string& path,
                                                 const InputLimit& limit);

}  // namespace g31::cli
