#include <cstddef>
#include <cstdint>

#include "tests/fuzz/entry.h"

// The name and the types are libFuzzer's; the build says which entry of entry.h a target feeds.
// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes are characters here.
  g31::fuzz::G31_FUZZ_ENTRY({reinterpret_cast<const char*>(data), size});
  return 0;
}
