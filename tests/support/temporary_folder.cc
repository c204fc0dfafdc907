#include "tests/support/temporary_folder.h"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <mutex>
#include <set>

#include "tests/support/kept_documents.h"

namespace g31::testing {
namespace {

bool is_document(const std::filesystem::path& path) {
  return path.extension() == ".json" || path.extension() == ".jsonl";
}

/// Texts of such files that tests wrote themselves.
class GivenDocuments {
 public:
  void add(std::string_view text) {
    const std::lock_guard lock(mutex_);
    texts_.emplace(text);
  }
  bool has(const std::string& text) {
    const std::lock_guard lock(mutex_);
    return texts_.contains(text);
  }

 private:
  std::mutex mutex_;
  std::set<std::string> texts_;
};

GivenDocuments& given_documents() {
  static GivenDocuments given;
  return given;
}

/// Documents that g31 has written into a folder are held against their schemas.
void keep_documents(const std::filesystem::path& folder) {
  std::error_code none;
  for (std::filesystem::recursive_directory_iterator file(folder, none), end; file != end;
       file.increment(none)) {
    if (!is_document(file->path()) || !file->is_regular_file(none)) {
      continue;
    }
    std::ifstream in(file->path(), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    if (!given_documents().has(text)) {
      keep_document(text);
    }
  }
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "g31_test_XXXXXX").string();
  path_ = ::mkdtemp(pattern.data());
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  keep_documents(path_);
  std::filesystem::remove_all(path_, ignored);
}

std::string TemporaryFolder::write(const std::string& name, std::string_view text) const {
  const std::string path = (path_ / name).string();
  std::ofstream(path, std::ios::binary) << text;
  if (is_document(path)) {
    given_documents().add(text);
  }
  return path;
}

std::string TemporaryFolder::path(const std::string& name) const {
  return (path_ / name).string();
}

std::vector<std::string> TemporaryFolder::names() const {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(path_)) {
    found.push_back(entry.path().filename().string());
  }
  return found;
}

std::vector<std::string> places(const std::string& text, const TemporaryFolder& folder) {
  std::vector<std::string> found;
  const std::string prefix = folder.path("");
  for (std::size_t at = text.find(prefix); at != text.npos; at = text.find(prefix, at + 1)) {
    const std::size_t begin = at + prefix.size();
    found.push_back(text.substr(begin, text.find('\n', begin) - begin));
  }
  return found;
}

}  // namespace g31::testing
