#pragma once

#include <atomic>
#include <chrono>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "class/submission_parts.hpp"

namespace umbral::grader {

/// The results of a class while it is graded, and class.json and index.html, which show them. Not for use by several
/// threads at once, but for is_shut().
class ClassBook {
public:
    /// `left_out`: units that are not graded, for the results to tell of.
    ClassBook(const SubmissionPlan& plan, std::vector<LeftOut> left_out) : plan_(plan), left_out_(std::move(left_out))
    {
    }

    /// A submission whose results are not there yet, or are older than its files.
    void await(const std::string& id) { awaited_.insert(id); }
    /// Results that hold: they take the place of what was there of the submission.
    void enter(const Graded& graded);
    /// The submission's reports could not be written. If the folder itself cannot be written (`of_the_folder`: maybe
    /// that is why) the book is shut: nothing that is graded now would be kept.
    void enter_trouble(const std::string& id, const std::string& cause, bool of_the_folder);

    /// Grading begins now.
    void begin() { began_ = last_ = Clock::now(); }
    /// Seconds since then.
    [[nodiscard]] double seconds() const { return std::chrono::duration<double>(Clock::now() - began_).count(); }

    /// Writes class.json and index.html if they have not been written for a few seconds; a failure shuts the book.
    void publish_if_due();
    /// Writes them for the last time; false if that fails, or any reports could not be written. The reasons are in the
    /// result.
    bool close();

    /// Is there no sense in grading on?
    [[nodiscard]] bool is_shut() const noexcept { return shut_; }

    [[nodiscard]] ClassResult result() const;
    /// Why units of a submission are not scored, one for each such unit.
    [[nodiscard]] std::vector<std::string> causes_of(const std::string& id) const;
    /// Points that are others than before, by submission.
    [[nodiscard]] std::vector<std::string> changed() const;

private:
    using Clock = std::chrono::steady_clock;

    void publish() const;

    const SubmissionPlan& plan_;
    std::vector<LeftOut> left_out_;
    std::map<std::string, Graded> known_;
    std::set<std::string> awaited_;
    std::map<std::string, std::string> troubles_;  ///< causes by submission; "": class.json
    int troubles_in_a_row_ = 0;
    std::atomic<bool> shut_ = false;
    Clock::time_point began_ = Clock::now();
    Clock::time_point last_ = began_;
    Clock::duration took_{};
};

}
