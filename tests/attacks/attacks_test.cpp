#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <set>

#include "attack/rehearsal.hpp"
#include "attack/verdict_table.hpp"
#include "support/temporary_folder.hpp"

// Every attack of tests/attacks, graded beside good work by the real program. Variables of the environment, for longer
// tests: UMBRAL_ATTACKS=all: all attacks in all settings; =here: all attacks in the one setting that CI uses; =alone:
// all of them one by one, against their bounds; =settings: CI's attacks in all settings. UMBRAL_ATTACKS_ONLY="ID ID…":
// these, whatever else is said. UMBRAL_ATTACKS_TABLE=FILE: what came of them, as Markdown.
namespace umbral::grader::attack {
namespace {

namespace fs = std::filesystem;

const fs::path source = UMBRAL_SOURCE;

Target target() { return {UMBRAL_PROGRAM, source / "reference", source / "exercises", source / "tests" / "class", 0}; }

std::string mode()
{
    const char* const chosen = std::getenv("UMBRAL_ATTACKS");
    return chosen == nullptr ? "" : chosen;
}

const std::vector<Attack>& all_attacks()
{
    static const std::vector<Attack> attacks = load_attacks(source / "tests" / "attacks");
    return attacks;
}

std::vector<Setting> settings()
{
    return mode() == "all" || mode() == "settings" ? all_settings() : std::vector<Setting>{{}};
}

/// What runs in a setting: EGL draws nothing for units that do not draw.
std::vector<Attack> attacks_in(const Setting& setting)
{
    std::vector<Attack> chosen;
    const char* const only = std::getenv("UMBRAL_ATTACKS_ONLY");
    const bool all = mode() == "all" || mode() == "here" || mode() == "alone";
    for (const Attack& attack : all_attacks()) {
        if (!attack.draws && setting.gl == "egl") continue;
        if (only != nullptr ? std::string_view(only).find(attack.id()) != std::string_view::npos : attack.ci || all)
            chosen.push_back(attack);
    }
    return chosen;
}

/// The class of a setting, graded when the first test asks for it.
const Rehearsal& rehearsal_in(const Setting& setting)
{
    static std::map<std::string, Rehearsal> graded;
    const std::string name = setting.name();
    if (const auto found = graded.find(name); found != graded.end()) return found->second;
    const umbral::test::TemporaryFolder scratch;
    // nobody's grading lies below.
    fs::permissions(scratch.path(), fs::perms::others_exec | fs::perms::group_exec, fs::perm_options::add);
    graded[name] = rehearse(target(), setting, attacks_in(setting), scratch.path(),
                            [](const std::string& text) { fmt::print(stderr, "{}\n", text); });
    if (const char* const file = std::getenv("UMBRAL_ATTACKS_TABLE"))
        std::ofstream(file) << markdown(all_attacks(), graded);
    return graded.at(name);
}

struct Trial {
    Setting setting;
    Attack attack;
};

void PrintTo(const Trial& trial, std::ostream* stream)
{
    *stream << trial.attack.folder << " (" << trial.setting.name() << ")";
}

std::vector<Trial> trials()
{
    std::vector<Trial> all;
    for (const Setting& setting : settings())
        for (const Attack& attack : attacks_in(setting)) all.push_back({setting, attack});
    return all;
}

std::string name_of(const testing::TestParamInfo<Trial>& info)
{
    std::string name = info.param.attack.id() + "_as_" + info.param.setting.name();
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    return name;
}

class Attacks : public testing::TestWithParam<Trial> {};

TEST_P(Attacks, holds)
{
    const auto& [setting, attack] = GetParam();
    if (const std::string reason = why_not(setting); !reason.empty()) GTEST_SKIP() << reason;
    Outcome outcome;
    if (mode() == "alone") {
        const umbral::test::TemporaryFolder scratch;
        outcome = rehearse_alone(target(), setting, attack, scratch.path());
        fmt::print(stderr, "{}: {}\n", attack.id(), outcome.came);
    } else {
        outcome = rehearsal_in(setting).outcomes.at(attack.id());
    }
    for (const std::string& finding : outcome.findings)
        ADD_FAILURE() << attack.what << "\n[" << attack.area << "] " << finding;
}

INSTANTIATE_TEST_SUITE_P(All, Attacks, testing::ValuesIn(trials()), name_of);

class Class : public testing::TestWithParam<Setting> {};

TEST_P(Class, good_work_keeps_its_results_beside_attackers)
{
    if (const std::string reason = why_not(GetParam()); !reason.empty()) GTEST_SKIP() << reason;
    if (mode() == "alone") GTEST_SKIP() << "attacks are graded one by one";
    const Rehearsal& rehearsal = rehearsal_in(GetParam());
    for (const std::string& change : rehearsal.changes_of_good) ADD_FAILURE() << change;
    fmt::print(stderr, "{}: {:.0f} s, {:.0f} MiB of the grader's memory, {:.1f} MiB of cache, {:.1f} MiB of reports\n",
               GetParam().name(), rehearsal.run.seconds, rehearsal.run.peak_mib, rehearsal.cache_mib,
               rehearsal.reports_mib);
    EXPECT_LT(rehearsal.run.peak_mib, 1024);
    EXPECT_FALSE(fs::exists("/tmp/umbral-planted"));
}

INSTANTIATE_TEST_SUITE_P(All, Class, testing::ValuesIn(settings()), [](const auto& one) {
    std::string name = one.param.name();
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    return name;
});

TEST(Collection, is_large_and_a_third_of_it_runs_in_every_test)
{
    const auto in_ci = static_cast<std::size_t>(std::ranges::count_if(all_attacks(), &Attack::ci));
    EXPECT_GE(all_attacks().size(), 120U);
    EXPECT_GE(3 * in_ci + 30, all_attacks().size());
    EXPECT_LT(2 * in_ci, all_attacks().size());
    std::set<std::string> sentences;
    for (const Attack& attack : all_attacks())
        EXPECT_TRUE(sentences.insert(attack.what).second) << attack.folder << ": another one says the same";
}

}
}
