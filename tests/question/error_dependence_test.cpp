#include "question/error_dependence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <umbral/core/random.hpp>

#include "question/moved_answers.hpp"

namespace umbral::grader::moved_test {
namespace {

const MovedPlace of_top{"f", "0.top"};

TEST(ErrorDependence, a_factor_is_made_of_one_argument_in_a_wrong_way)
{
    const auto found =
        error_dependences(answers([](const Asked& a) { return std::vector{a.left * a.size / std::tan(a.top)}; },
                                  [](const Asked& a) { return std::vector{a.left * a.size / std::tan(a.top / 2)}; }));
    EXPECT_EQ(found, (std::vector<ErrorDependence>{{{0}, ErrorKind::factor, of_top}}));
}

TEST(ErrorDependence, a_term_is_made_of_one_argument_in_a_wrong_way)
{
    const auto found = error_dependences(answers(
        [](const Asked& a) {
            return std::vector{a.left, a.left * a.size + 2 * a.top};
        },
        [](const Asked& a) {
            return std::vector{a.left, a.left * a.size + a.top * a.top};
        }));
    EXPECT_EQ(found, (std::vector<ErrorDependence>{{{1}, ErrorKind::difference, of_top}}));
}

TEST(ErrorDependence, nothing_is_said_where_all_depends_on_one_argument_or_the_error_on_several)
{
    const Answer square = [](const Asked& a) { return std::vector{a.top * a.top}; };
    EXPECT_TRUE(error_dependences(answers([](const Asked& a) { return std::vector{a.top}; }, square)).empty())
        << "the right one, too, depends on top alone";
    const Answer right = [](const Asked& a) { return std::vector{a.left * a.size}; };
    const Answer twice = [](const Asked& a) { return std::vector{2 * a.left * a.size}; };
    EXPECT_TRUE(error_dependences(answers(twice, right)).empty()) << "a factor that is the same everywhere";
    const Answer several = [](const Asked& a) { return std::vector{a.left * a.top * a.size * a.x}; };
    EXPECT_TRUE(error_dependences(answers(several, right)).empty());
    const Answer constant = [](const Asked&) { return std::vector{7.0}; };
    EXPECT_TRUE(error_dependences(answers(constant, right)).empty());
}

TEST(ErrorDependence, answers_by_chance_have_none)
{
    for (std::uint32_t seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Random random(seed);
        const Answer any = [&](const Asked&) { return std::vector<double>{random.uniform(-1, 1)}; };
        const Answer right = [](const Asked& a) { return std::vector{a.left * a.size + a.top}; };
        EXPECT_TRUE(error_dependences(answers(any, right)).empty());
    }
}

}
}
