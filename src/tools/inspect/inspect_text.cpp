// SPDX-License-Identifier: Apache-2.0
#include "tools/inspect/inspect_text.h"

#include <algorithm>

#include <rakelight/scene/motion.h>
#include <rakelight/scene/words.h>

#include "base/format_text.h"
#include "shading/choices.h"
#include "tools/camera_extent.h"
#include "tools/inspect/seam_sections.h"
#include "tools/inspect/whole_inspection.h"
#include "tools/material_names.h"
#include "tools/object_name.h"

namespace rakelight {
namespace {

using Has = ObjectSummary::Has;

std::string name_or(const std::string& name, const char* kind, std::size_t index) {
    return name.empty() ? kind + (" " + std::to_string(index)) : one_line(name, max_name);
}

/// "normals, tangents, texcoords(some)": what the file brings along.
std::string attributes_of(const ObjectSummary& o) {
    std::string text;
    const auto add = [&](const char* name, Has has) {
        if (has != Has::no) text += (text.empty() ? "" : ", ") + std::string(name) + (has == Has::some ? "(some)" : "");
    };
    add("normals", o.normals), add("tangents", o.tangents), add("texcoords", o.texcoords), add("colors", o.colors);
    add("groups", o.smoothing_groups), add("skin", o.skin), add("targets", o.morph_targets);
    return text.empty() ? "-" : text;
}

std::string joined(const std::vector<std::string>& names) { return names.empty() ? "-" : list_of_names(names, 4, 24); }

Section objects_section(const Inspection& i) {
    return section("objects", {">#", "name", ">meshes", ">triangles", ">vertices", "attributes", "materials"},
                   i.objects, [](const ObjectSummary& o, std::size_t n) {
                       return std::vector<std::string>{std::to_string(n),          name_or(o.name, "node", o.node),
                                                       std::to_string(o.meshes),   std::to_string(o.triangles),
                                                       std::to_string(o.vertices), attributes_of(o),
                                                       joined(o.materials)};
                   });
}

Section materials_section(const Inspection& i) {
    return section("materials", {">#", "name", "objects", "model", "alpha", "sides", "textures"}, i.scene.materials,
                   [&](const Material& m, std::size_t n) {
                       std::string textures;
                       for (const auto& [role, use] : named_texture_uses(m))
                           textures += (textures.empty() ? "" : ", ") + (role + (" " + std::to_string(use.texture)));
                       const bool two_sided = shading::is_two_sided(m);
                       const std::uint32_t objects = i.material_objects[n];
                       return std::vector<std::string>{std::to_string(n),
                                                       name_or(m.name, "material", n),
                                                       objects == 0 ? "unused" : std::to_string(objects),
                                                       name_of(m.model),
                                                       name_of(m.alpha_mode),
                                                       two_sided ? "2" : "1",
                                                       textures.empty() ? "-" : textures};
                   });
}

/// " (2 unused)" or nothing.
std::string unused_text(const Inspection& i) {
    const auto unused = std::count(i.material_objects.begin(), i.material_objects.end(), 0u);
    return unused > 0 ? format_text(" ({} unused)", unused) : "";
}

/// What pictures can be colored by.
Section arrays_section(const Inspection& i) {
    return section("numbers of vertices", {"name", ">components", ">from", ">to", ">vertices"}, i.arrays,
                   [](const ArraySummary& a, std::size_t) {
                       return std::vector<std::string>{one_line(a.name, max_name), std::to_string(a.components),
                                                       number(a.low), number(a.high), std::to_string(a.vertices)};
                   });
}

Section textures_section(const Scene& scene) {
    return section("textures", {">#", "image", "kind"}, scene.textures, [](const Texture& t, std::size_t n) {
        const bool embedded = t.image && t.image->bytes;
        const std::string kind = embedded ? format_text("embedded, {} bytes", t.image->bytes->size()) : "file";
        return std::vector<std::string>{std::to_string(n), t.image ? one_line(t.image->name, 80) : "-", kind};
    });
}

Section lights_section(const Scene& scene) {
    return section("lights", {">#", "name", "type", "units"}, scene.lights, [](const Light& l, std::size_t n) {
        return std::vector<std::string>{std::to_string(n), name_or(l.name, "light", n), name_of(l.type),
                                        l.units == LightUnits::photometric ? "photometric" : "classical"};
    });
}

std::string projection_text(const Camera& c) {
    if (c.projection == Projection::perspective) {
        const std::optional<double> across = horizontal_fov_rad(c);
        if (c.vertical_fov_rad == 0 && across)
            return "perspective, " + number(degrees(*across), "%.1f") + " degrees wide";
        const std::string up = number(degrees(c.vertical_fov_rad), "%.1f") + " degrees";
        return "perspective, " + up + (across ? " high, " + number(degrees(*across), "%.1f") + " wide" : "");
    }
    const std::optional<double> across = half_width(c);
    return "orthographic, height " + number(2 * c.half_height) + (across ? ", width " + number(2 * *across) : "");
}

Section cameras_section(const Scene& scene) {
    return section("cameras", {">#", "name", "projection"}, scene.cameras, [](const Camera& c, std::size_t n) {
        return std::vector<std::string>{std::to_string(n), name_or(c.name, "camera", n), projection_text(c)};
    });
}

/// What --animation-index counts: a character has dozens, and one is requested by its name.
constexpr std::size_t most_clips = 400;

Section clips_section(const Scene& scene) {
    return section(
        "animations", {">#", "name", ">from [s]", ">to", ">channels"}, scene.animations,
        [](const Animation& a, std::size_t n) {
            const ClipSpan span = clip_span(a);
            return std::vector<std::string>{std::to_string(n), name_or(a.name, "animation", n), number(span.begin_s),
                                            number(span.end_s), std::to_string(a.channels.size())};
        },
        0, most_clips);
}

}  // namespace

std::vector<std::string> summary_lines(const Inspection& i) {
    const dvec3 size{i.high.x - i.low.x, i.high.y - i.low.y, i.high.z - i.low.z};
    const auto text = [](dvec3 v, const char* between) {
        return number(v.x) + between + number(v.y) + between + number(v.z);
    };
    std::vector<std::string> lines = {
        counted(i.objects.size(), "object") + ", " + counted(i.triangles, "triangle") + ", " +
            counted(i.scene.materials.size(), "material") + unused_text(i) + ", " +
            counted(i.scene.textures.size(), "texture") + ", " + counted(i.scene.animations.size(), "animation"),
        "bounds " + text(i.low, " ") + " to " + text(i.high, " ") + ", size " + text(size, " x ") + " " + i.unit +
            (i.is_posed ? " as posed; seams in the bind pose" : "")};
    for (std::string& line : crease_lines(i)) lines.push_back(std::move(line));
    for (std::string& line : choice_lines(i)) lines.push_back(std::move(line));
    for (std::string& line : seams_lines(i)) lines.push_back(std::move(line));
    for (std::string& line : matched_lines(i)) lines.push_back(std::move(line));
    return lines;
}

std::vector<Section> sections_of(const Inspection& i) {
    std::vector<Section> all = {objects_section(i),        arrays_section(i),       materials_section(i),
                                textures_section(i.scene), lights_section(i.scene), cameras_section(i.scene),
                                clips_section(i.scene),    surfaces_section(i),     t_junctions_section(i),
                                inside_out_section(i),     borders_section(i),      matched_section(i)};
    std::erase_if(all, [](const Section& section) { return section.empty(); });
    return all;
}

std::string to_text(const Inspection& i) {
    check_whole(i);
    std::string text = one_line(i.file) + "\n";
    for (const std::string& line : summary_lines(i)) text += "  " + line + "\n";
    for (const Section& section : sections_of(i)) {
        if (!section.table.empty()) text += section.title + "\n" + section.table.text("  ");
        if (!section.note.empty()) text += "  " + section.note + "\n";
    }
    return text;
}

}  // namespace rakelight
