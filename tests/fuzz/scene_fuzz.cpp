
#include "fuzz.hpp"
#include "scene/scene_json.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace umbral;
    (void)tests::reads<std::runtime_error>([&] { (void)scene::parse_scene(tests::text_of(data, size), "scene.json"); });
    return 0;
}
