#include <glm/gtc/matrix_transform.hpp>

#include "explaining.hpp"

namespace umbral::grader::test {
namespace {

using Change = glm::dmat4 (*)(const glm::dmat4&);

glm::dmat4 view(Random& random)
{
    return glm::lookAt(glm::dvec3(random.in_cube()) * 5.0 + glm::dvec3(7, 1, 0), glm::dvec3(random.in_cube()),
                       glm::dvec3(0, 1, 0));
}

Tensor matrices(Change change)
{
    Random random(31);
    std::vector<float> values;
    for (int i = 0; i < 12; ++i) {
        const glm::dmat4 m = change(view(random));
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r) values.push_back(static_cast<float>(m[c][r]));
    }
    return floats(values, 16);
}

const Check check = check_of(JudgeKind{"matrices"}, relative(1e-6));
const Change unchanged = [](const glm::dmat4& m) { return m; };

glm::dmat4 with_translation(glm::dmat4 m, glm::dvec3 t)
{
    m[3] = glm::dvec4(t, 1);
    return m;
}
glm::dvec3 eye(const glm::dmat4& m) { return -glm::transpose(glm::dmat3(m)) * glm::dvec3(m[3]); }

TEST(ExplainMatrices, one_error_one_explanation)
{
    const std::vector<std::pair<std::string, Change>> errors = {
        {"transposed", [](const glm::dmat4& m) { return glm::transpose(m); }},
        {"inverse", [](const glm::dmat4& m) { return glm::inverse(m); }},
        {"negated", [](const glm::dmat4& m) { return -m; }},
        {"scaled", [](const glm::dmat4& m) { return 3.0 * m; }},
        {"rotation transposed",
         [](const glm::dmat4& m) {
             return with_translation(glm::dmat4(glm::transpose(glm::dmat3(m))), glm::dvec3(m[3]));
         }},
        {"translation missing", [](const glm::dmat4& m) { return with_translation(m, glm::dvec3(0)); }},
        {"translation negated", [](const glm::dmat4& m) { return with_translation(m, -glm::dvec3(m[3])); }},
        {"translation not rotated", [](const glm::dmat4& m) { return with_translation(m, -eye(m)); }},
        {"translation not rotated", [](const glm::dmat4& m) { return with_translation(m, eye(m)); }},
        {"homogeneous row",
         [](const glm::dmat4& m) {
             glm::dmat4 wrong = m;
             wrong[3][3] = 0;
             return wrong;
         }},
        {"axis flipped",
         [](const glm::dmat4& m) {
             glm::dmat4 wrong = m;
             for (int c = 0; c < 4; ++c) wrong[c][2] = -wrong[c][2];
             return wrong;
         }},
        {"axis flipped",
         [](const glm::dmat4& m) {
             glm::dmat4 wrong = m;
             wrong[0] = -wrong[0];
             return wrong;
         }},
    };
    const Tensor right = matrices(unchanged);
    for (const auto& [name, change] : errors) EXPECT_EQ(first(check, matrices(change), right), name);
}

glm::dmat4 stretched(const glm::dmat4& m) { return glm::scale(glm::dmat4(1), glm::dvec3(2, 3, 4)) * m; }

glm::dmat4 with_bare_place(const glm::dmat4& m)
{
    const glm::dmat4 right = stretched(m);
    return with_translation(right, inverse(glm::dmat3(right)) * glm::dvec3(right[3]));
}

// Only a matrix that turns may be a camera's.
TEST(ExplainMatrices, a_place_that_the_rest_is_not_applied_to_is_told)
{
    const auto of_others = explain(check, matrices(with_bare_place), matrices(stretched));
    ASSERT_FALSE(of_others.empty());
    EXPECT_EQ(of_others.front().name, "translation not rotated");
    EXPECT_NE(of_others.front().sentence.find("A * p"), std::string::npos) << of_others.front().sentence;
    const auto of_cameras =
        explain(check, matrices([](const glm::dmat4& m) { return with_translation(m, -eye(m)); }), matrices(unchanged));
    ASSERT_FALSE(of_cameras.empty());
    EXPECT_NE(of_cameras.front().sentence.find("-R * eye"), std::string::npos) << of_cameras.front().sentence;
}

TEST(ExplainMatrices, the_flipped_axis_is_told)
{
    const Tensor wrong = matrices([](const glm::dmat4& m) {
        glm::dmat4 result = m;
        for (int c = 0; c < 4; ++c) result[c][2] = -result[c][2];
        return result;
    });
    const auto found = explain(check, wrong, matrices(unchanged));
    ASSERT_FALSE(found.empty());
    EXPECT_NE(found.front().sentence.find("z axis"), std::string::npos) << found.front().sentence;
}

Tensor rotations(double unit)
{
    Random random(5);
    std::vector<float> values;
    for (int i = 0; i < 10; ++i) {
        const glm::dmat4 m =
            glm::rotate(glm::dmat4(1), unit * random.uniform(0.2F, 2.5F), glm::dvec3(random.unit_vector()));
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r) values.push_back(static_cast<float>(m[c][r]));
    }
    return floats(values, 16);
}

