#include "question/names.hpp"

#include <gtest/gtest.h>

namespace umbral::grader {
namespace {

using Names = std::vector<std::string>;

constexpr const char* header = R"(
/// Not meet(this, one), which stands in a comment.
[[nodiscard]] std::optional<float> meet(const Ray& ray, const Sphere& sphere = {});
class Stack {
public:
    virtual void compose(const glm::mat4& transformation) = 0;
    virtual void push() = 0;
    virtual bool set(const std::string& name, std::map<int, float> values) = 0;
};
class Picture;
class Picture final : public Thing {
public:
    void push(int layer) override;
};
void unnamed(const Ray&, float, std::vector<int>);
float meeting(float other);
)";

TEST(ParameterNames, are_those_of_the_header)
{
    EXPECT_EQ(parameter_names(header, "umbral::raytracing::meet"), (Names{"ray", "sphere"}));
    EXPECT_EQ(parameter_names(header, "umbral::Stack::compose"), (Names{"transformation"}));
    EXPECT_EQ(parameter_names(header, "push"), Names());
    EXPECT_EQ(parameter_names(header, "umbral::Stack::push"), Names());
    EXPECT_EQ(parameter_names(header, "umbral::Picture::push"), Names{"layer"});
    EXPECT_EQ(parameter_names(header, "set"), (Names{"name", "values"}));
    EXPECT_EQ(parameter_names(header, "unnamed"), (Names{"", "", ""}));
    EXPECT_EQ(parameter_names(header, "no_such"), Names());
}

TEST(ParameterNames, stand_in_the_place_of_numbers)
{
    const Names names = {"ray", ""};
    EXPECT_EQ(in_words("0.origin.x", names), "ray.origin.x");
    EXPECT_EQ(in_words("0", names), "ray");
    EXPECT_EQ(in_words("the least number in 0.positions", names), "the least number in ray.positions");
    EXPECT_EQ(in_words("1", names), "the second argument");
    EXPECT_EQ(in_words("1.radius", names), "the second argument's radius");
    EXPECT_EQ(in_words("9", names), "the last argument");
    EXPECT_EQ(in_words("what is no place", names), "what is no place");
}

}
}
