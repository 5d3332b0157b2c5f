// SPDX-License-Identifier: Apache-2.0
// What is wrong with the lines of one file, counted by kind: a file of a million bad faces costs a million increments
// and makes one remark.
#pragma once
#include <array>
#include <cstdint>
#include <string>

#include <rakelight/base/context.h>

namespace rakelight::io::obj {

enum class Issue : std::uint8_t {
    lone_cr,
    nul_bytes,
    bad_number,
    not_finite,
    missing_numbers,
    weight,
    extra_numbers,
    bad_normal,
    bad_texcoord,
    bad_color,
    bytes_as_colors,
    face_syntax,
    face_index,
    face_short,
    face_texcoord_index,
    face_normal_index,
    texcoords_missing,
    normals_missing,
    polygon_crossed,
    polygon_complex,
    element_syntax,
    smoothing_syntax,
    free_form,
    display_attribute,
    external_call,
    unknown_keyword,
    mtl_unknown,
    mtl_outside,
    mtl_number,
    mtl_spectral,
    mtl_range,
    mtl_exponent,
    mtl_redefined,
    mtl_option,
    mtl_option_hint,
    mtl_empty_map,
    mtl_unsupported_map,
    mtl_unsupported_value,
    count_
};

/// Counts issues of one file; flush() puts them into the report, one remark a kind with the first line in its place.
class Remarks {
public:
    Remarks() = default;  ///< to be appended to others
    explicit Remarks(std::string file) : file_(std::move(file)) {}
    void add(Issue issue, std::uint64_t line) {
        Tally& t = tallies_[std::size_t(issue)];
        if (t.count++ == 0) t.first_line = line;
    }
    /// What was counted in lines after those of this one.
    void append(const Remarks& later) {
        for (std::size_t i = 0; i < tallies_.size(); ++i) {
            if (tallies_[i].count == 0) tallies_[i].first_line = later.tallies_[i].first_line;
            tallies_[i].count += later.tallies_[i].count;
        }
    }
    std::uint64_t count(Issue issue) const { return tallies_[std::size_t(issue)].count; }
    void flush(Report& report);
    const std::string& file() const { return file_; }

private:
    struct Tally {
        std::uint64_t count = 0, first_line = 0;
    };
    std::string file_;
    std::array<Tally, std::size_t(Issue::count_)> tallies_{};
};

}  // namespace rakelight::io::obj
