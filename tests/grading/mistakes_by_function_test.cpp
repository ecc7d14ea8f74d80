#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "explain/explain_unit.hpp"
#include "handed_in.hpp"
#include "question/log.hpp"
#include "spoilt_reference.hpp"

// A known mistake that is made in one function only, and not in all that the unit's list makes it in.
namespace umbral::grader::test {
namespace {

class MistakesByFunction : public testing::Test {
protected:
    /// For each function the rows in which a run differs from the right one, by value.
    using Rows = std::map<std::string, std::map<std::string, std::vector<std::size_t>>>;

    Rows wrong_rows(const std::string& name, std::uint64_t seed, const RunOutcome& right, const RunOutcome& wrong)
    {
        Rows found;
        const QuestionLog& log = worker_.questions(exercise_, name, seed);
        for (const auto& [value, tensor] : right.recording.tensors) {
            const auto its = wrong.recording.tensors.find(value);
            if (its == wrong.recording.tensors.end() || its->second.bytes.size() != tensor.bytes.size()) continue;
            const std::size_t size = tensor.components * size_of(tensor.element);
            for (std::size_t row = 0; row < tensor.rows; ++row) {
                const auto question = log.question_of(value, row, tensor.rows);
                const QuestionKind* const kind = question ? log.kind_of(*question) : nullptr;
                const auto at = static_cast<std::ptrdiff_t>(row * size);
                if (kind != nullptr && !std::equal(tensor.bytes.begin() + at,
                                                   tensor.bytes.begin() + at + static_cast<std::ptrdiff_t>(size),
                                                   its->second.bytes.begin() + at))
                    found[kind->function][value].push_back(row);
            }
        }
        return found;
    }

    /// What explains a submission that answers as `mistake` where this function is asked, and right elsewhere.
    std::vector<Explanation> made_in(const std::string& function, const KnownSolution& mistake)
    {
        const auto [result, cases] = hand_in(worker_, exercise_, [&](const std::string& name, std::uint64_t seed) {
            RunOutcome answer = worker_.trusted(exercise_, Answers::reference, name, seed);
            const RunOutcome& wrong =
                worker_.run_known(exercise_, "mistakes/" + mistake.name, mistake.sources, name, seed);
            Rows rows = wrong_rows(name, seed, answer, wrong);
            for (const auto& [value, which] : rows[function]) {
                Tensor& into = answer.recording.tensors.at(value);
                const std::size_t size = into.components * size_of(into.element);
                for (const std::size_t row : which)
                    std::copy_n(wrong.recording.tensors.at(value).bytes.begin() + static_cast<long>(row * size), size,
                                into.bytes.begin() + static_cast<long>(row * size));
            }
            return answer;
        });
        return explain_unit(worker_, exercise_, result, cases);
    }

    std::set<std::string> functions_of(const KnownSolution& mistake)
    {
        std::set<std::string> functions;
        for (const std::string& name : exercise_.cases()) {
            const std::uint64_t seed = SeedPlan{}.seed_of(exercise_, name);
            const RunOutcome& right = worker_.trusted(exercise_, Answers::reference, name, seed);
            const RunOutcome& wrong =
                worker_.run_known(exercise_, "mistakes/" + mistake.name, mistake.sources, name, seed);
            for (const auto& [function, rows] : wrong_rows(name, seed, right, wrong)) functions.insert(function);
        }
        return functions;
    }

    Workbench bench_;
    Exercise exercise_ = bench_.exercise("transforms/basic-matrices");
    Worker worker_{bench_.tools()};
};

TEST_F(MistakesByFunction, are_told_with_the_function)
{
    int told = 0;
    for (const KnownSolution& mistake : explaining_mistakes(worker_, exercise_)) {
        const std::set<std::string> functions = functions_of(mistake);
        if (functions.size() < 2) continue;
        for (const std::string& function : functions) {
            const std::vector<Explanation> found = made_in(function, mistake);
            const std::string name = function.substr(function.rfind(':') + 1);
            const auto mine = std::ranges::find(found, "mistake: " + mistake.name, &Explanation::name);
            told += mine != found.end() ? 1 : 0;
            for (const Explanation& one : found) {
                if (!one.sentence.starts_with("Seen in ")) continue;
                EXPECT_TRUE(one.sentence.starts_with("Seen in " + name + ": ")) << one.sentence;
            }
        }
    }
    // Where few answers show it, or a transform says all of it, nothing need be said.
    EXPECT_GT(told, 3);
}

class DoubtedMistakes : public SpoiltReference {
protected:
    DoubtedMistakes() : SpoiltReference("texturing/mipmap") {}
};

// The few steps by hand are as long by a known mistake, those that are hidden are not.
TEST_F(DoubtedMistakes, are_not_very_likely)
{
    const UnitResult result =
        grade("const double step = std::max(length(texels * glm::dvec2(by_x)), length(texels * glm::dvec2(by_y)));",
              "const glm::dvec2 x = glm::abs(texels * glm::dvec2(by_x)), y = glm::abs(texels * glm::dvec2(by_y));\n"
              "    const double step = std::max(std::max(x.x, x.y), std::max(y.x, y.y));");
    EXPECT_LT(result.score, result.max_score);
    for (const Explanation& one : result.explanations) EXPECT_LT(one.confidence, 0.9) << one.name;
}

}
}
