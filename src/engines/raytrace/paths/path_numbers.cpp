// SPDX-License-Identifier: Apache-2.0
#include "engines/raytrace/paths/path_numbers.h"

namespace rakelight::raytrace {
namespace {

using Directions = std::array<std::uint32_t, 32>;

/// Of a primitive polynomial of this degree with these inner coefficients. @param first  the first numbers m, as many as the degree
constexpr Directions directions(std::size_t degree, std::uint32_t inner, const std::array<std::uint32_t, 3>& first) {
    Directions v{};
    for (std::size_t i = 0; i < 32; ++i) {
        if (i < degree) {
            v[i] = first[i] << (31 - i);
            continue;
        }
        v[i] = v[i - degree] ^ (v[i - degree] >> degree);
        for (std::size_t k = 1; k < degree; ++k)
            if ((inner >> (degree - 1 - k)) & 1u) v[i] ^= v[i - k];
    }
    return v;
}

constexpr Directions by_halves() {
    Directions v{};
    for (std::size_t i = 0; i < 32; ++i) v[i] = 1u << (31 - i);
    return v;
}

/// What each byte of an index adds to each dimension.
struct ByteTables {
    std::uint32_t of[4][4][256];  ///< [dimension][byte]
};
constexpr ByteTables make_tables() {
    const std::array<Directions, 4> v{by_halves(), directions(1, 0, {1, 0, 0}), directions(2, 1, {1, 3, 0}),
                                      directions(3, 1, {1, 3, 1})};
    ByteTables t{};
    for (std::size_t d = 0; d < 4; ++d)
        for (std::size_t b = 0; b < 4; ++b)
            for (std::uint32_t n = 0; n < 256; ++n)
                for (std::size_t bit = 0; bit < 8; ++bit)
                    if ((n >> bit) & 1u) t.of[d][b][n] ^= v[d][8 * b + bit];
    return t;
}
const ByteTables tables = make_tables();

std::uint32_t sobol(std::uint32_t index, std::size_t dimension) {
    const auto& t = tables.of[dimension];
    return t[0][index & 255u] ^ t[1][(index >> 8) & 255u] ^ t[2][(index >> 16) & 255u] ^ t[3][index >> 24];
}

std::uint32_t reversed(std::uint32_t x) {
    x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    return __builtin_bswap32(x);
}

/// Each bit is turned by a hash of those above it.
std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
    x = reversed(x);
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return reversed(x);
}

/// Appleby 2011, MurmurHash3: its mixer of 32 bits.
std::uint32_t mixed(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x85ebca6bu;
    x ^= x >> 13;
    x *= 0xc2b2ae35u;
    return x ^ (x >> 16);
}
std::uint32_t both(std::uint32_t a, std::uint32_t b) { return mixed(a ^ (b * 0x9e3779b9u + 0x7f4a7c15u)); }

}  // namespace

PathNumbers::PathNumbers(int x, int y, int seed)
    : pixel_(both(both(mixed(std::uint32_t(seed)), std::uint32_t(x)), std::uint32_t(y))) {}

std::array<std::uint32_t, 4> PathNumbers::of(std::uint32_t sample, std::uint32_t group) const {
    const std::uint32_t key = both(pixel_, group), index = scrambled(sample, mixed(key));
    std::array<std::uint32_t, 4> out{};
    for (std::uint32_t d = 0; d < 4; ++d) out[d] = scrambled(sobol(index, d), both(key, d + 1));
    return out;
}

}  // namespace rakelight::raytrace
