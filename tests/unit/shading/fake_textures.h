// SPDX-License-Identifier: Apache-2.0
// An engine's textures for tests of what stands before engines: it keeps how large a picture is.
#pragma once
#include <atomic>

#include "shading/texture_cache.h"

namespace rakelight::test {

struct FakeTexture final : shading::PackedTexture {
    int width = 0, levels = 0;
    bool is_srgb = false;
};

class FakePacker final : public shading::TexturePacker {
public:
    std::uint64_t packed_bytes(int width, int height, bool, bool) const override {
        return std::uint64_t(width) * std::uint64_t(height);
    }
    std::shared_ptr<const shading::PackedTexture> pack(const MipChain& chain, const shading::TextureKey&,
                                                       MemoryCharge) const override {
        if (chain.levels.empty()) throw Error(ErrorCode::bad_file, "the picture has no pixels");
        ++packed;
        auto out = std::make_shared<FakeTexture>();
        out->width = chain.levels[0].width, out->levels = int(chain.levels.size()), out->is_srgb = chain.is_srgb;
        return out;
    }
    mutable std::atomic<int> packed{0};
};

}  // namespace rakelight::test
