// SPDX-License-Identifier: Apache-2.0
// The values of one section, held against the table of its keys.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "io/world/toml_tree.h"
#include "io/world/world_keys.h"

namespace rakelight::io::world {

/// @throws Error bad_file with the place of the fault
[[noreturn]] void fail(WorldPlace place, std::string reason, std::string advice = {});

/// "did you mean 'x'?", or a list of names where none is near: `most` of them at most.
std::string advice_for(std::string_view word, const std::vector<const char*>& names, std::size_t most = 12);

/// Where a table comes from; refusals say how it is written there.
enum class Written { in_file, as_words };

/// The checked values of a table, by key.
class SectionValues {
public:
    /// @throws Error bad_file: an unknown key, one that is missing, a value of another kind or out of range
    SectionValues(const TomlNode& table, const WorldSection& section, Written written = Written::in_file);

    WorldPlace place() const { return place_; }
    const std::vector<WorldValue>& all() const { return values_; }
    /// The tables of its key of Kind::tables, of which a section has one at most.
    const std::vector<SectionValues>& tables() const { return tables_; }
    /// Null: not given. What only the tables have is as the first of them says it.
    const WorldValue* find(std::string_view key) const;
    bool has(std::string_view key) const { return find(key) != nullptr; }
    WorldPlace place_of(std::string_view key) const;  ///< of the table where it is not given

    std::string text(std::string_view key, const std::string& otherwise = {}) const;
    double number(std::string_view key, double otherwise) const;
    bool flag(std::string_view key, bool otherwise) const;
    dvec3 vector(std::string_view key, dvec3 otherwise) const;
    vec3 color(std::string_view key, vec3 otherwise) const;
    dvec3 direction(std::string_view key, dvec3 otherwise) const;  ///< unit; @throws Error: zero

private:
    void read_tables(const TomlEntry& entry, const WorldKey& key, const WorldSection& section);
    WorldPlace place_;
    std::vector<WorldValue> values_;
    std::vector<SectionValues> tables_;
};

/// A value of [render]: a text, number or flag, or an array of such.
WorldValue free_value(const TomlEntry& entry);

}  // namespace rakelight::io::world
