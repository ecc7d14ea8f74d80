#include <gtest/gtest.h>

#include "explain/asked_alone.hpp"
#include "explain/asked_sample.hpp"
#include "explain/other_questions.hpp"
#include "question/names.hpp"
#include "report/hidden.hpp"
#include "report/html/pages.hpp"
#include "spoilt_reference.hpp"
#include "worker/interface_text.hpp"

// What is said of bugs that are in no list of mistakes.
namespace umbral::grader::test {
namespace {

class Questions : public SpoiltReference {};

class QuestionsOfPhong : public SpoiltReference {
protected:
    QuestionsOfPhong() : SpoiltReference("lighting/phong") {}
};

class QuestionsOfPictures : public SpoiltReference {
protected:
    QuestionsOfPictures() : SpoiltReference("pipeline/draw-deferred") {}
};

class QuestionsOfLists : public SpoiltReference {
protected:
    QuestionsOfLists() : SpoiltReference("meshes/vertex-normals") {}
};

class QuestionsOfPolygons : public SpoiltReference {
protected:
    QuestionsOfPolygons() : SpoiltReference("pipeline/clip-polygon") {}
};

class QuestionsOfGrids : public SpoiltReference {
protected:
    QuestionsOfGrids() : SpoiltReference("meshes/grid-and-sphere") {}
};

class QuestionsOfAngles : public SpoiltReference {
protected:
    QuestionsOfAngles() : SpoiltReference("projections/curved") {}
};

TEST_F(Questions, an_interval_that_begins_at_0_is_told_by_what_it_answers_and_by_nothing_that_other_cases_deny)
{
    const UnitResult result = grade("if (ray.t_min < t &&", "if (0 < t &&");
    const CheckResult& wrong = check(result, "behind and before/t");
    ASSERT_LT(wrong.score, wrong.max_score);
    ASSERT_TRUE(wrong.first_difference);
    EXPECT_TRUE(wrong.first_difference->question.starts_with("intersect(Ray{{")) << wrong.first_difference->question;
    // Here only lines without an end are wrong, so "t_min is not 0 and t_max is not finite" parts them; in other cases
    // those with an end are wrong as well. That nothing is wrong where t_min is 0 all cases say.
    EXPECT_EQ(wrong.common, "wrong only where ray.t_min is not 0 (150 of 200), right everywhere else (300 of 300)");
    ASSERT_TRUE(wrong.simplest);
    EXPECT_LT(wrong.simplest->question.size(), wrong.first_difference->question.size());
    ASSERT_FALSE(result.explanations.empty());
    EXPECT_EQ(result.explanations.front().name, "question: ray.t_min taken as 0");
}

TEST_F(Questions, an_origin_inside_that_finds_nothing_is_told_in_words_of_lengths)
{
    const UnitResult result = grade(
        "const float q = b", "if (length(to_origin) < sphere.radius) return std::nullopt;\n    const float q = b");
    const std::string& common = check(result, "inside/t").common;
    // All rays of that case begin inside: those that are cut short find nothing, and rightly so.
    EXPECT_EQ(common, "nothing is found wherever something is to be found (201 of 201)");
}

// Two headers of the topic declare a draw_triangles.
TEST(InterfaceText, has_the_parameters_of_the_unit_s_own_functions_first)
{
    const Workbench bench;
    const Worker worker(bench.tools());
    const auto first_parameter = [&](const char* unit) {
        return parameter_names(interface_text(worker, bench.exercise(unit)), "draw_triangles").at(0);
    };
    EXPECT_EQ(first_parameter("pipeline/software-pipeline"), "state");
    EXPECT_EQ(first_parameter("pipeline/draw-immediate"), "positions");
}

TEST_F(Questions, what_is_wrong_by_chance_has_nothing_in_common)
{
    const UnitResult result = grade("return first_inside(ray,", R"(
    const unsigned bits = glm::floatBitsToUint(ray.origin.x);
    const unsigned hash = (bits ^ (bits >> 13U)) * 2654435761U;
    if (hash >> 31U) return static_cast<float>(hash % 10000U);
    return first_inside(ray,)");
    const CheckResult& wrong = check(result, "random/t");
    ASSERT_LT(wrong.score, wrong.max_score);
    for (const CheckResult& one : result.checks) EXPECT_EQ(one.common, "") << one.name;
    for (const Explanation& one : result.explanations) EXPECT_FALSE(one.name.starts_with("question: ")) << one.name;
}

TEST_F(Questions, of_hidden_checks_reach_instructors_only)
{
    const UnitResult result = grade("return t;", "return 1.001F * t;");
    const CheckResult& hidden = check(result, "random/t");
    ASSERT_TRUE(hidden.hidden);
    ASSERT_LT(hidden.score, hidden.max_score);
    EXPECT_TRUE(hidden.first_difference && !hidden.first_difference->question.empty());
    EXPECT_TRUE(hidden.common.empty() && !hidden.simplest);
    SubmissionResult submission;
    submission.units.push_back(result);
    const SubmissionResult shown = without_hidden_values(submission);
    EXPECT_FALSE(check(shown.units.front(), "random/t").first_difference);
}

// What students are told of a hidden check is seen on inputs that are no secret: whatever that is, they are the same.
TEST_F(Questions, of_practice_inputs_tell_students_where_a_hidden_check_goes_wrong)
{
    const std::string from = "return t;";
    const std::string to = "return ray.direction.x < 0 ? 1.001F * t : t;";
    const UnitResult result = grade(from, to);
    const std::string told = check(result, "random/t").practice;
    EXPECT_TRUE(told.starts_with("wrong wherever something is to be found and ray.direction.x is negative (")) << told;
    EXPECT_NE(told.find("every wrong answer is 1.001 times the right one"), std::string::npos) << told;
    GradeOptions options;
    options.seeds.secret = "another";
    const UnitResult other = grade(from, to, options);
    EXPECT_EQ(check(other, "random/t").practice, told);
    const auto& example = check(result, "random/t").practice_example;
    ASSERT_TRUE(example);
    EXPECT_TRUE(example->question.starts_with("intersect(Ray{{")) << example->question;
    EXPECT_NE(example->yours, example->expected);
    EXPECT_FALSE(example->cell);
    EXPECT_EQ(check(other, "random/t").practice_example->question, example->question);
    EXPECT_NE(check(result, "random/t").first_difference->question, example->question);
    const SubmissionResult shown = without_hidden_values({"ada", 0, 0, {other}, {}});
    EXPECT_EQ(check(shown.units.front(), "random/t").practice, told);
    EXPECT_TRUE(check(shown.units.front(), "random/t").practice_example);
}

TEST_F(QuestionsOfPictures, hidden_ones_are_shown_as_they_are_drawn_on_practice_inputs)
{
    const auto drawn = [&](const char* secret) {
        GradeOptions options;
        options.seeds.secret = secret;
        options.artefacts = bench.folder() / secret;
        options.relative_to = bench.folder();
        const UnitResult result = grade("index_count_, GL_UNSIGNED_INT", "index_count_ - 3, GL_UNSIGNED_INT", options);
        const CheckResult& hidden = check(result, "random/picture 1");
        EXPECT_LT(hidden.score, hidden.max_score);
        EXPECT_FALSE(hidden.artefacts.contains("triptych"));
        const SubmissionResult shown = without_hidden_values({"ada", 0, 0, {result}, {}});
        return read_text(bench.folder() /
                         check(shown.units.front(), "random/picture 1").artefacts.at(practice_picture));
    };
    const std::string picture = drawn("one secret");
    EXPECT_GT(picture.size(), 1000);
    EXPECT_EQ(picture, drawn("another"));
}

TEST_F(QuestionsOfPictures, students_see_a_hidden_picture_only_as_it_is_drawn_on_practice_inputs)
{
    const Built built = build_spoilt("index_count_, GL_UNSIGNED_INT", "index_count_ - 3, GL_UNSIGNED_INT");
    GradeOptions options;
    options.show_hidden = true;
    const GradedUnit graded = grade_with_evidence(worker, exercise, {built.files, {}, ""}, options);
    const auto page = [&](html::Edition edition) { return html::section_html(graded.result, graded.detail, edition); };
    const std::string told = "On practice inputs</h4>";
    EXPECT_NE(page(html::Edition::student).find(told), std::string::npos);
    EXPECT_EQ(page(html::Edition::instructor).find(told), std::string::npos);
}

TEST_F(Questions, two_known_mistakes_at_once_are_both_told)
{
    const std::filesystem::path file = exercise.folder / "alternatives" / "double_precision.cpp";
    Sources sources{{exercise.files.front(), read_text(file)}};
    const auto replace = [&](const std::string& from, const std::string& to) {
        std::string& text = sources.begin()->second;
        ASSERT_NE(text.find(from), std::string::npos) << from;
        text.replace(text.find(from), from.size(), to);
    };
    replace("t < ray.t_max", "t <= ray.t_max");
    replace("(discriminant < 0)", "(discriminant <= 0)");
    const UnitResult result = grade_unit(worker, exercise, {sources, {}, ""}, {});
    ASSERT_FALSE(result.explanations.empty());
    EXPECT_EQ(result.explanations.front().name, "mistakes: counts_t_max and drops_tangent");
}

TEST_F(Questions, what_an_earlier_call_left_behind_is_told)
{
    const UnitResult result =
        grade("const float a = dot(", "static int calls = 0; if (++calls > 1) return 1.0F;\n    const float a = dot(");
    const auto wrong = std::ranges::find_if(result.checks, [](const CheckResult& one) {
        return !one.hidden && one.first_difference && !one.first_difference->question.empty();
    });
    ASSERT_NE(wrong, result.checks.end());
    EXPECT_EQ(wrong->common, right_alone);
    EXPECT_FALSE(wrong->simplest);
}

// A list that nobody was asked for has no rows: those of the one that is asked stand elsewhere then.
TEST_F(QuestionsOfLists, what_an_earlier_call_left_in_a_list_is_told)
{
    const UnitResult result = grade("std::vector<glm::dvec3> sums(mesh.positions.size(), glm::dvec3(0));",
                                    "static std::vector<glm::dvec3> sums; sums.resize(mesh.positions.size());");
    const CheckResult& wrong = check(result, "known/vertices");
    ASSERT_TRUE(wrong.first_difference && wrong.first_difference->cell);
    EXPECT_GT(*wrong.first_difference->cell, 0U);
    EXPECT_EQ(wrong.common, right_alone);
}

TEST_F(QuestionsOfLists, what_is_wrong_of_itself_is_not_laid_on_earlier_calls)
{
    const UnitResult result = grade("size < cancelled", "size < 1e-3");
    const CheckResult& wrong = check(result, "sharp folds/vertices");
    ASSERT_TRUE(wrong.first_difference);
    EXPECT_NE(wrong.common, right_alone);
}

// Corners where none is expected are no row of the expected ones, and still somebody asked for them.
TEST_F(QuestionsOfPolygons, what_came_too_often_has_a_question)
{
    const UnitResult result = grade("if (result.size() < 3) result.clear();", "");
    const CheckResult& wrong = check(result, "borders/corners");
    ASSERT_TRUE(wrong.first_difference);
    EXPECT_EQ(wrong.first_difference->expected, "no corner");
    EXPECT_EQ(wrong.first_difference->question.find("clip_polygon("), 0U) << wrong.first_difference->question;
}

// Four grids of 63 corners: that all with one column are right, and others are wrong, is chance.
TEST_F(QuestionsOfGrids, many_answers_to_few_questions_tell_no_more_than_the_questions)
{
    const UnitResult result =
        grade("double(column) / columns", "double(column) / columns * (columns > rows ? 1.01 : 1.0)");
    const CheckResult& wrong = check(result, "grid/positions");
    ASSERT_LT(wrong.score, wrong.max_score);
    EXPECT_EQ(wrong.common, "every wrong answer differs in x only, which is 1.01 times the right one");
}

TEST_F(QuestionsOfGrids, a_question_is_wrong_if_one_of_its_answers_is)
{
    const Check& fine = *std::ranges::find_if(
        exercise.checks, [](const Check& one) { return one.case_name == "fine" && one.value == "grid"; });
    const Built built = build_spoilt("double(row) / rows", "double(row) / (rows > columns ? rows + row : rows)");
    CaseResult one;
    one.seed = 1;
    one.student = worker.run(exercise, built, fine.case_name, one.seed);
    CaseRuns runs(worker, exercise, built, fine.case_name, one);
    const std::string headers = interface_text(worker, exercise);
    const AskedCheck asked{exercise, fine, runs, one, worker.questions(exercise, fine.case_name, one.seed), headers};
    const AskedSample sample = asked_sample(worker, asked, one.seed);
    EXPECT_EQ(sample.by_question.names, (std::vector<std::string>{"columns", "rows", "there being a right answer"}));
    // Grids of one row, and of one column, in turn.
    ASSERT_EQ(sample.by_question.numbers.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(sample.by_question.numbers[i][i % 2 == 0 ? 1 : 0], 1);
    EXPECT_EQ(sample.by_question.wrong, (std::vector<bool>{false, true, false, true}));
    EXPECT_EQ(sample.by_answer.wrong.size(), 800U);
    EXPECT_EQ(sample.by_answer.names.size(), 5U)
        << "the right answer's, whether there is one, and its place among those of the call";
    EXPECT_EQ(sample.by_answer.numbers.front().front(), 1) << "the first";
    EXPECT_EQ(sample.by_answer.numbers.back().front(), 2) << "the last";
}

// One question that is written down in the driver is one example, however often it is asked.
TEST_F(QuestionsOfAngles, a_single_question_that_always_comes_proves_nothing)
{
    const UnitResult result =
        grade("{ return static_cast<float>(angle_between(a, b)); }",
              "{ return a == glm::vec3(0) && b != a ? 3.0F : static_cast<float>(angle_between(a, b)); }");
    const CheckResult& wrong = check(result, "known angles/angle");
    ASSERT_LT(wrong.score, wrong.max_score);
    EXPECT_EQ(wrong.common, "");
}

TEST_F(Questions, right_work_is_asked_nothing)
{
    const UnitResult result =
        grade_unit(worker, exercise, {reference_sources(bench.tools().reference, exercise), {}, ""}, {});
    for (const CheckResult& one : result.checks)
        EXPECT_TRUE(one.common.empty() && !one.simplest && !one.first_difference) << one.name;
}

// Its generators, drawing from few bits, draw null normals, of which the oracle makes no number.
TEST_F(QuestionsOfPhong, inputs_without_a_right_answer_are_no_fault_of_the_grader)
{
    const UnitResult result = grade("std::pow(std::clamp(cosine, 0.0, 1.0), double{e})",
                                    "std::pow(std::clamp(static_cast<float>(cosine), 0.0F, 1.0F), e)");
    EXPECT_EQ(result.verdict, Verdict::partial) << result.message;
    EXPECT_EQ(result.message, "");
    EXPECT_LT(check(result, "sharp/highlight").score, check(result, "sharp/highlight").max_score);
}

}
}
