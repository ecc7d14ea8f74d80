// alternative: a block of memory that is filled word by word, also with the beginning of a record that has no room;
// the matrix as a product of a scale and a translation; parsing by an index; a loop for the nearest
#include <umbral/interaction/pick_buffer.hpp>

namespace umbral::interaction {
namespace {

class Block final : public SelectionBuffer {
    std::vector<std::uint32_t> memory;
    std::size_t used = 0;
    std::size_t shown = 0;
    std::uint32_t stack[most_names] = {};
    std::size_t height = 0;
    bool hit = false;
    double nearest = 1;
    double farthest = 0;
    int count = 0;

    void put(std::uint32_t word)
    {
        if (used < memory.size()) memory[used] = word;
        ++used;
    }
    void flush()
    {
        if (!hit) return;
        hit = false;
        put(std::uint32_t(height));
        put(std::uint32_t(std::llround(nearest * 4294967295.0)));
        put(std::uint32_t(std::llround(farthest * 4294967295.0)));
        for (std::size_t i = 0; i < height; ++i) put(stack[i]);
        nearest = 1;
        farthest = 0;
        ++count;
    }

public:
    explicit Block(std::size_t words) : memory(words) {}

    void init_names() override
    {
        flush();
        height = 0;
    }
    bool load_name(std::uint32_t name) override
    {
        if (height == 0) return false;
        flush();
        stack[height - 1] = name;
        return true;
    }
    bool push_name(std::uint32_t name) override
    {
        if (height >= most_names) return false;
        flush();
        stack[height++] = name;
        return true;
    }
    bool pop_name() override
    {
        if (height == 0) return false;
        flush();
        --height;
        return true;
    }
    void note_primitive(double min_depth, double max_depth) override
    {
        hit = true;
        if (min_depth < nearest) nearest = min_depth;
        if (max_depth > farthest) farthest = max_depth;
    }
    int finish() override
    {
        flush();
        const int answer = used > memory.size() ? -1 : count;
        shown = std::min(used, memory.size());
        used = 0;
        height = 0;
        count = 0;
        return answer;
    }
    std::span<const std::uint32_t> words() const override { return {memory.data(), shown}; }
};

}

glm::mat4 pick_matrix(const glm::ivec2& pixel, float size, const glm::ivec2& picture)
{
    // Where the pixel's centre is in normalised device coordinates: bring it to the middle, then magnify.
    const glm::vec2 ndc(2 * (float(pixel.x) + 0.5F) / float(picture.x) - 1,
                        1 - 2 * (float(pixel.y) + 0.5F) / float(picture.y));
    const glm::mat4 magnified =
        glm::scale(glm::mat4(1), glm::vec3(float(picture.x) / size, float(picture.y) / size, 1));
    return glm::translate(magnified, glm::vec3(-ndc, 0));
}

std::optional<std::vector<SelectionRecord>> parse_selection(std::span<const std::uint32_t> buffer, int count)
{
    if (count < 0 || std::size_t(count) > buffer.size() / 3) return {};  // no memory for more than there can be
    std::vector<SelectionRecord> records(std::size_t(count), SelectionRecord{});
    std::size_t at = 0;
    for (SelectionRecord& record : records) {
        if (at + 3 > buffer.size() || at + 3 + std::size_t(buffer[at]) > buffer.size()) return {};
        record.min_depth = buffer[at + 1];
        record.max_depth = buffer[at + 2];
        for (std::uint32_t k = 0; k < buffer[at]; ++k) record.names.push_back(buffer[at + 3 + k]);
        at += 3 + record.names.size();
    }
    return records;
}

std::optional<std::size_t> nearest_record(std::span<const SelectionRecord> records)
{
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < records.size(); ++i)
        if (!best || records[i].min_depth < records[*best].min_depth) best = i;
    return best;
}

std::unique_ptr<SelectionBuffer> make_selection_buffer(std::size_t words) { return std::make_unique<Block>(words); }

}
