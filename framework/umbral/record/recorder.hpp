#pragma once

#include <concepts>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <umbral/core/grid.hpp>
#include <umbral/record/progress.hpp>
#include <umbral/record/tensor.hpp>

namespace umbral {

class Questions;

/// How refusals are recorded: a text "<value>.refusals".
namespace refusals {
inline constexpr std::string_view suffix = ".refusals";
inline constexpr std::size_t most_bytes = 8192;
}

/// Takes down what a driver observes: raw outputs under names, never a verdict of its own.
///
/// What was recorded proves nothing, since the student's code shares the address space: the grader computes from it
/// everything that has a known right value. Throws std::logic_error if one name is used with two types or shapes.
class Recorder {
public:
    using Tensors = std::map<std::string, Tensor, std::less<>>;

    Recorder() = default;
    /// Takes down in `questions` which of them led to what, too; it must live as long.
    explicit Recorder(Questions& questions) : questions_(&questions) {}
    /// Tells how far the run comes, and passes over questions; `progress` must live as long.
    explicit Recorder(Progress& progress) : progress_(&progress) {}

    /// Adds one row to the table called `name`.
    void append(std::string_view name, float value);
    void append(std::string_view name, double value);
    void append(std::string_view name, std::int32_t value);
    void append(std::string_view name, std::uint32_t value);
    void append(std::string_view name, glm::vec2 value);
    void append(std::string_view name, glm::vec3 value);
    void append(std::string_view name, glm::vec4 value);
    void append(std::string_view name, glm::dvec2 value);
    void append(std::string_view name, const glm::mat3& value);
    void append(std::string_view name, const glm::mat4& value);
    /// An answer to a question of yes and no: 1 or 0, which reports tell with the words true and false.
    template <std::same_as<bool> Answer>
    void append(std::string_view name, Answer value)
    {
        columns(name, std::string(name) + " (0: false; 1: true)");
        append(name, std::int32_t{value});
    }
    /// A row that may have no value; that is another observation than any number. Other rows of its table always have
    /// one.
    void append(std::string_view name, std::optional<float> value);
    void append(std::string_view name, const std::optional<glm::vec2>& value);
    void append(std::string_view name, const std::optional<glm::vec3>& value);
    void append(std::string_view name, const std::optional<glm::vec4>& value);
    void append(std::string_view name, const std::optional<glm::dvec2>& value);
    void append(std::string_view name, const std::optional<glm::dvec3>& value);
    void append(std::string_view name, const std::optional<glm::ivec2>& value);
    void append(std::string_view name, const std::optional<glm::mat4>& value);

    /// A row of as many numbers as the table's first one, at least one: a fragment or an event, say.
    void append(std::string_view name, std::span<const float> row);

    /// Says what the numbers in the rows of the table `name` are called, in their order, for reports: "red, width";
    /// "colour/4" stands for four numbers of one name, and "kind (0: none; 1: label)" gives values words. As often as
    /// it is convenient: the first time counts. Without it rows of two to four numbers are x, y, z, w, and others have
    /// no names.
    void columns(std::string_view name, std::string_view names);

    /// The next row of the table `name` stands for no answer: the unit refused what it was asked, and said `why`. What
    /// is recorded there is the author's choice (NaN, say); reports show the refusal.
    void refused(std::string_view name, std::string_view why);

    /// Records a text, byte by byte, under a name not used before: a trace of calls, say, one a line.
    void text(std::string_view name, std::string_view text);

    /// Records a whole picture or buffer under a name not used before.
    void image(std::string_view name, const Grid<glm::u8vec4>& picture);
    void image(std::string_view name, const Grid<glm::vec3>& picture);
    void buffer(std::string_view name, const Grid<std::uint32_t>& cells);
    void buffer(std::string_view name, const Grid<float>& cells);
    /// A rectangle of the picture or buffer `name`, which is recorded later, is the answer to the last question, or to
    /// the last few: where a picture is put together of tiles, each with questions of its own.
    void tile(std::string_view name, int x, int y, int width, int height, unsigned questions = 1);

    [[nodiscard]] const Tensors& tensors() const noexcept { return tensors_; }
    /// Where questions are taken down (ask.hpp); null where nobody wants to know them.
    [[nodiscard]] Questions* questions() const noexcept { return questions_; }
    /// A question that nobody takes down begins, a call of `function`. True if it must not be asked.
    [[nodiscard]] bool passes_over(std::string_view function)
    {
        return progress_ != nullptr && progress_->begin(function);
    }
    /// Ends the case before a question that must not be asked, and has no empty answer.
    void end_case() const { progress_->end(); }
    /// Adds refusals, and what was taken down of questions, to the tensors: called once, at the end.
    void finish();

private:
    Tensor& row(std::string_view name, Element element, std::uint32_t components, bool optional);
    template <class Value>
    void optional_row(std::string_view name, Element element, const std::optional<Value>& value);
    void whole(std::string_view name, Element element, int width, int height, std::uint32_t components,
               const void* data);

    Tensors tensors_;
    std::map<std::string, std::string, std::less<>> refusals_;  ///< of tables, lines "row<TAB>why"
    Questions* questions_ = nullptr;
    Progress* progress_ = nullptr;
};

}
