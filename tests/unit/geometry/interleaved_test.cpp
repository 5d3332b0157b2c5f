// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include <rakelight/base/interleaved.h>
#include <rakelight/math/vector.h>

namespace rakelight {
namespace {

using Bytes = std::vector<std::byte>;

/// A buffer whose bytes are their own numbers, modulo 251.
Bytes numbered(std::size_t size) {
    Bytes bytes(size);
    for (std::size_t i = 0; i < size; ++i) bytes[i] = std::byte(i % 251);
    return bytes;
}

TEST(Interleaved, WhatIsWrittenIsReadAndAllElseStays) {
    const std::vector<vec3> values{{1, 2, 3}, {-4, 5e-40f, 6}, {7, 8, std::numeric_limits<float>::infinity()}};
    for (const std::size_t stride : {12u, 13u, 32u})  // packed, unaligned, with other attributes between
        for (const std::size_t offset : {0u, 1u, 7u}) {
            Bytes buffer = numbered(offset + 2 * stride + sizeof(vec3));
            const Bytes before = buffer;
            ASSERT_TRUE(write_interleaved<vec3>(values, {buffer, offset, stride, 3}));
            const std::vector<vec3> read = packed<vec3>({buffer, offset, stride, 3});
            ASSERT_EQ(read.size(), 3u);
            EXPECT_EQ(std::memcmp(read.data(), values.data(), 3 * sizeof(vec3)), 0);
            for (std::size_t i = 0; i < buffer.size(); ++i) {
                const bool is_written = i >= offset && (i - offset) % stride < sizeof(vec3);
                if (!is_written) {
                    EXPECT_EQ(buffer[i], before[i]) << i;
                }
            }
        }
}

TEST(Interleaved, BuffersThatAreTooSmallAreLeftAlone) {
    Bytes buffer = numbered(2 * 32 + 11);  // a byte short of the third position
    const Bytes before = buffer;
    const std::vector<vec3> values(3);
    EXPECT_FALSE(write_interleaved<vec3>(values, {buffer, 0, 32, 3}));
    EXPECT_FALSE(write_interleaved<vec3>(std::span(values).first(1), {buffer, 0, 32, 2}));  // values are missing
    EXPECT_FALSE(write_interleaved<vec3>(values, {buffer, 0, 8, 2}));                       // they would overlap
    EXPECT_EQ(buffer, before);
    EXPECT_TRUE(packed<vec3>({buffer, 0, 32, 3}).empty());
    EXPECT_EQ(packed<vec3>({buffer, 0, 32, 2}).size(), 2u);
}

TEST(Interleaved, CountsOffsetsAndStridesThatOverflowAreNotBelieved) {
    constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
    const Bytes buffer = numbered(64);
    EXPECT_TRUE(packed<vec3>({buffer, most, 12, 1}).empty());
    EXPECT_TRUE(packed<vec3>({buffer, most - 8, 12, 3}).empty());
    EXPECT_TRUE(packed<vec3>({buffer, 0, most, 2}).empty());
    EXPECT_TRUE(packed<vec3>({buffer, 0, 12, most}).empty());
    EXPECT_TRUE(packed<vec3>({buffer, 0, most / 2 + 1, 3}).empty());  // twice that is 0
    EXPECT_TRUE(packed<vec3>({{}, 0, 12, 0}).empty());
}

TEST(Interleaved, AStrideOfZeroMeansPacked) {
    const Bytes buffer = numbered(4 * 12 + 2);
    const std::vector<vec3> read = packed<vec3>({buffer, 2, 0, 4});
    ASSERT_EQ(read.size(), 4u);
    EXPECT_EQ(std::memcmp(read.data(), buffer.data() + 2, 4 * sizeof(vec3)), 0);
    EXPECT_TRUE(packed<vec3>({buffer, 3, 0, 4}).empty());
}

}  // namespace
}  // namespace rakelight
