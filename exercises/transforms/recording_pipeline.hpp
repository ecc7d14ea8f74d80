#pragma once

#include <algorithm>
#include <array>
#include <glm/glm.hpp>
#include <stdexcept>
#include <umbral/core/grid.hpp>
#include <umbral/core/random.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/transforms/pipeline.hpp>
#include <vector>

/// A pipeline without a screen: it takes down what it is asked for.
namespace umbral::transforms {

/// How a pipeline stands when a drawing function is called.
struct Start {
    glm::mat4 modelview{1};
    glm::vec3 color{1};
    float line_width = 1;
    glm::vec3 background{0};
    std::size_t depth = 0;  ///< of other matrices, so that a pop too many is seen
};

/// A start that no function can have expected: any affine map of the plane, any colours, and somebody else's matrices
/// on the stack.
inline Start random_start(Random& random)
{
    const auto component = [&] { return random.uniform(-2, 2); };
    const auto channel = [&] { return random.uniform(0.05F, 1); };
    Start start;
    for (const int column : {0, 1, 3})
        for (int row = 0; row < 2; ++row) start.modelview[column][row] = component();
    for (int i = 0; i < 3; ++i) start.color[i] = channel();
    for (int i = 0; i < 3; ++i) start.background[i] = channel();
    start.line_width = 1 + static_cast<float>(random.below(7));
    start.depth = 1 + random.below(4);
    return start;
}

/// Something that was drawn, or a change of the stack, with the state of that moment.
struct Call {
    enum class Kind { figure, polyline, triangles, primitive, push, pop, empty_pop, set_view };
    Kind kind{};
    glm::dmat4 modelview{1};
    glm::vec3 color{0};
    float line_width = 0;
    std::vector<glm::vec2> places;  ///< of polylines and triangles, in master coordinates
    Primitive primitive{};
};

/// Matrices are multiplied in double, so that what is compared is the caller's rounding and not this class's.
class RecordingPipeline final : public Pipeline {
public:
    static constexpr std::size_t maximum_calls = 20'000;
    static constexpr std::size_t maximum_places = 100'000;  ///< of all lines and triangles

    explicit RecordingPipeline(const Start& start = {})
        : modelview_(start.modelview),
          stack_(start.depth, 2.0 * modelview_),
          color_(start.color),
          line_width_(start.line_width),
          background_(start.background)
    {
    }

    void set_view(const glm::mat4& view) override
    {
        modelview_ = view;
        stack_.clear();
        add(Call::Kind::set_view);
    }
    void compose(const glm::mat4& transformation) override
    {
        modelview_ = modelview_ * glm::dmat4(transformation);
        const auto is_push = [](const Call& call) { return call.kind == Call::Kind::push; };
        if (std::all_of(calls_.begin(), calls_.end(), is_push)) first_steps_.push_back(transformation);
        if (first_steps_.size() > maximum_calls)
            throw std::length_error(
                "more than 20,000 matrices before anything is drawn: does the loop come to an end?");
    }
    void push() override
    {
        add(Call::Kind::push);
        stack_.push_back(modelview_);
    }
    void pop() override
    {
        add(stack_.empty() ? Call::Kind::empty_pop : Call::Kind::pop);
        if (stack_.empty()) throw EmptyStack();
        modelview_ = stack_.back();
        stack_.pop_back();
    }

    void set_color(const glm::vec3& color) override { color_ = color; }
    [[nodiscard]] glm::vec3 color() const override { return color_; }
    void set_line_width(float width) override { line_width_ = width; }
    [[nodiscard]] float line_width() const override { return line_width_; }
    [[nodiscard]] glm::vec3 background() const override { return background_; }

    void draw_polyline(std::span<const glm::vec2> places) override { add(Call::Kind::polyline).places = copy(places); }
    void fill_triangles(std::span<const glm::vec2> corners) override
    {
        add(Call::Kind::triangles).places = copy(corners);
    }
    void draw(Primitive primitive) override { add(Call::Kind::primitive).primitive = primitive; }

    /// A figure to hand to a function under test: drawing it leaves an entry of its own kind.
    [[nodiscard]] Figure marker()
    {
        return [this](Pipeline&) { add(Call::Kind::figure); };
    }

    [[nodiscard]] const std::vector<Call>& calls() const { return calls_; }
    [[nodiscard]] const glm::dmat4& modelview() const { return modelview_; }
    [[nodiscard]] std::size_t depth() const { return stack_.size(); }
    /// The matrices that were composed, one by one, before anything was drawn or popped.
    [[nodiscard]] const std::vector<glm::mat4>& first_steps() const { return first_steps_; }

private:
    std::vector<glm::vec2> copy(std::span<const glm::vec2> places)
    {
        if (places.size() > maximum_places - places_)
            throw std::length_error("more than 100,000 places of lines and triangles: is the size of each list right?");
        places_ += places.size();
        return {places.begin(), places.end()};
    }

    Call& add(Call::Kind kind)
    {
        if (calls_.size() == maximum_calls)
            throw std::length_error(
                "more than 20,000 calls of the pipeline: does the drawing function come to an end?");
        return calls_.emplace_back(Call{kind, modelview_, color_, line_width_, {}, {}});
    }

    glm::dmat4 modelview_;
    std::vector<glm::dmat4> stack_;
    glm::vec3 color_;
    float line_width_;
    glm::vec3 background_;
    std::vector<Call> calls_;
    std::vector<glm::mat4> first_steps_;
    std::size_t places_ = 0;
};

/// "RecordingPipeline pipeline({.modelview = …, …});"
inline std::string code_of(const Start& start)
{
    const auto exact = [](const auto& value) { return literal::of_value(value, false, literal::in_full); };
    if (start.modelview == glm::mat4(1) && start.color == glm::vec3(1) && start.depth == 0)
        return "RecordingPipeline pipeline;";
    return "RecordingPipeline pipeline({.modelview = " + exact(start.modelview) + ", .color = " + exact(start.color) +
           ", .line_width = " + exact(start.line_width) + ", .background = " + exact(start.background) +
           ", .depth = " + exact(start.depth) + "});";
}

/// Questions about what is drawn with `pipeline` tell how it stands.
inline void introduce(Recorder& out, const Pipeline& pipeline, const Start& start)
{
    if (Questions* const questions = out.questions()) questions->set_object(&pipeline, "pipeline", code_of(start));
}

/// … and what draws the figure they hand over, a pipeline's marker, is called `name`.
inline void introduce(Recorder& out, const Figure& marker, const std::string& name)
{
    if (Questions* const questions = out.questions())
        questions->set_object(&marker, name, "const Figure " + name + " = pipeline.marker();");
}

}
