#include "batch/workshop.hpp"

#include <fmt/format.h>

#include "batch/specimens.hpp"

namespace umbral::grader {
namespace {

/// Enough for the visible cases of a good part of a course; hidden seeds differ by student and push old runs out.
constexpr std::size_t most_remembered = std::size_t{384} << 20U;

std::string key_of(const Exercise& exercise, const std::string& who, const std::string& case_name, std::uint64_t seed)
{
    return fmt::format("{}\n{}\n{}\n{}", exercise.id, who, case_name, seed);
}

}

Spawner& Workshop::spawner(bool gl)
{
    std::unique_ptr<Spawner>& wanted = gl ? gl_ : plain_;
    if (!wanted) wanted = std::make_unique<Spawner>(tools_.programs / (gl ? "umbral-spawner-gl" : "umbral-spawner"), gl_backend_);
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
    const std::string key = key_of(exercise, name, case_name, seed);
    if (const auto found = remembered_.find(key); found != remembered_.end()) return found->second;

    RunRequest wanted = request(exercise, case_name, seed);
    if (exercise.is_cpp()) wanted.tenant = unit_folder(tools_, exercise.id) / fmt::format("{}.so", name);
    wanted.sources = texts_of(exercise.is_cpp() ? Sources{} : reference_sources(tools_.reference, exercise));
    RunOutcome outcome = spawner(exercise.gl).run(wanted);
    if (outcome.verdict != Verdict::ok)
        throw std::runtime_error(
            fmt::format("{}: the {} did not finish case '{}' ({}): {}", exercise.id, name, case_name, to_string(outcome.verdict), outcome.message));
    return remember(key, std::move(outcome));
}

const RunOutcome& Workshop::run_mistake(const Exercise& exercise, const std::string& name, const Sources& sources, const std::string& case_name,
                                        std::uint64_t seed)
{
    const std::string key = key_of(exercise, "mistake " + name, case_name, seed);
    if (const auto found = remembered_.find(key); found != remembered_.end()) return found->second;
    RunRequest wanted = request(exercise, case_name, seed);
    if (exercise.is_cpp()) wanted.tenant = unit_folder(tools_, exercise.id) / "mistakes" / (name + ".so");
    wanted.sources = texts_of(sources);
    return remember(key, spawner(exercise.gl).run(wanted));
}

const RunOutcome& Workshop::remember(const std::string& key, RunOutcome outcome)
{
    std::size_t bytes = sizeof outcome;
    for (const auto& [name, tensor] : outcome.recording.tensors) bytes += tensor.bytes.size() + tensor.present.size();
    remembered_bytes_ += bytes;
    return remembered_.emplace(key, std::move(outcome)).first->second;
}

void Workshop::forget_if_full()
{
    if (remembered_bytes_ <= most_remembered) return;
    remembered_.clear();
    remembered_bytes_ = 0;
}

}
