// SPDX-License-Identifier: Apache-2.0
// Adds a row of each face to the rows of its vertices, inside each mesh. Fixed pieces of about 128k triangles own vertex
// ranges; rows for another piece's vertex are transferred and added in the order of the pieces, so results are bit-identical
// for any number of threads.
#pragma once
#include <atomic>
#include <cstring>

#include "base/atomic_ref.h"
#include "geometry/fast/fast_stages.h"

namespace rakelight::geometry {

constexpr std::uint32_t faces_per_piece = 1u << 18;
constexpr std::uint32_t max_pieces = 1u << 10;  // of one mesh
constexpr std::uint32_t pieces_in_flight =
    64;  // pieces with simultaneous outboxes, which limits their memory for shuffled meshes
constexpr std::uint32_t faces_per_small_chunk = 1u << 15;
constexpr std::uint32_t vertices_per_step = 1u << 10;  // rows prepared at a time, so that they are in the cache

/// @tparam Rows  what is added: floats (of a row); data(), of the first one; ready(lane, mesh, first, last), of rows that were cleared; set(job, mesh);
///               kernel(); add_odd(job, mesh, face, parcels[3]), for a face that the kernel leaves: whether it has rows
template <class Rows>
class FastScatter {
public:
    static constexpr int floats = Rows::floats;
    using Parcel = FastParcel<floats>;
    FastScatter(FastState& state, const Rows& rows) : state_(state), rows_(rows) {}

    bool run() {
        prepare_ranges();
        for (const auto& box : state_.scratch.outbox) outbox_bytes_ += box.capacity();
        const std::vector<std::uint32_t>& base = state_.input.triangle_base;
        const std::uint32_t meshes = std::uint32_t(state_.input.meshes.size());
        std::vector<Task> tasks;
        std::uint32_t open = 0;
        for (std::uint32_t m = 0; m < meshes; ++m) {
            const std::uint32_t faces = base[m + 1] - base[m];
            const std::uint32_t pieces = std::min(max_pieces, faces / faces_per_piece + 1);
            if (pieces > 1) {
                if (!tasks.empty() && tasks.size() + pieces > pieces_in_flight && !flush(tasks)) return false;
                if (pieces > pieces_in_flight) clear_mesh(m);
                for (std::uint32_t p = 0; p < pieces; ++p) {
                    tasks.push_back({m, m + 1, p, pieces, pieces <= pieces_in_flight});
                    if (tasks.size() == pieces_in_flight && p + 1 < pieces && !flush(tasks)) return false;
                }
                open = 0;
                continue;
            }
            if (open == 0 || open + faces > faces_per_small_chunk || tasks.empty()) {
                if (tasks.size() >= pieces_in_flight && !flush(tasks)) return false;
                tasks.push_back({m, m + 1, 0, 1, true});
                open = 0;
            }
            tasks.back().mesh_end = m + 1;
            open += faces + 1;
        }
        return flush(tasks);
    }

private:
    void prepare_ranges() {
        std::vector<std::size_t>& base = state_.scratch.range_base;
        base.assign(1, 0);
        for (const AttributeMesh& mesh : state_.input.meshes)
            base.push_back(base.back() + (mesh.indices.size() / 3 + faces_per_range - 1) / faces_per_range);
        state_.scratch.ranges.resize(base.back());
    }

    struct Task {
        std::uint32_t mesh_begin, mesh_end, piece, pieces;
        bool clears;  ///< clears its own rows before adding to them
    };

    // Pieces begin where a range does.
    static std::uint32_t face_begin(std::uint32_t faces, std::uint32_t piece, std::uint32_t pieces) {
        return piece == pieces ? faces : piece_begin(faces, piece, pieces) / faces_per_range * faces_per_range;
    }

    std::uint32_t vertices(std::uint32_t m) const { return std::uint32_t(state_.input.meshes[m].positions.size()); }

