#include "worker/check_basis.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "judge/judge.hpp"
#include "worker/case_results.hpp"
#include "worker/related.hpp"

namespace umbral::grader {

CheckBasis basis_of(const Check& check, const RunOutcome& expected_run, const RunOutcome& reference_run,
                    std::uint64_t seed)
{
    const auto [expected, margin, names] = expected_of(check, expected_run);
    const Tensor* reference = tensor_of(reference_run, check.value);
    if (expected == nullptr || reference == nullptr)
        throw std::runtime_error(
            fmt::format("check '{}': the driver recorded nothing called '{}'", check.name, check.value));
    CheckBasis basis;
    if (check.hard) basis.reference_error = judge(check, *reference, *expected, margin).error;
    basis.control = check.relation
                        ? RelationJudge(check, related_tensors(check, expected_run), margin, seed).best_control().right
                        : best_control(check, *expected, margin, seed).right;
    return basis;
}

}
