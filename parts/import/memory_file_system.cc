#include "parts/import/memory_file_system.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <utility>

#include <assimp/IOStream.hpp>

namespace g31::parts {
namespace {

class MemoryFile final : public Assimp::IOStream {
 public:
  explicit MemoryFile(const std::string& bytes) : bytes_(bytes) {}

  std::size_t Read(void* target, std::size_t size, std::size_t count) override {
    const std::size_t whole = size == 0 ? 0 : std::min(count, (bytes_.size() - here_) / size);
    if (whole == 0) {
      stop_at_the_end();
      return 0;
    }
    std::memcpy(target, bytes_.data() + here_, whole * size);
    here_ += whole * size;
    return whole;
  }

  std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }

  aiReturn Seek(std::size_t offset, aiOrigin origin) override {
    const std::size_t base = origin == aiOrigin_CUR   ? here_
                             : origin == aiOrigin_END ? bytes_.size()
                                                      : 0;
    // Offsets may be negative in disguise: modulo arithmetic brings them back.
    const std::size_t there = base + offset;
    if (there > bytes_.size()) {
      return aiReturn_FAILURE;
    }
    here_ = there;
    return aiReturn_SUCCESS;
  }

  [[nodiscard]] std::size_t Tell() const override { return here_; }
  [[nodiscard]] std::size_t FileSize() const override { return bytes_.size(); }
  void Flush() override {}

 private:
  void stop_at_the_end() {
    constexpr int kPatience = 1000;
    if (++reads_at_the_end_ > kPatience) {
      throw std::runtime_error("the file ends too early");
    }
  }

  const std::string& bytes_;
  std::size_t here_ = 0;
  int reads_at_the_end_ = 0;
};

}  // namespace

MemoryFileSystem::MemoryFileSystem(std::string name, std::string bytes)
    : name_(std::move(name)), bytes_(std::move(bytes)) {}

bool MemoryFileSystem::Exists(const char* name) const {
  return name_ == name;
}

char MemoryFileSystem::getOsSeparator() const {
  return '/';
}

Assimp::IOStream* MemoryFileSystem::Open(const char* name, const char*) {
  // A bare pointer, because assimp owns it: some readers give it to Close, others delete it.
  return Exists(name) ? new MemoryFile(bytes_) : nullptr;
}

void MemoryFileSystem::Close(Assimp::IOStream* file) {
  delete file;
}

}  // namespace g31::parts
