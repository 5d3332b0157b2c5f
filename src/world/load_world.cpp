// SPDX-License-Identifier: Apache-2.0
#include "world/load_world.h"

#include <rakelight/base/report.h>
#include <rakelight/scene/validate.h>

#include <algorithm>
#include <map>
#include <set>

#include "base/format_text.h"
#include "io/files/file.h"
#include "io/pictures/image_io.h"
#include "io/reader.h"
#include "math/functions.h"
#include "math/linear.h"
#include "scene/materials/texture_uses.h"
#include "scene/merge_scenes.h"
#include "world/make_shape.h"
#include "world/scene_of_request.h"
#include "world/world_clip.h"
#include "world/z_up.h"

namespace rakelight {
namespace {

constexpr std::uint64_t bytes_beside_name = 32;  ///< overhead of an allocation
constexpr double least_upright = 0.7;  ///< cosine of about 45 degrees: up is nearer to this axis than to others

dquat turn(dvec3 axis, double angle_rad) {
    const double s = math::sin(0.5 * angle_rad);
    return {axis.x * s, axis.y * s, axis.z * s, math::cos(0.5 * angle_rad)};
}

dquat product(const dquat& a, const dquat& b) {
    return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

dquat rotation_of(const WorldPlacement& placement) {
    const dvec3 d = placement.rotation_deg;
    return product(turn({0, 0, 1}, radians(d.z)),
                   product(turn({0, 1, 0}, radians(d.y)), turn({1, 0, 0}, radians(d.x))));
}

Node root_node(const std::string& name, const WorldPlacement& placement) {
    Node node;
    node.name = name;
    node.local.translation = placement.position;
    node.local.rotation = rotation_of(placement);
    node.local.scale = placement.scale;
    return node;
}

NormalSource normals_of(const std::string& word) {
    if (word == "file") return NormalSource::file;
    if (word == "flat") return NormalSource::flat;
    if (word == "object") return NormalSource::object;
    if (word == "seams") return NormalSource::seams;
    return word == "model" ? NormalSource::model : NormalSource::automatic;
}

/// The normal options of a part: from the world file, or the defaults of its file's format.
template <class Part>
std::optional<NormalChoice> choice_of(const Part& part, bool missing_are_flat) {
    if (part.normals.empty() && !part.crease_angle_rad && !missing_are_flat) return std::nullopt;
    NormalChoice choice{normals_of(part.normals), missing_are_flat, part.crease_angle_rad};
    if (part.normals.empty() && part.crease_angle_rad) choice.source = NormalSource::model;
    return choice;
}

/// An error of a referenced file, with the place of the reference.
Error at_place(const Error& error, const std::string& name, WorldPlace place) {
    const std::string file = error.file().empty() ? "" : "'" + one_line(name, 80) + "': ";
    const std::string inner = error.place().empty() ? "" : error.place() + ": ";
    const ErrorCode code = error.code() == ErrorCode::usage ? ErrorCode::bad_file : error.code();  // words of the file
    return Error(code, file + inner + error.reason(), to_text(place), error.advice()).naming(error.related());
}

/// Warns of duplicate names that identify parts. Shapes without a name have the name of their type.
void warn_of_twins(const WorldFile& world, const std::string& path, Report& report) {
    std::set<std::string_view> cameras, shapes;
    for (const Camera& c : world.cameras)
        if (!c.name.empty() && !cameras.insert(c.name).second)
            report.add(Remark::warning, path, {},
                       "two cameras are named '" + one_line(c.name, 40) + "': the first is found");
    for (const WorldPrimitive& p : world.primitives)
        if (p.name != p.type && !shapes.insert(p.name).second)
            report.add(Remark::warning, path, to_text(p.place),
                       "two primitives are named '" + one_line(p.name, 40) + "': what goes by name goes to both");
}

/// Whether it takes the axis Z near to Y: the component y of where the rotation takes (0, 0, 1).
bool stands_z_on_y(const WorldPlacement& placement) {
    const dquat q = rotation_of(placement);
    return 2 * (q.y * q.z - q.w * q.x) * (placement.scale.z < 0 ? -1 : 1) > least_upright;
}

/// Warns of STL files, which have Z up, in a world, which has Y up, unless they are turned upright or the up axis is
/// given.
void warn_of_lying_models(const WorldFile& world, const std::string& path, const LoadOptions& options, Report& report) {
    const bool is_given = std::ranges::find(world.render, "up", &WorldValue::key) != world.render.end() ||
                          std::ranges::find(options.overridden, "up") != options.overridden.end();
    if (is_given) return;
    for (const WorldModel& model : world.models)
        if (up_axis(model.file) == UpAxis::z && !stands_z_on_y(model.placement))
            warn_of_lying(path, to_text(model.place), "because worlds have Y up", report);
}

/// Options of a part besides its placement.
struct PartOptions {
    const std::string& name;
    const std::string& material;
    const std::optional<Subdivision>& subdivision;
    std::optional<NormalChoice> normals;
    const WorldPrimitive* shape = nullptr;  ///< null: a model
};

/// Renames a shape's nodes and meshes from its type to its name: 'tyre', or 'tyre 2' for pieces.
void rename(Scene& scene, const LoadedPart& part, const WorldPrimitive& shape, MemoryCharge& names) {
    if (shape.name == shape.type) return;
    const auto change = [&](std::string& name) {
        if (!name.starts_with(shape.type)) return;
        names.grow(shape.name.size() + name.size() + bytes_beside_name, "the names of shapes");
        name.replace(0, shape.type.size(), shape.name);
    };
    for (std::uint32_t i = part.first_node + 1; i < part.end_node; ++i) change(scene.nodes[i].name);
    for (std::uint32_t i = part.first_mesh; i < part.end_mesh; ++i) change(scene.meshes[i].name);
}

/// Collects the parts of a world and merges them when all are known, so that the memory is known before.
class Assembly {
public:
    Assembly(const std::string& path, const LoadOptions& options, Context& context)
        : path_(path), options_(options), context_(context) {}

    void add_model(const WorldModel& model) { add(load_file(model), model, {model.lights, model.cameras}); }

    void add_primitive(const WorldPrimitive& shape) {
        try {
            add(make_shape(shape), shape, {true, true});
        } catch (const Error& error) {  // incompatible lengths
            const bool is_of_objects = error.reason().starts_with("the objects of ");
            throw Error(ErrorCode::bad_file, error.reason(), to_text(is_of_objects ? shape.objects_place : shape.place),
                        error.advice());
        }
        part_options_.back().shape = &shape;
    }

    /// Cameras of the world precede those of its models.
    Scene finish(const WorldFile& world) {
        put_together();
        apply_materials(scene_, world, parts_, path_, options_, context_);
        add_lights_and_cameras(world);
        check_render(world);
        warn_of_twins(world, path_, context_.report());
        warn_of_lying_models(world, path_, options_, context_.report());
        if (world.fog) scene_.fog = *world.fog;
        if (world.environment) scene_.environment = surroundings(*world.environment);
        validate(scene_);
        return std::move(scene_);
    }

private:
    /// Inserted before those of the models, whose channels keep referring to them.
    void add_lights_and_cameras(const WorldFile& world) {
        for (Animation& animation : scene_.animations)
            for (AnimationChannel& channel : animation.channels) {
                if (channel.element == no_index) continue;
                if (channel.path == AnimationPath::light) channel.element += std::uint32_t(world.lights.size());
                if (channel.path == AnimationPath::camera) channel.element += std::uint32_t(world.cameras.size());
            }
        scene_.lights.insert(scene_.lights.begin(), world.lights.begin(), world.lights.end());
        scene_.cameras.insert(scene_.cameras.begin(), world.cameras.begin(), world.cameras.end());
        Animation own = world_clip(world);
        if (!own.channels.empty()) scene_.animations.push_back(std::move(own));
    }

    /// A file used several times in the world is read once; its arrays are shared.
    const Scene& load_file(const WorldModel& model) {
        const auto known = loaded_.find(model.file);
        if (known != loaded_.end()) return known->second;
        context_.throw_if_cancelled();
        try {
            const bool is_builtin = model.file.starts_with("builtin:");
            const std::string file =
                is_builtin ? model.file : io::resolve_reference(path_, model.file, options_.allow_outside);
            LoadOptions alone = options_;
            alone.joined.clear();
            Scene scene = load(file, alone, context_);
            name_default_material(scene);  // so that [[material]] finds it
            return loaded_.emplace(model.file, std::move(scene)).first->second;
        } catch (const Error& error) {
            throw at_place(error, model.file, model.place);
        }
    }

    /// Equal shapes share their arrays.
    const Scene& make_shape(const WorldPrimitive& shape) {
        const ShapeRequest request = request_of(shape);
        const auto known = shapes_.find(request);
        if (known != shapes_.end()) return known->second;
        context_.throw_if_cancelled();
        return shapes_.emplace(request, rakelight::make_shape(request, &context_.memory())).first->second;
    }

    struct Taken {
        bool lights, cameras;
    };

    /// @param scene must stay valid until all parts are merged
    template <class Part>
    void warn_of_crease(const Part& of) {
        if (!of.crease_angle_rad || (of.normals != "flat" && of.normals != "file")) return;
        context_.report().add(Remark::warning, path_, to_text(of.place),
                              "'crease_angle_deg' has no effect beside normals = \"" + of.normals + "\"");
    }

    template <class Part>
    void add(const Scene& scene, const Part& of, Taken taken) {
        warn_of_crease(of);
        Node root = root_node(of.name, of.placement);
        root.shading = of.shading;
        additions_.push_back({scene, std::move(root), taken.lights, taken.cameras});
        part_options_.push_back({of.name, of.material, of.subdivision, choice_of(of, scene.missing_normals_are_flat)});
    }

    void put_together() {
        MergedScene merged = merge_scenes(additions_, context_);
        scene_ = std::move(merged.scene);
        scene_.source = path_;
        MemoryCharge names(context_.memory());
        for (std::size_t i = 0; i < part_options_.size(); ++i) {
            const Scene& part = additions_[i].scene;
            const MergeOffsets& by = merged.offsets[i];
            const PartOptions& part_options = part_options_[i];
            const auto end = [](std::uint32_t first, std::size_t count) { return std::uint32_t(first + count); };
            parts_.push_back({part_options.name, by.materials, end(by.materials, part.materials.size()), by.meshes,
                              end(by.meshes, part.meshes.size()), by.nodes - 1, end(by.nodes, part.nodes.size()),
                              part_options.material});
            for (std::uint32_t m = by.meshes; m < parts_.back().end_mesh; ++m) {
                if (part_options.subdivision) scene_.meshes[m].subdivision = part_options.subdivision;
                scene_.meshes[m].normal_choice = part_options.normals;
            }
            if (part_options.shape) rename(scene_, parts_.back(), *part_options.shape, names);
        }
        scene_.charges.push_back(share(std::move(names)));
    }

    /// Checks that camera and pictures named in [render] exist.
    void check_render(const WorldFile& world) const {
        for (const WorldValue& value : world.render) {
            const std::vector<std::string>& others = options_.overridden;
            if (value.words.size() != 1 || std::find(others.begin(), others.end(), value.key) != others.end()) continue;
            if (value.key == "camera-index") check_camera(value);
            for (const char* key : {"texture-base-color", "texture-normal", "height-map", "hdri-file"})
                if (value.key == key) checked_picture(path_, value.words[0], value.place, options_, context_);
        }
    }

    void check_camera(const WorldValue& value) const {
        try {
            find_camera(scene_, value.words[0]);
        } catch (const Error& error) {
            throw error.as(ErrorCode::bad_file).at(to_text(value.place));
        }
    }

    Environment surroundings(const WorldEnvironment& from) {
        Environment out = from.environment;
        if (from.file.empty()) return out;
        std::pair<int, int> size;
        const std::string file = checked_picture(path_, from.file, from.place, options_, context_, &size);
        if (size.first != 2 * size.second)
            context_.report().add(
                Remark::warning, path_, to_text(from.place),
                format_text("the environment is {} x {} pixels: equirectangular pictures are twice as wide as high",
                            size.first, size.second));
        out.image = io::image_from_file(from.file, path_, file);
        return out;
    }

    const std::string& path_;
    const LoadOptions& options_;
    Context& context_;
    std::map<std::string, Scene> loaded_;
    std::map<ShapeRequest, Scene> shapes_;
    std::vector<ScenePart> additions_;
    std::vector<PartOptions> part_options_;  ///< [additions]
    Scene scene_;
    std::vector<LoadedPart> parts_;  ///< [additions]
};

}  // namespace

Scene load_world(const std::string& path, const WorldFile& world, const LoadOptions& options, Context& context) {
    for (const WorldRemark& r : world.remarks) context.report().add(r.kind, path, to_text(r.place), r.message);
    try {
        Assembly assembly(path, options, context);
        for (const WorldModel& model : world.models) assembly.add_model(model);
        for (const WorldPrimitive& shape : world.primitives) assembly.add_primitive(shape);
        return assembly.finish(world);
    } catch (const Error& error) {
        throw error.with_file(path);
    }
}

}  // namespace rakelight
