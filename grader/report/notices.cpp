#include "report/notices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "model/caps.hpp"
#include "report/paint.hpp"

namespace umbral::grader {
namespace {

std::string counted(std::size_t count, const char* thing)
{
    return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

/// A sentence from words that a program composed: capital and full stop.
std::string sentence(std::string words)
{
    if (words.empty()) return words;
    if (words.front() >= 'a' && words.front() <= 'z') words.front() = static_cast<char>(words.front() - 'a' + 'A');
    if (std::string_view(".!?…").find(words.back()) == std::string_view::npos) words += '.';
    return words;
}

std::string headline_of(const Fault& fault)
{
    std::size_t units = 0;
    std::size_t reports = 0;
    bool class_too = false;
    std::set<std::string> submissions;
    for (const Fault::Place& place : fault.places) {
        if (!place.unit.empty()) {
            ++units;
            submissions.insert(place.submission);
        } else if (place.submission.empty()) {
            class_too = true;
        } else {
            ++reports;
        }
    }
    std::string text;
    if (units > 0)
        text += fmt::format("{} of {} {} not scored: {} points are in no sum.", counted(units, "unit"),
                            counted(submissions.size(), "submission"), units == 1 ? "is" : "are",
                            points_text(fault.points));
    if (reports > 0)
        text += fmt::format("{}The reports of {} could not be written.", text.empty() ? "" : " ",
                            counted(reports, "submission"));
    if (class_too) text += fmt::format("{}class.json and index.html could not be written.", text.empty() ? "" : " ");
    return text;
}

std::vector<Fault::Place> whole(const std::vector<std::string>& submissions)
{
    std::vector<Fault::Place> places;
    for (const std::string& id : submissions) places.push_back({id, ""});
    return places;
}

std::vector<Fault::Place> who_began(const std::vector<LeftOut>& units)
{
    std::vector<Fault::Place> places;
    for (const LeftOut& one : units)
        for (const std::string& id : one.submissions) places.push_back({id, one.unit});
    return places;
}

}

std::vector<Notice> notices(const ClassResult& result)
{
    std::vector<Notice> all;
    for (const Fault& fault : faults(result)) {
        Notice notice{true, headline_of(fault), sentence(fault.cause), sentence(fault.remedy), fault.places};
        std::erase_if(notice.who, [](const Fault::Place& place) { return place.submission.empty(); });
        all.push_back(std::move(notice));
    }
    // Whose reports could not be written was told already.
    std::vector<std::string> unfinished = result.unfinished;
    std::erase_if(unfinished, [&](const std::string& id) {
        return std::ranges::find(result.unwritten, id, &Unwritten::submission) != result.unwritten.end();
    });
    if (const std::size_t count = unfinished.size(); count > 0)
        all.push_back(
            {true,
             fmt::format("{} {} not graded to the end: missing here, or here with older results.",
                         counted(count, "submission"), count == 1 ? "is" : "are"),
             "", "If grading does not go on right now, run the same command again: only what is missing is graded.",
             whole(unfinished)});
    if (const std::size_t count = result.left_out.size(); count > 0)
        all.push_back(
            {false,
             fmt::format("{} {} in no sum: hardly anybody handed {} in.", counted(count, "unit"),
                         count == 1 ? "is" : "are", count == 1 ? "it" : "them"),
             "", "If it is the class's task, name all units of the task: --unit grades those named, for everybody.",
             who_began(result.left_out)});
    if (const std::size_t count = result.elsewhere.size(); count > 0)
        all.push_back(
            {false,
             fmt::format("{} {} results of another version of Umbral, or of another machine, than the one named here.",
                         counted(count, "submission"), count == 1 ? "has" : "have"),
             "", "Grade the whole class again where all should be judged alike.", whole(result.elsewhere)});
    return all;
}

std::string who_in_words(const Notice& notice)
{
    std::vector<std::string> submissions;
    std::vector<std::string> texts;
    for (const Fault::Place& place : notice.who) {
        auto found = std::ranges::find(submissions, place.submission);
        if (found == submissions.end()) {
            found = submissions.insert(found, place.submission);
            texts.push_back(one_line(place.submission));
        }
        if (place.unit.empty()) continue;
        std::string& text = texts[static_cast<std::size_t>(found - submissions.begin())];
        text += (text == one_line(place.submission) ? ": " : ", ") + place.unit;
    }
    std::string text;
    for (std::size_t i = 0; i < std::min(texts.size(), caps::listed); ++i)
        text += (i == 0 ? "" : "; ") + one_line(texts[i]);
    if (texts.size() > caps::listed) text += fmt::format(" and {} more", texts.size() - caps::listed);
    return text;
}

}
