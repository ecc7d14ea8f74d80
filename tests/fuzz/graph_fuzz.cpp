#include "fuzz.hpp"
#include "scenegraph/graph_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace umbral;
    (void)tests::reads<std::runtime_error>([&] {
        const scenegraph::GraphFile file = scenegraph::parse_graph(tests::text_of(data, size), "graph.json");
        tests::expect(file.shapes.size() == file.object_names.size(), "an object without a shape");
    });
    return 0;
}
