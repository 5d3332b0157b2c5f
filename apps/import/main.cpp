// SPDX-License-Identifier: Apache-2.0
// rakelight-import: reads one model of a foreign format with Assimp and writes what it held to standard output
// (src/io/import/stream_format.h). It runs apart from the program because Assimp crashes and hangs on some files.
//
//   rakelight-import --memory BYTES --seconds N --outside 0|1 -- FILE
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <rakelight/base/current_error.h>
#include <rakelight_internal/base/file_ending.h>

#include "../common/helper_limits.h"
#include "convert_mesh.h"
#include "convert_nodes.h"
#include "convert_surface.h"
#include "folder_io.h"
#include "io/import/stream_writer.h"

namespace rakelight::import_helper {
namespace {

struct Options {
    std::uint64_t memory_bytes = 0, seconds = 0;
    bool outside = false;
    std::string file;
};

bool parse(int argc, char** argv, Options& options) {
    if (argc != 9 || std::strcmp(argv[1], "--memory") != 0 || std::strcmp(argv[3], "--seconds") != 0 ||
        std::strcmp(argv[5], "--outside") != 0 || std::strcmp(argv[7], "--") != 0)
        return false;
    options = {std::strtoull(argv[2], nullptr, 10), std::strtoull(argv[4], nullptr, 10), argv[6][0] == '1', argv[8]};
    return options.memory_bytes > 0 && options.seconds > 0;
}

/// Standard output only for the stream: prints of Assimp are dropped.
int take_standard_output() {
    const int stream = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3), nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere >= 0) dup2(nowhere, STDOUT_FILENO);
    return stream;
}

/// Buffered; a reader that went away ends the program.
class Output {
public:
    explicit Output(int file) : file_(file) { buffer_.reserve(size); }
    void put(std::span<const std::byte> bytes) {
        if (buffer_.size() + bytes.size() > size) flush();
        if (bytes.size() >= size)
            send(bytes);
        else
            buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
    }
    void flush() {
        send(buffer_);
        buffer_.clear();
    }

private:
    void send(std::span<const std::byte> bytes) const {
        while (!bytes.empty()) {
            const ssize_t sent = write(file_, bytes.data(), bytes.size());
            if (sent < 0 && errno == EINTR) continue;
            if (sent <= 0) _exit(3);
            bytes = bytes.subspan(std::size_t(sent));
        }
    }
    static constexpr std::size_t size = 1 << 18;
    int file_;
    std::vector<std::byte> buffer_;
};

/// Only the reader that the name's ending asks for may touch the file: less surface, and no guessing by content.
void keep_one_reader(Assimp::Importer& importer, const std::string& ending) {
    const std::size_t wanted = importer.GetImporterIndex(ending.c_str());
    if (wanted == std::size_t(-1))
        throw Error(ErrorCode::bad_file, "this build of Assimp has no reader for ." + ending);
    std::vector<Assimp::BaseImporter*> others;
    for (std::size_t i = 0; i < importer.GetImporterCount(); ++i)
        if (i != wanted) others.push_back(importer.GetImporter(i));
    for (Assimp::BaseImporter* other : others) importer.UnregisterLoader(other);  // leaks it: the process is short
}

/// What Assimp throws itself has words for people. It catches the exceptions of the standard library, too; those continue.
[[noreturn]] void refuse(const Assimp::Importer& importer) {
    try {
        if (importer.GetException()) std::rethrow_exception(importer.GetException());
    } catch (const std::runtime_error&) {
    }
    throw Error(ErrorCode::bad_file, importer.GetErrorString());
}

const aiScene& read(Assimp::Importer& importer, const Options& options, const Format& format) {
    keep_one_reader(importer, format.ending);
    importer.SetIOHandler(new FolderIo(options.file, options.outside, format.ending == "ase"));
    importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, true);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_REMOVE_EMPTY_BONES, false);
    const aiScene* scene = importer.ReadFile(options.file, aiProcess_Triangulate);
    if (!scene) refuse(importer);
    if (!scene->mRootNode) throw Error(ErrorCode::bad_file, "nothing to draw");
    return *scene;
}

