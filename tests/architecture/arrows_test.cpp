#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>

#include "sources.hpp"

namespace umbral::test {
namespace {

namespace fs = std::filesystem;

struct Include {
    Line line;
    std::string target;
    bool system;  ///< in <>
};

std::vector<Include> includes_of(const fs::path& file)
{
    static const std::regex form(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)re");
    std::vector<Include> includes;
    for (const Line& line : lines_of(file)) {
        std::smatch found;
        if (std::regex_match(line.text, found, form)) includes.push_back({line, found[2], found[1] == "<"});
    }
    return includes;
}

std::vector<Include> includes_below(const std::string& folder)
{
    std::vector<Include> all;
    for (const fs::path& file : files_below(folder)) {
        if (!is_cpp(file)) continue;
        const std::vector<Include> some = includes_of(file);
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

/// The n-th part of a path: part("grader/run/x.hpp", 1) is "run".
std::string part(const fs::path& path, int n)
{
    auto at = path.begin();
    for (; n > 0 && at != path.end(); --n) ++at;
    return at == path.end() ? "" : at->string();
}

/// The layer of the grader that a path belongs to, which begins with the layer's folder. A folder of its own: what
/// needs most of the others, so that the rest of cli need not.
std::string grader_layer(const fs::path& path)
{
    const std::string layer = part(path, 0);
    return layer == "cli" && part(path, 1) == "authors" ? "cli/authors" : layer;
}

using Layers = std::map<std::string, std::set<std::string>>;

// "mesh.hpp" beside the file belongs to the file's own layer; "../x.hpp" would hide where it goes.
TEST(Arrows, of_the_grader)
{
    const Layers may_include = {
        {"model", {}},
        {"run", {"model"}},
        {"store", {"model", "run"}},
        {"collect", {"model", "run"}},
        {"build", {"model", "run", "collect"}},
        {"judge", {"model"}},
        {"question", {"model", "judge"}},
        {"manifest", {"model", "judge"}},
        {"report", {"model", "judge"}},
        {"worker", {"model", "manifest", "run", "store", "collect", "build", "judge", "question"}},
        {"explain", {"model", "build", "judge", "question", "report", "worker"}},
        {"unit", {"model", "run", "store", "build", "judge", "question", "report", "worker", "explain"}},
        {"class", {"model", "store", "collect", "build", "report", "worker", "unit"}},
        {"validate", {"manifest", "judge", "question", "worker", "unit"}},
        {"mutants", {"model", "run", "collect", "build", "worker", "unit"}},
        {"bench",
         {"model", "run", "collect", "build", "judge", "report", "worker", "explain", "unit", "mutants", "question"}},
        {"inspect", {"model"}},
        {"attack", {"model"}},
        {"cli",
         {"model", "manifest", "run", "store", "collect", "build", "judge", "question", "report", "worker", "unit",
          "class"}},
        {"cli/authors",
         {"cli", "model", "manifest", "run", "store", "collect", "build", "judge", "question", "report", "worker",
          "unit", "class", "validate", "mutants", "bench", "attack"}}};
    std::size_t seen = 0;
    for (const Include& include : includes_below("grader")) {
        const std::string layer = grader_layer(fs::path(include.line.file).lexically_relative("grader"));
        ASSERT_TRUE(may_include.contains(layer)) << "a layer nobody declared: " << include.line.where();
        if (include.system) continue;
        const std::string target = grader_layer(include.target);
        ++seen;
        EXPECT_TRUE(target == layer || target == "text" || may_include.at(layer).contains(target))
            << include.line.where();
    }
    EXPECT_GT(seen, 100U);
}

// A judge is its folder and its line in judges.cpp: nothing else asks which judge it has before it. What is listed here
// needs one judge's own measurements, and no other's.
TEST(Arrows, judges_are_known_by_their_records)
{
    std::set<std::string> judges;
    for (const fs::path& file : files_below("grader/judge"))
        if (file.filename() == "record.cpp") judges.insert(file.parent_path().filename());
    EXPECT_GE(judges.size(), 9U);
    const std::set<std::string> allowed{
        "grader/unit/pictures.cpp judge/image/rule.hpp",         // what is drawn is compared as a colour picture
        "grader/report/triptych.hpp judge/image/rule.hpp",       // the same
        "grader/bench/judges/results.cpp judge/image/rule.hpp",  // measures that judge
        "grader/cli/compare.cpp judge/image/rule.hpp",           // compares two files of pictures
        "grader/worker/weigh_cost.cpp judge/cost/cost.hpp",      // weighs counts against processor time
        "grader/worker/weigh_cost.cpp judge/cost/outside_cost.hpp",
        "grader/worker/weigh_cost.cpp judge/cost/answers.hpp",
        "grader/judge/noise/noise.cpp judge/events/events.hpp",  // names of quantities are written like names of events
    };
    for (const Include& include : includes_below("grader")) {
        const fs::path target(include.target);
        if (part(target, 0) != "judge" || !judges.contains(part(target, 1))) continue;
        const std::string file = include.line.file;
        if (file.find("grader/judge/" + part(target, 1) + "/") != std::string::npos) continue;
        const std::string used = file.substr(file.find("grader/")) + " " + include.target;
        EXPECT_TRUE(allowed.contains(used)) << used;
    }
}

TEST(Arrows, the_grader_knows_no_answers)
{
    for (const Include& include : includes_below("grader")) {
        for (const char* const forbidden : {"reference/", "exercises/", "../"})
            EXPECT_EQ(include.target.find(forbidden), std::string::npos) << include.line.where();
        // Of the framework only what describes a run, and in programs that run students' code what they link.
        if (!include.target.starts_with("umbral/")) continue;
        const std::string layer = part(include.target, 1);
        EXPECT_TRUE(layer == "core" || layer == "record" || layer == "gl") << include.line.where();
    }
}

/// Of each topic, the other topics whose units some unit of it uses.
Layers used_topics()
{
    Layers used;
    const std::regex uses(R"re("uses": \[([^\]]*)\])re");
    const std::regex topic(R"re("([a-z]+)/)re");
    for (const fs::path& file : files_below("exercises")) {
        if (file.filename() != "exercise.json") continue;
        const std::string own = file.parent_path().parent_path().filename().string();
        std::string manifest;
        for (const Line& line : lines_of(file)) manifest += line.text;
        std::smatch list;
        if (!std::regex_search(manifest, list, uses)) continue;
        const std::string units = list[1];
        for (std::sregex_iterator unit(units.begin(), units.end(), topic); unit != std::sregex_iterator(); ++unit)
            if ((*unit)[1] != own) used[own].insert((*unit)[1]);
    }
    return used;
}

TEST(Arrows, of_topics_run_one_way)
{
    const Layers used = used_topics();
    EXPECT_FALSE(used.empty());
    for (const auto& [topic, others] : used)
        for (const std::string& other : others) {
            const auto back = used.find(other);
            EXPECT_TRUE(back == used.end() || !back->second.contains(topic)) << topic << " and " << other;
        }
}

TEST(Arrows, of_the_framework)
{
    const std::set<std::string> below_topics = {"core", "gl", "input", "record"};
    const Layers may_include = {{"core", {}}, {"gl", {"core", "record"}}, {"input", {"core"}}, {"record", {"core"}}};
    // What units of several topics are about.
    const std::set<std::string> plain_data = {"umbral/lighting/light.hpp"};
    const Layers used = used_topics();
    std::size_t seen = 0;
    for (const Include& include : includes_below("framework/umbral")) {
        if (!include.target.starts_with("umbral/")) {
            EXPECT_TRUE(include.system || include.target.find('/') == std::string::npos) << include.line.where();
            continue;
        }
        const std::string layer = part(include.line.file, 2);
        const std::string target = part(include.target, 1);
        ++seen;
        // What every student's file sees: interfaces and what they need.
        if (layer == "student.hpp" || layer == target) continue;
        const bool is_topic = !below_topics.contains(layer);
        // Topics are data and interfaces of their own: they meet in the reference, and where a unit uses others.
        const auto others = used.find(layer);
        const bool is_used = others != used.end() && others->second.contains(target);
        EXPECT_TRUE(is_topic ? below_topics.contains(target) || is_used || plain_data.contains(include.target)
                             : may_include.at(layer).contains(target))
            << include.line.where();
    }
    EXPECT_GT(seen, 20U);
    for (const std::string& header : plain_data)
        for (const Line& line : lines_of("framework/" + header))
            EXPECT_EQ(line.text.find("[[nodiscard]]"), std::string::npos) << line.where() << ": that is no data";
}

// What the grader and the engine's programs share knows neither of them, nor the framework.
TEST(Arrows, of_what_is_shared)
{
    std::size_t seen = 0;
    for (const Include& include : includes_below("framework/shared")) {
        ++seen;
        EXPECT_EQ(part(include.target, 0) == "text", !include.system) << include.line.where();
        EXPECT_FALSE(include.target.starts_with("umbral/")) << include.line.where();
    }
    EXPECT_GT(seen, 10U);
    for (const char* const folder : {"framework/umbral", "exercises"})
        for (const Include& include : includes_below(folder))
            EXPECT_NE(part(include.target, 0), "text") << include.line.where();
}

TEST(Arrows, nobody_below_includes_reference_exercises_or_grader)
{
    for (const char* const folder : {"framework", "reference"}) {
        for (const Include& include : includes_below(folder))
            for (const char* const forbidden :
                 {"grader/", "exercises/", "model/", "run/", "build/", "worker/", "unit/", "reference/"})
                EXPECT_FALSE(include.target.starts_with(forbidden)) << include.line.where();
    }
}

// Stubs, mistakes and alternatives are students' files: the framework is all they see. Drivers may share a topic's
// files.
TEST(Arrows, of_the_exercises)
{
    std::size_t seen = 0;
    for (const Include& include : includes_below("exercises")) {
        ++seen;
        for (const char* const forbidden : {"grader/", "reference/", "model/", "run/", "worker/", "unit/"})
            EXPECT_EQ(include.target.find(forbidden), std::string::npos) << include.line.where();
        const bool shared = part(include.line.file, 2).ends_with(".hpp") ||
                            fs::path(include.line.file).filename() == "driver.cpp" ||
                            fs::path(include.line.file).extension() == ".hpp";
        EXPECT_TRUE(shared || include.system) << include.line.where();
    }
    EXPECT_GT(seen, 10U);
}

// A topic's drivers have its own files and the kit; the kit has the framework below the topics.
TEST(Arrows, exercises_share_the_kit_and_nothing_else)
{
    std::set<std::string> layers;
    for (const fs::path& file : files_below("exercises")) layers.insert(part(file, 1));
    ASSERT_TRUE(layers.contains("kit"));
    std::size_t seen = 0;
    for (const Include& include : includes_below("exercises")) {
        const fs::path file(include.line.file);
        const std::string layer = part(file, 1);
        const fs::path near = (file.parent_path() / include.target).lexically_normal();
        if (!include.system) {
            EXPECT_EQ(part(near, 0) + "/" + part(near, 1), "exercises/" + layer) << include.line.where();
        } else if (layers.contains(part(include.target, 0))) {
            ++seen;
            EXPECT_EQ(part(include.target, 0), "kit") << include.line.where();
        } else if (layer == "kit" && include.target.starts_with("umbral/")) {
            const std::string below = part(include.target, 1);
            EXPECT_TRUE(below == "core" || below == "gl" || below == "input" || below == "record")
                << include.line.where();
        }
    }
    EXPECT_GT(seen, 30U);
}

}
}
