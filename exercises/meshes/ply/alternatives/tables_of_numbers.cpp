// alternative: every element becomes a table of rows of numbers, and the mesh is made of the tables at the end;
// decimals by streams in the classic locale; written with an exponent
#include <charconv>
#include <cmath>
#include <cstring>
#include <locale>
#include <set>
#include <sstream>
#include <umbral/meshes/ply.hpp>
#include <umbral/meshes/ply_types.hpp>

namespace umbral::meshes {
namespace {

[[noreturn]] void refuse(PlyProblem problem, std::size_t place, const std::string& word = "")
{
    throw PlyError(problem, place, "refused '" + word + "' at " + std::to_string(place));
}

struct Property {
    std::string name;
    PlyType type = PlyType::int8;
    std::optional<PlyType> length;
};

struct Element {
    std::string name;
    unsigned long long count = 0;
    std::vector<Property> properties;
};

std::vector<std::string> split(const std::string& line)
{
    std::vector<std::string> words(1);
    for (const char c : line + ' ') {
        if (c != ' ' && c != '\t' && c != '\r')
            words.back() += c;
        else if (!words.back().empty())
            words.emplace_back();
    }
    words.pop_back();
    return words;
}

bool only(const std::string& word, const char* letters) { return word.find_first_not_of(letters) == std::string::npos; }

template <class Number>
std::optional<double> parsed_as(const std::string& word)
{
    std::istringstream stream(word);
    stream.imbue(std::locale::classic());
    Number number{};
    if (!(stream >> number) || stream.peek() != std::istringstream::traits_type::eof()) return std::nullopt;
    return static_cast<double>(number);
}

std::optional<double> parsed(const std::string& word, PlyType type)
{
    const std::string digits = word.substr(!word.empty() && (word[0] == '+' || word[0] == '-') ? 1 : 0);
    if (type >= PlyType::float32) {
        const double sign = word[0] == '-' ? -1 : 1;
        if (digits == "inf") return sign * std::numeric_limits<double>::infinity();
        if (digits == "nan") return sign * std::numeric_limits<double>::quiet_NaN();
        return type == PlyType::float32 ? parsed_as<float>(word) : parsed_as<double>(word);
    }
    const std::optional<double> value = parsed_as<long long>(word);
    const bool fits = with_ply_type(type, [&](auto zero) {
        using Number = decltype(zero);
        return value && *value >= static_cast<double>(std::numeric_limits<Number>::lowest()) &&
               *value <= static_cast<double>(std::numeric_limits<Number>::max());
    });
    return fits ? value : std::nullopt;
}

struct Reader {
    const std::string file;
    std::size_t at = 0;
    std::size_t line = 0;
    PlyFormat format = PlyFormat::ascii;
    std::vector<Element> elements;

    std::optional<std::string> next_line()
    {
        if (at >= file.size()) return std::nullopt;
        const std::size_t end = std::min(file.find('\n', at), file.size());
        std::string text = file.substr(at, end - at);
        at = end + 1;
        ++line;
        return text;
    }

    void read_header()
    {
        std::set<std::string> names;
        bool has_format = false;
        if (split(next_line().value_or("")) != std::vector<std::string>{"ply"}) refuse(PlyProblem::not_ply, 1);
        while (true) {
            const auto text = next_line();
            if (!text) refuse(PlyProblem::header, line);
            std::vector<std::string> words = split(*text);
            const std::string keyword = words.empty() ? "" : words[0];
            if (keyword == "comment" || keyword == "obj_info") continue;
            if (keyword == "end_header" && words.size() == 1) break;
            bool good = false;
            if (keyword == "format" && words.size() == 3 && words[2] == "1.0" && !has_format) {
                has_format = good = true;
                if (words[1] == "binary_little_endian")
                    format = PlyFormat::little_endian;
                else if (words[1] == "binary_big_endian")
                    format = PlyFormat::big_endian;
                else
                    good = words[1] == "ascii";
            } else if (keyword == "element" && words.size() == 3 && only(words[2], "0123456789")) {
                const std::optional<double> count = parsed_as<long long>(words[2]);
                elements.push_back({words[1], static_cast<unsigned long long>(count.value_or(0)), {}});
                good = count && names.insert(words[1]).second;
            } else if (keyword == "property" && !elements.empty() &&
                       (words.size() == 3 || (words.size() == 5 && words[1] == "list"))) {
                const bool list = words.size() == 5;
                const auto type = ply_type(words[list ? 3 : 1]);
                const auto length = list ? ply_type(words[2]) : std::nullopt;
                good = type && (!list || (length && *length < PlyType::float32)) &&
                       names.insert(elements.back().name + ' ' + words.back()).second;
                if (good) elements.back().properties.push_back({words.back(), *type, length});
            }
            if (!good) refuse(PlyProblem::header, line);
        }
        if (!has_format) refuse(PlyProblem::header, line);
    }

    double binary(PlyType type)
    {
        return with_ply_type(type, [&](auto number) {
            char bytes[8];
            for (std::size_t i = 0; i < sizeof number; ++i) {
                if (at + i >= file.size()) refuse(PlyProblem::truncated, at);
                bytes[format == PlyFormat::little_endian ? i : sizeof number - 1 - i] = file[at + i];
            }
            std::memcpy(&number, bytes, sizeof number);
            at += sizeof number;
            return static_cast<double>(number);
        });
    }

