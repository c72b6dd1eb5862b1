#pragma once

#include <cstdint>

namespace lissom {

/// Random bits that depend on their number alone (splitmix64, Steele et al. 2014): the same on every machine,
/// whatever was asked before.
[[nodiscard]] constexpr std::uint64_t hash_bits(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}
[[nodiscard]] constexpr std::uint64_t hash_bits(std::uint64_t seed, std::uint64_t index, std::uint64_t purpose) {
    return hash_bits(hash_bits(hash_bits(seed) ^ index) ^ (purpose << 32));
}

/// The upper bits as a number in [0, 1).
[[nodiscard]] constexpr double unit(std::uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1p-53; }

/// One chance of one thing (a strand, a vertex), in [0, 1).
[[nodiscard]] constexpr double chance(std::uint64_t seed, std::uint64_t index, std::uint64_t purpose) {
    return unit(hash_bits(seed, index, purpose));
}

} // namespace lissom
