#include <umbral/interaction/pick_buffer.hpp>

namespace umbral::interaction {

glm::mat4 pick_matrix(const glm::ivec2& pixel, float size, const glm::ivec2& picture)
{
    // TODO
    return not_implemented<glm::mat4>(pixel, size, picture);
}

std::optional<std::vector<SelectionRecord>> parse_selection(std::span<const std::uint32_t> buffer, int count)
{
    // TODO
    return not_implemented<std::optional<std::vector<SelectionRecord>>>(buffer, count);
}

std::optional<std::size_t> nearest_record(std::span<const SelectionRecord> records)
{
    // TODO
    return not_implemented<std::optional<std::size_t>>(records);
}

std::unique_ptr<SelectionBuffer> make_selection_buffer(std::size_t words)
{
    // TODO: a class that derives from SelectionBuffer. Of each command that changes names:
    // 1. refuse it if it cannot be carried out,
    // 2. write a record if a primitive was noted since the last one,
    // 3. change the stack.
    return not_implemented<std::unique_ptr<SelectionBuffer>>(words);
}

}
