#include "worker/student_case.hpp"

#include <stdexcept>

#include "build/inspection.hpp"
#include "worker/past_crashes.hpp"
#include "worker/seeds.hpp"

namespace umbral::grader {

CaseResult run_case(Worker& worker, const Exercise& exercise, const Built& built, const std::string& name,
                    std::uint64_t seed, bool explains)
{
    CaseResult one;
    one.seed = seed;
    one.hidden = is_hidden_case(exercise, name);
    one.student = worker.run(exercise, built, name, one.seed);
    if (one.student.verdict == Verdict::grader_fault) throw std::runtime_error(one.student.message);
    if (one.student.verdict == Verdict::crashed && !one.student.recording.frames.empty() && !built.library.empty())
        one.place = place_of(worker.tools(), built.library, one.student.recording.frames);
    go_past_crashes(worker, exercise, built, name, one);
    // A run that reached a stub tells itself which rows that concerns; but not where these are read from OpenGL's
    // state, which is as it was when nothing was done.
    if (one.is_stub() && !exercise.gl) one.past = one.student;
    if (explains) one.asked = question_of_end(worker, exercise, name, one);
    return one;
}

}
