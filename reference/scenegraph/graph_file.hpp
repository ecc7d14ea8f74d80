#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <umbral/transforms/pipeline.hpp>
#include <umbral/transforms/scene_graph.hpp>
#include <variant>
#include <vector>

namespace umbral::scenegraph {

/// What a simple object is: a solid, or a polygon in the plane z = 0.
using Shape = std::variant<transforms::Primitive, std::vector<glm::vec2>>;

/// A scene graph with the names of its file. Objects and nodes are numbered by their names' order.
struct GraphFile {
    std::string title;
    transforms::SceneGraph graph;
    std::vector<std::string> node_names;
    std::vector<std::string> object_names;
    std::vector<Shape> shapes;  ///< of the objects
};

/// Reads a scene graph (docs/schemas/scene-graph.schema.json describes the format). Names refer to what is there, and
/// numbers are finite; a node may contain itself, which is for transforms::expand to refuse. Throws std::runtime_error
/// "file: nodes.house[1].scale: expected …, got …".
[[nodiscard]] GraphFile read_graph(const std::filesystem::path& file);

/// The same from a text; `file` is what complaints call it.
[[nodiscard]] GraphFile parse_graph(std::string_view text, const std::string& file);

/// The nodes of a cycle by their names, as "house -> window -> house".
[[nodiscard]] std::string path_text(const GraphFile& file, const transforms::CycleError& error);

}
