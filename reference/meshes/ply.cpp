// Based on: G. Turk. The PLY Polygon File Format. Stanford University, 1994.

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <set>
#include <umbral/meshes/ply.hpp>
#include <umbral/meshes/ply_types.hpp>

namespace umbral::meshes {
namespace {

constexpr std::string_view format_names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
constexpr std::string_view blanks = " \t\r";
constexpr auto native = std::endian::native == std::endian::big ? PlyFormat::big_endian : PlyFormat::little_endian;

enum class Role { x, y, z, corners, none };  ///< what a property is to the mesh

struct Property {
    std::string_view name;
    PlyType type;
    std::optional<PlyType> length_type;  ///< of a list
    Role role = Role::none;
};

struct Element {
    std::string_view name;
    double count;
    std::vector<Property> properties;
};

struct Header {
    std::optional<PlyFormat> format;
    std::vector<Element> elements;
    double vertices = 0;  ///< how many
};

/// Whether a decimal that no float or double comes near is too small, and not too large: where its first digit other
/// than 0 stands, counted from the point that its exponent moves. No exponent is too long for this.
bool is_tiny(std::string_view word)
{
    const std::size_t e = std::min(word.find_first_of("eE"), word.size());
    const auto first = static_cast<double>(word.find_first_of("123456789"));
    const auto point = static_cast<double>(std::min(word.find('.'), e));
    double exponent = 0;
    for (const char c : word.substr(e))
        if (c >= '0' && c <= '9') exponent = 10 * exponent + (c - '0');
    return point - first + (word.substr(e).find('-') == std::string_view::npos ? exponent : -exponent) < 0;
}

/// The nearest number of the type, if the whole word is one that it has room for.
template <class Number>
std::optional<double> parsed(std::string_view word)
{
    if (word.starts_with('+') && !word.starts_with("+-")) word.remove_prefix(1);
    // Types without negative numbers have a -0 all the same.
    if (std::is_unsigned_v<Number> && word.starts_with("-0") && word.find_first_not_of('0', 1) == word.npos)
        word.remove_prefix(1);
    Number number{};
    const char* const last = word.data() + word.size();
    const auto [end, error] = std::from_chars(word.data(), last, number);
    if (end != last || error == std::errc::invalid_argument) return std::nullopt;
    if (error == std::errc()) return static_cast<double>(number);
    return std::is_floating_point_v<Number> && is_tiny(word) ? std::optional(0.0) : std::nullopt;
}

/// The file, read from its beginning to its end: lines of words, and from where it is binary, bytes.
class File {
public:
    explicit File(std::string_view text) : text_(text) {}
    [[nodiscard]] std::string_view line() const { return line_.substr(0, 40); }  ///< as far as errors show it
    bool next_line()
    {
        if (next_ == text_.size()) return false;
        line_ = words_ = text_.substr(next_, text_.substr(next_).find('\n'));
        next_ = std::min(next_ + line_.size() + 1, text_.size());
        ++place_;
        return true;
    }

    /// Takes the next word off the line; empty if there is none.
    std::string_view word()
    {
        words_.remove_prefix(std::min(words_.find_first_not_of(blanks), words_.size()));
        const std::string_view word = words_.substr(0, words_.find_first_of(blanks));
        words_.remove_prefix(word.size());
        return word;
    }

    void begin_data(PlyFormat format) { binary_ = format != PlyFormat::ascii, swap_ = format != native; }
    void begin_element()
    {
        if (!binary_ && !next_line_with_words()) refuse(PlyProblem::truncated, "as much data as the header promises");
    }
    void end_element()
    {
        if (!word().empty()) refuse(PlyProblem::line_length, "fewer numbers", line());
    }

    /// The next number: a double holds the values of all types exactly.
    double number(PlyType type) { return binary_ ? bytes(type) : decimal(type); }
    /// The number that came last, as it stands in the file.
    [[nodiscard]] std::string shown(double x) const { return binary_ ? std::to_string(x) : std::string(last_word_); }

    void end_data()
    {
        if (binary_) place_ = next_;
        if (binary_ ? next_ < text_.size() : next_line_with_words())
            refuse(PlyProblem::left_over, "the end of the file: its header promises no more");
    }

