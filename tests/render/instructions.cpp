// Draws the scene without effects by the kernel without effects, or with the word "all" by the one with all, so that
// instructions can be counted: in a program that holds all kernels, and in one from whose sources the effects were
// taken out.

#include <string_view>

#include "render/software.hpp"
#include "scenes.hpp"

int main(int count, char** words)
{
    using namespace umbral::render;
    const umbral::scene::Scene scene = test::plain();
    const DrawList list = make_draw_list(scene, 256, 256);
    const EffectSet set = count > 1 && std::string_view(words[1]) == "all" ? all_effects : EffectSet{};
    const SoftwarePicture picture = draw_in_software(list, set, 256, 256);
    return picture.counters.fragments_shaded > 10000 ? 0 : 1;
}
