#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "judge/judges.hpp"
#include "manifest/check_fields.hpp"
#include "manifest/knob.hpp"
#include "manifest/marks.hpp"
#include "manifest/recorded_values.hpp"
#include "manifest/units.hpp"
#include "manifest/with.hpp"
#include "model/forbidden_families.hpp"
#include "text/field.hpp"

// The manifest exercise.json, field by field; what belongs to one judge alone is read by that judge.
// docs/schemas/exercise.schema.json says the same for editors; a test holds both together.
namespace umbral::grader {
namespace {

constexpr std::array suffixes{".cpp", ".hpp", ".glsl", ".vert", ".frag", ".geom", ".comp"};

bool is_one_of(char letter, std::string_view others)
{
    const bool alphanumeric =
        (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9') || (letter >= 'A' && letter <= 'Z');
    return alphanumeric || others.find(letter) != std::string_view::npos;
}

std::string read_id(const Field& field)
{
    std::string id = field.text(100);
    const auto slash = id.find('/');
    const bool split = slash != std::string::npos && slash > 0 && slash + 1 < id.size() &&
                       id.find('/', slash + 1) == std::string::npos;
    const bool plain = std::all_of(id.begin(), id.end(), [](char letter) {
        return letter == '/' || (is_one_of(letter, "-") && !(letter >= 'A' && letter <= 'Z'));
    });
    if (!split || !plain) field.refuse("\"topic/unit\" in letters a-z, digits and '-'");
    return id;
}

std::vector<std::string> read_files(const Field& field)
{
    std::vector<std::string> files = field.texts(1, 16, 64);
    for (const std::string& file : files) {
        const std::string suffix = std::filesystem::path(file).extension();
        const bool plain =
            std::all_of(file.begin(), file.end(), [](char letter) { return is_one_of(letter, "_.-"); }) &&
            is_one_of(file.front(), "_");
        if (!plain || std::find(suffixes.begin(), suffixes.end(), suffix) == suffixes.end() || file == "driver.cpp" ||
            file == "support.hpp")
            field.refuse(
                fmt::format("plain file names that end in .cpp, .hpp, .glsl, .vert, .frag, .geom or .comp (and are not "
                            "driver.cpp or support.hpp; '{}' is not so)",
                            file));
    }
    return files;
}

std::vector<std::string> read_uses(const Field& field, const std::string& own_id)
{
    std::set<std::string> seen{own_id};
    std::vector<std::string> uses;
    for (const Field& item : field.items(0, 64)) {
        uses.push_back(read_id(item));
        if (!seen.insert(uses.back()).second) item.refuse("another unit than this one, and each once");
    }
    return uses;
}

std::map<std::string, std::string> read_title(const Field& field)
{
    std::map<std::string, std::string> title;
    for (const std::string& language : field.names()) {
        const bool is_code = language.size() == 2 && std::all_of(language.begin(), language.end(), [](char letter) {
                                 return letter >= 'a' && letter <= 'z';
                             });
        if (!is_code) field.member(language).refuse("titles by language, as \"en\" and \"es\"");
        title[language] = field.member(language).text(120);
    }
    if (!title.contains("en")) field.member("en").refuse("the title in English");
    return title;
}

Limits read_limits(const Field& field, bool gl)
{
    Limits limits;
    if (field.given()) {
        field.allow_only({"wall_seconds", "memory_mib"});
        if (const Field seconds = field.member("wall_seconds"); seconds.given())
            limits.wall_seconds = seconds.number(0.1, 600);
        // Under 256 MiB of address space Mesa draws black pictures and reports no error.
        if (const Field memory = field.member("memory_mib"); memory.given())
            limits.memory_mib = memory.integer(gl ? 512 : 64, 16384);
    }
    return limits;
}

Tolerance read_tolerance(const Field& field)
{
    field.allow_only({"absolute", "relative", "ulps", "band_ulps"});
    const auto bound = [&](const char* name) -> std::optional<double> {
        const Field member = field.member(name);
        if (!member.given()) return std::nullopt;
        return member.number(0, 1e9);
    };
    Tolerance tolerance{bound("absolute"), bound("relative"), bound("ulps"), bound("band_ulps")};
    if (!tolerance.absolute && !tolerance.relative && !tolerance.ulps)
        field.refuse("at least one of absolute, relative and ulps");
    return tolerance;
}

/// "\"numbers\", \"matrices\" or \"noise\"": those judges for which `chosen` holds.
template <class Chosen>
std::string judges_with(const Chosen& chosen, std::string_view last)
{
    std::vector<std::string> names;
    for (const JudgeRecord* record : judges())
        if (chosen(*record)) names.push_back(fmt::format("\"{}\"", record->name));
    if (names.size() < 2) return fmt::format("{}", fmt::join(names, ""));
    const std::string end = std::move(names.back());
    names.pop_back();
    return fmt::format("{} {} {}", fmt::join(names, ", "), last, end);
}

const JudgeRecord& read_judge(const Field& field)
{
    const std::string name = field.text(40);
    if (const JudgeRecord* record = find_judge(name)) return *record;
    field.refuse(judges_with([](const JudgeRecord&) { return true; }, "or"));
}

bool read_flag(const Field& field) { return field.given() && field.boolean(); }

/// The fields that several judges take, each refused where the judge takes none.
void read_shared(const Field& field, const JudgeRecord& judge, Check& check)
{
    const Field tolerance = field.member("tolerance");
    if (tolerance.given()) check.tolerance = read_tolerance(tolerance);
    if (judge.needs_tolerance && !tolerance.given())
        tolerance.refuse(fmt::format("a tolerance, since the judge is {}",
                                     judges_with([](const JudgeRecord& one) { return one.needs_tolerance; }, "or")));
    if (tolerance.given() && check.why.empty()) field.member("why").refuse("where the tolerance comes from");
    if (check.pairs && !judge.pairs)
        field.member("pairs").refuse(fmt::format("no pairs: what \"{}\" judges has no rows that pair", judge.name));
    if (const Field range = field.member("range"); range.given()) {
        if (!has_range(judge))
            range.refuse(fmt::format("no range, since the judge is not {}", judges_with(has_range, "or")));
        const auto ends = range.items(2, 2);
        check.range_low = ends[0].number(-1e9, 1e9);
        check.range_high = ends[1].number(-1e9, 1e9);
    }
    if (!(check.range_low < check.range_high)) field.member("range").refuse("[low, high] with low < high");
    if (const Field relation = field.member("relation"); relation.given())
        check.relation = read_relation(relation, check);
}

/// A judge's own fields, and nobody else's.
void read_own(const Field& field, const JudgeRecord& judge, Check& check)
{
    for (const JudgeRecord* other : judges())
        for (const OwnField& one : other->own_fields)
            if (const Field own = field.member(std::string(one.name));
                own.given() ? other != &judge : other == &judge && !one.optional)
                own.refuse(fmt::format("{} if, and only if, the judge is \"{}\"", one.name, other->name));
    if (judge.read_own != nullptr) judge.read_own(field, check);
}

Check read_check(const Field& field)
{
    std::vector<std::string_view> allowed(check_fields.begin(), check_fields.end());
    for (const JudgeRecord* judge : judges())
        for (const OwnField& own : judge->own_fields) allowed.push_back(own.name);
    field.allow_only(allowed);
    Check check;
    check.case_name = field.member("case").text(64);
    if (check.case_name.find('/') != std::string::npos) field.member("case").refuse("a case's name without '/'");
    check.value = read_recorded_name(field.member("value"));
    check.name = check.case_name + "/" + check.value;
    const JudgeRecord& judge = read_judge(field.member("judge"));
    check.judge = {std::string(judge.name)};
    check.points = read_points(field.member("points"));
    check.hard = read_flag(field.member("hard"));
    check.hidden = read_flag(field.member("hidden"));
    check.pairs = read_flag(field.member("pairs"));
    if (const Field full = field.member("full"); full.given()) check.full = full.number(0, 1);
    if (const Field zero = field.member("zero"); zero.given()) check.zero = zero.number(0, 1);
    if (!(check.zero < check.full)) field.member("zero").refuse(fmt::format("less than \"full\" ({})", check.full));
    if (const Field why = field.member("why"); why.given()) check.why = why.text(1000);
    if (const Field with = field.member("with"); with.given()) check.with = with.text(200);
    read_shared(field, judge, check);
    read_own(field, judge, check);
    return check;
}

std::vector<Check> read_checks(const Field& field, std::size_t rubric_lines)
{
    std::vector<Check> checks;
    std::set<std::string> names;
    for (const Field& item : field.items(1, 256)) {
        checks.push_back(read_check(item));
        checks.back().rubric_line = read_rubric_line(item.member("rubric"), rubric_lines);
        if (!names.insert(checks.back().name).second)
            item.refuse(fmt::format("a case and value not checked before ('{}' is)", checks.back().name));
    }
    return checks;
}

/// An unknown family would forbid nothing, without a word.
std::vector<std::string> read_forbid(const Field& field)
{
    std::vector<std::string> entries = field.texts(0, 256, 128);
    for (const std::string& entry : entries)
        if (!is_forbid_entry(entry)) {
            std::vector<std::string_view> families;
            for (const ForbiddenFamily& family : forbidden_families()) families.push_back(family.name);
            field.refuse(fmt::format("names, patterns, or one of the families {}", fmt::join(families, ", ")));
        }
    return entries;
}

}

Exercise parse_exercise(const nlohmann::json& json, const std::string& where)
{
    const Field root(json, where);
    root.allow_only({"format", "version", "id", "files", "points", "uses", "forbid", "gl", "gl_calls", "glfw", "title",
                     "course", "order", "limits", "rubric", "knob", "checks"});
    if (root.member("format").text(40) != "umbral-exercise") root.member("format").refuse("\"umbral-exercise\"");
    (void)root.member("version").integer(1, 1);

    Exercise exercise;
    exercise.id = read_id(root.member("id"));
    exercise.topic = exercise.id.substr(0, exercise.id.find('/'));
    exercise.name = exercise.id.substr(exercise.topic.size() + 1);
    exercise.files = read_files(root.member("files"));
    exercise.points = read_points(root.member("points"));
    if (const Field uses = root.member("uses"); uses.given()) exercise.uses = read_uses(uses, exercise.id);
    if (const Field forbid = root.member("forbid"); forbid.given()) exercise.forbid = read_forbid(forbid);
    exercise.gl = read_flag(root.member("gl"));
    exercise.gl_calls = read_flag(root.member("gl_calls"));
    if (exercise.gl_calls && !exercise.gl) root.member("gl_calls").refuse("true only in a unit with \"gl\": true");
    exercise.glfw = read_flag(root.member("glfw"));
    exercise.title = read_title(root.member("title"));
    if (const Field course = root.member("course"); course.given()) exercise.course = course.texts(0, 64, 200);
    if (const Field order = root.member("order"); order.given()) exercise.order = order.number(-1e6, 1e6);
    exercise.limits = read_limits(root.member("limits"), exercise.gl);
    exercise.rubric = read_rubric(root.member("rubric"));
    exercise.checks = read_checks(root.member("checks"), exercise.rubric.size());
    expect_known_with(root.member("checks"), exercise);
    exercise.knob = read_unit_knob(root.member("knob"), exercise);
    exercise.counts_work =
        std::ranges::any_of(exercise.checks, [](const Check& check) { return judge_of(check).counts_work; });

    Millipoints sum = 0;
    for (const Check& check : exercise.checks) sum += check.points;
    if (sum != exercise.points)
        root.member("points").refuse(fmt::format("the sum of the checks' points, {}", static_cast<double>(sum) / 1000));
    expect_rubric_of_checks(root.member("rubric"), exercise);
    return exercise;
}

}
