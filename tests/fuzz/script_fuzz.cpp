#include <umbral/input/script.hpp>

#include "fuzz.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace umbral;
    (void)tests::reads<std::invalid_argument>([&] {
        const input::EventScript script = input::parse_script(tests::text_of(data, size));
        const std::string written = input::to_text(script);
        // What was read once must not be refused, or be another script, when it is written down.
        bool again = tests::reads<std::invalid_argument>([&] {
            tests::expect(input::to_text(input::parse_script(written)) == written,
                          "written and read back, the script is another");
        });
        tests::expect(again, "written down, the script is refused");
    });
    return 0;
}
