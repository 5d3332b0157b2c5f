// SPDX-License-Identifier: Apache-2.0
// MTL materials as materials of a scene: what each value means, which guesses are made.
#pragma once
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <rakelight/base/context.h>
#include <rakelight/scene/scene.h>

#include "base/name_table.h"
#include "io/obj/mtl_file.h"
#include "io/obj/references.h"

namespace rakelight::io::obj {

/// A file name that says normal map: "normal" or "nrm" in it, or one of the words n, nm, nor, norm, nrml between
/// characters that are no letters ("brick_n.png", "wall-norm.tga"), in any case. The picture itself is not looked at.
bool is_normal_map_name(const std::string& file);

/// Materials of one model: reads its MTL files, fills Scene::materials and Scene::textures.
///
/// Colors are display values and become linear. The ambient factor k_a is Ka, or k_d without Ka. Values outside 0..1
/// are clamped, but Ke over 1 keeps its strength: the color over its largest component becomes linear and is multiplied
/// by it. With illum 0 the material is unlit (color only); illum 1 has no specular term; others and none have it when
/// Ks is there. Ns is at least 1. Alpha is d, else 1 - Tr; Tr 1 alone would hide the object and is a known exporter
/// fault: it counts as opaque, `guessed`.
///
/// With Pr, Pm, map_Pr or map_Pm the model is metallic-roughness. Its metallic factor is Pm (0 without it). Its
/// roughness is Pr; without it sqrt(sqrt(2 / (Ns + 2))) (Walter et al. 2007, section 5.2: the GGX width of a Phong
/// exponent; roughness squared); without both 1. One picture for both is packed (G roughness, B metallic); a single
/// map_Pr works as a gray picture if Pm is 0.
///
/// A texture of `norm` is a normal map. One of `map_Bump` is a normal map by its name (is_normal_map_name, `guessed`),
/// else a height map; `disp` is the height map where no bump map is. The alpha of map_Kd is used when map_d names the
/// same file. With illum 3 to 7, k_s reflects, with 5 and 7 more at grazing angles. With 4, 6 and 7 Tf is transmitted
/// (without Tf, white where alpha is below 1). With 6 and 7 it is also refracted by Ni. A map_Ka is not supported; no
/// remark is made if it names the file of map_Kd, since base color textures multiply the ambient term too.
class MaterialLibrary {
public:
    MaterialLibrary(Scene& scene, std::string model_path, bool allow_outside, Context& context)
        : scene_(scene),
          context_(context),
          charge_(context.memory()),
          model_path_(model_path),
          finder_(std::move(model_path), allow_outside) {}

    /// Reads what one mtllib line names: one file whose name may hold blanks, else several. What is missing is a
    /// warning.
    void load(const std::string& argument);
    /// For usemtl: index into Scene::materials; an undefined name becomes a default material with a warning, the empty
    /// name the default one (light gray, k_d 0.8 as display value, no highlight).
    std::uint32_t find(const std::string& name, std::uint64_t line);
    void finish();  ///< says how many warnings were held back; the scene gets the charge for its materials
    /// [Scene::materials] no file gives the material's color: the gray of default materials stands for it.
    const std::vector<bool>& have_invented_color() const { return have_invented_color_; }

private:
    struct File {
        std::string folder, name;  ///< of the MTL file at hand: folder as seen from the model's, name for messages
    };
    bool load_file(const std::string& reference);
    void add(const MtlMaterial& source, const File& file, Remarks& remarks);
    void set_colors(Material& m, const MtlMaterial& source, Remarks& remarks) const;
    static void set_rays(Material& m, const MtlMaterial& source, Remarks& remarks);
    void set_emission(Material& m, const MtlMaterial& source, const File& file, Remarks& remarks);
    void set_alpha(Material& m, const MtlMaterial& source, const File& file, Remarks& remarks);
    void set_relief(Material& m, const MtlMaterial& source, const File& file);
    void set_metallic_roughness(Material& m, const MtlMaterial& source, const File& file, Remarks& remarks);
    TextureUse use(const MtlMap* map, const File& file);
    void remark(Remark kind, const std::string& file, std::uint64_t line, std::string message);

    Scene& scene_;
    Context& context_;
    MemoryCharge charge_;  ///< pays for the scene's materials
    std::string model_path_;
    ReferenceFinder finder_;
    std::vector<bool> have_invented_color_;
    NameMap<std::uint32_t> by_name_;
    std::set<std::string> loaded_;                                    ///< paths
    std::map<std::string, ImageHandle> images_;                       ///< by path
    std::map<std::pair<std::string, bool>, std::uint32_t> textures_;  ///< by path and clamping
    std::set<std::string> missing_;                                   ///< references already warned of
    std::uint64_t remarks_made_ = 0;
};

}  // namespace rakelight::io::obj
