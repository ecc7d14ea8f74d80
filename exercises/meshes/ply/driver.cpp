#include <kit/row_of.hpp>
#include <kit/varied.hpp>
#include <umbral/meshes/ply.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "comma_locale.hpp"
#include "dialect.hpp"
#include "hard_numbers.hpp"
#include "malformed.hpp"
#include "models.hpp"
#include "own_file.hpp"
#include "reading_text.hpp"
#include "well_formed.hpp"
#include "written.hpp"

namespace umbral {
namespace {

using namespace meshes;

PolygonMesh read(Recorder& out, const std::string& file, const std::string& remark = "")
{
    ask_in_words(out, [&] { return remark + reading_text(file, out.questions()->inquiry().in_full); });
    return read_ply(std::as_bytes(std::span(file)));
}

/// What is refused is recorded as missing, and the next row of each of the tables as a refusal.
PolygonMesh read_or_nothing(Recorder& out, const std::string& file, std::initializer_list<const char*> tables,
                            const std::string& remark = "")
{
    try {
        return read(out, file, remark);
    } catch (const std::exception& refusal) {
        for (const char* const table : tables) out.refused(table, refusal.what());
        return {};
    }
}

/// The bits of x, y, z, x, …: what was lost shows in any of them, and NaN can be told from infinity. Any NaN will do.
void record_bits(Recorder& out, const PolygonMesh& mesh, std::size_t count)
{
    std::vector<std::uint32_t> bits;
    for (std::size_t i = 0; i < std::min(count, mesh.positions.size()); ++i)
        for (int axis = 0; axis < 3; ++axis) bits.push_back(bits_of(mesh.positions[i][axis]));
    append_rows(out, "bits", bits, 3 * count, [](std::uint32_t row) { return row; });
}

/// What came of a file that holds `expected`.
void record_read(Recorder& out, const std::string& file, const PolygonMesh& expected)
{
    const bool has_places = !expected.positions.empty();
    const PolygonMesh mesh =
        has_places ? read_or_nothing(out, file, {"positions", "faces"}) : read_or_nothing(out, file, {"faces"});
    for (std::size_t i = 0; i < expected.positions.size(); ++i) out.append("positions", row_of(mesh.positions, i));
    record_faces(out, mesh.faces, expected);
}

/// The course's example, and what a first file may have that it has not.
void record_known(Variation& vary, Recorder& out)
{
    PolygonMesh course{
        {{0, 0, 0}, {0, 0, 2}, {0, 1.3F, 1}, {0, 1.4F, 0}, {1.1F, 0, 0}, {1, 0, 2}, {1, 0.8F, 1.5F}, {0.5F, 1, 0}},
        {{0, 1, 2, 3}, {7, 6, 5, 4}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}}};
    const ExactMap map = vary.exact_map();
    for (glm::vec3& position : course.positions) position = map.place(position);
    course.faces = in_random_order(vary, course.faces);
    Random unused(1);
    Dialect dialect;
    dialect.corners_name = "vertex_index";
    record_read(out, written_in(dialect, course, unused), course);
    dialect.corners_name = "vertex_indices";
    dialect.line_end = "\r\n";
    record_read(out, written_in(dialect, course, unused), course);
    dialect.remarks = true;
    record_read(out, written_in(dialect, course, unused), course);
    const PolygonMesh cloud{{{1, 2, 3}, {-4, 5.5F, 6e-3F}}, {}};
    record_read(out,
                "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float "
                "z\nend_header\n1 2 3\n-4 5.5 6e-3\n",
                cloud);
    record_read(out,
                "ply\nformat ascii 1.0\nelement vertex 2\nproperty int x\nproperty short y\nproperty uchar "
                "z\nend_header\n16777217 -1 0\n+16777219 -32768 255\n",
                {{{16777216, -1, 0}, {16777220, -32768, 255}}, {}});
    for (const std::string& file : odd_files()) {
        const PolygonMesh mesh = varied_corners(vary);
        record_read(out, with_corners(commented(vary, file), mesh), mesh);
    }
    // More vertices than 16 bits count; of them all only the faces are recorded.
    std::string many =
        "ply\nformat ascii 1.0\nelement vertex 70000\nproperty float x\nproperty float y\nproperty float "
        "z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n";
    for (int i = 0; i < 70'000; ++i) many += "0 0 0\n";
    record_read(out, many + "3 0 65535 65536\n4 69999 65537 1 2\n", {{}, {{0, 65535, 65536}, {69999, 65537, 1, 2}}});
}

void record_dialects(std::initializer_list<PlyFormat> kinds, Random& random, Recorder& out)
{
    for (int i = 0; i < 60; ++i) {
        for (const PlyFormat format : kinds) {
            const PolygonMesh mesh = some_mesh(random);
            const Dialect dialect = some_dialect(format, random);
            record_read(out, written_in(dialect, mesh, random), mesh);
        }
    }
}

/// Numbers that hardly are floats.
void record_binary_numbers(Variation& vary, Recorder& out)
{
    for (const std::string& file : in_random_order(vary, binary_number_files()))
        record_bits(out, read_or_nothing(out, commented(vary, file), {"bits"}), 1);
}

void record_decimals(Variation& vary, Recorder& out)
{
    for (const auto& [word, file] : in_random_order(vary, decimal_files())) {
        PolygonMesh mesh = read_or_nothing(out, commented(vary, file), {"bits"});
        // A zero that came of what is too small may have either sign.
        if (word != "-0" && !mesh.positions.empty() && mesh.positions[0].x == 0) mesh.positions[0].x = 0;
        record_bits(out, mesh, 1);
    }
}

struct Outcome {
    std::uint32_t problem = 0;  ///< 0 for a file that was read, 99 for an exception that is no PlyError
    std::uint32_t place = missing;
    std::string text{};
};

Outcome outcome(Recorder& out, const std::string& file)
{
    try {
        (void)read(out, file);
        return {};
    } catch (const PlyError& error) {
        return {static_cast<std::uint32_t>(error.problem()),
                static_cast<std::uint32_t>(std::min<std::size_t>(error.place(), missing)), error.what()};
    } catch (const std::exception&) {
        return {99};
    }
}

/// Each bad file is paired with a good one, in either order, so that who refuses all, or every other one, earns
/// nothing.
void record_problems(Case& what, Recorder& out, const std::vector<Malformed>& written)
{
    Variation& vary = what.vary;
    out.columns("problems", problem_words());
    const std::vector<Malformed> files = in_random_order(vary, written);
    std::vector<std::string> good = odd_files();
    for (const std::string& file : empty_files()) good.push_back(file);
    for (std::size_t i = 0; i < files.size(); ++i) {
        const Malformed& bad = files[i];
        const bool bad_first = what.random.below(2) == 0;
        const std::string right = commented(vary, good[i % good.size()]);
        if (!bad_first) out.append("problems", outcome(out, right).problem);
        const auto [problem, place, text] = outcome(out, commented(vary, bad.file));
        const auto tells = [&text = text](const std::string& word) { return text.find(word) != std::string::npos; };
        out.append("problems", problem);
        if (bad.has_place) out.append("places", place);
        if (!bad.word.empty()) out.append("texts", tells(bad.word) && tells(std::to_string(place)) ? place : missing);
        if (bad_first) out.append("problems", outcome(out, right).problem);
    }
}

void record_in_locale(Random& random, Recorder& out)
{
    const PolygonMesh mesh{{{0.5F, -1.25F, 12345.5F}, {1e6F, 2e-3F, 1234567}}, {{0, 1, 0}}};
    const std::string file = written_in({}, mesh, random);
    const std::string remark = "// std::locale::global was given a decimal comma, and dots between thousands\n";
    const auto in_locale = [](const auto& work) {
        const CommaLocale locale;
        return work();
    };
    record_bits(out, in_locale([&] { return read_or_nothing(out, file, {"bits"}, remark); }), 2);
    ask_in_words(out, [&] {
        return remark + "write_ply(" + literal::of_value(mesh, true, literal::Style{}) + ", PlyFormat::ascii)";
    });
    const std::string written = in_locale([&] { return write_ply(mesh, PlyFormat::ascii); });
    append_rows(out, "bits", decoded(written, PlyFormat::ascii).position_bits, 6,
                [](std::uint32_t row) { return row; });
}

}

const Driver driver = {
    {"known", [](Case& c, Recorder& out) { record_known(c.vary, out); }},
    {"ascii", [](Case& c, Recorder& out) { record_dialects({PlyFormat::ascii}, c.random, out); }},
    {"binary",
     [](Case& c, Recorder& out) {
         record_dialects({PlyFormat::little_endian, PlyFormat::big_endian}, c.random, out);
     }},
    {"binary numbers", [](Case& c, Recorder& out) { record_binary_numbers(c.vary, out); }},
    {"decimals", [](Case& c, Recorder& out) { record_decimals(c.vary, out); }},
    {"headers", [](Case& c, Recorder& out) { record_problems(c, out, bad_headers()); }},
    {"data", [](Case& c, Recorder& out) { record_problems(c, out, bad_data(c.vary)); }},
    {"bytes", [](Case& c, Recorder& out) { record_problems(c, out, bad_binaries()); }},
    {"counts that lie", [](Case& c, Recorder& out) { record_problems(c, out, lying_counts()); }},
    {"writing",
     [](Case& c, Recorder& out) {
         record_writing(c.random, out);
         record_long_faces(c.random, out);
     }},
    {"locale", [](Case& c, Recorder& out) { record_in_locale(c.random, out); }},
    {"own file", [](Case& c, Recorder& out) { record_own_file(c, out); }},
    {"picture",
     [](Case& c, Recorder& out) {
         const PolygonMesh models[] = {football(), twisted_ring(c.vary.one_of(36U, std::array{24U, 28U, 44U})),
                                       knot(c.vary.one_of(72U, std::array{54U, 60U, 84U}))};
         std::vector<PolygonMesh> got;
         for (std::size_t i = 0; i < 3; ++i) {
             Dialect dialect;
             dialect.format = formats[i];
             got.push_back(read_or_nothing(out, written_in(dialect, models[i], c.random), {}));
         }
         out.image("models", picture_of(got));
     }},
};

}
