#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "build/submission.hpp"
#include "model/exercise.hpp"

namespace umbral::grader {

/// Which random inputs a submission meets. Visible cases have the same for all; hidden ones follow from a secret, the
/// student, and what the student handed in for the unit.
struct SeedPlan {
    std::string secret = "practice";
    std::string course = "course";
    std::string student = "student";
    unsigned attempt = 0;
    /// work_digest() of the unit's files: what a run gives away about its hidden inputs describes inputs that no other
    /// files will ever meet, while the same files meet the same. Left empty, grade_unit fills it in.
    std::string work{};

    /// The seed of a unit's case.
    [[nodiscard]] std::uint64_t seed_of(const Exercise& exercise, const std::string& case_name) const;
    /// The seed with which a borderline case is run again: as secret, and unrelated to it.
    [[nodiscard]] std::uint64_t fresh_seed_of(const Exercise& exercise, const std::string& case_name) const;
    /// A seed of a visible case that follows from the secret: other inputs, of which there may be several, and those
    /// that are written down in the driver varied (umbral/record/variation.hpp). There are 64 such seeds for a class,
    /// so that the reference need not answer each student's own; which of them a work meets follows from the secret,
    /// the student and the files. Of a run with them nothing is told but points.
    [[nodiscard]] std::uint64_t other_seed_of(const Exercise& exercise, const std::string& case_name,
                                              unsigned number) const;
    /// Another seed of a visible case, for varied inputs that are the same for all.
    [[nodiscard]] std::uint64_t public_seed_of(const Exercise& exercise, const std::string& case_name) const;
    /// Two seeds of a case with which inputs differ, unless they never do; of visible cases the same for all.
    [[nodiscard]] std::pair<std::uint64_t, std::uint64_t> two_seeds_of(const Exercise& exercise,
                                                                       const std::string& case_name) const;
};

/// What known solutions are graded with, those of one number with the same hidden inputs: the trusted runs of one serve
/// the next.
[[nodiscard]] inline SeedPlan validation_seeds(unsigned number)
{
    return {"validate", "validate", "validate", number, "validate"};
}

/// Seeds of practice inputs of a hidden case, from place 0 on: they follow from no secret and are the same for
/// everybody, so that what is said of answers to them tells nothing about those that are graded.
[[nodiscard]] std::uint64_t practice_seed(const Exercise& exercise, const std::string& case_name, std::size_t place);
/// A seed that follows from another, for one more set of inputs of the same kind; itself at place 0.
[[nodiscard]] constexpr std::uint64_t seed_at(std::uint64_t seed, std::size_t place) noexcept
{
    return seed ^ (place * 0x9E3779B97F4A7C15U);
}

/// SHA-256 over names and texts.
[[nodiscard]] std::string work_digest(const Sources& files);

/// The number that a run of a case is given, from which its random numbers follow. Of a visible case it is the seed; of
/// a hidden one a one-way function of the seed, so that the memory of a run holds nothing from which another run's
/// inputs could be computed. Whatever is written down in the driver is varied in hidden cases.
[[nodiscard]] std::uint64_t stream_of(const Exercise& exercise, const std::string& case_name, std::uint64_t seed);

/// Is any check of this case hidden?
[[nodiscard]] bool is_hidden_case(const Exercise& exercise, const std::string& case_name);

}
