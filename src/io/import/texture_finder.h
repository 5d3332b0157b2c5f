// SPDX-License-Identifier: Apache-2.0
// Textures of imported models: files that the model names (often by a path of the author's machine) and pictures inside it.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <rakelight/scene/scene.h>

#include "io/import/stream_format.h"

namespace rakelight::io {

/// The file that `reference` means: as written, else its bare name in the model's folder, in any case of letters. Nothing
/// outside the model's folder tree unless `allow_outside`. nullopt when there is none.
std::optional<std::string> find_texture_file(const std::string& model, const std::string& reference,
                                             bool allow_outside);

/// Makes each texture and each image once.
class TextureTable {
public:
    TextureTable(std::string model, bool allow_outside, std::vector<import_stream::Picture>& pictures, Scene& scene,
                 Context& context)
        : model_(std::move(model)),
          allow_outside_(allow_outside),
          pictures_(pictures),
          scene_(scene),
          context_(context) {}
    /// Its number in Scene::textures, or `none` with a warning in the report.
    std::uint32_t number(const import_stream::TextureLink& link);

private:
    ImageHandle image(const import_stream::TextureLink& link);
    ImageHandle embedded(std::uint32_t picture);
    std::string model_;
    bool allow_outside_;
    std::vector<import_stream::Picture>& pictures_;
    Scene& scene_;
    Context& context_;
    std::map<std::pair<std::uint32_t, std::string>, ImageHandle> images_;
    std::map<std::tuple<ImageHandle, std::uint32_t, std::uint32_t>, std::uint32_t> numbers_;
};

}  // namespace rakelight::io
