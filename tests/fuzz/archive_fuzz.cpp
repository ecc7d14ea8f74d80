#include "collect/archive.hpp"
#include "collect/file_names.hpp"
#include "collect/roster.hpp"
#include "collect/submission_id.hpp"
#include "collect/text_encoding.hpp"
#include "fuzz.hpp"
#include "model/caps.hpp"

// Texts that come with a class: what the unpacker printed for a hostile archive, names in it, a roster, a file in
// whatever encoding.
namespace {

using namespace umbral;

void expect_harmless(const std::string& path)
{
    tests::expect(path.empty() || path.front() != '/', "an absolute path");
    for (std::size_t at = 0; at <= path.size();) {
        const std::size_t end = std::min(path.find('/', at), path.size());
        const std::string_view part = std::string_view(path).substr(at, end - at);
        tests::expect(part != ".." && part != ".", "a path that leads elsewhere");
        at = end + 1;
    }
}

}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string text(tests::text_of(data, size));
    for (const auto& [path, bytes] : grader::parse_unpacked(text).files) expect_harmless(path);
    expect_harmless(grader::harmless_path(text));
    (void)tests::reads<std::runtime_error>([&] {
        for (const grader::RosterEntry& entry : grader::parse_roster(text, "roster.csv"))
            tests::expect(grader::is_submission_id(entry.id), "an id that is none");
    });
    const std::string id = grader::derived_id(text);
    tests::expect(id.empty() || grader::is_submission_id(id), "a derived id that is none");
    (void)grader::file_key(text);
    (void)grader::folder_key(text);
    (void)grader::kind_of(text);
    tests::expect(grader::as_utf8(text).size() <= 3 * text.size() + 3, "more text than was given");
    return 0;
}
