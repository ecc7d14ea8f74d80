#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <umbral/core/random.hpp>
#include <umbral/record/changes.hpp>
#include <umbral/record/features.hpp>
#include <umbral/record/tensor.hpp>
#include <vector>

namespace umbral {

/// What a run is to tell of its questions beside what it records: nothing, unless something went wrong and the grader
/// asks a trusted solution.
struct Inquiry {
    bool questions = false;               ///< which question led to which row, and the numbers in it
    bool blocks = false;                  ///< through which blocks of counted code each went (block_trace.hpp)
    std::vector<std::uint32_t> wanted{};  ///< questions, counted from 0, that are written as code
    bool in_full = false;                 ///< … with all elements of their lists
    /// Asked in place of the driver's own, each in all calls of its function: the case runs once for each, and what it
    /// records is called "0?name", "1?name" and so on.
    std::vector<OtherQuestion> others{};
    Grain grain{};                        ///< of the case's random numbers
    std::optional<std::uint32_t> stop{};  ///< at this question question_reached() is called: for debuggers
};

/// Names of what a recording holds of questions; no driver's own begin with '?'.
namespace question_names {
inline constexpr std::string_view rows = "?rows ";    ///< + value: a question for each row, counted from 1; 0: none
inline constexpr std::string_view whole = "?whole ";  ///< + value: first question and how many led to a picture
/// + value: rows "first question, how many, x, y, width, height, columns of the picture" of rectangles
inline constexpr std::string_view tiles = "?tiles ";
inline constexpr std::string_view code = "?code";            ///< lines "number<TAB>code"
inline constexpr std::string_view functions = "?functions";  ///< lines "function<TAB>feature<TAB>…"
inline constexpr std::string_view features = "?features ";   ///< + line of ?functions: rows "question, features …"
/// The same two of answers: how many elements the lists in them have, called by their places in what was returned, or
/// in the arguments.
inline constexpr std::string_view sized = "?sized";
inline constexpr std::string_view sizes = "?sizes ";
inline constexpr std::string_view others = "?others";        ///< lines "function<TAB>place<TAB>change<TAB>other place"
inline constexpr std::string_view moves = "?moves";          ///< the same, of small changes
inline constexpr std::string_view histories = "?histories";  ///< lines "function<TAB>what changed its objects<TAB>…"
inline constexpr char of_other = '?';  ///< between the number of an other question and a recorded name
/// What `value` is called where the other question of this number is asked.
[[nodiscard]] inline std::string with_other(std::size_t number, std::string_view value)
{
    return std::to_string(number) + of_other + std::string(value);
}
inline constexpr char line_break = '\x1F';  ///< in code; texts in it are escaped, and hold no such letter
}

/// Where a debugger stops: the student's function is called next.
void question_reached();

/// Takes down what a run is asked: calls, one after the other, and which of them led to which rows.
class Questions {
public:
    /// With another question, that is asked in place of the driver's.
    explicit Questions(Inquiry inquiry, const std::optional<OtherQuestion>& other = {}) : inquiry_(std::move(inquiry))
    {
        if (other) instead_.emplace(*other);
    }

    [[nodiscard]] const Inquiry& inquiry() const noexcept { return inquiry_; }

    /// May another question be asked in place of a call of the function?
    [[nodiscard]] bool asks_instead_of(std::string_view function) const
    {
        return instead_ && instead_->means(function);
    }

    /// Has `noted` called whenever a question begins.
    void at_each_question(std::function<void()> noted) { noted_ = std::move(noted); }

    /// Has `left` called whenever an exception ends a question.
    void at_each_exception(std::function<void()> left) { left_ = std::move(left); }

