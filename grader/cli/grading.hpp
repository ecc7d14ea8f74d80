#pragma once

#include <string>
#include <vector>

#include "cli/application.hpp"

namespace umbral::grader {

/// The command line of `grade`; `demo` fills one in by itself.
struct GradeCommand {
    std::string submissions;
    std::string out;
    std::string roster;
    std::vector<std::string> only;  ///< ids of submissions; empty: all
    bool fresh = false;             ///< ask again for what was kept
    unsigned jobs = 0;
    std::vector<std::string> units;
    bool handed_in = false;  ///< of these, only the class's task (class/handed_in.hpp)
    std::string course = "course";
    unsigned attempt = 0;
    std::string secret_file;
    bool allow_weak_sandbox = false;
    bool json = false;
    bool with_hidden = false;  ///< write instructors' pages as well
};

/// Grades the class, prints its table and where the reports lie.
void grade_and_print(Application& application, const GradeCommand& command);

}