    [[noreturn]] void refuse(PlyProblem problem, const char* expected, std::string_view got = {}) const
    {
        std::string text = (binary_ ? "byte " : "line ") + std::to_string(place_) + ": expected " + expected;
        if (!got.empty()) text += ", got '" + std::string(got) + "'";
        throw PlyError(problem, place_, text);
    }

private:
    bool next_line_with_words()
    {
        while (next_line())
            if (line_.find_first_not_of(blanks) != std::string_view::npos) return true;
        return false;
    }

    double decimal(PlyType type)
    {
        const std::string_view text = last_word_ = word();
        if (text.empty()) refuse(PlyProblem::line_length, "more numbers", line());
        const auto number = with_ply_type(type, [text](auto zero) { return parsed<decltype(zero)>(text); });
        if (!number) refuse(PlyProblem::number, "a number of the property's type", text);
        return *number;
    }

    double bytes(PlyType type)
    {
        place_ = next_;
        return with_ply_type(type, [this](auto number) {
            std::array<char, sizeof number> bytes{};
            next_ += text_.copy(bytes.data(), bytes.size(), next_);
            if (next_ - place_ < bytes.size()) refuse(PlyProblem::truncated, "as much data as the header promises");
            if (swap_) std::reverse(bytes.begin(), bytes.end());
            return static_cast<double>(std::bit_cast<decltype(number)>(bytes));
        });
    }

