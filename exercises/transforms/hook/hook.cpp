#include <umbral/transforms/hook.hpp>

namespace umbral::transforms {

// In each function: delete its last line, which says that nothing is written yet.

void draw_hook(Pipeline& pipeline)
{
    // TODO: one pipeline.draw_polyline with the five places, from (0,0) to (0,2).
    (void)not_implemented<int>(pipeline);
}

void draw_four_hooks(Pipeline& pipeline, const Figure& hook)
{
    // TODO: four times: hook(pipeline), then compose what takes the lower end of the next hook to the upper end of this
    // one, a quarter turn round.
    (void)not_implemented<int>(pipeline, hook);
}

void draw_hook_between(Pipeline& pipeline, const Figure& hook, const glm::vec3& from, const glm::vec3& to)
{
    // TODO: compose a translation, a rotation about z and a scaling, in this order, between a push and a pop, and draw
    // the hook. std::atan2 gives angles.
    (void)not_implemented<int>(pipeline, hook, from, to);
}

glm::mat4 hook_matrix(const glm::vec3& from, const glm::vec3& to)
{
    // TODO: the columns are what becomes of (1,0), (0,1), z, and the origin. (0,2) must go to `to`; (1,0) stays at a
    // right angle to it. No angles.
    return not_implemented<glm::mat4>(from, to);
}

void draw_hook_circle(Pipeline& pipeline, const Figure& hook, unsigned count)
{
    // TODO: one hook from each of the `count` places on the unit circle to the next one.
    (void)not_implemented<int>(pipeline, hook, count);
}

}
