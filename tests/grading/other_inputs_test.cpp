#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "support/workbench.hpp"
#include "unit/grade_unit.hpp"
#include "unit/right_questions.hpp"
#include "worker/known_solutions.hpp"

// Answers that are written down for the inputs that everybody has earn nothing; work that is what it seems loses
// nothing.
namespace umbral::grader::test {
namespace {

/// Right for its first four questions; from then on only if it has met these four before.
constexpr const char* knows_its_case = R"(
#include <bit>
#include <cstdio>
#include <initializer_list>
namespace {
bool is_known(unsigned number)
{
    for (const unsigned one : std::initializer_list<unsigned>{@KNOWN@})
        if (one == number) return true;
    return false;
}
bool answers(const umbral::Ray& ray, const umbral::raytracing::Sphere& ball)
{
    static int calls = 0;
    static unsigned met = 0;
    static bool known = true;
    if (++calls <= 4)
        for (const float number : {ray.origin.x, ray.origin.y, ray.direction.x, ray.direction.z, ball.radius})
            met = std::rotr(31 * met + std::bit_cast<unsigned>(number), 11);  // small integers end with zeros
    if (calls == 4 && @TELLS@) std::printf("case %u\n", met);
    if (calls == 4) known = @TELLS@ || is_known(met);
    return known;
}
}
)";

/// What is no bug of the usual kind: of all rays but one in so many, by their numbers.
constexpr const char* all_but_one = R"(
bool is_among_all_but_one(unsigned in, const umbral::Ray& ray)
{
    unsigned bits = 0;
    for (const float number : {ray.origin.x, ray.origin.y, ray.direction.x})
        bits = (bits ^ std::bit_cast<unsigned>(number)) * 2654435761U;
    return (bits >> 8U) % in != 0;
}
)";

class OtherInputs : public testing::Test {
protected:
    /// `unless`: a condition under which it answers rightly for inputs it does not know.
    [[nodiscard]] Sources sphere(const std::string& known, bool tells, const std::string& unless = "false") const
    {
        std::string before = knows_its_case;
        before.replace(before.find("@KNOWN@"), 7, known);
        for (int i = 0; i < 2; ++i) before.replace(before.find("@TELLS@"), 7, tells ? "true" : "false");
        before += all_but_one;
        return {{"sphere.cpp",
                 sphere_with(before, "    if (!answers(ray, sphere) && !(" + unless + ")) return 0.125F;\n")}};
    }
    UnitResult grade(const Sources& sources, bool other_inputs)
    {
        GradeOptions options;
        options.seeds.secret = "a secret of the test's";
        options.seeds.work = "one work for all, which then meet the same inputs";
        options.explain = false;
        options.other_inputs = other_inputs;
        return grade_unit(worker, exercise, {sources, {}, ""}, options);
    }
    /// The numbers that the visible cases begin with: what everybody can find out at a desk.
    [[nodiscard]] std::string told_by_visible_cases()
    {
        std::istringstream printed(grade(sphere("", true), false).output);
        std::set<unsigned> numbers;
        std::string known;
        unsigned number = 0;
        for (std::string word; printed >> word >> number;)
            if (numbers.insert(number).second) known += fmt::format("{}{}U", known.empty() ? "" : ", ", number);
        return known;
    }

    Workbench bench;
    Exercise exercise = bench.exercise("raytracing/sphere");
    Worker worker{bench.tools()};
};

TEST_F(OtherInputs, answers_for_known_inputs_alone_earn_nothing)
{
    const std::string known = told_by_visible_cases();
    ASSERT_GT(known.size(), 40U) << known;
    const UnitResult plain = grade(sphere(known, false), false);
    // It counts the questions, which cases beside themselves notice.
    EXPECT_GT(plain.score, exercise.points / 2) << "this is what it is about: " << plain.message;
    const UnitResult result = grade(sphere(known, false), true);
    for (const CheckResult& check : result.checks)
        EXPECT_LT(check.score, check.max_score / 3) << check.name << ": " << check.message;
    const auto inside = std::ranges::find(result.checks, "inside/t", &CheckResult::name);
    EXPECT_NE(inside->message.find("not with others"), std::string::npos) << inside->message;
}

TEST_F(OtherInputs, half_a_solution_and_answers_for_known_inputs_earn_what_the_half_does)
{
    const std::string known = told_by_visible_cases();
    const Sources cheat = sphere(known, false, "is_among_all_but_one(3, ray)");
    const Sources honest = sphere("", false, "is_among_all_but_one(3, ray)");
    const UnitResult half = grade(honest, false);
    const UnitResult result = grade(cheat, true);
    EXPECT_GT(grade(cheat, false).score, half.score + exercise.points / 5) << "this is what it is about";
    // Inputs that never change, of head-on rays and of the picture, hold a fifth of the unit's points.
    EXPECT_LT(result.score, half.score + exercise.points / 5);
    for (std::size_t i = 0; i < result.checks.size(); ++i) {
        const CheckResult& check = result.checks[i];
        if (check.name == "head-on/t" || check.name.starts_with("picture")) continue;
        EXPECT_LT(check.score, half.checks[i].score + check.max_score / 5) << check.name << ": " << check.message;
    }
    EXPECT_EQ(grade(honest, true).score, half.score) << "who answers two of three questions is no cheat";
}

