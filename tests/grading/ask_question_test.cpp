#include "worker/ask_question.hpp"

#include <gtest/gtest.h>

#include "support/workbench.hpp"
#include "worker/known_solutions.hpp"

namespace umbral::grader::test {
namespace {

constexpr const char* question = "intersect(Ray{{8, -3, 4}, {-1, 0, 0}, 0, INFINITY}, Sphere{{0, 0, 0}, 13})";

class AskQuestion : public testing::Test {
protected:
    Workbench bench;
    Exercise sphere = bench.exercise("raytracing/sphere");
    Worker worker{bench.tools()};

    AskedQuestion ask(const std::string& text, const std::string& asked = question)
    {
        return ask_question(worker, sphere, bench.build_sphere(text), asked);
    }
    /// Asks another unit, whose reference is the student's work too.
    AskedQuestion ask_reference(const Exercise& exercise, const std::string& asked)
    {
        const Built built = build(bench.tools(), exercise, reference_sources(bench.tools().reference, exercise));
        return ask_question(worker, exercise, built, asked);
    }
    /// The reference with one text in place of another.
    [[nodiscard]] std::string changed(const std::string& from, const std::string& to) const
    {
        std::string text = reference_sources(bench.tools().reference, sphere).begin()->second;
        EXPECT_NE(text.find(from), std::string::npos) << from;
        return text.replace(text.find(from), from.size(), to);
    }
};

TEST_F(AskQuestion, gives_the_answers_of_all_three_solutions)
{
    const AskedQuestion asked = ask(changed("return t;", "return 2.0F * t;"));
    ASSERT_EQ(asked.refused, "");
    ASSERT_TRUE(asked.yours.given && asked.reference.given && asked.oracle);
    EXPECT_EQ(asked.reference.text, asked.oracle->text);
    EXPECT_EQ(asked.reference.text, "20");
    EXPECT_EQ(asked.yours.text, "40");
}

TEST_F(AskQuestion, takes_lines_that_make_what_is_asked_about)
{
    const AskedQuestion asked =
        ask(changed("return t;", "return t;"),
            "const Ray ray{{0, 0, 9}, {0, 0, 1}, 0, INFINITY};\nray.origin + 2.0F * ray.direction");
    ASSERT_EQ(asked.refused, "");
    EXPECT_EQ(asked.yours.text, "glm::vec3{0, 0, 11}");
    EXPECT_EQ(asked.yours.names, (std::vector<std::string>{"x", "y", "z"}));
    EXPECT_EQ(asked.yours.numbers, (std::vector<double>{0, 0, 11}));
}

// A refusal is an answer like any other, and what it says does not count.
TEST_F(AskQuestion, tells_what_is_thrown)
{
    const Exercise frustum = bench.exercise("projections/frustum");
    const Built built = build(bench.tools(), frustum, reference_sources(bench.tools().reference, frustum));
    const AskedQuestion asked = ask_question(worker, frustum, built, "frustum_matrix(ViewVolume{1, 1, -1, 1, 1, 10})");
    EXPECT_EQ(asked.refused, "");
    EXPECT_EQ(asked.reference.text, "throws std::invalid_argument");
    EXPECT_EQ(asked.yours.text, asked.reference.text);
}

// What it holds is told, and not that it is a variant: two of them looked equal whatever they held.
TEST_F(AskQuestion, tells_what_a_variant_holds)
{
    const auto told = [&](const std::string& held) {
        return ask(changed("return t;", "return t;"), "std::variant<int, glm::vec2>(" + held + ")").yours;
    };
    EXPECT_EQ(told("3").text, "3");
    const auto vector = told("glm::vec2(1, 2)");
    EXPECT_EQ(vector.text, "glm::vec2{1, 2}");
    EXPECT_EQ(vector.numbers, (std::vector<double>{1, 2}));
}

TEST_F(AskQuestion, refuses_what_does_not_compile_with_the_compilers_message)
{
    const std::string refused = ask(changed("return t;", "return t;"), "1 +\nintersect(nothing)").refused;
    EXPECT_NE(refused.find("question:2:"), std::string::npos) << refused;
    EXPECT_EQ(refused.find(bench.tools().cache.string()), std::string::npos) << refused;
    EXPECT_NE(ask(changed("return t;", "return t;"), "({ __asm__(\"nop\"); 1; })").refused, "");
}

TEST_F(AskQuestion, tells_how_a_run_ended_that_gave_no_answer)
{
    const AskedQuestion asked = ask(changed("return t;", "__builtin_trap();"));
    EXPECT_FALSE(asked.yours.given);
    EXPECT_NE(asked.yours.text, "");
    EXPECT_TRUE(asked.reference.given);
}

TEST_F(AskQuestion, is_for_functions_that_need_nothing_else)
{
    EXPECT_EQ(not_askable(sphere), "");
    // One of its functions returns a shader: the reference's is no answer to show.
    for (const char* const unit : {"lighting/shaders", "texturing/generation"})
        EXPECT_NE(not_askable(bench.exercise(unit)), "") << unit;
}

// Its pictures are drawn by OpenGL, and its functions are not.
TEST_F(AskQuestion, is_for_functions_of_units_with_pictures)
{
    const Exercise frustum = bench.exercise("projections/fit-frustum");
    ASSERT_TRUE(frustum.gl);
    const AskedQuestion asked = ask_reference(frustum, "fit_sphere(1, 4, PictureSize{200, 100})");
    EXPECT_TRUE(asked.reference.given) << asked.refused << asked.reference.text;
    EXPECT_TRUE(asked.yours.given) << asked.yours.text;
}

// Nor does every function of a unit with a window look at one.
TEST_F(AskQuestion, is_for_functions_of_units_with_windows)
{
    const Exercise region = bench.exercise("pipeline/visible-region");
    ASSERT_TRUE(region.glfw);
    const AskedQuestion asked = ask_reference(region, "ndc_of(Box{{0, 0, 0}, {4, 2, 1}}, {1, 1, 0})");
    EXPECT_TRUE(asked.reference.given) << asked.refused << asked.reference.text;
    EXPECT_EQ(asked.yours.text, asked.reference.text);
    const AskedQuestion refused =
        ask_reference(bench.exercise("interaction/callbacks"), "(install_callbacks(nullptr), 1)");
    EXPECT_NE(refused.refused.find("answers events"), std::string::npos) << refused.refused << refused.reference.text;
}

// What the student's code calls of other units is the reference's, as it is in the unit's own cases.
TEST_F(AskQuestion, is_for_functions_that_call_other_units)
{
    const AskedQuestion rays = ask_reference(bench.exercise("raytracing/bounding-volumes"), R"(
std::vector<Triangle> triangles{Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, Triangle{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}};
make_triangle_hierarchy(triangles)->first_hit(Ray{{0.25, 0.25, 3}, {0, 0, -1}, 0, INFINITY})->index)");
    EXPECT_EQ(rays.refused, "");
    EXPECT_EQ(rays.reference.text, "1") << rays.yours.text;
    EXPECT_EQ(rays.yours.text, rays.reference.text);
    // With a window as well.
    const AskedQuestion eye =
        ask_reference(bench.exercise("interaction/orbit-camera"), "make_orbit_camera({})->view()");
    EXPECT_TRUE(eye.reference.given) << eye.refused << eye.reference.text;
}

// Of such a unit, a question that gets no answer from the reference draws, as a rule; a loop does not.
TEST_F(AskQuestion, without_an_end_is_said_to_be_one)
{
    Exercise frustum = bench.exercise("projections/fit-frustum");
    frustum.limits.wall_seconds = 1;
    const AskedQuestion asked = ask_reference(frustum, "[] { for (volatile int i = 0; i == 0;) {} }(), 1");
    EXPECT_EQ(asked.refused, "");
    EXPECT_NE(asked.reference.text.find("a loop that never ends"), std::string::npos) << asked.reference.text;
}

}
}
