#include <nlohmann/json.hpp>

#include "fuzz.hpp"
#include "manifest/units.hpp"
#include "text/json_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace umbral;
    (void)tests::reads<std::runtime_error>([&] {
        const grader::Exercise exercise =
            grader::parse_exercise(parse_json(tests::text_of(data, size), "exercise.json"), "exercise.json");
        tests::expect(exercise.id == exercise.topic + "/" + exercise.name, "an id that is not its parts");
        for (const std::string& file : exercise.files)
            tests::expect(!file.empty() && file.find('/') == std::string::npos && file != "..",
                          "a file outside the unit's folder");
        tests::expect(!exercise.cases().empty() && exercise.points > 0, "a unit without work");
        grader::Millipoints sum = 0;
        for (const grader::Check& check : exercise.checks) sum += check.points;
        tests::expect(sum == exercise.points, "points that are not the sum of the checks'");
    });
    return 0;
}
