#include "judge/fragments/fragments.hpp"

namespace umbral::grader {
namespace {

struct Box {
    Place low;
    Place high;
    [[nodiscard]] double pixels() const { return (double{1} + high.x - low.x) * (double{1} + high.y - low.y); }
};

std::vector<Box> boxes_of(const FragmentTable& table)
{
    std::vector<Box> boxes;
    for (const Fragment& fragment : table.sorted()) {
        const Place& place = fragment.place;
        if (boxes.empty() || boxes.back().low.primitive != place.primitive) boxes.push_back({place, place});
        Box& box = boxes.back();
        box.low.x = std::min(box.low.x, place.x);
        box.low.y = std::min(box.low.y, place.y);
        box.high.x = std::max(box.high.x, place.x);
        box.high.y = std::max(box.high.y, place.y);
    }
    return boxes;
}

}

std::optional<Tensor> bounding_boxes(const Tensor& expected, std::span<const double> row)
{
    const std::vector<Box> boxes = boxes_of(FragmentTable(expected));
    double pixels = 0;
    for (const Box& box : boxes) pixels += box.pixels();
    if (pixels > 16.0 * static_cast<double>(expected.cells())) return std::nullopt;

    std::vector<double> values;
    for (const Box& box : boxes)
        for (std::int32_t y = box.low.y; y <= box.high.y; ++y)
            for (std::int32_t x = box.low.x; x <= box.high.x; ++x) {
                values.insert(values.end(),
                              {static_cast<double>(box.low.primitive), static_cast<double>(x), static_cast<double>(y)});
                values.insert(values.end(), row.begin() + 3, row.end());
            }
    Tensor tensor = expected;
    tensor.present.clear();
    tensor.rows = static_cast<std::uint32_t>(values.size() / expected.components);
    tensor.bytes.resize(values.size() * size_of(expected.element));
    return with_values(tensor, values);
}

}
