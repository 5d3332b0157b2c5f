// SPDX-License-Identifier: Apache-2.0
#include "io/obj/obj_faces.h"

#include <atomic>
#include <memory>
#include <mutex>

#include "base/name_table.h"
#include "io/obj/merge_corners.h"

namespace rakelight::io::obj {
namespace {

/// An entry of a table by names, without what a long name keeps outside.
constexpr std::uint64_t group_bytes = sizeof(std::string) + 48;

/// What a string keeps outside itself, at most.
std::uint64_t heap_bytes(const std::string& text) { return text.size() < 16 ? 0 : text.size() + 1; }

std::uint64_t kept_bytes(const ChunkElements& c) {
    std::uint64_t bytes = sizeof(c) + c.changes.capacity() * sizeof(StateChange) + c.runs.capacity() * sizeof(Run) +
                          c.corners.capacity() * sizeof(Corner) + c.indices.capacity() * sizeof(std::uint32_t) +
                          c.polygons.capacity() * sizeof(CutPolygon) +
                          c.smoothing.capacity() * sizeof(SmoothingChange) + c.faces.capacity() * sizeof(FaceRecord) +
                          c.places.capacity() * sizeof(std::uint32_t);
    for (const StateChange& change : c.changes) bytes += heap_bytes(change.name);
    return bytes;
}

/// Scratch of the threads that read chunks.
class ScratchPool {
public:
    std::unique_ptr<ChunkScratch> take() {
        const std::lock_guard lock(mutex_);
        if (idle_.empty()) return std::make_unique<ChunkScratch>();
        std::unique_ptr<ChunkScratch> scratch = std::move(idle_.back());
        idle_.pop_back();
        return scratch;
    }
    void give_back(std::unique_ptr<ChunkScratch> scratch) {
        const std::lock_guard lock(mutex_);
        idle_.push_back(std::move(scratch));
    }

private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<ChunkScratch>> idle_;
};

/// All chunks that contain more than vertices, in batches. The most that a batch may take is charged before it, and
/// corrected to what it took afterwards, so the order of threads does not decide where memory runs out.
std::vector<ChunkElements> read_chunks(std::string_view file, const Contents& contents, const VertexData& data,
                                       bool keep_faces, MemoryCharge& charge, Context& context) {
    constexpr std::size_t batch_bytes = 16 << 20;
    std::vector<ChunkElements> chunks(contents.chunks.size());
    ScratchPool pool;
    for (std::size_t first = 0, end = 0; first < chunks.size(); first = end) {
        std::uint64_t bytes = 0;
        for (; end < chunks.size() && bytes < batch_bytes; ++end)
            if (contents.chunks[end].others > 0)
                bytes += contents.chunks[end].chunk.end - contents.chunks[end].chunk.begin;
        charge.grow(bytes * most_kept_per_byte, "the faces of an OBJ file");
        context.parallel_for(end - first, [&](std::size_t i) {
            if (contents.chunks[first + i].others == 0) return;
            std::unique_ptr<ChunkScratch> scratch = pool.take();
            chunks[first + i] =
                read_chunk(file, contents.chunks[first + i], contents, data, keep_faces, *scratch, context);
            pool.give_back(std::move(scratch));
        });
        std::uint64_t kept = 0;
        for (std::size_t i = first; i < end; ++i) kept += kept_bytes(chunks[i]);
        charge.grow(kept, "the faces of an OBJ file");
        charge.shrink(bytes * most_kept_per_byte);
        context.progress("load", 0.4 + 0.5 * double(end) / double(chunks.size()));
    }
    return chunks;
}

/// The state that continues from chunk to chunk, and the meshes that it leads to.
class Assembler {
public:
    Assembler(const Contents& contents, const FindMaterial& find_material, Elements& elements, Context& context)
        : contents_(contents), find_material_(find_material), elements_(elements), charge_(context.memory()) {}

