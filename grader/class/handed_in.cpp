#include "class/handed_in.hpp"

#include <algorithm>
#include <string>

namespace umbral::grader {

std::size_t submissions_for_a_task(std::size_t submissions) noexcept
{
    return std::max((submissions + 9) / 10, std::min<std::size_t>(submissions, 2));
}

HandedIn handed_in(const std::vector<SubmissionFolder>& submissions, const std::vector<Exercise>& exercises,
                   const ArchiveTools& archives)
{
    std::vector<std::vector<std::string>> begun_by(exercises.size());
    std::size_t counted = 0;
    for (const SubmissionFolder& submission : submissions) {
        const SubmittedFiles files = read_submission(submission.folder, exercises, archives);
        bool has_begun = false;
        for (std::size_t i = 0; i < exercises.size(); ++i) {
            const Sources own = collect(files, exercises[i]).files;
            if (own.empty() || equals_stub(own, exercises[i])) continue;
            begun_by[i].push_back(submission.id);
            has_begun = true;
        }
        counted += has_begun ? 1 : 0;
    }
    const std::size_t enough = submissions_for_a_task(counted);
    HandedIn result;
    for (std::size_t i = 0; i < exercises.size(); ++i) {
        if (begun_by[i].empty()) continue;
        if (begun_by[i].size() >= enough)
            result.task.push_back(exercises[i]);
        else
            result.too_few.push_back({exercises[i].id, std::move(begun_by[i])});
    }
    return result;
}

}
