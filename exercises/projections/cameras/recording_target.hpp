#pragma once

#include <umbral/projections/camera.hpp>
#include <umbral/record/ask.hpp>

/// What a camera tells the pipeline that it is activated for.
namespace umbral::projections {

/// A pipeline that takes down what it is told.
class RecordingTarget final : public MatrixTarget {
public:
    void set_view(const glm::mat4& view) override
    {
        view_ = view;
        calls_.x += 1;
    }
    void set_projection(const glm::mat4& projection) override
    {
        projection_ = projection;
        calls_.y += 1;
    }

    [[nodiscard]] const glm::mat4& view() const { return view_; }
    [[nodiscard]] const glm::mat4& projection() const { return projection_; }
    [[nodiscard]] const glm::vec2& calls() const { return calls_; }

private:
    glm::mat4 view_{0};
    glm::mat4 projection_{0};
    glm::vec2 calls_{0};
};

/// What a new target is told.
inline RecordingTarget activated(Recorder& out, Camera& camera)
{
    RecordingTarget target;
    if (Questions* const questions = out.questions())
        questions->set_object(&target, "target", "RecordingTarget target;");
    ask<&Camera::activate>(out, camera, target);
    return target;
}

inline void record(Recorder& out, Camera& camera)
{
    const RecordingTarget target = activated(out, camera);
    out.append("view", target.view());
    out.append("projection", target.projection());
}

}
