#pragma once

#include <string>
#include <vector>

#include "tools/session/control.h"

namespace g31::cli {

/// A file of a starter folder.
struct StarterFile {
  std::string path;  ///< below the folder
  std::string text;
};

/// What a folder for programs of this control begins with; the program first.
std::vector<StarterFile> starter_files(const session::Control& control);

}  // namespace g31::cli
