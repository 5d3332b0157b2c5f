// SPDX-License-Identifier: Apache-2.0
#include "io/obj/material_files.h"

#include <algorithm>
#include <array>
#include <set>

#include <rakelight_internal/base/text.h>

#include "io/files/file.h"
#include "io/obj/mtl_file.h"
#include "io/obj/obj_lines.h"
#include "io/obj/obj_vertices.h"
#include "io/obj/references.h"

namespace rakelight::io::obj {
namespace {

constexpr std::size_t most_files = 10000;

bool names_a_picture(const std::string& key) {
    static constexpr std::array words{"bump", "norm", "disp", "decal", "refl"};
    return key.starts_with("map_") || std::find(words.begin(), words.end(), key) != words.end();
}

class Collector {
public:
    Collector(const std::string& model_path, const ReadOptions& options, Context& context)
        : model_path_(model_path), context_(context), finder_(model_path, options.allow_outside) {}

    /// What one mtllib line names: one file whose name may hold blanks, else several.
    void add_libraries(const std::string& argument) {
        if (const auto found = finder_.find(argument)) return add_library(*found);
        Tokens words(argument, 0, argument.size());
        for (Token word; words.next(word);)
            if (const auto found = finder_.find(std::string(word.text))) add_library(*found);
    }

    std::vector<NamedFile> take() { return std::move(files_); }

private:
    bool add(const FoundFile& found) {
        if (files_.size() >= most_files || !seen_.insert(found.path).second) return false;
        const std::string name = std::filesystem::path(found.path)
                                     .lexically_normal()
                                     .lexically_relative(folder_of(model_path_).lexically_normal())
                                     .generic_string();
        if (is_inside(name)) {
            files_.push_back({name, found.path});
        } else {
            context_.report().add(Remark::warning, model_path_, {},
                                  "the file '" + one_line(ReferenceFinder::bare_name(found.path), 80) +
                                      "' is not copied: it is not in the model's folder");
        }
        return true;
    }

    void add_library(const FoundFile& found) {
        if (!add(found)) return;
        const Bytes bytes = read_file(found.path, context_);
        const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
        const std::string folder = finder_.folder_of(found.path);
        Remarks quiet(found.path);  // made when the model was read
        LineReader lines(text);
        for (Line line; lines.next(line);) {
            if (!names_a_picture(lower_case(line.keyword.text))) continue;
            const auto map = parse_map(text, line.keyword.end(), line.end, line.number, quiet);
            if (!map) continue;
            if (const auto picture = finder_.find(map->file, folder)) add(*picture);
        }
    }

    const std::string& model_path_;
    Context& context_;
    ReferenceFinder finder_;
    std::set<std::string> seen_;
    std::vector<NamedFile> files_;
};

}  // namespace

std::vector<NamedFile> material_files(std::string_view text, const std::string& model_path, const ReadOptions& options,
                                      Context& context) {
    Context quiet({.threads = context.threads(), .max_memory = context.memory().limit(), .parent = &context});
    Remarks remarks(model_path);
    Collector collector(model_path, options, context);
    for (const std::string& argument : count_contents(text, remarks, quiet).libraries)
        collector.add_libraries(argument);
    return collector.take();
}

}  // namespace rakelight::io::obj
