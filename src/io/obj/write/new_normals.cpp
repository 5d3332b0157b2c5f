// SPDX-License-Identifier: Apache-2.0
#include "io/obj/write/new_normals.h"

#include <algorithm>
#include <atomic>

#include "io/same_attributes.h"

namespace rakelight::io::obj {
namespace {

constexpr const char* what = "the normals of an OBJ file";

[[noreturn]] void does_not_fit() { throw Error(ErrorCode::failed, "the file changed while it was being processed"); }

/// A run's normals, each once, as they lie in the chunk's.
struct RunNormals {
    std::uint32_t object = 0;
    std::size_t first = 0;         ///< into ChunkWork::normals; ends where the next one begins
    std::size_t first_number = 0;  ///< into ChunkNormals::numbers
};

struct ChunkWork {
    std::vector<RunNormals> runs;
    std::vector<NormalBits> normals;
    std::vector<std::uint32_t> in_block;  ///< [normals] their numbers in the object's block

    std::size_t end(std::size_t run) const { return run + 1 < runs.size() ? runs[run + 1].first : normals.size(); }
};

/// The normals of one chunk's faces.
class ChunkChooser {
public:
    ChunkChooser(const Elements& elements, const VertexData& data, const Scene& after, std::size_t number,
                 ChunkNormals& out, ChunkWork& work)
        : elements_(elements),
          chunk_(elements.chunks[number]),
          places_(elements.places[number]),
          data_(data),
          after_(after),
          out_(out),
          work_(work) {}

    /// @return whether some normal is another one
    bool choose() {
        std::size_t corners = 0, face = 0, place = 0;
        for (const FaceRecord& f : chunk_.faces) corners += f.corners;
        out_.object.reserve(chunk_.faces.size());
        out_.numbers.reserve(corners);
        for (std::size_t r = 0; r < chunk_.runs.size(); ++r) {
            const Mesh& mesh = after_.meshes[places_.runs[r].mesh];
            const std::uint32_t object = elements_.meshes[places_.runs[r].mesh].key.object;
            work_.runs.push_back({object, work_.normals.size(), out_.numbers.size()});
            for (; face < chunk_.faces.size() && chunk_.faces[face].first_index < chunk_.run_end(r); ++face) {
                const bool is_cut = chunk_.faces[face].corners > 3;
                add_face(r, chunk_.faces[face], mesh, is_cut ? chunk_.places.data() + place : nullptr);
                place += is_cut ? chunk_.faces[face].corners : 0;
                out_.object.push_back(object);
            }
            work_.normals.insert(work_.normals.end(), table_.keys().begin(), table_.keys().end());
            table_.clear();
        }
        return is_changed_;
    }

private:
    void add_face(std::size_t r, const FaceRecord& face, const Mesh& mesh, const std::uint32_t* cut) {
        const Run& run = chunk_.runs[r];
        const std::size_t first = places_.runs[r].first_index + (face.first_index - run.first_index);
        for (std::uint32_t k = 0; k < face.corners; ++k) {
            const std::uint32_t place = cut ? cut[k] : k;
            const std::size_t at = first + place;
            if (place == no_index || at >= mesh.indices.size() || mesh.normals.empty()) does_not_fit();
            const vec3 n = mesh.normals[mesh.indices[at]];
            const Corner& was = chunk_.corners[run.first_corner + chunk_.indices[face.first_index + place]];
            is_changed_ = is_changed_ || was.normal == no_index || !is_near(data_.normals[was.normal], n);
            out_.numbers.push_back(
                table_.number_of({std::bit_cast<std::uint32_t>(n.x), std::bit_cast<std::uint32_t>(n.y),
                                  std::bit_cast<std::uint32_t>(n.z)}));
        }
    }

