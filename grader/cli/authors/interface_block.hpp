#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/exercise.hpp"

namespace umbral::grader {

/// Where the sources of interfaces lie: a unit, and the framework's include folder.
struct InterfaceSources {
    const Exercise& exercise;
    const std::filesystem::path& framework;
};

/// The files whose interface the unit's statements must show: the headers of its topic that its stubs include
/// ("umbral/raytracing/intersect.hpp"), and the stubs of shaders ("phong.vert").
[[nodiscard]] std::vector<std::string> interface_files(const Exercise& exercise);

/// What a statement shows of a header: without #pragma once, includes, the namespace's lines and private members. With
/// `names`, only the declarations of those, in the header's order. Throws std::runtime_error if the header declares no
/// such name.
[[nodiscard]] std::string shown_of_header(std::string_view text, const std::vector<std::string>& names);

/// What a statement shows of a shader's stub: all before main() but what is to be done.
[[nodiscard]] std::string shown_of_shader(std::string_view text);

/// The statement with its interface blocks as their sources are now. A block lies between two lines of its own:
///
///     <!-- interface umbral/pipeline/depth.hpp: DepthState, Layer -->
///     <!-- /interface -->
///
/// Without names all of the header is shown; a name without a folder ("phong.vert") is a stub of the unit. Files that
/// interface_files() names and no block shows get one in the section `heading` ("## Interface"), which is made before
/// the second section if it is missing. Throws std::runtime_error that names the line if a block has no end, or its
/// file or a name in it does not exist.
[[nodiscard]] std::string with_interfaces(const std::string& statement, const std::string& heading,
                                          const InterfaceSources& sources);

}