    /// The next question begins. Rows that are recorded from now on are its answers.
    void begin();
    /// Is the current one to be written as code?
    [[nodiscard]] bool code_is_wanted() const;
    /// An exception ends the question.
    void leave() const
    {
        if (left_) left_();
    }
    void set_code(std::string_view code);
    /// Has `function` been introduced?
    [[nodiscard]] bool knows(std::string_view function) const;
    /// Takes what the numbers in calls of `function` are called, and what could be asked in place of them. Once.
    void introduce(std::string_view function, const Features& features, std::span<const Part> parts);
    /// The current question, a call of `function`, returns nothing and may change its object: it can be left out.
    void may_leave_out(std::string_view function);
    /// Is a call of the function not to be made?
    [[nodiscard]] bool leaves_out(std::string_view function) const
    {
        return instead_ && instead_->leaves_out(function);
    }
    /// Takes the numbers in the current question, a call of `function`.
    void set_features(std::string_view function, const Features& features);
    /// Are the lists in what `function` answers known by their names?
    [[nodiscard]] bool knows_sizes(std::string_view function) const;
    /// Takes how long the lists in the answer to the current question are, a call of `function`; the first time with
    /// their names.
    void set_sizes(std::string_view function, const Features& sizes);
    /// Asks the other question: changes the arguments of the current one, a call of `function`.
    void change(std::string_view function, std::span<const Part> parts) { instead_->change(function, parts); }

    /// `object` is called `name` in code from now on, and was made by this line; what had the name before is gone.
    void set_object(const void* object, std::string_view name, std::string made);
    /// What `object` is called, or nothing.
    [[nodiscard]] std::string name_of(const void* object) const;
    [[nodiscard]] bool is_object(const void* address) const { return objects_.contains(address); }
    /// The lines that brought all objects where they are, in the order in which they were called: what an object does
    /// may depend on what was done to another. Of each object only the last lines unless in full.
    [[nodiscard]] std::string history() const;
    /// One more line that changed it.
    void add_line(const void* object, std::string line);
    /// Calls of `function` made an object, or may have changed one.
    void note_change(std::string_view function);
    /// The current question, a call of `function`, is to an object: what it answers may come of all changes so far.
    void note_object(std::string_view function);

    /// A row was added to the table `value`, or the picture `value` was recorded whole.
    void link_row(std::string_view value);
    void link_whole(std::string_view value);

    /// The last questions led to this rectangle of the picture `value`, which is recorded later.
    void link_tile(std::string_view value, int x, int y, int width, int height, std::uint32_t questions);

    /// Adds what was taken down to a recording's tensors.
    void write(std::map<std::string, Tensor, std::less<>>& tensors) const;

private:
    struct Function;
    struct Line {
        std::size_t number;  ///< among all objects' lines
        std::string text;
    };
    struct Object {
        std::string name;
        std::vector<Line> lines;
        std::size_t left_out = 0;  ///< behind the first line
    };
    struct Function {
        std::string name;
        std::vector<std::string> features;
        std::vector<double> table;  ///< question, features, row by row
    };

    void add_numbers(Function& function, const Features& features) const;
    static void write_tables(const std::vector<Function>& functions, std::string_view names, std::string_view table,
                             std::map<std::string, Tensor, std::less<>>& tensors);

    Inquiry inquiry_;
    std::function<void()> noted_{};
    std::function<void()> left_{};
    std::optional<AskedInstead> instead_;
    std::uint32_t count_ = 0;       ///< of questions begun
    std::uint32_t whole_from_ = 0;  ///< the questions that the last picture answered: from this one …
    std::uint32_t whole_to_ = 0;    ///< … to the one before this
    std::string code_;
    std::vector<Function> functions_;
    std::vector<Function> sized_;  ///< with the lists in their answers in the place of features
    std::string others_;
    std::string moves_;
    std::map<const void*, Object> objects_;
    std::set<std::string, std::less<>> may_be_left_out_;  ///< functions
    std::set<std::string, std::less<>> changing_;         ///< functions that made objects or changed them
    std::map<std::string, std::set<std::string, std::less<>>, std::less<>> histories_;
    std::size_t lines_ = 0;  ///< of all objects
    std::map<std::string, std::vector<std::uint32_t>, std::less<>> rows_;
    std::map<std::string, std::pair<std::uint32_t, std::uint32_t>, std::less<>> wholes_;
    std::map<std::string, std::vector<std::array<std::uint32_t, 6>>, std::less<>> tiles_;
};

/// Tells when the call that it stands before ends by an exception.
class EndOfCall {
public:
    explicit EndOfCall(const Questions& questions) : questions_(questions) {}
    EndOfCall(const EndOfCall&) = delete;
    EndOfCall& operator=(const EndOfCall&) = delete;
    ~EndOfCall()
    {
        if (std::uncaught_exceptions() > before_) questions_.leave();
    }

private:
    const Questions& questions_;
    int before_ = std::uncaught_exceptions();
};

}
