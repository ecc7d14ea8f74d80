#include "bench/judges/unit_pairs.hpp"

#include <fmt/format.h>

#include "bench/judges/picture_operators.hpp"
#include "build/builder.hpp"
#include "judge/judges.hpp"
#include "judge/rules.hpp"
#include "unit/grade_unit.hpp"
#include "worker/case_results.hpp"
#include "worker/known_solutions.hpp"

namespace umbral::grader {
namespace {

/// One picture that is judged.
struct Subject {
    const Check& check;
    std::string scene;
    const Tensor& expected_tensor;
    Picture expected;

    void show(const Tensor* tensor, const std::string& change, bool harmful, const VisitPair& visit) const
    {
        if (tensor == nullptr || shape_error(check, *tensor, expected_tensor) || !complete(*tensor)) return;
        visit({scene, change, harmful, false, false, expected, to_picture(check, *tensor)});
    }
};

void visit_picture(Worker& worker, Worker& other_gl, const Exercise& exercise, const Check& check, std::uint64_t seed,
                   const VisitPair& visit)
{
    const Tensor* expected =
        tensor_of(worker.trusted(exercise, judged_against(check), check.case_name, seed), check.value);
    if (expected == nullptr)
        throw std::runtime_error(fmt::format("{}: nothing recorded for check '{}'", exercise.id, check.name));
    const Subject subject{check, fmt::format("{}: {}", exercise.id, check.name), *expected,
                          to_picture(check, *expected)};
    if (check.hard)
        subject.show(tensor_of(worker.trusted(exercise, Answers::reference, check.case_name, seed), check.value),
                     "reference beside oracle", false, visit);
    if (exercise.gl)
        subject.show(tensor_of(other_gl.trusted(exercise, judged_against(check), check.case_name, seed), check.value),
                     "other back end of OpenGL", false, visit);
    const auto& reference = worker.tools().reference;
    for (const KnownSolution& other : alternatives_of(reference, exercise)) {
        const RunOutcome run =
            worker.run(exercise, build(worker.tools(), exercise, other.sources), check.case_name, seed);
        subject.show(tensor_of(run, check.value), "alternative: " + other.name, false, visit);
    }
    for (const KnownSolution& mistake : mistakes_of(reference, exercise)) {
        if (mistake.verdict) continue;
        const RunOutcome& run = worker.run_known(exercise, mistake, check.case_name, seed);
        if (run.verdict == Verdict::ok)
            subject.show(tensor_of(run, check.value), "mistake: " + mistake.name, true, visit);
    }
    visit_operators(subject.scene, subject.expected, visit);
}

}

void visit_unit(Worker& worker, Worker& other_gl, const Exercise& exercise, unsigned seed, const VisitPair& visit)
{
    const SeedPlan seeds{"calibrate", "calibrate", "calibrate", seed};
    for (const Check& check : exercise.checks)
        if (judge_of(check).look == Look::colours)
            visit_picture(worker, other_gl, exercise, check, seeds.seed_of(exercise, check.case_name), visit);
}

}