/// Smoothing groups count where Assimp found no normals.
FbxSmoothing smoothing_of(const std::string& file, const aiScene& scene, Document& document) {
    const auto lacks_normals = [](const aiMesh* mesh) { return mesh->HasFaces() && !mesh->HasNormals(); };
    if (std::none_of(scene.mMeshes, scene.mMeshes + scene.mNumMeshes, lacks_normals)) return {};
    bool is_read = true;
    FbxSmoothing smoothing;
    try {
        std::ifstream in(file, std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(in), {}};
        smoothing = FbxSmoothing(read_fbx_geometries(std::as_bytes(std::span(bytes))));
        is_read = !smoothing.has_unknown_kinds();
    } catch (const std::exception&) {  // what Assimp could read is shown without
        is_read = false;
    }
    if (!is_read) document.notes.push_back({1, {}, "smoothing groups that cannot be read are left out"});
    return smoothing;
}

void send_scene(const aiScene& scene, const Options& options, const Format& format, Writer& writer) {
    const std::vector<PartSource> parts = list_parts(scene);
    if (parts.empty()) throw Error(ErrorCode::bad_file, "nothing to draw: the file holds no triangle, line or point");
    std::vector<std::vector<std::uint32_t>> parts_of_mesh(scene.mNumMeshes);
    for (std::uint32_t p = 0; p < parts.size(); ++p) parts_of_mesh[parts[p].mesh].push_back(p);
    Document document;
    document.part_count = std::uint32_t(parts.size());
    if (format.ending == "fbx") document.axes = axes_of(scene);
    if (format.ending == "blend")
        document.axes = {2, 1, 1, -1, 0, 1, 1};  // Z up, seen from -Y; Assimp 5.2 leaves it so
    const NodeTable nodes(scene, parts_of_mesh, document);
    JointTable joints(nodes, document);
    joints.collect(scene);
    convert_surfaces(scene, format, document);
    convert_lamps_and_views(scene, nodes, document);
    convert_motions(scene, nodes, document);
    note_dropped(scene, document);
    const FbxSmoothing smoothing =
        format.ending == "fbx" ? smoothing_of(options.file, scene, document) : FbxSmoothing();
    writer.value(Head{magic, version, std::uint32_t(Kind::scene)});
    transfer(writer, document);
    for (const PartSource& source : parts) {
        Part part = convert_part(*scene.mMeshes[source.mesh], source, format, smoothing, joints);
        if (part.surface >= scene.mNumMaterials) part.surface = nothing;
        transfer(writer, part);
    }
    writer.value(end_mark);
}

void send_refusal(const std::string& reason, Writer& writer) {
    writer.value(Head{magic, version, std::uint32_t(Kind::refusal)});
    writer.text(reason.substr(0, 4096));
}

int run(const Options& options) {
    Output output(take_standard_output());
    Writer writer([&output](std::span<const std::byte> bytes) { output.put(bytes); });
    std::string refusal;
    try {
        // Never taken down: the end of the process does it faster and cannot crash.
        auto* importer = new Assimp::Importer;
        const Format format = format_of(options.file);
        send_scene(read(*importer, options, format), options, format, writer);
        output.flush();
        _exit(0);
    } catch (...) {
        refusal = current_error("reading it takes more memory than the limit of " +
                                std::to_string(options.memory_bytes >> 20) + " MiB")
                      .reason();
    }
    send_refusal(refusal, writer);  // after a part of a scene the reader sees a broken stream, which is right too
    output.flush();
    _exit(1);
}

}  // namespace

}  // namespace rakelight::import_helper

int main(int argc, char** argv) {
    rakelight::import_helper::Options options;
    if (!rakelight::import_helper::parse(argc, argv, options)) {
        std::fputs("rakelight-import is started by rakelight; use that\n", stderr);
        return 2;
    }
    rakelight::apps::limit_this_process(options.memory_bytes, options.seconds);
    try {
        return rakelight::import_helper::run(options);
    } catch (...) {  // no memory for as much as a refusal: the reader says that this ended early
        return 1;
    }
}
