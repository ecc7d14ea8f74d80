#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "support/workbench.hpp"

namespace umbral::grader::test {
namespace {

/// An attack that uses what is forbidden, where debug information is not looked at or names something else.
struct Hidden {
    const char* attack;
    const char* file;
    const char* found;  ///< what the message must name
};

void PrintTo(const Hidden& hidden, std::ostream* stream) { *stream << hidden.attack; }

class HiddenNames : public testing::TestWithParam<Hidden> {};

TEST_P(HiddenNames, are_found)
{
    const Workbench bench;
    const std::filesystem::path file = GetParam().file;
    const std::string text =
        project_file("tests/attacks/forbidden/" + std::string(GetParam().attack) + "/" + file.string());
    const Built built =
        build(bench.tools(), bench.exercise(file.parent_path().string()), {{file.filename().string(), text}});
    EXPECT_EQ(to_string(built.verdict), "forbidden") << built.message;
    EXPECT_NE(built.message.find(GetParam().found), std::string::npos) << built.message;
}

constexpr const char* file_of_rotation = "transforms/axis-rotation/axis_rotation.cpp";
constexpr const char* file_of_reflection = "raytracing/reflect-refract/reflect_refract.cpp";
INSTANTIATE_TEST_SUITE_P(
    All, HiddenNames,
    testing::Values(Hidden{"rotate-below-blocks", file_of_rotation, "glm::rotate is not allowed"},
                    Hidden{"rotate-in-union", file_of_rotation, "glm::rotate is not allowed"},
                    Hidden{"rotate-by-dotted-path", file_of_rotation, "glm::rotateNormalizedAxis is not allowed"},
                    Hidden{"rotate-called-identity", file_of_rotation,
                           "by another name (glm/gtx/rotate_normalized_axis.inl:"},
                    Hidden{"reflect-renamed", file_of_reflection, "glm::detail::compute_reflect_::call is not allowed"},
                    Hidden{"reflect-of-long-type", file_of_reflection, "glm::reflect is not allowed"},
                    Hidden{"reflect-of-detail", file_of_reflection, "is not allowed"},
                    Hidden{"srgb-of-detail", "lighting/color/color.cpp", "is not allowed"},
                    Hidden{"products-of-quaternions", "transforms/vectors/vectors.cpp", "is not allowed"},
                    Hidden{"mix-of-quaternions", "interaction/keyframes/keyframes.cpp", "glm::mix is not allowed"}),
    [](const auto& one) {
        std::string name = one.param.attack;
        std::ranges::replace(name, '-', '_');
        return name;
    });

}
}
