#include "cli/built_work.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/checkout.hpp"
#include "cli/paths.hpp"

namespace umbral::grader {

BuiltWork built_work(const Application& application, const Exercise& exercise, const std::string& folder,
                     const std::vector<std::string>& flags)
{
    expect_folder(folder, "a workspace");
    Handed handed = collect(read_submission(folder, {&exercise, 1}, archive_tools(application.tools)), exercise);
    if (!handed.refused.empty()) throw UsageError(fmt::format("not read in {}: {}", folder, handed.refused));
    if (!handed.missing.empty())
        throw UsageError(fmt::format("not found in {}: {}", folder, fmt::join(handed.missing, ", ")));
    have_built(application, {&exercise, 1});
    Toolchain tools = application.tools;
    tools.flags.insert(tools.flags.end(), flags.begin(), flags.end());
    Built built = build(tools, exercise, handed.files);
    if (built.verdict != Verdict::ok) throw UsageError(fmt::format("{}:\n{}", in_words(built.verdict), built.message));
    return {std::move(handed.files), std::move(built)};
}

}
