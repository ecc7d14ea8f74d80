#include "scenegraph/graph_file.hpp"

#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include "scene/values.hpp"
#include "text/json_file.hpp"

namespace umbral::scenegraph {
namespace {

using transforms::Entry;
using transforms::Primitive;

constexpr std::size_t maximum_bytes = std::size_t{8} << 20U;
constexpr std::size_t maximum_names = 10'000;
constexpr std::size_t maximum_entries = 10'000;
constexpr std::size_t maximum_corners = 10'000;
constexpr std::size_t maximum_name_length = 200;
constexpr double maximum_number = 1e6;

glm::vec3 vector(const Field& node) { return scene::vector3(node, -maximum_number, maximum_number); }

Shape parse_shape(const Field& node)
{
    node.allow_only({"primitive", "polygon"});
    const Field primitive = node.member("primitive");
    const Field polygon = node.member("polygon");
    if (primitive.given() == polygon.given()) node.refuse("either \"primitive\" or \"polygon\"");
    if (primitive.given())
        return primitive.one_of({"half-sphere", "cylinder"}) == 0 ? Primitive::half_sphere : Primitive::cylinder;
    std::vector<glm::vec2> corners;
    for (const Field& corner : polygon.items(3, maximum_corners))
        corners.push_back(scene::vector2(corner, -maximum_number, maximum_number));
    return corners;
}

glm::mat4 parse_rotation(const Field& node)
{
    node.allow_only({"degrees", "axis"});
    const Field axis = node.member("axis");
    const glm::vec3 direction = vector(axis);
    if (dot(direction, direction) < 1e-20F) axis.refuse("a direction of length 1e-10 or more");
    const double angle = glm::radians(node.member("degrees").number(-maximum_number, maximum_number));
    return glm::mat4(glm::rotate(glm::dmat4(1), angle, glm::dvec3(direction)));
}

// As on paper: four rows of four numbers.
glm::mat4 parse_matrix(const Field& node)
{
    glm::mat4 matrix(1);
    const std::vector<Field> rows = node.items(4, 4);
    for (int row = 0; row < 4; ++row) {
        const std::vector<Field> numbers = rows[static_cast<std::size_t>(row)].items(4, 4);
        for (int column = 0; column < 4; ++column)
            matrix[column][row] =
                scene::real(numbers[static_cast<std::size_t>(column)], -maximum_number, maximum_number);
    }
    return matrix;
}

class Reader {
public:
    explicit Reader(const Field& root) : root_(root) {}

    GraphFile read()
    {
        root_.allow_only({"format", "version", "title", "objects", "nodes", "root"});
        (void)root_.member("format").one_of({"umbral-scene-graph"});
        (void)root_.member("version").integer(1, 1);
        if (const Field title = root_.member("title"); title.given()) file_.title = title.text(maximum_name_length);
        for (const auto& [name, shape] : root_.member("objects").members(maximum_names)) {
            file_.object_names.push_back(name);
            file_.shapes.push_back(parse_shape(shape));
        }
        const auto nodes = root_.member("nodes").members(maximum_names);
        for (const auto& [name, entries] : nodes) file_.node_names.push_back(name);
        for (const auto& [name, entries] : nodes) {
            std::vector<Entry>& node = file_.graph.nodes.emplace_back();
            for (const Field& entry : entries.items(0, maximum_entries)) node.push_back(parse_entry(entry));
        }
        file_.graph.root = static_cast<std::uint32_t>(root_.member("root").one_of(file_.node_names));
        return std::move(file_);
    }

private:
    Entry parse_entry(const Field& node)
    {
        node.allow_only({"object", "node", "translate", "scale", "rotate", "matrix"});
        const auto members = node.members(6);
        if (members.size() != 1)
            node.refuse("one of \"object\", \"node\", \"translate\", \"scale\", \"rotate\", \"matrix\"");
        const auto& [kind, value] = members.front();
        if (kind == "object")
            return {Entry::Kind::object, static_cast<std::uint32_t>(value.one_of(file_.object_names))};
        if (kind == "node") return {Entry::Kind::node, static_cast<std::uint32_t>(value.one_of(file_.node_names))};
        if (kind == "translate") return add(glm::translate(glm::mat4(1), vector(value)));
        if (kind == "scale") return add(glm::scale(glm::mat4(1), vector(value)));
        return add(kind == "rotate" ? parse_rotation(value) : parse_matrix(value));
    }

    Entry add(const glm::mat4& matrix)
    {
        file_.graph.transformations.push_back(matrix);
        return {Entry::Kind::transformation, static_cast<std::uint32_t>(file_.graph.transformations.size() - 1)};
    }

    const Field& root_;
    GraphFile file_;
};

}

GraphFile read_graph(const std::filesystem::path& file)
{
    const nlohmann::json json = read_json(file, maximum_bytes);
    return Reader(Field(json, file.string())).read();
}

GraphFile parse_graph(std::string_view text, const std::string& file)
{
    const nlohmann::json json = parse_json(text, file);
    return Reader(Field(json, file)).read();
}

std::string path_text(const GraphFile& file, const transforms::CycleError& error)
{
    std::string text;
    for (const std::uint32_t node : error.path()) text += (text.empty() ? "" : " -> ") + file.node_names.at(node);
    return text;
}

}
