// SPDX-License-Identifier: Apache-2.0
#include "tools/bench/bench_export.h"

#include <cstdlib>
#include <filesystem>

#include "image/decode.h"
#include "io/files/file.h"
#include "io/gltf/write/glb_writer.h"
#include "io/pictures/image_io.h"

namespace rakelight {
namespace {

/// A temporary folder, removed together with this object.
class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "rakelight-XXXXXX").string();
        if (!::mkdtemp(name.data())) throw Error(ErrorCode::failed, "no temporary folder can be made").with_file(name);
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    std::string file(const std::string& name) const { return (path_ / name).string(); }

private:
    std::filesystem::path path_;
};

/// The same picture with bytes of a file: the PNG writer writes files only.
ImageHandle as_png(const ImageHandle& image, const TemporaryFolder& folder, Context& context) {
    const std::string path = folder.file("texture.png");
    io::write_image(path, decode(*image, context));
    auto encoded = std::make_shared<EncodedImage>(*image);
    encoded->bytes = io::read_file(path, context);
    encoded->mime_type = "image/png";
    return encoded;
}

}  // namespace

void export_bench_scene(const Scene& scene, const std::string& path, Context& context) {
    Scene encoded = scene;
    const TemporaryFolder folder;
    for (Texture& texture : encoded.textures)
        if (!texture.image->bytes && texture.image->path.empty())
            texture.image = as_png(texture.image, folder, context);
    io::write_glb(encoded, path, context);
}

}  // namespace rakelight
