#include "store/kept_unit.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <span>
#include <umbral/core/png.hpp>

#include "model/digest.hpp"
#include "text/field.hpp"
#include "text/json_file.hpp"

namespace umbral::grader {
namespace {

namespace fs = std::filesystem;

// A file is a line of JSON with the result and the sizes and digest of what follows: the sections. One file, one
// rename: result and sections can never be of two gradings. The line alone is read where no page is made.
constexpr const char* unit_format = "umbral-unit";
constexpr std::size_t largest_file = std::size_t{1} << 30U;

struct Line {
    KeptUnit unit;
    std::size_t student = 0;
    std::size_t instructor = 0;
    std::string digest;
};

Line parse(const std::string& text, const std::string& where)
{
    const nlohmann::json json = parse_json(text, where);
    const Field field(json, where);
    field.allow_only({"format", "version", "key", "machine", "student", "instructor", "digest", "unit"});
    if (field.member("format").any_text(32) != unit_format || field.member("version").integer(1, 1) != 1)
        field.refuse("a kept result of this version");
    Line line;
    line.unit.key = field.member("key").any_text(64);
    line.unit.machine = field.member("machine").any_text(64);
    line.unit.result = unit_result_from_json(json.at("unit"), where);
    line.student = static_cast<std::size_t>(field.member("student").integer(0, largest_file));
    line.instructor = static_cast<std::size_t>(field.member("instructor").integer(0, largest_file));
    line.digest = field.member("digest").any_text(64);
    return line;
}

/// The file, if it is one: a pipe that somebody put there would be waited for.
std::ifstream opened(const fs::path& file)
{
    std::error_code none;
    return fs::is_regular_file(fs::symlink_status(file, none)) ? std::ifstream(file, std::ios::binary)
                                                               : std::ifstream();
}

/// The line of an open file, if the file has the size that it says.
std::optional<Line> read_line(std::ifstream& stream, const fs::path& file)
{
    if (!stream.is_open()) return std::nullopt;
    try {
        std::string text;
        if (!std::getline(stream, text) || stream.eof()) return std::nullopt;
        Line line = parse(text, file.string());
        if (fs::file_size(file) != text.size() + 1 + line.student + line.instructor) return std::nullopt;
        return line;
    } catch (const std::exception&) {  // damaged, or of another version: it is asked for again
        return std::nullopt;
    }
}

}

void keep_unit(const fs::path& file, const KeptUnit& unit, const UnitSections& sections)
{
    const std::string body = sections.student + sections.instructor;
    const nlohmann::json line{{"format", unit_format},
                              {"version", 1},
                              {"key", unit.key},
                              {"machine", unit.machine},
                              {"student", sections.student.size()},
                              {"instructor", sections.instructor.size()},
                              {"digest", sha256_hex(std::string_view(body))},
                              {"unit", to_json(unit.result)}};
    const std::string text = line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n" + body;
    write_file_atomically(file, std::as_bytes(std::span(text)));
}

std::optional<KeptUnit> kept_unit(const fs::path& file)
{
    std::ifstream stream = opened(file);
    std::optional<Line> line = read_line(stream, file);
    if (!line) return std::nullopt;
    return std::move(line->unit);
}

std::optional<UnitSections> kept_sections(const fs::path& file)
{
    std::ifstream stream = opened(file);
    const std::optional<Line> line = read_line(stream, file);
    if (!line) return std::nullopt;
    std::string body(line->student + line->instructor, '\0');
    if (!stream.read(body.data(), static_cast<std::streamsize>(body.size())) ||
        sha256_hex(std::string_view(body)) != line->digest)
        return std::nullopt;
    return UnitSections{body.substr(0, line->student), body.substr(line->student)};
}

}
