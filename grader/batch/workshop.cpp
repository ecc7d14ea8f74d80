#include "batch/workshop.hpp"

#include <fmt/format.h>

#include "batch/specimens.hpp"

namespace umbral::grader {
namespace {

/// Enough for all cases of a whole course with one set of visible seeds; hidden seeds differ by student and push old ones out.
constexpr std::size_t most_kept = 512;

Sources only_texts(const Sources& sources)
{
    Sources texts;
    for (const auto& [name, text] : sources)
        if (!name.ends_with(".cpp") && !name.ends_with(".hpp")) texts[name] = text;
    return texts;
}

}

Spawner& Workshop::spawner(bool gl)
{
    std::unique_ptr<Spawner>& wanted = gl ? gl_ : plain_;
    if (!wanted) wanted = std::make_unique<Spawner>(tools_.programs / (gl ? "umbral-spawner-gl" : "umbral-spawner"));
    return *wanted;
}

RunRequest Workshop::request(const Exercise& exercise, const std::string& case_name, std::uint64_t seed) const
{
    return {unit_folder(tools_, exercise.id) / "driver.so", {}, {}, case_name, seed, exercise.limits};
}

RunOutcome Workshop::run(const Exercise& exercise, const Built& built, const std::string& case_name, std::uint64_t seed)
{
    RunRequest wanted = request(exercise, case_name, seed);
    wanted.tenant = built.library;
    wanted.sources = built.sources;
    return spawner(exercise.gl).run(wanted);
}

const RunOutcome& Workshop::trusted(const Exercise& exercise, Tenant tenant, const std::string& case_name, std::uint64_t seed)
{
    const char* name = tenant == Tenant::reference ? "reference" : "oracle";
    const std::string key = fmt::format("{}\n{}\n{}\n{}", exercise.id, name, case_name, seed);
    if (const auto found = trusted_.find(key); found != trusted_.end()) return found->second;

    RunRequest wanted = request(exercise, case_name, seed);
    if (exercise.is_cpp()) wanted.tenant = unit_folder(tools_, exercise.id) / fmt::format("{}.so", name);
    wanted.sources = only_texts(exercise.is_cpp() ? Sources{} : reference_sources(tools_.reference, exercise));
    RunOutcome outcome = spawner(exercise.gl).run(wanted);
    if (outcome.verdict != Verdict::ok)
        throw std::runtime_error(
            fmt::format("{}: the {} did not finish case '{}' ({}): {}", exercise.id, name, case_name, to_string(outcome.verdict), outcome.message));
    if (trusted_.size() >= most_kept) trusted_.clear();
    return trusted_.emplace(key, std::move(outcome)).first->second;
}

RunOutcome Workshop::run_mistake(const Exercise& exercise, const std::string& name, const Sources& sources, const std::string& case_name, std::uint64_t seed)
{
    RunRequest wanted = request(exercise, case_name, seed);
    if (exercise.is_cpp()) wanted.tenant = unit_folder(tools_, exercise.id) / "mistakes" / (name + ".so");
    wanted.sources = only_texts(sources);
    return spawner(exercise.gl).run(wanted);
}

}
