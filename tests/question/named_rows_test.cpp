#include <gtest/gtest.h>

#include "first_pattern.hpp"

// What is wrong in rows whose numbers have names together, such as a colour's, and in rows of a kind among others.
namespace umbral::grader::test {
namespace {

using Row = std::vector<double>;

/// Lists of a transformation, of two numbers, and an object of a name and two colours; the given ones in place of the
/// right colours.
AnswerTable objects(const std::vector<Row>& diffuse, const std::vector<Row>& specular, const std::vector<Row>& yours)
{
    AnswerTable made;
    made.components = 8;
    made.keys = 1;
    made.kinds = {{1, {"a transformation", {"the kind of event", "x", "y", "", "", "", "", ""}}},
                  {2,
                   {"an object",
                    {"the kind of event", "name", "diffuse.r", "diffuse.g", "diffuse.b", "specular.r", "specular.g",
                     "specular.b"}}}};
    for (std::size_t i = 0; i < yours.size(); ++i) {
        const Row first{1, 7.5, static_cast<double>(i), 0, 0, 0, 0, 0};
        const auto list = [&](const Row& last) {
            Row all = first;
            for (const Row& part : {Row{2, 20}, diffuse[i], last}) all.insert(all.end(), part.begin(), part.end());
            return all;
        };
        made.answers.push_back({list(yours[i]), list(specular[i]), true});
    }
    return made;
}

const std::vector<Row> diffuse{{.1, .2, .3}, {.4, .8, .2}, {.9, .1, .1}, {.3, .3, .7}, {.5, .6, .1}};
const std::vector<Row> specular{{.9, .9, .9}, {.8, .8, .1}, {.2, .7, .7}, {.6, .5, .4}, {0, 0, .3}};

TEST(NamedRows, what_differs_is_called_by_its_name_in_the_kind_that_differs)
{
    std::vector<Row> yours = specular;
    for (Row& one : yours) one[1] = one[1] == .5 ? .1 : .5;
    EXPECT_EQ(first_pattern(objects(diffuse, specular, yours)), "differs in specular.g only");
    yours = {{.1, .1, .1}, {.2, .1, .2}, {.1, .3, .1}, {.1, .1, .9}, {.7, .1, .8}};
    EXPECT_EQ(first_pattern(objects(diffuse, specular, yours)), "differs in specular only");
}

TEST(NamedRows, what_belongs_to_another_name_is_told)
{
    EXPECT_EQ(first_pattern(objects(diffuse, specular, diffuse)),
              "differs in specular only, which is the right diffuse");
    // Greys differ in one number as well.
    std::vector<Row> yours = specular;
    for (std::size_t i = 0; i < yours.size(); ++i) yours[i][0] = diffuse[i][0];
    EXPECT_EQ(first_pattern(objects(diffuse, specular, yours)),
              "differs in specular.r only, which is the right diffuse.r");
}

TEST(NamedRows, rows_of_several_kinds_have_no_common_names)
{
    AnswerTable made = objects(diffuse, specular, diffuse);
    for (AnswerPair& one : made.answers) one.yours[2] += 3;
    EXPECT_EQ(first_pattern(made), "");
}

TEST(NamedRows, of_one_kind_in_a_table_are_called_together_too)
{
    AnswerTable made;
    made.components = 6;
    made.columns = {"from.x", "from.y", "from.z", "to.x", "to.y", "to.z"};
    for (double i = 0; i < 6; ++i)
        made.answers.push_back({{i, 2 - i, i * i, 3, 4, i}, {5 + i, 3 * i, 1, 3, 4, i}, true});
    EXPECT_EQ(first_pattern(made), "differs in from only");
    for (AnswerPair& one : made.answers)
        for (std::size_t k = 0; k < 3; ++k) one.yours[k] = -one.expected[3 + k];
    EXPECT_EQ(first_pattern(made), "differs in from only, which is the right to with the opposite sign");
}

}
}
