#include "spoilt_reference.hpp"

// How long the lists are that a call answers with, though the driver records their rows one by one.
namespace umbral::grader::test {
namespace {

class AnswerLengths : public SpoiltReference {
protected:
    AnswerLengths() : SpoiltReference("pipeline/polygon-tables") {}
};

TEST_F(AnswerLengths, of_what_is_returned_and_of_lists_in_it)
{
    const UnitResult result = grade("for (std::size_t i = 0; i < corners.size(); ++i) {",
                                    "for (std::size_t i = 0; i < corners.size(); i += 2) {");
    EXPECT_NE(
        check(result, "by hand/segments")
            .common.find("polygon_segments: the answer has too few elements (first 4 elements where 6 are right) in 4 "
                         "of 4 calls"),
        std::string::npos)
        << check(result, "by hand/segments").common;
}

TEST_F(AnswerLengths, of_lists_in_what_is_returned)
{
    const UnitResult result =
        grade("polygon.edges.emplace_back(centre, i);", "if (i > 0) polygon.edges.emplace_back(centre, i);");
    EXPECT_NE(
        check(result, "by hand/edges").common.find("polygon_fan: its list edges has 1 element too few in 4 of 4 calls"),
        std::string::npos)
        << check(result, "by hand/edges").common;
    EXPECT_EQ(check(result, "by hand/edges").common.find("positions"), std::string::npos);
}

}
}