    void read_row(const Element& element, std::size_t vertices, PolygonMesh& mesh)
    {
        std::vector<std::string> words;
        std::size_t next = 0;
        if (format == PlyFormat::ascii) {
            do {
                const auto text = next_line();
                if (!text) refuse(PlyProblem::truncated, line);
                words = split(*text);
            } while (words.empty());
        }
        std::size_t place = line;
        const auto number = [&](PlyType type) {
            if (format != PlyFormat::ascii) {
                place = at;
                return binary(type);
            }
            if (next == words.size()) refuse(PlyProblem::line_length, line);
            const auto value = parsed(words[next++], type);
            if (!value) refuse(PlyProblem::number, line, words[next - 1]);
            return *value;
        };
        glm::vec3 position(0);
        bool has_corners = false;
        for (const Property& property : element.properties) {
            if (!property.length) {
                const auto value = static_cast<float>(number(property.type));
                if (property.name == "x") position.x = value;
                if (property.name == "y") position.y = value;
                if (property.name == "z") position.z = value;
                continue;
            }
            const double length = number(*property.length);
            if (length < 0) refuse(PlyProblem::number, place);
            const bool corners = element.name == "face" && !has_corners &&
                                 (property.name == "vertex_index" || property.name == "vertex_indices");
            has_corners = has_corners || corners;
            if (corners) mesh.faces.emplace_back();
            for (double i = 0; i < length; ++i) {
                const double value = number(property.type);
                if (!corners) continue;
                if (!(value >= 0) || value >= static_cast<double>(vertices) || value != std::trunc(value))
                    refuse(PlyProblem::index, place, words.empty() ? "" : words[next - 1]);
                mesh.faces.back().push_back(static_cast<std::uint32_t>(value));
            }
        }
        if (next != words.size()) refuse(PlyProblem::line_length, line);
        if (element.name == "vertex") mesh.positions.push_back(position);
    }
};

}

PolygonMesh read_ply(std::span<const std::byte> bytes)
{
    Reader reader{{reinterpret_cast<const char*>(bytes.data()), bytes.size()}, 0, 0, PlyFormat::ascii, {}};
    reader.read_header();
    std::size_t vertices = 0;
    int coordinates = 0;
    for (const Element& element : reader.elements) {
        bool has_corners = element.name != "face";
        for (const Property& p : element.properties) {
            if (element.name == "vertex" && !p.length && (p.name == "x" || p.name == "y" || p.name == "z"))
                ++coordinates;
            if (p.length && (p.name == "vertex_index" || p.name == "vertex_indices")) has_corners = true;
        }
        if (!has_corners) refuse(PlyProblem::missing_property, reader.line);
        if (element.name == "vertex") vertices = element.count;
    }
    if (coordinates != 3) refuse(PlyProblem::missing_property, reader.line);
    PolygonMesh mesh;
    for (const Element& element : reader.elements)
        for (unsigned long long i = 0; i < element.count && !element.properties.empty(); ++i)
            reader.read_row(element, vertices, mesh);
    if (reader.format != PlyFormat::ascii && reader.at < reader.file.size()) refuse(PlyProblem::left_over, reader.at);
    while (reader.format == PlyFormat::ascii)
        if (const auto text = reader.next_line(); !text)
            break;
        else if (!split(*text).empty())
            refuse(PlyProblem::left_over, reader.line);
    return mesh;
}

std::string write_ply(const PolygonMesh& mesh, PlyFormat format)
{
    const std::string name = format == PlyFormat::ascii           ? "ascii"
                             : format == PlyFormat::little_endian ? "binary_little_endian"
                                                                  : "binary_big_endian";
    std::string file =
        "ply\nformat " + name + " 1.0\ncomment by a student\nelement vertex " + std::to_string(mesh.positions.size());
    file += "\nproperty float32 x\nproperty float32 y\nproperty float32 z\nelement face " +
            std::to_string(mesh.faces.size());
    file += "\nproperty list int32 uint32 vertex_indices\nend_header\n";
    const auto put = [&](std::uint32_t bits) {
        for (int i = 0; i < 4; ++i)
            file += static_cast<char>(bits >> (format == PlyFormat::little_endian ? 8 * i : 24 - 8 * i));
    };
    for (const glm::vec3& position : mesh.positions) {
        for (int axis = 0; axis < 3; ++axis) {
            if (format != PlyFormat::ascii) {
                std::uint32_t bits = 0;
                std::memcpy(&bits, &position[axis], 4);
                put(bits);
                continue;
            }
            // Always with an exponent: 5e-01, 1e+10.
            char word[32];
            char* const end = std::to_chars(word, word + 32, position[axis], std::chars_format::scientific).ptr;
            file += std::string(word, end) + (axis < 2 ? "\t" : "\r\n");
        }
    }
    for (const auto& face : mesh.faces) {
        std::vector<std::uint32_t> row{static_cast<std::uint32_t>(face.size())};
        row.insert(row.end(), face.begin(), face.end());
        for (const std::uint32_t number : row)
            format == PlyFormat::ascii ? void(file += std::to_string(number) + ' ') : put(number);
        if (format == PlyFormat::ascii) file += '\n';
    }
    return file;
}

}
