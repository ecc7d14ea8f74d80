#include <gtest/gtest.h>

#include <bench/accuracy/json.hpp>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <support/schema.hpp>

#include "synthetic.hpp"

namespace umbral::bench {
namespace {

using nlohmann::json;

TEST(AccuracyJson, fits_its_schema)
{
    Accuracy accuracy = test::synthetic();
    const umbral::test::Schema schema("accuracy");
    EXPECT_EQ(schema.complaints(to_json(accuracy)), "");
    accuracy.knobs[0].results[0].errors["e"] = std::numeric_limits<double>::quiet_NaN();
    // What is not finite becomes null when it is written.
    EXPECT_EQ(schema.complaints(json::parse(to_json(accuracy).dump())), "");
    accuracy.knobs.clear();
    EXPECT_EQ(schema.complaints(to_json(accuracy)), "");
}

TEST(AccuracyJson, schema_refuses_what_is_wrong)
{
    const umbral::test::Schema schema("accuracy");
    const json right = to_json(test::synthetic());
    for (const auto& [pointer, value] :
         std::vector<std::pair<const char*, json>>{{"/version", 2},
                                                   {"/format", "umbral-class"},
                                                   {"/quick", "yes"},
                                                   {"/machine/gl", nullptr},
                                                   {"/knobs/0/id", "Two Words"},
                                                   {"/knobs/0/results/0/time", 0},
                                                   {"/knobs/0/results/0/time", -1},
                                                   {"/knobs/0/results/0/ratio", 0.5},
                                                   {"/knobs/0/results/0/errors/e", -1},
                                                   {"/knobs/0/results/0/errors", json::object()},
                                                   {"/knobs/0/results/0/more", 1},
                                                   {"/knobs/0/curves/0/knee", 1},
                                                   {"/knobs/0/curves/0/front", json::array()},
                                                   {"/knobs/0/curves/0/sentence", ""},
                                                   {"/knobs/1/situations/0/place", 0},
                                                   {"/knobs/1/measures", json::array()}}) {
        json wrong = right;
        wrong[json::json_pointer(pointer)] = value;
        EXPECT_NE(schema.complaints(wrong), "") << pointer << " = " << value;
    }
    for (const char* pointer : {"", "/machine", "/knobs/0", "/knobs/0/measures/0", "/knobs/0/situations/0",
                                "/knobs/0/settings/0", "/knobs/0/results/0", "/knobs/0/curves/0"}) {
        const json object = right[json::json_pointer(pointer)];
        for (const auto& [key, value] : object.items()) {
            json less = right;
            less[json::json_pointer(pointer)].erase(key);
            EXPECT_NE(schema.complaints(less), "") << pointer << " without " << key;
        }
    }
}

TEST(AccuracyJson, counts_ratios_from_the_fastest_of_each_situation)
{
    const json knob = to_json(test::synthetic())["knobs"][0];
    EXPECT_EQ(knob["results"][0]["ratio"], 1.0);
    EXPECT_EQ(knob["results"][3]["ratio"], 8.0);
    EXPECT_EQ(knob["curves"][0]["knee"], "s1");
    EXPECT_EQ(knob["curves"][0]["front"], json::array({"s0", "s1", "s2", "s3"}));
    EXPECT_EQ(to_json(test::synthetic())["knobs"][1]["curves"][0]["knee"], json());
}

}
}