    void clear_mesh(std::uint32_t m) const {
        constexpr std::uint32_t step = 1u << 16;
        for_each_in_lanes(state_, (vertices(m) + step - 1) / step, [&](LaneScratch& lane, std::size_t c) {
            const std::uint32_t first = std::uint32_t(c) * step;
            make_ready(lane, m, first, std::min(vertices(m), first + step));
        });
    }

    float* row(std::uint32_t vertex) const { return rows_.data() + std::size_t(vertex) * floats; }

    void make_ready(LaneScratch& lane, std::uint32_t m, std::uint32_t first, std::uint32_t last) const {
        if (first >= last) return;
        std::memset(row(state_.input.vertex_base[m] + first), 0, std::size_t(last - first) * floats * sizeof(float));
        rows_.ready(lane, m, first, last);
    }

    bool flush(std::vector<Task>& tasks) {
        auto& outbox = state_.scratch.outbox;
        std::size_t slots = 0;
        first_slot_.clear();
        for (const Task& task : tasks) {
            first_slot_.push_back(slots);
            slots += task.pieces > 1 ? task.pieces : 0;
        }
        if (outbox.size() < slots) outbox.resize(slots);
        for (std::size_t s = 0; s < slots; ++s) outbox[s].clear();
        std::atomic<bool> is_good{true};
        for_each_in_lanes(state_, tasks.size(), [&](LaneScratch& lane, std::size_t i) {
            if (!scatter(tasks[i], first_slot_[i], lane)) is_good = false;
        });
        if (!is_good) return false;
        drain(tasks);
        tasks.clear();
        state_.context.throw_if_cancelled();
        return true;
    }

    bool scatter(const Task task, std::size_t slot, LaneScratch& lane) {
        lane.parcels.resize(parcel_capacity * sizeof(Parcel));
        lane.odd.resize(odd_capacity);
        for (std::uint32_t m = task.mesh_begin; m != task.mesh_end; ++m)
            if (!scatter_mesh(task, m, slot, lane)) return false;
        return true;
    }

    ScatterJob job_of(const Task& task, std::uint32_t m, LaneScratch& lane) const {
        const AttributeMesh& mesh = state_.input.meshes[m];
        ScatterJob job;
        job.positions = mesh.positions.empty() ? nullptr : &mesh.positions[0].x;
        job.indices = mesh.indices.data();
        job.vertices = vertices(m);
        job.face = face_begin(std::uint32_t(mesh.indices.size() / 3), task.piece, task.pieces);
        job.rows = row(state_.input.vertex_base[m]);
        job.own_begin = piece_begin(job.vertices, task.piece, task.pieces);
        job.own_end = piece_begin(job.vertices, task.piece + 1, task.pieces);
        job.foreign = lane.parcels.data();
        job.odd = lane.odd.data();
        job.ready_end = task.clears ? job.own_begin : job.own_end;
        rows_.set(job, m);
        return job;
    }

    bool scatter_mesh(const Task& task, std::uint32_t m, std::size_t slot, LaneScratch& lane) {
        ScatterJob job = job_of(task, m, lane);
        const std::uint32_t faces = std::uint32_t(state_.input.meshes[m].indices.size() / 3);
        const std::uint32_t face_end = face_begin(faces, task.piece + 1, task.pieces);
        std::uint32_t degenerate = 0;
        while (job.face < face_end) {
            const std::uint32_t range = job.face / faces_per_range;
            if (job.face % faces_per_range == 0) {
                job.smallest = 0xffffffffu;
                job.largest = 0;
            }
            job.face_end = std::min(face_end, (range + 1) * faces_per_range);
            rows_.kernel()(&job);
            if (job.is_index_bad) return false;
            if (job.ready_end < job.wanted_end) {
                const std::uint32_t last =
                    std::min(job.own_end, std::max(job.wanted_end, job.ready_end + vertices_per_step));
                make_ready(lane, m, job.ready_end, last);
                job.ready_end = last;
            }
            state_.scratch.ranges[state_.scratch.range_base[m] + range] = {job.smallest, job.largest};
            for (std::uint32_t i = 0; i < job.odd_count; ++i)
                degenerate += add_odd(job, m, task, slot, job.odd[i]) ? 0 : 1;
            const Parcel* parcels = static_cast<const Parcel*>(job.foreign);
            for (std::uint32_t i = 0; i < job.foreign_count; ++i) send(job, task, slot, parcels[i]);
            job.foreign_count = job.odd_count = 0;
        }
        make_ready(lane, m, job.ready_end, job.own_end);
        if (degenerate != 0 && Rows::counts_degenerate)
            atomic_ref(state_.degenerate[m]).fetch_add(degenerate, std::memory_order_relaxed);
        return true;
    }

