#include "unit/curve.hpp"

#include <gtest/gtest.h>

#include <set>

#include "support/workbench.hpp"
#include "unit/grade_unit.hpp"

// Where right and naive solutions lie on the curve of their unit's knob.
namespace umbral::grader::test {
namespace {

class Curve : public testing::Test {
protected:
    Workbench bench;
    Worker worker{bench.tools()};
    const Exercise sphere = bench.exercise("raytracing/sphere");

    [[nodiscard]] UnitResult graded(const std::string& text)
    {
        return grade_built(worker, sphere, bench.build_sphere(text), {});
    }
};

TEST_F(Curve, the_reference_lies_where_the_reference_lies)
{
    const UnitResult result = graded(project_file("reference/raytracing/sphere.cpp"));
    ASSERT_TRUE(result.curve);
    std::set<std::string> names;
    for (const CurvePoint& one : result.curve->others) {
        names.insert(one.name);
        if (one.name == "reference") {
            EXPECT_EQ(one.error, result.curve->yours.error);
        }
        if (one.name == "oracle") {
            EXPECT_EQ(one.error, 0);
        }
        if (one.name == "double precision") {
            EXPECT_LT(one.error, result.curve->yours.error);
        }
        if (one.name == "school formula") {
            EXPECT_GT(one.error, 10 * result.curve->yours.error);
        }
    }
    EXPECT_EQ(names, (std::set<std::string>{"reference", "oracle", "double precision", "school formula"}));
    EXPECT_EQ(result.score, result.max_score) << "it gives no points";
}

TEST_F(Curve, what_is_mostly_wrong_or_crashes_in_the_timed_case_has_no_place)
{
    EXPECT_FALSE(graded(sphere_with("", "return 1.0F;")).curve);
    EXPECT_FALSE(graded(sphere_with("static int calls = 0;", "if (++calls > 20000) __builtin_trap();")).curve);
}

TEST(ErrorOnCurve, is_missing_where_more_than_half_of_the_rows_have_none)
{
    EXPECT_EQ(error_on_curve({{"rows", 100}, {"p95_error", 2}, {"missing_hits", 50}}), 2);
    EXPECT_FALSE(error_on_curve({{"rows", 100}, {"p95_error", 2}, {"missing_hits", 30}, {"not_finite", 30}}));
    EXPECT_FALSE(error_on_curve({{"rows", 100}}));
}

}
}
