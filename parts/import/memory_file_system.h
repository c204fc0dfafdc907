#pragma once

#include <string>

#include <assimp/IOSystem.hpp>

namespace g31::parts {

/// Shows assimp one file, from memory, and nothing else of the disk.
///
/// Some of assimp's readers try for ever to read on behind the end of a damaged file (a PLY whose
/// header is cut off does it in 5.2).  Here such a reader is stopped by a std::runtime_error, which
/// assimp turns into an ordinary failure.  Material files that an OBJ names are not found, which
/// assimp takes in its stride.
class MemoryFileSystem final : public Assimp::IOSystem {
 public:
  MemoryFileSystem(std::string name, std::string bytes);

  [[nodiscard]] bool Exists(const char* name) const override;
  [[nodiscard]] char getOsSeparator() const override;
  Assimp::IOStream* Open(const char* name, const char* mode) override;
  void Close(Assimp::IOStream* file) override;

 private:
  std::string name_;
  std::string bytes_;
};

}  // namespace g31::parts
