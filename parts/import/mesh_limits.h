#pragma once

#include <cstddef>
#include <cstdint>

namespace g31::parts {

/// What no part needs: a file beyond is refused before memory is asked for.
inline constexpr std::uint64_t kMostMeshFileBytes = std::uint64_t{4} << 30U;
inline constexpr std::uint64_t kMostTriangles = 50'000'000;
/// Of files that are read whole, packed ones as they are when unpacked: reading takes some ten
/// times as much memory.
inline constexpr std::uint64_t kMostBytesReadWhole = std::uint64_t{512} << 20U;
/// Corners of one face: cutting it into triangles takes time with their square.
inline constexpr std::size_t kMostCorners = 10'000;
/// Coordinates, mm: as those of a set-up sheet (units.def of tools/setup).
inline constexpr double kFarthestMm = 1e6;
/// How large a part is at least, mm: a smaller one is a slip in its unit.
inline constexpr double kSmallestMm = 1e-3;

}  // namespace g31::parts
