#include <cstddef>
#include <cstdint>

#include "tests/fuzz/entry.h"

// The name and the types are libFuzzer's.
// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes are characters here.
  g31::fuzz::run_any_text({reinterpret_cast<const char*>(data), size});
  return 0;
}
