// The parts of a scene's file that say what is where: transforms, groups, instances.

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "scene/limits.hpp"
#include "scene/parts.hpp"
#include "scene/values.hpp"

namespace umbral::scene {
namespace {

float degrees(const Field& field) { return real(field.member("degrees"), -3600, 3600); }
float period(const Field& field) { return real(field.member("period"), 0.01, maximum_seconds); }
float phase(const Field& field) { return real_or(field.member("phase"), -1, 1, 0); }

Transform parse_scale(const Field& field)
{
    const Scale factors{vector3(field, -1000, 1000)};
    if (glm::any(glm::lessThan(glm::abs(factors.by), glm::vec3(1e-4F)))) field.refuse("factors of size 0.0001 or more");
    return factors;
}

Transform parse_transform(const Field& field)
{
    struct Kind {
        const char* name;
        Transform (*parse)(const Field&);
    };
    constexpr Kind kinds[] = {
        {"translate", [](const Field& one) -> Transform { return Translate{place(one)}; }},
        {"rotate",
         [](const Field& one) -> Transform {
             one.allow_only({"axis", "degrees"});
             return Rotate{direction(one.member("axis")), degrees(one)};
         }},
        {"scale", parse_scale},
        {"spin",
         [](const Field& one) -> Transform {
             one.allow_only({"axis", "degrees_per_second"});
             return Spin{direction(one.member("axis")), real(one.member("degrees_per_second"), -36000, 36000)};
         }},
        {"swing",
         [](const Field& one) -> Transform {
             one.allow_only({"axis", "degrees", "period", "phase"});
             return Swing{direction(one.member("axis")), degrees(one), period(one), phase(one)};
         }},
        {"move", [](const Field& one) -> Transform { return Move{place(one)}; }},
        {"bob",
         [](const Field& one) -> Transform {
             one.allow_only({"by", "period", "phase"});
             return Bob{place(one.member("by")), period(one), phase(one)};
         }},
    };
    field.allow_only({"translate", "rotate", "scale", "spin", "swing", "move", "bob"});
    const auto given = [&](const Kind& kind) { return field.member(kind.name).given(); };
    if (std::count_if(std::begin(kinds), std::end(kinds), given) != 1)
        field.refuse("exactly one of translate, rotate, scale, spin, swing, move, bob");
    const Kind& kind = *std::find_if(std::begin(kinds), std::end(kinds), given);
    return kind.parse(field.member(kind.name));
}

/// One thing of a group: an instance, or another group's use.
struct Part {
    Instance instance;               ///< of a group's use: name and transforms only
    std::optional<std::size_t> use;  ///< place of the group, if it is one
};

/// What groups refer to; their own names as well.
struct Names {
    std::vector<std::string> geometries;
    std::vector<std::string> materials;
    std::vector<std::string> groups;
};

Part parse_part(const Field& field, const Names& names, const Scene& scene)
{
    field.allow_only({"name", "geometry", "material", "group", "transforms", "shading", "sides"});
    Part part;
    Instance& instance = part.instance;
    instance.name = field.member("name").text(maximum_name_length);
    if (const Field transforms = field.member("transforms"); transforms.given())
        for (const Field& transform : transforms.items(0, maximum_transforms))
            instance.transforms.push_back(parse_transform(transform));
    if (const Field group = field.member("group"); group.given()) {
        for (const char* of_things : {"geometry", "material", "shading", "sides"})
            if (const Field other = field.member(of_things); other.given())
                other.refuse(std::string("no ") + of_things + ": a group's parts have their own");
        part.use = group.one_of(names.groups);
        return part;
    }
    instance.geometry = field.member("geometry").one_of(names.geometries);
    instance.material = field.member("material").one_of(names.materials);
    instance.smooth = !field.member("shading").given() || field.member("shading").one_of({"flat", "smooth"}) == 1;
    if (const Field sides = field.member("sides"); sides.given())
        instance.sides = static_cast<Sides>(sides.one_of({"front", "both"}));
    const Material& material = scene.materials[instance.material];
    if ((material.texture || material.bump) && !has_uvs(scene.geometries[instance.geometry]))
        field.member("material")
            .refuse("a material without a texture, as geometry \"" + scene.geometries[instance.geometry].name +
                    "\" has no uvs");
    return part;
}

std::vector<Part> parse_parts(const Field& list, std::size_t least, const Names& names, const Scene& scene)
{
    std::vector<Part> parts;
    std::vector<std::string> of_parts;
    for (const Field& field : list.items(least, maximum_items)) {
        parts.push_back(parse_part(field, names, scene));
        of_parts.push_back(parts.back().instance.name);
    }
    refuse_a_name_twice(list, std::move(of_parts));
    return parts;
}

/// Replaces uses of groups by what is in them. Every group holds something, so that this ends with the limit at last.
class Flattening {
public:
    Flattening(const std::vector<std::vector<Part>>& groups, const Field& list, std::vector<Instance>& instances)
        : groups_(groups), list_(list), instances_(instances)
    {
    }

    /// `after`: what acts on all of them afterwards, the first one first; `within`: what their names begin with.
    void add(const std::vector<Part>& parts, const std::vector<Transform>& after, const std::string& within,
             std::size_t nesting)
    {
        if (nesting > maximum_nesting)
            list_.refuse("groups within each other at most " + std::to_string(maximum_nesting) +
                         " deep, and none within itself: see \"" + within + "\"");
        for (const Part& part : parts) {
            Instance instance = part.instance;
            instance.name.insert(0, within);
            instance.transforms.insert(instance.transforms.end(), after.begin(), after.end());
            if (part.use) {
                add(groups_[*part.use], instance.transforms, instance.name + "/", nesting + 1);
                continue;
            }
            if (instances_.size() == maximum_instances)
                list_.refuse("at most " + std::to_string(maximum_instances) + " instances, those of groups counted");
            instances_.push_back(std::move(instance));
        }
    }

private:
    const std::vector<std::vector<Part>>& groups_;
    const Field& list_;
    std::vector<Instance>& instances_;
};

}

void parse_instances(const Field& root, Scene& scene)
{
    const Field groups_field = root.member("groups");
    Names names{names_of(scene.geometries), names_of(scene.materials), {}};
    std::vector<std::vector<Part>> groups;
    if (groups_field.given()) {
        names.groups = groups_field.names();
        for (const auto& [name, list] : groups_field.members(maximum_items)) {
            if (name.empty() || name.size() > maximum_name_length) list.refuse("a name of 1 to 64 bytes");
            groups.push_back(parse_parts(list, 1, names, scene));
        }
    }
    const Field list = root.member("instances");
    const std::vector<Part> parts = parse_parts(list, 0, names, scene);
    Flattening(groups, list, scene.instances).add(parts, {}, "", 0);
    refuse_a_name_twice(list, names_of(scene.instances));
}

}
