#include "attack/attack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "attack/generators.hpp"
#include "text/field.hpp"
#include "text/json_file.hpp"

namespace umbral::grader::attack {
namespace {

namespace fs = std::filesystem;

constexpr std::array areas = {"build", "collect", "run", "judge", "report", "store", "cli", "gl"};

std::vector<std::string> texts_of(const Field& field)
{
    return field.given() ? field.texts(1, 32, 200) : std::vector<std::string>{};
}

double number_or(const Field& field, double otherwise) { return field.given() ? field.number(0, 1e6) : otherwise; }

bool flag(const Field& field) { return field.given() && field.boolean(); }

ExpectedUnit read_unit(const Field& field)
{
    field.allow_only({"verdicts", "least_points", "most_points", "message_has", "message_lacks", "most_seconds"});
    ExpectedUnit unit;
    for (const std::string& name : texts_of(field.member("verdicts"))) {
        try {
            unit.verdicts.push_back(verdict_from(name));
        } catch (const std::invalid_argument& error) {
            field.member("verdicts").refuse(error.what());
        }
    }
    unit.least_points = number_or(field.member("least_points"), 0);
    unit.most_points = field.member("most_points").number(0, 100);
    unit.message_has = texts_of(field.member("message_has"));
    unit.message_lacks = texts_of(field.member("message_lacks"));
    unit.most_seconds = number_or(field.member("most_seconds"), 0);
    return unit;
}

Bounds read_bounds(const Field& field)
{
    Bounds bounds;
    if (!field.given()) return bounds;
    field.allow_only({"seconds", "grader_memory_mib", "report_kib", "disk_mib"});
    bounds.seconds = number_or(field.member("seconds"), bounds.seconds);
    bounds.grader_memory_mib = number_or(field.member("grader_memory_mib"), bounds.grader_memory_mib);
    bounds.report_kib = number_or(field.member("report_kib"), bounds.report_kib);
    bounds.disk_mib = number_or(field.member("disk_mib"), bounds.disk_mib);
    return bounds;
}

}

Attack load_attack(const fs::path& folder)
{
    const fs::path file = folder / "attack.json";
    const nlohmann::json json = read_json(file);
    const Field root(json, file.string());
    root.allow_only({"what", "area", "harmless", "ci", "draws", "knows_paths", "make", "units", "lacks",
                     "student_lacks", "bounds"});
    Attack attack;
    attack.folder = folder;
    attack.name = folder.filename().string();
    attack.theme = folder.parent_path().filename().string();
    attack.what = root.member("what").text(240);
    attack.area = root.member("area").text(16);
    if (std::ranges::find(areas, attack.area) == areas.end())
        root.member("area").refuse(fmt::format("one of {}", fmt::join(areas, ", ")));
    attack.harmless = flag(root.member("harmless"));
    attack.ci = flag(root.member("ci"));
    attack.draws = flag(root.member("draws"));
    attack.knows_paths = flag(root.member("knows_paths"));
    if (root.member("make").given()) attack.make = root.member("make").text(64);
    if (!attack.make.empty() && !has_generator(attack.make))
        root.member("make").refuse("the name of a generator in grader/attack/generators.cpp");
    const Field units = root.member("units");
    for (const std::string& id : units.names()) attack.units[id] = read_unit(units.member(id));
    if (attack.units.empty()) units.refuse("what must come of at least one unit");
    attack.lacks = texts_of(root.member("lacks"));
    attack.student_lacks = texts_of(root.member("student_lacks"));
    attack.bounds = read_bounds(root.member("bounds"));
    return attack;
}

std::vector<Attack> load_attacks(const fs::path& root)
{
    if (!fs::is_directory(root))
        throw std::runtime_error(
            fmt::format("{}: expected the folder with the attacks, one folder a theme", root.string()));
    std::vector<Attack> attacks;
    for (const auto& theme : fs::directory_iterator(root)) {
        if (!theme.is_directory()) continue;
        for (const auto& one : fs::directory_iterator(theme.path()))
            if (one.is_directory()) attacks.push_back(load_attack(one.path()));
    }
    std::ranges::sort(attacks, {}, &Attack::id);
    return attacks;
}

}