Tensor perspectives(double unit)
{
    Random random(5);
    std::vector<float> values;
    for (int i = 0; i < 10; ++i) {
        const glm::dmat4 m = glm::perspective(unit * random.uniform(0.3F, 2), 1.5, 0.1, 100.0);
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r) values.push_back(static_cast<float>(m[c][r]));
    }
    return floats(values, 16);
}

TEST(ExplainMatrices, angles_in_the_wrong_unit)
{
    const double degree = 0.017453292519943295;
    EXPECT_EQ(first(check, rotations(degree), rotations(1)), "angle in degrees");
    EXPECT_EQ(first(check, rotations(1 / degree), rotations(1)), "angle in degrees");
    EXPECT_EQ(first(check, perspectives(degree), perspectives(1)), "angle in degrees");
    EXPECT_EQ(first(check, rotations(0.5), rotations(1)), "none");
    EXPECT_EQ(first(check, perspectives(0.5), perspectives(1)), "none") << "half the field of view is another mistake";
}

TEST(ExplainMatrices, matrices_of_three)
{
    const std::vector<float> right{1, 2, 3, 0, 4, 5, 1, 0, 6};
    EXPECT_EQ(first(check, floats({1, 0, 1, 2, 4, 0, 3, 5, 6}, 9), floats(right, 9)), "transposed");
    // By hand: determinant 22, adjugate over it.
    const std::vector<float> inverse{24.0F / 22, -12.0F / 22, -2.0F / 22, 5.0F / 22, 3.0F / 22,
                                     -5.0F / 22, -4.0F / 22,  2.0F / 22,  4.0F / 22};
    EXPECT_EQ(first(check, floats(inverse, 9), floats(right, 9)), "inverse");
}

TEST(ExplainMatrices, unrelated_errors_have_no_explanation)
{
    const Tensor right = matrices(unchanged);
    EXPECT_TRUE(explain(check, matrices([](const glm::dmat4&) { return glm::dmat4(1); }), right).empty());
    EXPECT_TRUE(explain(check, matrices([](const glm::dmat4&) { return glm::dmat4(0); }), right).empty());
    EXPECT_TRUE(explain(check, matrices([](const glm::dmat4& m) { return m * m; }), right).empty());
    EXPECT_TRUE(
        explain(check, matrices([](const glm::dmat4& m) { return glm::translate(m, glm::dvec3(1, 2, 3)); }), right)
            .empty());
    EXPECT_TRUE(explain(check, matrices([](const glm::dmat4&) { return glm::dmat4(NAN); }), right).empty());
}

TEST(ExplainMatrices, undoing_may_round)
{
    const Change inverse = [](const glm::dmat4& m) { return glm::inverse(m); };
    EXPECT_EQ(first(check_of(JudgeKind{"matrices"}, ulps(0)), matrices(inverse), matrices(unchanged)), "inverse")
        << "floats do not come back to the bit";
}

TEST(ExplainMatrices, one_stray_matrix_does_not_hide_a_factor)
{
    Tensor student = matrices([](const glm::dmat4& m) { return 3.0 * m; });
    for (std::size_t i = 0; i < 16; ++i) {
        float value = 0;
        std::memcpy(&value, student.bytes.data() + i * sizeof value, sizeof value);
        value *= 7;
        std::memcpy(student.bytes.data() + i * sizeof value, &value, sizeof value);
    }
    EXPECT_EQ(first(check, student, matrices(unchanged)), "scaled");
}

TEST(ExplainNumbers, every_order_of_components_is_tried)
{
    Random random(5);
    std::vector<float> right;
    std::vector<float> turned;
    for (int i = 0; i < 20; ++i) {
        const glm::dvec3 v = random.in_cube();
        right.insert(right.end(), {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
        turned.insert(turned.end(), {static_cast<float>(v.z), static_cast<float>(v.x), static_cast<float>(v.y)});
    }
    const auto found = explain(check_of(JudgeKind{"numbers"}, relative(1e-6)), floats(turned, 3), floats(right, 3));
    ASSERT_FALSE(found.empty());
    EXPECT_NE(found.front().sentence.find("the expected vector is your (y, z, x)"), std::string::npos)
        << found.front().sentence;
}

}
}
