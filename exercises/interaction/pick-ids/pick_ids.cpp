#include <umbral/gl/opengl.hpp>
#include <umbral/interaction/pick_ids.hpp>

namespace umbral::interaction {

glm::u8vec3 color_of_id(std::uint32_t id)
{
    // TODO
    return not_implemented<glm::u8vec3>(id);
}

std::uint32_t id_of_color(const glm::u8vec3& color)
{
    // TODO
    return not_implemented<std::uint32_t>(color);
}

std::unique_ptr<IdPicker> make_id_picker()
{
    // TODO: a class that derives from IdPicker. Its ids_around
    // 1. notes the state that it is going to change,
    // 2. makes a framebuffer object of the picture's size, with colours and depths, if it has none of that size,
    // 3. draws each thing into it in the colour of its id, with all switched off that would change colours,
    // 4. reads the square's pixels, turns rows round, and makes ids of the colours,
    // 5. puts the state back.
    return not_implemented<std::unique_ptr<IdPicker>>();
}

std::uint32_t nearest_id(const Grid<std::uint32_t>& ids)
{
    // TODO
    return not_implemented<std::uint32_t>(ids);
}

}
