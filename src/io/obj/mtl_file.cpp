// SPDX-License-Identifier: Apache-2.0
#include "io/obj/mtl_file.h"

#include <array>
#include <cmath>

#include <rakelight_internal/base/text.h>

#include "io/obj/obj_lines.h"
#include "io/obj/obj_numbers.h"

namespace rakelight::io::obj {
namespace {

// Maps that materials use, and those that are known but have no place in them.
constexpr std::array used_maps{"map_kd",   "map_ka", "map_ks", "map_ke", "map_d",
                               "map_bump", "norm",   "disp",   "map_pr", "map_pm"};
constexpr std::array unsupported_maps{"map_ns",   "map_ni", "map_tr", "map_tf",  "decal",   "refl",
                                      "map_refl", "map_ps", "map_pc", "map_rma", "map_orm", "map_aniso"};
constexpr std::array unsupported_values{"sharpness", "ps", "pc", "pcr", "km", "kt", "map_aat", "pro", "it"};

template <class List>
bool is_in(const std::string& key, const List& list) {
    for (const char* word : list)
        if (key == word) return true;
    return false;
}

/// Other spellings of exporters.
std::string canonical(std::string key) {
    if (key == "bump") return "map_bump";
    if (key == "map_disp") return "disp";
    if (key == "map_kn" || key == "map_norm") return "norm";
    if (key == "map_opacity" || key == "map_alpha") return "map_d";
    return key;
}

class MtlReader {
public:
    MtlReader(std::string_view file, Remarks& remarks, Context& context)
        : file_(file), remarks_(remarks), context_(context) {}

    std::vector<MtlMaterial> read() {
        LineReader lines(file_);
        if (file_.find('\0') != std::string_view::npos) remarks_.add(Issue::nul_bytes, 0);
        for (Line line; lines.next(line);) {
            if (line.number % 65536 == 0) context_.throw_if_cancelled();
            if (lines.saw_lone_cr() && remarks_.count(Issue::lone_cr) == 0) remarks_.add(Issue::lone_cr, line.number);
            if (!line.keyword.text.empty()) statement(line, lines.arguments(line));
        }
        return std::move(materials_);
    }

private:
    void statement(const Line& line, Tokens words) {
        const std::string key = canonical(lower_case(line.keyword.text));
        line_ = line.number;
        if (key == "newmtl") {
            context_.memory().check((materials_.size() + 1) * sizeof(MtlMaterial), "the materials of an MTL file");
            materials_.emplace_back();
            materials_.back().name = name_text(file_, line.keyword.end(), line.end);
            materials_.back().line = line_;
        } else if (materials_.empty()) {
            remarks_.add(Issue::mtl_outside, line_);
        } else if (is_in(key, used_maps)) {
            auto map = parse_map(file_, line.keyword.end(), line.end, line_, remarks_);
            if (map)
                materials_.back().maps[key] = std::move(*map);
            else
                remarks_.add(Issue::mtl_empty_map, line_);
        } else if (!value(key, words, materials_.back())) {
            remarks_.add(is_in(key, unsupported_maps)     ? Issue::mtl_unsupported_map
                         : is_in(key, unsupported_values) ? Issue::mtl_unsupported_value
                                                          : Issue::mtl_unknown,
                         line_);
        }
    }

    bool value(const std::string& key, Tokens words, MtlMaterial& m) {
        if (key == "ka")
            color(words, m.ambient);
        else if (key == "kd")
            color(words, m.diffuse);
        else if (key == "ks")
            color(words, m.specular);
        else if (key == "ke")
            color(words, m.emission);
        else if (key == "tf")
            color(words, m.filter);
        else if (key == "ns")
            number(words, m.exponent);
        else if (key == "d")
            dissolve(words, m.dissolve);
        else if (key == "tr")
            number(words, m.transparency);
        else if (key == "ni")
            number(words, m.ior);
        else if (key == "pr")
            number(words, m.roughness);
        else if (key == "pm")
            number(words, m.metallic);
        else if (key == "aniso")
            number(words, m.anisotropy);
        else if (key == "anisor")
            number(words, m.anisotropy_rotation);
        else if (key == "illum") {
            Token word;
            const auto parsed = words.next(word) ? parse_number(word.text) : std::nullopt;  // "2.0" is seen too
            if (parsed && *parsed >= 0 && *parsed <= 10)
                m.illumination = std::int64_t(*parsed);
            else
                remarks_.add(Issue::mtl_number, line_);
        } else {
            return false;
        }
        return true;
    }

    void number(Tokens words, std::optional<double>& target) {
        Token word;
        const auto parsed = words.next(word) ? parse_number(word.text) : std::nullopt;
        if (parsed && std::isfinite(float(*parsed)))
            target = parsed;
        else
            remarks_.add(Issue::mtl_number, line_);
    }

    // "d -halo 0.5" fades with the angle; the factor is taken without the halo.
    void dissolve(Tokens words, std::optional<double>& target) {
        Tokens after = words;
        Token word;
        if (after.next(word) && word.text == "-halo") {
            remarks_.add(Issue::mtl_unsupported_value, line_);
            words = after;
        }
        number(words, target);
    }

    // "Kd r", "Kd r g b"; one number stands for three. "Kd spectral FILE" and "Kd xyz x y z" are dropped.
    void color(Tokens words, std::optional<vec3>& target) {
        Token word;
        std::array<float, 3> rgb{};
        std::size_t count = 0;
        for (; count < 3 && words.next(word); ++count) {
            if (count == 0 && (word.text == "spectral" || word.text == "xyz"))
                return remarks_.add(Issue::mtl_spectral, line_);
            const auto parsed = parse_number(word.text);
            if (!parsed || !std::isfinite(float(*parsed))) return remarks_.add(Issue::mtl_number, line_);
            rgb[count] = float(*parsed);
        }
        if (count == 1)
            rgb[1] = rgb[2] = rgb[0];
        else if (count != 3)
            return remarks_.add(Issue::mtl_number, line_);
        target = vec3{rgb[0], rgb[1], rgb[2]};
    }

    std::string_view file_;
    Remarks& remarks_;
    Context& context_;
    std::vector<MtlMaterial> materials_;
    std::uint64_t line_ = 0;
};

}  // namespace

std::vector<MtlMaterial> read_mtl(std::string_view file, Remarks& remarks, Context& context) {
    return MtlReader(file, remarks, context).read();
}

}  // namespace rakelight::io::obj