    void assemble(const std::string& default_object) {
        name_ = default_object;
        elements_.places.resize(elements_.chunks.size());
        for (std::size_t i = 0; i < elements_.chunks.size(); ++i) add(elements_.chunks[i], elements_.places[i]);
    }

private:
    void add(const ChunkElements& chunk, ChunkPlaces& places) {
        places.smoothing_before = smoothing_;
        std::size_t changes = 0;
        for (std::size_t r = 0; r < chunk.runs.size(); ++r) {
            const Run& run = chunk.runs[r];
            for (; changes < run.changes; ++changes) apply(chunk.changes[changes]);
            const std::size_t number = mesh_for(run);
            ReadMesh& mesh = elements_.meshes[number];
            places.runs.push_back({number, std::size_t(mesh.index_count)});
            mesh.index_count += chunk.run_end(r) - run.first_index;
            mesh.has_polygons |= has_polygon(chunk, run, r);
        }
        for (; changes < chunk.changes.size(); ++changes) apply(chunk.changes[changes]);
        if (!chunk.smoothing.empty()) smoothing_ = chunk.smoothing.back().group;
        elements_.charge.grow(places.runs.capacity() * sizeof(RunPlace), "the faces of an OBJ file");
        elements_.drawable += chunk.drawable;
    }

    static bool has_polygon(const ChunkElements& chunk, const Run& run, std::size_t r) {
        if (run.topology != Topology::triangles) return false;
        const auto first =
            std::ranges::lower_bound(chunk.polygons, run.first_triangle, {}, &CutPolygon::first_triangle);
        return first != chunk.polygons.end() &&
               first->first_triangle < run.first_triangle + (chunk.run_end(r) - run.first_index) / 3;
    }

    void apply(const StateChange& change) {
        switch (change.kind) {
            case StateChange::Kind::object:
                name_ = change.name;
                object_ = no_index;
                break;
            case StateChange::Kind::group:
                resume_group(change.name);
                break;
            case StateChange::Kind::material:
                material_name_ = change.name;
                material_line_ = change.line;
                is_material_known_ = false;
                break;
        }
    }

    void resume_group(const std::string& name) {
        if (name == name_ && object_ != no_index) return;
        const auto known = groups_.find(name);
        object_ = known != groups_.end() ? known->second : no_index;
        name_ = name;
    }

    std::size_t mesh_for(const Run& run) {
        if (object_ == no_index) {
            object_ = std::uint32_t(elements_.objects.size());
            make_room(elements_.objects, elements_.charge);
            elements_.charge.grow(heap_bytes(name_), "the names of an OBJ file");
            elements_.objects.push_back(name_);
            if (!contents_.has_objects) {
                charge_.grow(group_bytes + heap_bytes(name_), "the names of an OBJ file");
                groups_.emplace(name_, object_);
            }
        }
        if (!is_material_known_) {
            material_ = find_material_(material_name_, material_line_);
            is_material_known_ = true;
        }
        return numbers_.number_of({object_, material_, run.topology, run.has_normals}, elements_.meshes,
                                  elements_.charge);
    }

    const Contents& contents_;
    const FindMaterial& find_material_;
    Elements& elements_;
    MeshNumbers numbers_;
    std::uint64_t material_line_ = 0;
    std::string name_, material_name_;
    NameMap<std::uint32_t> groups_;  ///< name -> object, in files without `o`
    std::uint32_t object_ = no_index, material_ = no_index, smoothing_ = 0;
    bool is_material_known_ = false;
    MemoryCharge charge_;  ///< pays for groups_
};

}  // namespace

Elements read_elements(std::string_view file, const Contents& contents, const VertexData& data,
                       const std::string& default_object, const FindMaterial& find_material, Remarks& remarks,
                       Context& context, bool keep) {
    Elements elements;
    elements.charge = MemoryCharge(context.memory());
    MemoryCharge of_chunks(context.memory());
    elements.chunks = read_chunks(file, contents, data, keep, of_chunks, context);
    for (const ChunkElements& chunk : elements.chunks) remarks.append(chunk.remarks);
    Assembler(contents, find_material, elements, context).assemble(default_object);
    merge_corners(elements.chunks, elements.places, elements.meshes, contents.has_smoothing, elements.charge, context);
    if (keep)
        elements.charge.grow(of_chunks.bytes(), "the faces of an OBJ file");
    else
        elements.chunks = {}, elements.places = {};
    return elements;
}

}  // namespace rakelight::io::obj
