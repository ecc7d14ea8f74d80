// mistake: reads words from a stream, ASCII only, and takes whatever stops it for the end
// credit: 20..55
// hint: A stream reads on over line ends, says neither what was wrong nor where, and its decimal point is the locale's.
// Take the file apart by lines and words, and read each word with std::from_chars.
#include <sstream>
#include <umbral/meshes/ply.hpp>

namespace umbral::meshes {

PolygonMesh read_ply(std::span<const std::byte> bytes)
{
    std::istringstream file(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    struct Property {
        std::string name;
        bool list;
    };
    struct Element {
        std::string name;
        std::size_t count = 0;
        std::vector<Property> properties;
    };
    std::vector<Element> elements;
    std::string line;
    if (!std::getline(file, line) || line.substr(0, 3) != "ply")
        throw PlyError(PlyProblem::not_ply, 1, "expected 'ply'");
    for (std::size_t number = 2; std::getline(file, line); ++number) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "end_header") break;
        if (word == "format" && words >> word && word != "ascii")
            throw PlyError(PlyProblem::header, number, "only ASCII");
        if (word == "element") {
            Element element;
            if (!(words >> element.name >> element.count))
                throw PlyError(PlyProblem::header, number, "expected a name and a count");
            elements.push_back(element);
        } else if (word == "property") {
            Property property;
            words >> word;
            property.list = word == "list";
            if (property.list) words >> word >> word;
            words >> property.name;
            if (elements.empty() || property.name.empty())
                throw PlyError(PlyProblem::header, number, "expected a name");
            elements.back().properties.push_back(property);
        }
    }
    PolygonMesh mesh;
    for (const Element& element : elements) {
        for (std::size_t i = 0; i < element.count && !element.properties.empty(); ++i) {
            glm::vec3 position(0);
            for (const Property& property : element.properties) {
                float value = 0;
                int length = 1;
                std::vector<std::uint32_t> face;
                if (property.list) file >> length;
                for (int k = 0; k < length; ++k) {
                    if (!(file >> value)) throw PlyError(PlyProblem::truncated, 0, "the file ends");
                    face.push_back(static_cast<std::uint32_t>(value));
                }
                if (property.list && element.name == "face") mesh.faces.push_back(face);
                if (property.name == "x") position.x = value;
                if (property.name == "y") position.y = value;
                if (property.name == "z") position.z = value;
            }
            if (element.name == "vertex") mesh.positions.push_back(position);
        }
    }
    return mesh;
}

std::string write_ply(const PolygonMesh& mesh, PlyFormat format)
{
    std::ostringstream file;
    if (format != PlyFormat::ascii) return "";
    file << "ply\nformat ascii 1.0\nelement vertex " << mesh.positions.size()
         << "\nproperty float x\nproperty float y\nproperty float z\n";
    file << "element face " << mesh.faces.size() << "\nproperty list uchar int vertex_index\nend_header\n";
    for (const glm::vec3& p : mesh.positions) file << p.x << ' ' << p.y << ' ' << p.z << '\n';
    for (const auto& face : mesh.faces) {
        file << face.size();
        for (const std::uint32_t corner : face) file << ' ' << corner;
        file << '\n';
    }
    return file.str();
}

}