    void send(const ScatterJob& job, const Task& task, std::size_t slot, const Parcel& parcel) {
        std::vector<std::byte>& box = state_.scratch.outbox[slot + piece_of(parcel.vertex, job.vertices, task.pieces)];
        const std::size_t at = box.size();
        if (box.capacity() < at + sizeof parcel) {  // for unordered triangles all parcels are sent
            const std::size_t wanted = std::max<std::size_t>(4096, 2 * at), more = wanted - box.capacity();
            state_.context.memory().check(outbox_bytes_.fetch_add(more) + more,
                                          "smoothing normals of triangles in disorder");
            box.reserve(wanted);
        }
        box.resize(at + sizeof parcel);
        std::memcpy(box.data() + at, &parcel, sizeof parcel);
    }

    bool add_odd(const ScatterJob& job, std::uint32_t m, const Task& task, std::size_t slot, std::uint32_t face) {
        Parcel parcels[3] = {};
        for (std::uint32_t k = 0; k < 3; ++k)
            parcels[k].vertex = state_.input.meshes[m].indices[3 * std::size_t(face) + k];
        if (!rows_.add_odd(job, m, face, parcels)) return false;
        for (const Parcel& parcel : parcels) {
            if (parcel.vertex - job.own_begin < job.own_end - job.own_begin)
                add(job.rows, parcel);
            else
                send(job, task, slot, parcel);
        }
        return true;
    }

    static void add(float* rows, const Parcel& parcel) {
        float* to = rows + std::size_t(parcel.vertex) * floats;
        for (int a = 0; a < floats; ++a) to[a] += parcel.row[a];
    }

    // Every piece receives parcels from the pieces of this wave, in their order. Meshes with more pieces take several
    // waves.
    void drain(const std::vector<Task>& tasks) {
        std::vector<std::pair<std::size_t, std::uint32_t>> work;  // first task of the mesh, receiving piece
        for (std::size_t i = 0; i < tasks.size(); ++i)
            if (tasks[i].pieces > 1 && (i == 0 || tasks[i - 1].mesh_begin != tasks[i].mesh_begin))
                for (std::uint32_t p = 0; p < tasks[i].pieces; ++p) work.emplace_back(i, p);
        state_.context.parallel_for(work.size(), [&](std::size_t w) {
            const auto [first, piece] = work[w];
            const std::uint32_t m = tasks[first].mesh_begin;
            float* const rows = row(state_.input.vertex_base[m]);
            for (std::size_t i = first; i < tasks.size() && tasks[i].mesh_begin == m; ++i) {
                const std::vector<std::byte>& box = state_.scratch.outbox[first_slot_[i] + piece];
                for (std::size_t at = 0; at < box.size(); at += sizeof(Parcel)) {
                    Parcel parcel;
                    std::memcpy(&parcel, box.data() + at, sizeof parcel);
                    add(rows, parcel);
                }
            }
        });
    }

    FastState& state_;
    const Rows& rows_;
    std::vector<std::size_t> first_slot_;
    std::atomic<std::uint64_t> outbox_bytes_{0};  ///< held by all outboxes
};

}  // namespace rakelight::geometry
