#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "judge/evidence/kinds.hpp"
#include "judge/judges.hpp"
#include "judge/picture/colour_map.hpp"
#include "judge/picture/image_difference.hpp"
#include "judge/picture/to_image.hpp"
#include "judge/rows/tensor_view.hpp"

namespace umbral::grader {
namespace {

constexpr std::size_t most_pixels = 12;

Image part_of(const Image& image, const Window& window)
{
    Image part(window.width, window.height);
    for (int y = 0; y < window.height; ++y)
        for (int x = 0; x < window.width; ++x) part.at(x, y) = image.at(window.x + x, window.y + y);
    return part;
}

/// Values of a window in words, each different text once.
class Words {
public:
    explicit Words(std::vector<std::string>& texts) : texts_(texts) {}

    std::uint16_t number_of(const std::string& text)
    {
        const auto [found, added] = numbers_.emplace(text, static_cast<std::uint16_t>(texts_.size()));
        if (added) texts_.push_back(text);
        return found->second;
    }

private:
    std::vector<std::string>& texts_;
    std::map<std::string, std::uint16_t> numbers_;
};

/// A pixel's value in words. Pictures are judged in steps of a 255th of their range: four digits say more than that.
std::string pixel_text(const Check& check, const TensorView& view, std::size_t cell)
{
    if (judge_of(check).look == Look::values || !view.present(cell)) return cell_text(view, cell);
    std::string text;
    for (const double value : view.cell(cell)) text += fmt::format("{}{:.4g}", text.empty() ? "" : ", ", value);
    return view.components() == 1 ? text : "(" + text + ")";
}

/// Two recordings of one shape, and what a page shows of them.
struct PicturePair {
    const Tensor& yours;
    const Tensor& expected;
    Image yours_image;
    Image expected_image;
    Grid<std::uint8_t> map;
    Image difference;
    int largest = 0;
};

Magnified magnify(const Check& check, const PicturePair& pair, const Window& window,
                  std::vector<PixelPair>& worst_pixels)
{
    Magnified result;
    result.x = window.x;
    result.y = window.y;
    result.yours = part_of(pair.yours_image, window);
    result.reference = part_of(pair.expected_image, window);
    result.difference = part_of(pair.difference, window);
    const TensorView yours(pair.yours);
    const TensorView expected(pair.expected);
    Words words(result.texts);
    for (int y = window.y; y < window.y + window.height; ++y)
        for (int x = window.x; x < window.x + window.width; ++x) {
            const std::size_t cell = static_cast<std::size_t>(y) * pair.expected.columns + static_cast<std::size_t>(x);
            const int level = pair.map.at(x, y);
            const std::string of_yours = pixel_text(check, yours, cell);
            const std::string of_expected = pixel_text(check, expected, cell);
            result.yours_texts.push_back(words.number_of(of_yours));
            result.reference_texts.push_back(words.number_of(of_expected));
            result.levels.push_back(static_cast<std::uint8_t>(level));
            if (level > 0) worst_pixels.push_back({x, y, of_yours, of_expected, level});
        }
    std::stable_sort(worst_pixels.begin(), worst_pixels.end(),
                     [](const PixelPair& a, const PixelPair& b) { return a.level > b.level; });
    if (worst_pixels.size() > most_pixels) worst_pixels.resize(most_pixels);
    return result;
}

bool is_measured(const Check& check, const Tensor& tensor)
{
    return judge_of(check).look != Look::values || is_real(tensor.element);
}

/// Pictures of different or no size: both are shown, and why they cannot be compared.
PictureEvidence uncomparable(const Check& check, const Tensor& yours, const Tensor& expected)
{
    PictureEvidence result;
    result.problem = *shape_error(yours, expected);
    result.reference = to_image(expected, check);
    try {
        result.yours = to_image(yours, check);
    } catch (const std::invalid_argument&) {
        // What is no picture at all cannot be drawn; the sentence says what it is.
        result.yours = {};
    }
    return result;
}

}

Evidence picture_evidence(const Check& check, const Observation& observation, bool right)
{
    const Tensor& yours = *observation.yours;
    const Tensor& expected = *observation.expected;
    if (!can_be_drawn(check, expected)) return {};
    try {
        if (shape_error(yours, expected)) return uncomparable(check, yours, expected);
        PicturePair pair{
            yours, expected, to_image(yours, check), to_image(expected, check), difference_map(check, yours, expected),
            {},    0};
        PictureEvidence result;
        result.graded = is_measured(check, expected);
        for (const std::uint8_t level : pair.map.cells) {
            pair.largest = std::max<int>(pair.largest, level);
            result.differing += level > 0 ? 1 : 0;
        }
        result.largest = pair.largest;
        result.yours = pair.yours_image;
        if (pair.largest == 0) return result;
        result.reference = pair.expected_image;
        pair.difference = Image(pair.map.width, pair.map.height);
        for (std::size_t i = 0; i < pair.map.cells.size(); ++i)
            pair.difference.cells[i] = magma(static_cast<double>(pair.map.cells[i]) / pair.largest);
        result.difference = pair.difference;
        const std::optional<WorstRegion> worst = worst_region(check, yours, expected);
        if (worst && !right) result.worst = magnify(check, pair, worst->worst, result.pixels);
        return result;
    } catch (const std::invalid_argument&) {
        // A buffer of another kind than pictures are (two channels, say): the judge's words must do.
        return {};
    }
}

}