    std::string_view text_, line_, words_, last_word_;
    std::size_t next_ = 0;   ///< the byte after the line, or after the last number
    std::size_t place_ = 0;  ///< for errors: the line, or where the last number begins
    bool binary_ = false, swap_ = false;
};

void assign_roles(Header& header, const File& file)
{
    int coordinates = 0;
    bool has_corners = true;
    for (Element& element : header.elements) {
        if (element.name == "vertex") header.vertices = element.count;
        if (element.name == "face") has_corners = false;
        for (Property& property : element.properties) {
            const std::string_view name = property.name;
            if (element.name == "vertex" && !property.length_type && (name == "x" || name == "y" || name == "z"))
                property.role = static_cast<Role>(name[0] - 'x'), ++coordinates;
            else if (element.name == "face" && !has_corners && property.length_type &&
                     (name == "vertex_index" || name == "vertex_indices"))
                property.role = Role::corners, has_corners = true;
        }
    }
    if (coordinates < 3) file.refuse(PlyProblem::missing_property, "an element 'vertex' with properties x, y and z");
    if (!has_corners)
        file.refuse(PlyProblem::missing_property, "a list 'vertex_index' or 'vertex_indices' of the element 'face'");
}

Header read_header(File& file)
{
    Header header;
    std::set<std::string_view> elements, properties;  // names
    const auto require = [&](bool holds, const char* expected) {
        if (!holds) file.refuse(PlyProblem::header, expected, file.line());
    };
    if (!file.next_line() || file.word() != "ply" || !file.word().empty())
        file.refuse(PlyProblem::not_ply, "'ply'", file.line());
    for (std::string_view keyword; keyword != "end_header";) {
        require(file.next_line(), "'end_header' before the file ends");
        keyword = file.word();
        if (keyword == "comment" || keyword == "obj_info") continue;
        if (keyword == "format") {
            const auto place = std::ranges::find(format_names, file.word()) - format_names;
            require(place < std::ssize(format_names) && file.word() == "1.0" && !header.format,
                    "once 'format ascii 1.0', or binary_little_endian, or binary_big_endian");
            header.format = static_cast<PlyFormat>(place);
        } else if (keyword == "element") {
            const std::string_view name = file.word();
            const auto count = parsed<std::int64_t>(file.word());
            require(count >= 0.0 && elements.insert(name).second, "'element', a new name and a count");
            header.elements.push_back({name, *count, {}});
            properties.clear();
        } else if (keyword == "property") {
            std::string_view word = file.word();
            const bool is_list = word == "list";
            const auto length_type = is_list ? ply_type(file.word()) : std::nullopt;
            const auto type = ply_type(is_list ? file.word() : word);
            word = file.word();
            require(!header.elements.empty(), "an element before its properties");
            require(type && is_list == length_type.has_value() && !(length_type >= PlyType::float32) && !word.empty() &&
                        properties.insert(word).second,
                    "'property', a type and a new name, or 'property list', an integer type, a type and a new name");
            header.elements.back().properties.push_back({word, *type, length_type});
        } else {
            require(keyword == "end_header", "'format', 'element', 'property', 'comment', 'obj_info' or 'end_header'");
        }
        require(file.word().empty(), "a shorter line");
    }
    require(header.format.has_value(), "a line 'format' before the header's end");
    assign_roles(header, file);
    file.begin_data(*header.format);
    return header;
}

/// `face` is room that all faces share until their length is known.
void read_list(File& file, const Property& property, double vertices, std::vector<std::uint32_t>& face,
               PolygonMesh& mesh)
{
    // The list grows as its numbers come: the length may be a lie.
    const double length = file.number(*property.length_type);
    if (length < 0) file.refuse(PlyProblem::number, "a list of length 0 or more", file.shown(length));
    face.clear();
    for (double i = 0; i < length; ++i) {
        const double value = file.number(property.type);
        if (property.role != Role::corners) continue;
        if (!(value >= 0 && value < std::min(vertices, 0x1p32)) || value != std::floor(value))
            file.refuse(PlyProblem::index, "a vertex, counted from 0", file.shown(value));
        face.push_back(static_cast<std::uint32_t>(value));
    }
    if (property.role == Role::corners) mesh.faces.push_back(face);
}

}

PolygonMesh read_ply(std::span<const std::byte> bytes)
{
    File file({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    const Header header = read_header(file);
    PolygonMesh mesh;
    std::vector<std::uint32_t> face;
    for (const Element& element : header.elements) {
        // Without properties an element takes no room, whatever its count. The others end with the file at the latest.
        const double count = element.properties.empty() ? 0 : element.count;
        for (double i = 0; i < count; ++i) {
            std::array<float, 5> by_role{};
            file.begin_element();
            for (const Property& property : element.properties) {
                if (property.length_type)
                    read_list(file, property, header.vertices, face, mesh);
                else
                    by_role[static_cast<std::size_t>(property.role)] = static_cast<float>(file.number(property.type));
            }
            file.end_element();
            if (element.name == "vertex") mesh.positions.emplace_back(by_role[0], by_role[1], by_role[2]);
        }
    }
    file.end_data();
    return mesh;
}

std::string write_ply(const PolygonMesh& mesh, PlyFormat format)
{
    const bool is_short = std::ranges::all_of(mesh.faces, [](const auto& face) { return face.size() < 256; });
    std::string file = "ply\nformat " + std::string(format_names[static_cast<int>(format)]) + " 1.0\nelement vertex " +
                       std::to_string(mesh.positions.size()) +
                       "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                       std::to_string(mesh.faces.size()) + "\nproperty list " + (is_short ? "uchar" : "uint") +
                       " uint vertex_indices\nend_header\n";
    // In ASCII with a character after each number.
    const auto put = [&]<class Number>(Number number, char after) {
        if (format == PlyFormat::ascii) {
            char digits[32];
            file.append(digits, std::to_chars(digits, digits + sizeof digits, number).ptr) += after;
        } else {
            auto bytes = std::bit_cast<std::array<char, sizeof number>>(number);
            if (format != native) std::reverse(bytes.begin(), bytes.end());
            file.append(bytes.data(), bytes.size());
        }
    };
    for (const glm::vec3& position : mesh.positions)
        for (int axis = 0; axis < 3; ++axis) put(position[axis], axis < 2 ? ' ' : '\n');
    for (const std::vector<std::uint32_t>& face : mesh.faces) {
        const auto after = [&](std::size_t numbers) { return numbers < face.size() ? ' ' : '\n'; };
        is_short ? put(static_cast<std::uint8_t>(face.size()), after(0))
                 : put(static_cast<std::uint32_t>(face.size()), after(0));
        for (std::size_t i = 0; i < face.size(); ++i) put(face[i], after(i + 1));
    }
    return file;
}

}
