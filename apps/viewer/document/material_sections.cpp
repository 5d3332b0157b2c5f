// SPDX-License-Identifier: Apache-2.0
#include "material_sections.h"

#include <algorithm>
#include <iterator>

namespace rakelight::viewer {
namespace {

bool has_key(const WorldMaterial& section, const std::string& key) {
    return std::ranges::find(section.values, key, &WorldValue::key) != section.values.end();
}

void erase_key(WorldMaterial& section, const std::string& key) {
    std::erase_if(section.values, [&](const WorldValue& v) { return v.key == key; });
}

void set_value(WorldMaterial& section, const WorldValue& value) {
    erase_key(section, value.key);
    section.values.push_back(value);
}

bool is_for(const WorldMaterial& section, const WorldMaterial& target) {
    return section.name == target.name && section.model == target.model && section.object == target.object;
}

WorldMaterial* find(WorldFile& world, const WorldMaterial& target) {
    const auto found = std::ranges::find_if(world.materials, [&](const WorldMaterial& m) { return is_for(m, target); });
    return found == world.materials.end() ? nullptr : &*found;
}

/// Sections for all objects, and sections for single ones: the second kind acts after the first.
bool are_of_one_kind(const WorldMaterial& a, const WorldMaterial& b) { return a.object.empty() == b.object.empty(); }

/// All that `section` acts on `over` acts on, too.
bool covers(const WorldMaterial& over, const WorldMaterial& section) {
    return (over.name == "*" || over.name == section.name) && (over.model.empty() || over.model == section.model) &&
           over.object == section.object;
}

bool may_meet(const WorldMaterial& a, const WorldMaterial& b) {
    return (a.name == b.name || a.name == "*" || b.name == "*") &&
           (a.model == b.model || a.model.empty() || b.model.empty()) &&
           (a.object == b.object || a.object.empty() || b.object.empty());
}

/// Moves a section behind all others, and behind it those that went over some of its keys for some materials: what the
/// file says stays the same. Keys that a later section takes away from all of its materials go.
void move_last(WorldFile& world, const WorldMaterial& target) {
    std::vector<WorldMaterial>& all = world.materials;
    std::vector<bool> moves(all.size(), false);
    moves[std::size_t(find(world, target) - all.data())] = true;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!moves[i]) continue;
        for (std::size_t later = i + 1; later < all.size(); ++later) {
            const auto goes_over = [&](const WorldValue& v) { return has_key(all[later], v.key); };
            if (!are_of_one_kind(all[later], all[i]) || !may_meet(all[later], all[i])) continue;
            if (covers(all[later], all[i]))
                std::erase_if(all[i].values, goes_over);
            else if (std::ranges::any_of(all[i].values, goes_over))
                moves[later] = true;
        }
    }
    std::vector<WorldMaterial> stay, move;
    for (std::size_t i = 0; i < all.size(); ++i) (moves[i] ? move : stay).push_back(std::move(all[i]));
    all = std::move(stay);
    all.insert(all.end(), std::make_move_iterator(move.begin()), std::make_move_iterator(move.end()));
}

/// A material that is the world's own stands in a section of its name, before any other acts.
bool is_own(const WorldFile& world, const std::string& name) {
    const auto has_it = [&](const auto& part) { return part.material == name; };
    return std::ranges::any_of(world.models, has_it) || std::ranges::any_of(world.primitives, has_it);
}

/// Takes back what sections that act after the target's say of a key, or says the new value behind them.
void set_in_later(WorldFile& world, const WorldMaterial& target, const WorldValue& value) {
    std::vector<WorldMaterial> behind;
    const WorldMaterial* const own = find(world, target);
    for (WorldMaterial& m : world.materials) {
        const bool is_later = are_of_one_kind(m, target) ? &m > own : !m.object.empty();
        const bool makes_own = target.name == "*" && m.object.empty() && is_own(world, m.name);
        if (makes_own) set_value(m, value);
        if (makes_own || !is_later || !may_meet(m, target) || !has_key(m, value.key)) continue;
        if (covers({.name = target.name, .model = target.model, .object = m.object}, m))
            erase_key(m, value.key);
        else
            behind.push_back({.name = target.name == "*" ? m.name : target.name,
                              .model = target.model.empty() ? m.model : target.model,
                              .object = m.object});
    }
    for (const WorldMaterial& next : behind) {
        if (find(world, next))
            move_last(world, next);
        else
            world.materials.push_back(next);
        set_value(*find(world, next), value);
    }
}

}  // namespace

void set_values(WorldFile& world, const WorldMaterial& target, const std::vector<WorldValue>& values) {
    if (values.empty()) return;
    if (find(world, target))
        move_last(world, target);
    else
        world.materials.push_back({.name = target.name, .model = target.model, .object = target.object});
    for (const WorldValue& value : values) {
        set_in_later(world, target, value);
        set_value(*find(world, target), value);
    }
    std::erase_if(world.materials, [&](const WorldMaterial& m) { return m.values.empty() && !is_own(world, m.name); });
}

}  // namespace rakelight::viewer
