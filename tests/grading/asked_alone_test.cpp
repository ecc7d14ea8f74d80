#include "spoilt_reference.hpp"

// What is said of an answer that is right where nothing else is asked.
namespace umbral::grader::test {
namespace {

class AskedAlone : public SpoiltReference {
protected:
    AskedAlone() : SpoiltReference("pipeline/primitive-assembly") {}

    bool is_said(const std::string& from, const std::string& to)
    {
        const UnitResult result = grade(from, to);
        EXPECT_LT(result.score, result.max_score);
        return std::ranges::any_of(result.checks, [](const CheckResult& one) {
            return one.common.find("if no other is made before it") != std::string::npos;
        });
    }
};

const std::string quads = "for (std::size_t i = 0; i + 4 <= n; i += 4)";

// Of quads of four vertices the only one is lost, and four others lose none: aligned with what is expected, the first
// row that lacks is one that they have.
TEST_F(AskedAlone, is_asked_what_has_a_wrong_answer)
{
    EXPECT_FALSE(is_said(quads, "for (std::size_t i = 0; i + 4 < n; i += 4)"));
}

TEST_F(AskedAlone, what_is_kept_between_calls_is_said)
{
    EXPECT_TRUE(is_said(quads,
                        "static int calls = 0;\n            for (std::size_t i = calls++ > 0 ? 4 : 0; i + 4 <= n; "
                        "i += 4)"));
}

}
}
