// SPDX-License-Identifier: Apache-2.0
// What the tests of picture files share: a folder that goes away, noise, the error of a call.
#pragma once
#include <gtest/gtest.h>
#include <rakelight/image/image.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "support/temporary_folder.h"
#include "support/thrown_error.h"

namespace rakelight::test {

inline std::vector<std::byte> bytes_of_file(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    EXPECT_TRUE(file) << path;
    const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    std::vector<std::byte> bytes(text.size());
    if (!bytes.empty()) std::memcpy(bytes.data(), text.data(), text.size());
    return bytes;
}

/// Deterministic noise over smooth ramps, so that filters and run lengths have something to do.
inline Pixels noise_picture(int width, int height, int channels, Component component) {
    Pixels pixels{width, height, channels, component, component == Component::f32, {}};
    const std::size_t count = std::size_t(width) * std::size_t(height) * std::size_t(channels);
    pixels.bytes.resize(count * size_of(component));
    std::uint32_t state = 12345;
    for (std::size_t i = 0; i < count; ++i) {
        state = state * 1664525u + 1013904223u;
        const std::uint32_t noise = (i / 64) % 2 == 0 ? state >> 16 : std::uint32_t(i / 7);
        if (component == Component::u8) {
            pixels.bytes[i] = std::byte(noise & 255);
        } else if (component == Component::u16) {
            const auto value = std::uint16_t(noise);
            std::memcpy(&pixels.bytes[i * 2], &value, 2);
        } else {
            const float value = float(noise) / 4096.0f;
            std::memcpy(&pixels.bytes[i * 4], &value, 4);
        }
    }
    return pixels;
}

/// Puts the right CRC behind the chunk that begins at `at` (PNG specification, annex D).
inline void mend_png_checksum(std::vector<std::byte>& bytes, std::size_t at) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = length << 8 | std::size_t(bytes[at + i]);
    std::uint32_t crc = 0xffffffff;
    for (std::size_t i = at + 4; i < at + 8 + length; ++i) {
        crc ^= std::uint32_t(bytes[i]);
        for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    for (std::size_t i = 0; i < 4; ++i) bytes[at + 8 + length + i] = std::byte(~crc >> (24 - 8 * i) & 255);
}

}  // namespace rakelight::test