    const Elements& elements_;
    const ChunkElements& chunk_;
    const ChunkPlaces& places_;
    const VertexData& data_;
    const Scene& after_;
    ChunkNormals& out_;
    ChunkWork& work_;
    UniqueTable<NormalBits> table_;
    bool is_changed_ = false;
};

/// One object's runs and the number of their normals, those that several have counted each time.
struct Parts {
    std::vector<UniquePart<NormalBits>> parts;
    std::size_t normals = 0;
};

void number_in_blocks(std::vector<ChunkWork>& work, NewNormals& out, Context& context) {
    std::vector<Parts> parts(out.blocks.size());
    for (ChunkWork& w : work) {
        w.in_block.resize(w.normals.size());
        for (std::size_t r = 0; r < w.runs.size(); ++r) {
            const std::size_t first = w.runs[r].first, count = w.end(r) - first;
            parts[w.runs[r].object].parts.push_back({w.normals.data() + first, count, w.in_block.data() + first});
            parts[w.runs[r].object].normals += count;
        }
    }
    for (const Parts& of : parts) out.charge.grow(UniqueTable<NormalBits>::bytes_for(of.normals), what);
    context.parallel_for(parts.size(),
                         [&](std::size_t i) { out.blocks[i].normals = merged(parts[i].parts, parts[i].normals); });
    context.parallel_for(work.size(), [&](std::size_t c) {
        const ChunkWork& w = work[c];
        std::vector<std::uint32_t>& numbers = out.chunks[c].numbers;
        for (std::size_t r = 0; r < w.runs.size(); ++r) {
            const std::size_t end = r + 1 < w.runs.size() ? w.runs[r + 1].first_number : numbers.size();
            for (std::size_t i = w.runs[r].first_number; i < end; ++i)
                numbers[i] = w.in_block[w.runs[r].first + numbers[i]];
        }
    });
}

/// After the last v, vt or vn line before the object's first face, unless another block is there; then right before
/// that face.
void place_blocks(const Elements& elements, const Contents& contents, NewNormals& out) {
    std::vector<bool> placed(out.blocks.size(), false);
    std::size_t vertices_end = 0, last = 0;
    for (std::size_t c = 0; c < elements.chunks.size(); ++c) {
        const ChunkElements& chunk = elements.chunks[c];
        for (std::size_t r = 0; r < chunk.runs.size(); ++r) {
            const Run& run = chunk.runs[r];
            const std::uint32_t object = elements.meshes[elements.places[c].runs[r].mesh].key.object;
            if (run.topology != Topology::triangles || placed[object]) continue;
            placed[object] = true;
            const auto face = std::ranges::lower_bound(chunk.faces, run.first_index, {}, &FaceRecord::first_index);
            const std::size_t after_vertices = std::max(vertices_end, run.vertices_end);
            last = out.blocks[object].at = after_vertices > last ? after_vertices : face->line_begin;
            out.write_order.push_back(object);
        }
        vertices_end = std::max(vertices_end, contents.chunks[c].vertices_end);
    }
    std::uint64_t count = 0;
    for (const std::size_t object : out.write_order) {
        out.blocks[object].first = count;
        count += out.blocks[object].normals.size();
    }
}

std::uint64_t corner_count(const Elements& elements) {
    std::uint64_t corners = 0;
    for (const ChunkElements& chunk : elements.chunks)
        for (const FaceRecord& face : chunk.faces) corners += face.corners;
    return corners;
}

}  // namespace

NewNormals choose_normals(const Elements& elements, const Contents& contents, const VertexData& data,
                          const Scene& after, Context& context) {
    if (elements.meshes.size() != after.meshes.size()) does_not_fit();
    NewNormals out;
    // For each corner a number, for each face an object; then at most a normal a corner.
    const std::uint64_t corners = corner_count(elements);
    out.charge = MemoryCharge(context.memory(), corners * (2 * sizeof(std::uint32_t)), what);
    MemoryCharge working(context.memory(), corners * (sizeof(NormalBits) + sizeof(std::uint32_t)), what);
    out.blocks.resize(elements.objects.size());
    out.chunks.resize(elements.chunks.size());
    std::vector<ChunkWork> work(elements.chunks.size());
    std::atomic<bool> is_changed{false};
    context.parallel_for(work.size(), [&](std::size_t i) {
        if (ChunkChooser(elements, data, after, i, out.chunks[i], work[i]).choose()) is_changed = true;
    });
    out.is_changed = is_changed;
    number_in_blocks(work, out, context);
    place_blocks(elements, contents, out);
    return out;
}

}  // namespace rakelight::io::obj
