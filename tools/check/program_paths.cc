#include "tools/check/program_paths.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "machine/base/letters.h"
#include "machine/base/utf_8.h"
#include "tools/disk/disk.h"
#include "tools/session/control.h"

namespace g31::check {
namespace {

namespace fs = std::filesystem;

bool is_one_of(const std::string& ending, std::initializer_list<std::string_view> endings) {
  return std::ranges::find(endings, ending) != endings.end();
}

bool is_sinumerik(const std::string& ending) {
  return is_one_of(ending, {".mpf", ".spf", ".arc"});
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// O1234, O1234.txt
bool has_program_number(const std::string& stem) {
  return stem.size() > 1 && stem.front() == 'o' &&
         std::all_of(stem.begin() + 1, stem.end(), is_digit);
}

/// Definition files hold for all programs of a SINUMERIK, wherever they lie in its memory.
bool is_definition(const fs::path& path) {
  return in_small_letters(path.extension().string()) == ".def" &&
         session::defines_data(path.string(), disk::Disk().read(path.string()).value_or(""));
}

bool is_program(const fs::path& path) {
  const std::string ending = in_small_letters(path.extension().string());
  return is_sinumerik(ending) || has_program_number(in_small_letters(path.stem().string())) ||
         is_one_of(ending, {".nc", ".cnc", ".tap", ".eia", ".iso", ".ncc", ".min"});
}

/// %, and O1234 or :1234 in the next line with text; or the header of a SINUMERIK's program.  Other
/// texts begin with %, too.
bool begins_as_program(const fs::path& path) {
  constexpr std::size_t kLook = 512;
  constexpr std::string_view kHeader = "%_N_";
  const std::string head = disk::Disk().read_part(path.string(), 0, kLook).value_or("");
  std::string_view text = head;
  text.remove_prefix(text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
  if (in_capitals(text.substr(0, kHeader.size())) == kHeader) {
    return true;
  }
  const std::size_t number = text.find_first_not_of(" \t\r\n", 1);
  const bool has_line = text.starts_with('%') && number != std::string_view::npos &&
                        text.substr(0, number).find('\n') != std::string_view::npos;
  return has_line && number + 1 < text.size() &&
         std::string_view("Oo:").find(text[number]) != std::string_view::npos &&
         is_digit(text[number + 1]);
}

/// All files of a folder and those below it; links to folders are not followed.
void add_files(const fs::path& folder, std::map<fs::path, std::vector<fs::path>>& by_folder,
               std::vector<ProgramPaths::Closed>& closed) {
  std::vector<fs::path> below;
  auto why = disk::look_into(folder.string(), [&](const fs::directory_entry& entry) {
    std::error_code ignored;
    if (entry.is_regular_file(ignored)) {
      by_folder[folder].push_back(entry.path());
    } else if (entry.is_directory(ignored) && !entry.is_symlink(ignored)) {
      below.push_back(entry.path());
    }
  });
  if (why) {
    closed.push_back({folder.lexically_normal().string(), *std::move(why)});
  }
  std::ranges::sort(below);
  for (const fs::path& each : below) {
    add_files(each, by_folder, closed);
  }
}

/// Folders before files of the same folder would depend on the file system: all paths are sorted.
std::vector<std::string> programs_below(const std::string& folder,
                                        std::vector<ProgramPaths::Closed>& closed) {
  std::map<fs::path, std::vector<fs::path>> by_folder;
  add_files(folder, by_folder, closed);
  const auto has_sinumerik = [](const auto& files) {
    return std::ranges::any_of(files.second, [](const fs::path& file) {
      return is_sinumerik(in_small_letters(file.extension().string()));
    });
  };
  const bool among_sinumerik = std::ranges::any_of(by_folder, has_sinumerik);
  std::vector<std::string> found;
  for (auto& folder_files : by_folder) {
    std::vector<fs::path>& files = folder_files.second;
    std::ranges::sort(files);
    for (const fs::path& file : files) {
      if (is_program(file) || (among_sinumerik && is_definition(file)) || begins_as_program(file)) {
        found.push_back(file.lexically_normal().string());
      }
    }
  }
  return found;
}

}  // namespace

ProgramPaths program_paths(const std::vector<std::string>& named) {
  ProgramPaths paths;
  std::set<std::string> known;
  const auto add = [&](const std::string& file) {
    std::error_code error;
    const fs::path whole = fs::absolute(file, error);  // b.nc and ../here/b.nc are one
    const bool is_new = known.insert(whole.lexically_normal().string()).second;
    if (is_new) {
      paths.files.push_back(file);
    }
    return is_new;
  };
  for (const std::string& name : named) {
    std::error_code error;
    if (fs::is_directory(name, error)) {
      const std::size_t closed = paths.closed.size();
      const std::vector<std::string> found = programs_below(name, paths.closed);
      std::ranges::for_each(found, add);
      paths.trees.push_back(fs::path(name).lexically_normal().string());
      if (found.empty() && paths.closed.size() == closed) {
        paths.empty.push_back(name);
      }
    } else if (name == "-" || fs::exists(name, error)) {
      if (add(name)) {
        paths.named.push_back(name);
      }
    } else {
      paths.missing.push_back(name);
    }
  }
  return paths;
}

}  // namespace g31::check
