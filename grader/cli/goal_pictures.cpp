#include "cli/goal_pictures.hpp"

#include "class/check_submission.hpp"
#include "cli/checkout.hpp"
#include "worker/crew.hpp"

namespace umbral::grader {

void draw_goal_pictures(const Application& application, const std::vector<Exercise>& exercises,
                        const std::function<void(Worker& worker, std::size_t unit)>& draw)
{
    constexpr std::size_t many = 20;
    have_built(application, exercises, UnitParts::answers);
    if (exercises.size() > many)
        application.say("drawing goal pictures; the first time on a machine this takes up to a minute");
    Crew crew(application.tools, default_jobs());
    keep_runs_as_checks_do(crew, exercises);
    crew.share_out(exercises.size(), [&](Worker& worker, std::size_t unit) {
        draw(worker, unit);
        worker.let_go();
    });
}

}
