#include "class/class_book.hpp"

#include "model/faults.hpp"
#include "report/formats.hpp"

namespace umbral::grader {
namespace {

/// Between two writings of class.json: at least so long, and so many times as long as the last one took.
constexpr std::chrono::seconds least_pause{3};
constexpr int least_pause_factor = 20;

}

void ClassBook::enter(const Graded& graded)
{
    const std::string& id = graded.result.id;
    known_[id] = graded;
    awaited_.erase(id);
    troubles_.erase(id);
    troubles_in_a_row_ = 0;
}

void ClassBook::enter_trouble(const std::string& id, const std::string& cause, bool of_the_folder)
{
    troubles_[id] = cause;
    if (!of_the_folder) return;
    if (++troubles_in_a_row_ > 1) shut_ = true;
}

ClassResult ClassBook::result() const
{
    ClassResult result;
    result.fingerprint = plan_.plan.fingerprint;
    result.grading = plan_.plan.grading;
    result.unfinished.assign(awaited_.begin(), awaited_.end());
    for (const auto& [id, graded] : known_) {
        result.submissions.push_back(graded.result);
        if (graded.elsewhere) result.elsewhere.push_back(id);
    }
    result.left_out = left_out_;
    for (const auto& [id, cause] : troubles_) result.unwritten.push_back({id, cause});
    return result;
}

void ClassBook::publish() const
{
    const ClassResult all = result();
    write_reports(plan_.out.path(), ClassReport{all, english_titles(plan_.course), plan_.plan.instructor_edition});
}

void ClassBook::publish_if_due()
{
    const Clock::time_point start = Clock::now();
    if (start - last_ < std::max<Clock::duration>(least_pause, least_pause_factor * took_)) return;
    try {
        publish();
    } catch (const std::exception& error) {
        troubles_[""] = error.what();
        shut_ = true;
    }
    last_ = Clock::now();
    took_ = last_ - start;
}

bool ClassBook::close()
{
    try {
        troubles_.erase("");
        publish();
    } catch (const std::exception& error) {
        troubles_[""] = error.what();
    }
    return troubles_.empty();
}

std::vector<std::string> ClassBook::causes_of(const std::string& id) const
{
    std::vector<std::string> causes;
    if (const auto found = known_.find(id); found != known_.end())
        for (const Fault& fault : faults({.fingerprint = {}, .submissions = {found->second.result}}))
            causes.insert(causes.end(), fault.places.size(), fault.remedy + fault.cause);
    return causes;
}

std::vector<std::string> ClassBook::changed() const
{
    std::vector<std::string> lines;
    for (const auto& [id, graded] : known_)
        for (const std::string& line : graded.changed) lines.push_back(id + ", " + line);
    return lines;
}

}
