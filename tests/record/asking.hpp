#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <umbral/core/ray.hpp>
#include <umbral/record/ask.hpp>

namespace umbral::sample {

// As a unit's header declares them.
struct Ball {
    glm::vec3 centre;
    float radius;
};
enum class Side { front, back };
class Counter {
public:
    virtual ~Counter() = default;
    virtual void add(int amount) = 0;
    [[nodiscard]] virtual int total() const = 0;
};

inline std::optional<float> meet(const Ray& ray, const Ball& ball)
{
    return ray.direction.z < 0 ? std::optional(ball.radius) : std::nullopt;
}
inline float sum(std::span<const float> numbers, Side side)
{
    float result = side == Side::back ? 100.0F : 0.0F;
    for (const float number : numbers) result += number;
    return result;
}
inline bool is_odd(bool odd) { return odd; }
inline void append_twice(float value, std::vector<float>& to) { to.insert(to.end(), 2, value); }

struct Shape {
    std::vector<glm::vec2> corners;
    std::string name;
    glm::vec3 color{};
};
inline Shape shape_of(int corners)
{
    return {std::vector<glm::vec2>(static_cast<std::size_t>(corners)), std::to_string(corners), {}};
}

using Step = std::function<void(Counter&)>;
inline void take_steps(Counter& counter, const Step& step, int count)
{
    for (int i = 0; i < count; ++i) step(counter);
}

inline std::unique_ptr<Counter> make_counter(int first)
{
    class Real : public Counter {
    public:
        explicit Real(int first) : total_(first) {}
        void add(int amount) override { total_ += amount; }
        [[nodiscard]] int total() const override { return total_; }

    private:
        int total_;
    };
    return std::make_unique<Real>(first);
}

/// Keeps a reference to what it is made of, as a wrong solution may.
inline std::unique_ptr<const void*> make_keeper(const std::shared_ptr<int>& number)
{
    return std::make_unique<const void*>(&number);
}

}

namespace umbral {

using namespace sample;

/// What a driver's case leaves in a recording that takes down questions.
template <class Case>
Recorder::Tensors asked(const Inquiry& inquiry, const Case& run, const std::optional<OtherQuestion>& other = {})
{
    Questions questions(inquiry, other);
    Recorder out(questions);
    run(out);
    Recorder::Tensors tensors = out.tensors();
    questions.write(tensors);
    return tensors;
}

inline std::string text(const Recorder::Tensors& tensors, std::string_view name)
{
    const Tensor& tensor = tensors.find(name)->second;
    std::string text(reinterpret_cast<const char*>(tensor.bytes.data()), tensor.bytes.size());
    std::ranges::replace(text, question_names::line_break, '|');
    return text;
}

template <class Number>
std::vector<Number> numbers(const Recorder::Tensors& tensors, std::string_view name)
{
    const Tensor& tensor = tensors.find(name)->second;
    std::vector<Number> result(tensor.count());
    std::memcpy(result.data(), tensor.bytes.data(), tensor.bytes.size());
    return result;
}

inline const Inquiry first_two{.questions = true, .wanted = {0, 1}};

}
