#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "manifest/units.hpp"
#include "manifest_json.hpp"
#include "message_of.hpp"

// Checks whose points hang on another one.
namespace umbral::grader {
namespace {

using nlohmann::json;

json hanging_on(const char* other, const char* field = "with")
{
    json manifest = test::manifest();
    manifest["checks"][2][field] = other;
    return manifest;
}

std::string refusal_of(const json& manifest)
{
    return test::message_of([&] { (void)parse_exercise(manifest, "here.json"); });
}

TEST(With, is_read)
{
    const json manifest = hanging_on("views/matrix");
    EXPECT_EQ(parse_exercise(manifest, "here.json").checks[2].with, "views/matrix");
    EXPECT_EQ(parse_exercise(test::manifest(), "here.json").checks[2].with, "");
}

TEST(With, names_a_visible_check_that_hangs_on_none)
{
    for (const char* other : {"views/other", "matrix", "head-on/ids"})
        EXPECT_NE(refusal_of(hanging_on(other)).find("checks[2].with: "), std::string::npos) << other;
    json hidden = hanging_on("views/matrix");
    hidden.erase("knob");
    hidden["checks"][1]["hidden"] = true;
    EXPECT_NE(refusal_of(hidden).find("checks[2].with: "), std::string::npos);
    json chain = hanging_on("views/matrix");
    chain["checks"][1]["with"] = "frames/calls";
    EXPECT_NE(refusal_of(chain).find(".with: "), std::string::npos);
}

}
}
