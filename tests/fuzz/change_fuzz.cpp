#include "fuzz.hpp"
#include "model/change.hpp"

// A text to change, a byte 0, and the change.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace umbral;
    const std::string_view all = tests::text_of(data, size);
    const std::size_t zero = all.find('\0');
    const std::string base(all.substr(0, zero));
    const std::string text(zero == std::string_view::npos ? std::string_view() : all.substr(zero + 1));
    (void)grader::solution_header(text);
    (void)tests::reads<std::runtime_error>([&] {
        const grader::Change change = grader::parse_change(text, "x.change");
        const std::string changed = grader::apply_change(change, base, "x.change");
        std::size_t most = base.size();
        for (const auto& step : change.steps) most += step.after.size();
        tests::expect(changed.size() <= most, "more text than was given");
    });
    return 0;
}
