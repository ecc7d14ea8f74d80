#include "worker/seeds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <umbral/record/variation.hpp>

#include "model/digest.hpp"

namespace umbral::grader {
namespace {

/// Of other inputs for a case. What a run gives away about its own describes those of one work in so many, and of the
/// next one that the student hands in hardly ever; the reference answers for a class no more than these.
constexpr std::uint64_t pools = 64;

/// Everybody knows this one.
std::uint64_t visible_seed(const SeedPlan& plan, const Exercise& exercise, const std::string& words)
{
    return VariedSeed::without_mark(case_seed("visible", plan.course, "", exercise.id, words, plan.attempt));
}

/// `word` tells seeds of one case apart; the name of a case is one line, so that no other case has this one's.
std::uint64_t seed_for(const SeedPlan& plan, const Exercise& exercise, const std::string& case_name,
                       const std::string& word)
{
    if (!is_hidden_case(exercise, case_name)) return visible_seed(plan, exercise, case_name + word);
    const std::string work = plan.work.empty() ? "" : "\nwork " + plan.work;
    return VariedSeed::without_mark(
        case_seed(plan.secret, plan.course, plan.student, exercise.id, case_name + word + work, plan.attempt));
}

}

std::uint64_t SeedPlan::seed_of(const Exercise& exercise, const std::string& case_name) const
{
    return seed_for(*this, exercise, case_name, "");
}

std::uint64_t SeedPlan::fresh_seed_of(const Exercise& exercise, const std::string& case_name) const
{
    return seed_for(*this, exercise, case_name, "\nagain");
}

std::uint64_t SeedPlan::other_seed_of(const Exercise& exercise, const std::string& case_name, unsigned number) const
{
    const std::uint64_t pool = case_seed(secret, course, student, exercise.id, "pool\nwork " + work, attempt) % pools;
    return VariedSeed::with_mark(case_seed(secret, course, "", exercise.id,
                                           fmt::format("{}\nother inputs {} of {}", case_name, number, pool), attempt));
}

std::uint64_t SeedPlan::public_seed_of(const Exercise& exercise, const std::string& case_name) const
{
    return VariedSeed::with_mark(visible_seed(*this, exercise, case_name + "\nother inputs"));
}

std::pair<std::uint64_t, std::uint64_t> SeedPlan::two_seeds_of(const Exercise& exercise,
                                                               const std::string& case_name) const
{
    return {seed_of(exercise, case_name), is_hidden_case(exercise, case_name) ? fresh_seed_of(exercise, case_name)
                                                                              : public_seed_of(exercise, case_name)};
}

std::uint64_t practice_seed(const Exercise& exercise, const std::string& case_name, std::size_t place)
{
    return seed_at(case_seed("practice", "", "", exercise.id, case_name, 0), place);
}

std::string work_digest(const Sources& files)
{
    Sha256 hash;
    hash.update_field("umbral-work-1");
    for (const auto& [name, text] : files) {
        hash.update_field(name);
        hash.update_field(text);
    }
    return hash.finish();
}

std::uint64_t stream_of(const Exercise& exercise, const std::string& case_name, std::uint64_t seed)
{
    if (!is_hidden_case(exercise, case_name)) return seed;
    Sha256 hash;
    hash.update_field("umbral-hidden-stream-1");
    hash.update(seed);
    return VariedSeed::with_mark(std::stoull(hash.finish().substr(0, 16), nullptr, 16));
}

bool is_hidden_case(const Exercise& exercise, const std::string& case_name)
{
    return std::any_of(exercise.checks.begin(), exercise.checks.end(),
                       [&](const Check& check) { return check.hidden && check.case_name == case_name; });
}

}
