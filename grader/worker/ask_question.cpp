#include "worker/ask_question.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "build/compile.hpp"
#include "judge/rows/tensor_view.hpp"
#include "model/scratch.hpp"
#include "text/printable.hpp"
#include "worker/case_results.hpp"

namespace umbral::grader {
namespace {

constexpr const char* file_name = "question";                ///< as diagnostics call it
constexpr std::size_t most_answer = std::size_t{64} << 10U;  ///< letters

/// The driver's text. The question is a file of its own, so that diagnostics count and show its lines.
std::string driver_text(const Exercise& exercise)
{
    std::string topic = exercise.topic;
    std::ranges::replace(topic, '-', '_');
    return fmt::format(R"(#include <cstdlib>
#include <cxxabi.h>
#include <exception>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <string>
#include <typeinfo>
#include <umbral/record/driver.hpp>
#include <umbral/record/features.hpp>
#include <umbral/record/literal.hpp>
#include <variant>
namespace umbral::{0} {{}}
namespace umbral {{
namespace {{
using namespace {0};
template <class Value>
void tell(Recorder& out, const Value& result)
{{
    out.text("answer", literal::of_value(result, true, literal::in_full));
    Features features;
    const auto add = [&features](const auto& value) {{
        if constexpr (!literal::detail::is_optional<std::remove_cvref_t<decltype(value)>>)
            add_features(Place{{}}, value, features);
        else if (value)
            add_features(Place{{}}, *value, features);
    }};
    add(result);
    std::string names;
    for (std::size_t i = 0; i < features.values.size(); ++i) {{
        names += features.names[i] + '\n';
        out.append("numbers", features.values[i]);
    }}
    out.text("names", names);
}}
template <class... Values>
void tell(Recorder& out, const std::variant<Values...>& result)
{{
    std::visit([&out](const auto& value) {{ tell(out, value); }}, result);
}}
void answer(Case&, Recorder& out)
{{
    try {{
        tell(out, __extension__({{
{1}
        ;}}));
    }} catch (const std::exception& refusal) {{
        // What it says is the solution's own.
        std::unique_ptr<char, decltype(&std::free)> name(
            abi::__cxa_demangle(typeid(refusal).name(), nullptr, nullptr, nullptr), &std::free);
        out.text("answer", std::string("throws ") + (name ? name.get() : "an exception"));
    }}
}}
}}
const Driver driver = {{{{"{2}", answer}}}};
}}
)",
                       topic, fmt::format("#include \"{}\"", file_name), asked_case);
}

/// "origin.x" of "0.origin.x", which is how a question's only argument is called; without the words of enumerators.
std::string name_of(std::string_view feature)
{
    feature = feature.substr(0, feature.find(Features::before_word));
    if (feature.starts_with('0')) feature.remove_prefix(1);
    if (feature.starts_with('.')) feature.remove_prefix(1);
    return std::string(feature);
}

Answer answer_in(const RunOutcome& run)
{
    if (run.verdict != Verdict::ok) return {false, fmt::format("{}: {}", in_words(run.verdict), run.message)};
    if (run.recording.not_implemented > 0) return {false, std::string(in_words(Verdict::not_implemented))};
    const auto tensor = [&](const char* name) {
        const auto found = run.recording.tensors.find(name);
        return found == run.recording.tensors.end() || !well_formed(found->second) ? nullptr : &found->second;
    };
    Answer answer{true, printable(text_of(tensor("answer")), most_answer)};
    if (const Tensor* numbers = tensor("numbers")) answer.numbers = to_doubles(*numbers);
    std::istringstream lines{std::string(text_of(tensor("names")))};
    for (std::string line; std::getline(lines, line);) answer.names.push_back(printable(name_of(line), 64));
    if (answer.names.size() != answer.numbers.size()) answer.names.clear(), answer.numbers.clear();
    return answer;
}

}

std::string not_askable(const Exercise& exercise)
{
    if (!exercise.is_cpp()) return "its shaders are drawn with, and not called";
    // Nor may the reference's shaders be asked for, which some of these functions return.
    if (exercise.gl_calls) return "its functions draw, and a question alone has nothing to draw on";
    return "";
}

namespace {

/// What a question alone has not, of a unit of which some functions need it.
std::string missing_beside(const Exercise& exercise)
{
    if (exercise.glfw) return "this function answers events, and a question alone has none\n";
    if (exercise.gl) return "this function draws, and a question alone has nothing to draw on\n";
    return "";
}

}

AskedQuestion ask_question(Worker& worker, const Exercise& exercise, const Built& built, const std::string& question)
{
    AskedQuestion asked;
    const ScratchFolder work(worker.tools().cache);
    const Compilation driver = compile_driver(
        worker.tools(), exercise, {{"driver.cpp", driver_text(exercise)}, {file_name, question + "\n"}}, work.path());
    if (!driver.library) {
        asked.refused = driver.diagnostics;
        return asked;
    }
    const RunOutcome reference = worker.answer(exercise, Answers::reference, *driver.library);
    asked.reference = answer_in(reference);
    // What a question lacks ends it at once; a question that is a loop, or fills the memory, lacks nothing.
    if (!asked.reference.given && !is_endless(reference, exercise.limits)) asked.refused = missing_beside(exercise);
    if (!asked.refused.empty()) return asked;
    if (std::ranges::any_of(exercise.checks, &Check::hard))
        asked.oracle = answer_in(worker.answer(exercise, Answers::oracle, *driver.library));
    asked.yours = answer_in(worker.answer(exercise, built, *driver.library));
    return asked;
}

}