// Of few questions chance alone can take as many: who had them all right is asked what others come to.
TEST_F(OtherInputs, most_of_a_solution_and_answers_for_known_inputs_earn_what_the_most_does)
{
    const std::string known = told_by_visible_cases();
    const std::string most = "is_among_all_but_one(8, ray)";
    const UnitResult plain = grade(sphere(known, false, most), false);
    const UnitResult cheat = grade(sphere(known, false, most), true);
    const UnitResult honest = grade(sphere("", false, most), true);
    int known_checks = 0;
    for (std::size_t i = 0; i < cheat.checks.size(); ++i) {
        const CheckResult& check = cheat.checks[i];
        if (check.hidden || check.name == "head-on/t" || check.name.starts_with("picture")) continue;
        if (plain.checks[i].score < check.max_score && !plain.checks[i].beside) continue;
        ++known_checks;
        EXPECT_LT(check.score, honest.checks[i].score + check.max_score / 4) << check.name;
    }
    EXPECT_GE(known_checks, 5) << "this is what it is about";
}

TEST(BeyondChance, is_five_standard_deviations_of_two_proportions)
{
    // 30 and 60 of 100: the share is 0.45, its deviation 0.07036 for the difference, 0.3 is 4.26 of them.
    EXPECT_FALSE(is_beyond_chance({60, 100}, {30, 100}));
    EXPECT_TRUE(is_beyond_chance({120, 200}, {60, 200})) << "6.03 of them";
    EXPECT_FALSE(is_beyond_chance({60, 200}, {120, 200})) << "more right than before";
    EXPECT_FALSE(is_beyond_chance({1, 1}, {0, 1}));
    EXPECT_FALSE(is_beyond_chance({100, 100}, {100, 100}));
    EXPECT_FALSE(is_beyond_chance({0, 0}, {0, 10}));
    EXPECT_TRUE(is_beyond_chance({100, 100}, {65, 100}));
}

TEST_F(OtherInputs, cost_no_other_work_anything)
{
    std::vector<Sources> works{reference_sources(bench.tools().reference, exercise), stub_sources(exercise)};
    for (const KnownSolution& mistake : mistakes_of(bench.tools().reference, exercise))
        works.push_back(mistake.sources);
    for (const Sources& sources : works) {
        const UnitResult without = grade(sources, false);
        const UnitResult with = grade(sources, true);
        EXPECT_EQ(with.score, without.score) << sources.begin()->second;
        EXPECT_EQ(to_string(with.verdict), to_string(without.verdict));
    }
}

TEST_F(OtherInputs, follow_from_the_secret)
{
    const SeedPlan one{"secret", "course", "ada", 0, "work"};
    const std::uint64_t seed = one.other_seed_of(exercise, "inside", 0);
    EXPECT_EQ(seed, SeedPlan(one).other_seed_of(exercise, "inside", 0));
    EXPECT_NE(seed, one.other_seed_of(exercise, "inside", 1));
    const SeedPlan another{"another", "course", "ada", 0, "work"};
    EXPECT_NE(seed, another.other_seed_of(exercise, "inside", 0));
    EXPECT_EQ(one.public_seed_of(exercise, "inside"), another.public_seed_of(exercise, "inside"));
    EXPECT_NE(seed, (SeedPlan{"secret", "course", "ada", 1, "work"}.other_seed_of(exercise, "inside", 0)));
    EXPECT_NE(one.public_seed_of(exercise, "inside"), one.seed_of(exercise, "inside"));
}

// Who learned those of one work has hardly learned those of the next.
TEST_F(OtherInputs, are_64_for_a_class_by_student_and_work)
{
    std::set<std::uint64_t> by_student;
    std::set<std::uint64_t> by_work;
    for (int i = 0; i < 2000; ++i) {
        const std::string number = std::to_string(i);
        by_student.insert(SeedPlan{"secret", "course", "s" + number, 0, "w"}.other_seed_of(exercise, "inside", 0));
        by_work.insert(SeedPlan{"secret", "course", "ada", 0, number}.other_seed_of(exercise, "inside", 0));
    }
    EXPECT_EQ(by_student.size(), 64U);
    EXPECT_EQ(by_work, by_student);
}

}
}
